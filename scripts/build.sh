#!/usr/bin/env bash
# Configures and builds one preset.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

usage() {
  cat <<'HELP'
usage: scripts/build.sh [PRESET] [ARGUMENT...]

Configures and builds PRESET in build/PRESET/. Later calls compile only what has changed.

  release   optimised, with tests and benchmarks (the default)
  debug     for a debugger
  asan      address and undefined-behaviour sanitizers

Every ARGUMENT goes to `cmake --build`. All cores compile unless -j N or the variable
CMAKE_BUILD_PARALLEL_LEVEL says otherwise. ccache is used where it is installed.

  scripts/build.sh                              all of it
  scripts/build.sh release --target mda-bench   the program alone
  scripts/build.sh asan -j 1                    one compiler at a time, for little memory

It installs nothing: scripts/setup.sh does. To run what was built: scripts/test.sh,
scripts/reproduce.sh, scripts/bench.sh.
HELP
}

case ${1-} in
  -h | --help)
    usage
    exit 0
    ;;
esac
preset=release
if (($#)) && [[ $1 != -* ]]; then
  preset=$1
  shift
fi

if ! command -v cmake >/dev/null; then
  echo "build.sh: there is no cmake here; scripts/setup.sh installs all that the build needs" >&2
  exit 2
fi

configure=(--preset "$preset")
if command -v ccache >/dev/null; then
  # Relative paths in the cache's keys let another clone use what this one has compiled.
  export CCACHE_BASEDIR="${CCACHE_BASEDIR:-$root}" CCACHE_NOHASHDIR="${CCACHE_NOHASHDIR:-1}"
else
  configure+=(-DCMAKE_CXX_COMPILER_LAUNCHER=)
fi

cd "$root"
cmake "${configure[@]}" >/dev/null # warnings and errors go to standard error
export CMAKE_BUILD_PARALLEL_LEVEL="${CMAKE_BUILD_PARALLEL_LEVEL:-$(nproc)}"
cmake --build --preset "$preset" "$@"
