#!/usr/bin/env bash
# From a bare checkout to a verdict: installs, builds, runs every test.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  cat <<'HELP'
usage: scripts/test.sh [CTEST-ARGUMENT...]

Installs the packages that are missing, builds the release preset in build/release/ and runs every
test. Arguments go to ctest:

  scripts/test.sh                  every test
  scripts/test.sh -R rounding      those whose name matches
  scripts/test.sh -j 1             one at a time

A test that fails prints its output. A test that needs a program which is not there (glpsol,
lp_solve) is skipped and says so. For the sanitizers: scripts/build.sh asan && ctest --preset asan

exit code: 0 all passed; otherwise that of the step that failed
HELP
}

case ${1-} in
  -h | --help)
    usage
    exit 0
    ;;
esac

"$root/scripts/setup.sh" --for test
"$root/scripts/build.sh" release
cd "$root"
CTEST_PARALLEL_LEVEL="${CTEST_PARALLEL_LEVEL:-$(nproc)}" \
  exec ctest --preset release --no-tests=error "$@"
