#!/usr/bin/env bash
# Runs the kernel benchmarks.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  cat <<'HELP'
usage: scripts/bench.sh [GOOGLE-BENCHMARK-ARGUMENT...]

Builds the release preset and runs every kernel benchmark. Results are printed, and written as JSON
into results/runs/bench-TIME/, one file per program. Arguments go to each program:

  scripts/bench.sh --benchmark_filter=grow
  scripts/bench.sh --benchmark_repetitions=5 --benchmark_report_aggregates_only=true

Compare CPU times, on an idle machine. Google Benchmark warns that the library was built as DEBUG:
this is about Debian's build of the library, which has its assertions on, not about mda-bench.
HELP
}

case ${1-} in
  -h | --help)
    usage
    exit 0
    ;;
esac

"$root/scripts/setup.sh" --for reproduce
"$root/scripts/build.sh" release

mapfile -d '' -t programs < <(
  find "$root/build/release" -type f -name '*_bench' -executable -print0 | sort -z
)
if ((${#programs[@]} == 0)); then
  echo "bench.sh: no program *_bench under $root/build/release" >&2
  exit 1
fi

out="$root/results/runs/bench-$(date -u +%Y%m%dT%H%M%SZ)"
mkdir -p "$out"
for program in "${programs[@]}"; do
  name=$(basename "$program")
  echo "== $name"
  "$program" --benchmark_out_format=json "--benchmark_out=$out/$name.json" "$@"
done
echo "JSON in $out"
