#!/usr/bin/env bash
# Renders one frame: render_frame.sh SCENE.pov PICTURE.png WIDTHxHEIGHT POVRAY_FLAG...
#
# The picture is seen whole or not at all. Called by ninja in the folder of the film; when ninja ends, so does this.
# FROND_POVRAY names another povray.
set -euo pipefail

if [[ ${FROND_TIED:-} != "$$" ]]; then
  FROND_TIED=$$ exec setpriv --pdeathsig TERM -- "$BASH" "$0" "$@"
fi

scene=$1 picture=$2 size=$3
shift 3
povinc=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../povinc" && pwd)
part=$(dirname -- "$picture")/.$(basename -- "$picture" .png).$$.part.png
log=$(mktemp)
povray=''
# shellcheck disable=SC2317  # called by traps
clean() { rm -f -- "$log" "$part" "${part%.png}.pov-state"; }
# shellcheck disable=SC2317
stop() {
  if [[ -n $povray ]]; then kill -KILL "$povray" 2>/dev/null || true; fi
  clean
  exit 143
}
trap stop TERM INT HUP
trap clean EXIT

# POV-Ray parses its options by itself and stumbles over quotes in a path: the includes come through a descriptor.
exec {includes}<"$povinc" {pictures}<"$(dirname -- "$scene")"
library=/proc/self/fd/$includes

# One thread a frame: several frames are rendered at once, and pixels then never depend on the count of threads.
setpriv --pdeathsig KILL -- "${FROND_POVRAY:-povray}" "+I$scene" "+O$part" +FN8 "+W${size%x*}" "+H${size#*x}" \
  "+L$library" "+L/proc/self/fd/$pictures" +WT1 -D -P "$@" >"$log" 2>&1 </dev/null &
povray=$!
status=0
wait "$povray" || status=$?

if ((status == 0)) && [[ -s $part ]]; then
  mv -f -- "$part" "$picture"
  exit 0
fi
{
  printf '%s could not be rendered:\n' "$scene"
  # What matters of POV-Ray's many lines: the file, the line and what was wrong.
  errors=$(sed -n "s|$library|povinc|g; /Fatal error\|Render failed/d; /Error:/,\$p" "$log" | grep . | head -n 6 || true)
  if [[ -n $errors ]]; then
    printf '%s\n' "$errors"
  else
    if ((status > 128)); then printf 'povray was ended by signal %d (out of memory?)\n' $((status - 128)); fi
    tail -n 5 "$log"
  fi
} >&2
exit 1
