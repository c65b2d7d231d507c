#!/usr/bin/env bash
# Installs the Debian packages that mda-bench needs, and nothing when they are all there.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

# Everything that configures, builds and turns rows into tables. The test libraries are here
# because there is one build configuration for all purposes: a build that left them out would be a
# second one to keep working. zlib1g-dev: COIN's pkg-config files name -lz, but COIN's packages do
# not ask for it.
build_packages=(
  build-essential ca-certificates ccache cmake git ninja-build pkg-config
  coinor-libcbc-dev coinor-libcgl-dev coinor-libclp-dev coinor-libcoinutils-dev coinor-libosi-dev
  libboost-dev libboost-random-dev libcli11-dev libeigen3-dev libfmt-dev liblemon-dev
  libtomlplusplus-dev nlohmann-json3-dev zlib1g-dev
  libbenchmark-dev libgtest-dev librapidcheck-dev
  python3 python3-numpy python3-pandas python3-scipy
)
# Programs that the tests call, to solve exported windows by other means, and the figures.
test_packages=(glpk-utils lp-solve python3-matplotlib python3-pytest)
# valgrind counts instructions.
nightly_packages=(valgrind)
# libomp-dev: clang reads its own omp.h, not that of g++.
lint_packages=(clang-format clang-tidy libomp-dev shellcheck)
# The page of scripts/report.py: what it is tested in, and where its chart library comes from.
report_source="$root/scripts/report_page"
report_assets="$root/build/report-assets"

usage() {
  cat <<'HELP'
usage: scripts/setup.sh [--for reproduce|nightly|test|lint] [--report]

Installs the packages of Debian 12 (bookworm) that are missing: one line says which, then apt-get
installs them without recommended extras. When all are there it does nothing, without asking the
network. It uses sudo only when you are not root.

  --for reproduce   what scripts/build.sh, scripts/reproduce.sh and scripts/bench.sh need
  --for nightly     the same, and valgrind for scripts/nightly.sh
  --for test        what reproduce needs, and the programs that the tests call (the default)
  --for lint        the same, and the formatter and the linters of scripts/lint.sh
  --report          also Node.js with npm, and by npm the chart library and the bundler of
                    scripts/report.py into build/report-assets/, in the versions that
                    scripts/report_page/package-lock.json fixes; with --for test (the default)
                    also chromium, in which the page is tested

scripts/reproduce.sh, scripts/test.sh and scripts/lint.sh call this script themselves. On a system
without apt-get, install the equivalents of the packages named at the top of this file, then call
scripts/build.sh, which installs nothing.

exit code: 0 everything is there; 2 bad usage, or nothing can be installed here;
otherwise that of apt-get
HELP
}

refuse() {
  printf 'setup.sh: %s\n' "$1" >&2
  exit 2
}

purpose="test"
report=""
while (($#)); do
  case $1 in
    -h | --help)
      usage
      exit 0
      ;;
    --for)
      (($# > 1)) || refuse "--for needs one of reproduce, nightly, test, lint"
      purpose=$2
      shift 2
      ;;
    --report)
      report=yes
      shift
      ;;
    *) refuse "unknown argument '$1'; see scripts/setup.sh --help" ;;
  esac
done

case $purpose in
  reproduce) wanted=("${build_packages[@]}") ;;
  nightly) wanted=("${build_packages[@]}" "${nightly_packages[@]}") ;;
  test) wanted=("${build_packages[@]}" "${test_packages[@]}") ;;
  lint) wanted=("${build_packages[@]}" "${test_packages[@]}" "${lint_packages[@]}") ;;
  *) refuse "--for '$purpose' is not one of reproduce, nightly, test, lint" ;;
esac

if [[ $report ]]; then
  # Node.js from elsewhere will do, and does not bear Debian's npm beside it.
  command -v node >/dev/null && command -v npm >/dev/null || wanted+=(nodejs npm)
  [[ $purpose != test ]] || wanted+=(chromium)
fi

fetch_chart_library() {
  local lock="$report_source/package-lock.json"
  if cmp -s "$lock" "$report_assets/package-lock.json"; then return; fi
  echo "setup.sh: fetching the chart library of scripts/report.py into $report_assets"
  mkdir -p "$report_assets"
  rm -f "$report_assets/package-lock.json"
  # No scripts of packages run here; the lock comes last and says that all is there.
  cp "$report_source/package.json" "$report_assets"
  cp "$lock" "$report_assets/npm-shrinkwrap.json"
  npm ci --prefix "$report_assets" --ignore-scripts --no-audit --no-fund --loglevel=error >&2
  cp "$lock" "$report_assets/package-lock.json"
}

if ! command -v apt-get >/dev/null || ! command -v dpkg-query >/dev/null; then
  refuse "there is no apt-get here; install these packages of Debian 12 or their equivalents by \
hand, then call scripts/build.sh: ${wanted[*]}"
fi

# dpkg-query complains about packages that it has never heard of; they are missing all the same.
installed=$(dpkg-query -W -f='${db:Status-Status} ${Package}\n' "${wanted[@]}" 2>/dev/null || true)
missing=()
for package in "${wanted[@]}"; do
  grep -qxF "installed $package" <<<"$installed" || missing+=("$package")
done
if ((${#missing[@]} == 0)); then
  [[ ! $report ]] || fetch_chart_library
  exit 0
fi
echo "setup.sh: installing ${#missing[@]} missing package(s): ${missing[*]}"

as_root=()
if ((EUID != 0)); then
  command -v sudo >/dev/null ||
    refuse "installing needs root and there is no sudo; as root run: apt-get install ${missing[*]}"
  as_root=(sudo)
fi

apt() {
  ${as_root[@]+"${as_root[@]}"} env DEBIAN_FRONTEND=noninteractive \
    apt-get -q -y -o DPkg::Lock::Timeout=300 -o Dpkg::Use-Pty=0 "$@"
}

# An unreachable third-party source must not stop packages that Debian itself can deliver.
apt update || echo "setup.sh: apt-get update failed; trying the package lists at hand" >&2
apt install --no-install-recommends "${missing[@]}"
[[ ! $report ]] || fetch_chart_library
