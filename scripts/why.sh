#!/usr/bin/env bash
# Says why a frame is out of date.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/why.sh FOLDER NUMBER [OLD_SCENE]

Says why the next run in FOLDER would render frame NUMBER, or that it would not. OLD_SCENE is what its scene was before:
then the first line that has changed is shown.
TEXT
}
help_where_asked "$@"
[[ ${2:-} =~ ^[1-9][0-9]{0,8}$ ]] || bad_usage "expected FOLDER NUMBER [OLD_SCENE]"
number=$2 old=${3:-}
cd -- "$1" 2>/dev/null || fail 2 "$1: no such folder"
printf -v frame 'frames/frame_%04d' "$number"
told=$(ninja -d explain -n "$frame.png" 2>&1) || true

# The first reason is the one; the others follow from it.
case $told in
  *"unknown target"*) fail 2 "frame $number is none of this film" ;;
  *"$frame.pov"*" is missing"*) why="its scene $frame.pov is missing; the next run writes it again" ;;
  *"$frame.png doesn't exist"*) why="there is no picture of it" ;;
  *"older than most recent input $frame.pov"*) why="its scene is newer than its picture" ;;
  *"older than most recent input "*)
    input=${told#*older than most recent input }
    why="${input%% (*} is newer than its picture"
    ;;
  *"command line changed for $frame.png"*) why="its size, quality or flags are others than those it was rendered with" ;;
  *"command line not found in log"*) why="nothing is noted of how its picture was rendered" ;;
  *"no work to do"*) why='' ;;
  *) why=$told ;;
esac
if [[ -z $why ]]; then
  printf 'frame %d is up to date\n' "$number"
  exit 0
fi
printf 'frame %d is rendered again: %s\n' "$number" "$why"
if [[ -n $old && -s $old ]] && ! cmp -s -- "$old" "$frame.pov"; then
  { diff -- "$old" "$frame.pov" || true; } | awk '
    /^[0-9]/ && !line { line = $0; sub(/[^0-9].*/, "", line) }
    /^</ && was == "" { was = substr($0, 3, 100) }
    /^>/ && is == "" { is = substr($0, 3, 100) }
    END { printf "its scene has changed, from line %d on:\n  was: %s\n  is:  %s\n", line, was, is }'
fi
