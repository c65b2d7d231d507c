#!/usr/bin/env bash
# Format, layers, shell scripts, and clang-tidy on what has changed.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

# Long enough for the commits of one working session, short enough to stay quick when the project
# has grown.
recent_commits=20

tidy_options=(
  # Flags of g++ that clang does not know are no finding.
  --extra-arg=-Wno-unknown-warning-option --extra-arg=-Wno-ignored-optimization-argument
  # Half the time of the full analysis; the sanitizers see the rest when the tests run.
  --extra-arg=-Xclang --extra-arg=-analyzer-config --extra-arg=-Xclang --extra-arg=mode=shallow
)

usage() {
  cat <<HELP
usage: scripts/lint.sh [--all | FILE.cc...]

Checks the C++ files for format (clang-format), layers (scripts/check_layers.py) and bugs and
naming (clang-tidy), and the shell scripts (shellcheck). Installs the linters that are missing.
clang-tidy takes some seconds per file, so by default it sees only what the last
$recent_commits commits and the working tree have changed; for a changed header, one file that
includes it.

  scripts/lint.sh                            what has changed
  scripts/lint.sh --all                      every file
  scripts/lint.sh algorithms/api/problem.cc  clang-tidy on these files only

To repair the format: clang-format -i FILE. scripts/build.sh must have run once: clang-tidy takes
the compiler flags of every file from there.

exit code: 0 clean; 1 findings; 2 bad usage or nothing built yet
HELP
}

selection=changed
chosen=()
while (($#)); do
  case $1 in
    -h | --help)
      usage
      exit 0
      ;;
    --all) selection=all ;;
    *.cc)
      selection=chosen
      chosen+=("$(realpath --relative-base="$root" -- "$1")")
      ;;
    *)
      echo "lint.sh: '$1' is not a .cc file; see scripts/lint.sh --help" >&2
      exit 2
      ;;
  esac
  shift
done

cd "$root"
scripts/setup.sh --for lint
if [[ ! -f build/release/compile_commands.json ]]; then
  echo "lint.sh: nothing is configured in build/release; run scripts/build.sh first" >&2
  exit 2
fi

failed=()
section() {
  echo "== $1"
  "${@:2}" || failed+=("$1")
}

# In alphabetical order, one per line; no file of ours has a line break in its name.
our_files() { find algorithms scenarios harness -name "$1" | sort; }

changed_files() {
  local base
  if ! git rev-parse --verify --quiet HEAD >/dev/null 2>&1; then
    our_files '*.h' && our_files '*.cc'
    return
  fi
  base=$(git rev-parse --verify --quiet "HEAD~$recent_commits") ||
    base=$(git hash-object -t tree /dev/null) # the empty tree: the history is shorter or cut off
  git diff --name-only --diff-filter=d "$base" -- algorithms scenarios harness &&
    git ls-files --others --exclude-standard -- algorithms scenarios harness
}

# The .cc files whose compilation shows the findings in the changed files.
files_to_tidy() {
  local file
  changed_files | while IFS= read -r file; do
    case $file in
      *.cc) echo "$file" ;;
      *.h)
        if [[ -f ${file%.h}.cc ]]; then
          echo "${file%.h}.cc"
        else
          our_files '*.cc' | xargs -d '\n' grep -lF "#include \"$file\"" | head -n 1 || true
        fi
        ;;
    esac
  done | sort -u
}

# Without those of options that are off: clang-tidy would have to guess how they are compiled.
only_compiled() {
  local file
  while IFS= read -r file; do
    if grep -qF "/$file\"" build/release/compile_commands.json; then echo "$file"; fi
  done
}

check_format() {
  { our_files '*.h' && our_files '*.cc'; } | xargs -d '\n' clang-format --dry-run -Werror
}

check_layers() { scripts/check_layers.py; }

check_shell() { shellcheck scripts/*.sh .ci/run; }

check_tidy() {
  # Not shown: how many warnings clang-tidy has hidden in the headers of others.
  case $selection in
    all) our_files '*.cc' | only_compiled ;;
    chosen) printf '%s\n' "${chosen[@]}" ;;
    changed) files_to_tidy | only_compiled ;;
  esac |
    xargs -r -d '\n' -n 1 -P "$(nproc)" clang-tidy --quiet -p build/release "${tidy_options[@]}" \
      2> >(grep -vE '^[0-9]+ (warnings?|errors?)( and [0-9]+ errors?)? generated\.$' >&2)
}

if [[ $selection != chosen ]]; then
  section "format" check_format
  section "layers" check_layers
  section "shell scripts" check_shell
fi
section "clang-tidy ($selection)" check_tidy

if ((${#failed[@]})); then
  printf 'lint.sh: findings in: %s\n' "${failed[@]}" >&2
  exit 1
fi
echo "lint.sh: clean"
