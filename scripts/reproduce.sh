#!/usr/bin/env bash
# Rebuilds Tables 2-5 of Storms & Spieksma from scenarios simulated here.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  cat <<'HELP'
usage: scripts/reproduce.sh [ARGUMENT...]

Rebuilds the tables of Storms & Spieksma (2003) and prints them beside the published ones:
installs the packages that are missing, builds mda-bench, runs the sweep storms2003 (the paper's
4,650 windows) into a new directory under results/runs/, and makes the tables. After the first
build it takes less than a minute.

Arguments go to `mda-bench run`, for example:

  scripts/reproduce.sh --workers 1     on one core
  scripts/reproduce.sh --seed 2        other scenarios of the same kind

The tables go to standard output, all else to standard error.

exit code: 0 well; otherwise that of the step that failed (mda-bench: 1 a wrong answer was found)
HELP
}

case ${1-} in
  -h | --help)
    usage
    exit 0
    ;;
esac

run="$root/results/runs/storms2003-$(date -u +%Y%m%dT%H%M%SZ)"
{
  "$root/scripts/setup.sh" --for reproduce
  "$root/scripts/build.sh" release --target mda-bench
  "$root/build/release/mda-bench" run storms2003 --out "$run" "$@"
} >&2
"$root/scripts/tables.py" storms2003 "$run"
cat >&2 <<DONE

Rows, answers and manifest of this run: $run
The tables again: scripts/tables.py storms2003 "$run"
DONE
