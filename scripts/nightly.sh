#!/usr/bin/env bash
# Times and checks a revision against an earlier one, in turns, and says whether it got worse.
set -euo pipefail
root=$(CDPATH='' cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)

# What history refers to: the first revision that can take turns. Times are told as multiples of
# its times on the same machine in the same session; pin a later one only with a new history.
anchor_revision=71d92d9ea8d9040b0a8596f3578d16ad74b8f804

usage() {
  cat <<'HELP'
usage: scripts/nightly.sh [--candidate REV] [--baseline REV] [--anchor REV] [ARGUMENT...]

Builds three revisions, has them answer the sweep smoke, counts their instructions and times them in
turns on the same frozen windows and kernels, all in one session. Then compares the candidate with
the baseline, and puts the session into the history.

  --candidate REV   what is judged [HEAD]; uncommitted changes take no part
  --baseline REV    what it is compared with [the last candidate without a regression; else the
                    anchor]
  --anchor REV      what the history refers to [pinned in this script]

Every ARGUMENT goes to scripts/measure.py: --rounds R, --budget SECONDS, --seed N.
Programs are kept in build/nightly/, sessions in results/runs/nightly/. The verdict goes to standard
output, all else to standard error. Without builds it takes less than ten minutes.

  scripts/nightly.sh                             tonight
  scripts/nightly.sh --baseline main             a branch before it is merged
  17 2 * * * cd /path/to/clone && git pull -q && scripts/nightly.sh >> nightly.log   a line for cron

exit code: 0 no credible regression; 1 a regression; 4 the session is invalid: the machine was too
noisy, run it again; otherwise that of the step that failed (2: bad usage or input)
HELP
}

refuse() {
  printf 'nightly.sh: %s\n' "$1" >&2
  exit 2
}

nightly="$root/build/nightly"
sessions="$root/results/runs/nightly"
green="$sessions/last-green"

candidate=HEAD baseline="" anchor=$anchor_revision
more=()
while (($#)); do
  case $1 in
    -h | --help)
      usage
      exit 0
      ;;
    --candidate | --baseline | --anchor)
      (($# > 1)) || refuse "$1 needs a revision"
      declare "${1#--}=$2"
      shift 2
      ;;
    --rounds | --budget | --seed)
      (($# > 1)) || refuse "$1 needs a value"
      more+=("$1" "$2")
      shift 2
      ;;
    *) refuse "unknown argument '$1'; see scripts/nightly.sh --help" ;;
  esac
done

commit_of() {
  git -C "$root" rev-parse --verify --quiet "$1^{commit}" ||
    refuse "there is no revision '$1' here (a shallow clone has few)"
}

# The programs of a commit into build/nightly/programs/COMMIT/. All commits are built at one place,
# so that equal sources make equal files, and only what differs is compiled.
build() {
  local commit=$1 tree="$nightly/tree" out="$nightly/programs/$1" target
  [[ ! -x $out/mda-bench ]] || return 0
  git -C "$root" worktree prune
  if [[ -e $tree/.git ]]; then
    git -C "$tree" checkout --quiet --force --detach "$commit"
  else
    git -C "$root" worktree add --quiet --force --detach "$tree" "$commit"
  fi
  "$tree/scripts/build.sh" release --target mda-bench
  mkdir -p "$out"
  for target in $("$root/scripts/measure.py" --list-programs); do
    # A commit that does not know a program has no such cells.
    ninja -C "$tree/build/release" -t query "$target" >/dev/null 2>&1 || continue
    "$tree/scripts/build.sh" release --target "$target"
    find "$tree/build/release" -type f -name "$target" -executable -exec cp {} "$out" \;
  done
  cp "$tree/build/release/mda-bench" "$out" # last: it says that all is there
}

measure() {
  "$root/scripts/measure.py" "$session" --programs "$nightly/programs" --anchor "$anchor" \
    --baseline "$baseline" --candidate "$candidate" "${more[@]}" "$@"
}

session="$sessions/$(date -u +%Y%m%dT%H%M%SZ)"
{
  candidate=$(commit_of "$candidate")
  anchor=$(commit_of "$anchor")
  if [[ -z $baseline && -r $green ]]; then baseline=$(<"$green"); fi
  baseline=$(commit_of "${baseline:-$anchor}")
  "$root/scripts/setup.sh" --for nightly
  measure --check
  for commit in "$anchor" "$baseline" "$candidate"; do build "$commit"; done
  mkdir -p "$sessions"
  measure
} >&2

verdict=0
"$root/scripts/compare.py" "$session/baseline" "$session/candidate" || verdict=$?
if ((verdict == 0)); then echo "$candidate" >"$green"; fi
"$root/scripts/history.py" --sessions "$sessions" >"$session/history.txt" || true
cat >&2 <<DONE

The session: $session
The verdict again: scripts/compare.py "$session/baseline" "$session/candidate"
All nights: scripts/history.py
DONE
exit "$verdict"
