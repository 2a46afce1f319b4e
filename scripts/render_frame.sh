#!/usr/bin/env bash
# Renders one frame: render_frame.sh SCENE.pov PICTURE.png WIDTHxHEIGHT POVRAY_FLAG...
#
# The picture is seen whole or not at all, and has the same bytes however often its rendering was killed: POV-Ray notes
# each block of pixels in a state file, and the next call goes on from there. The state bears a hash of all that makes the
# picture, so that nothing of another scene, size or quality is taken for it.
#
# FROND_THREADS is how many threads trace it (1); the pixels do not depend on it. Called by ninja in the folder of the
# film; when ninja ends, so does this. FROND_POVRAY names another povray.
set -euo pipefail

if [[ ${FROND_TIED:-} != "$$" ]]; then
  FROND_TIED=$$ exec setpriv --pdeathsig TERM -- "$BASH" "$0" "$@"
fi

scene=$1 picture=$2 size=$3
shift 3
povinc=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../povinc" && pwd)
folder=$(dirname -- "$picture")
name=.$(basename -- "$picture" .png)
renderer=$(command -v "${FROND_POVRAY:-povray}") || { echo "${FROND_POVRAY:-povray}: no such program" >&2; exit 1; }

# All that the picture depends on. What lies beside the scene is named by what is in it.
key=$({
  printf '%s\n' "$size" "$@"
  find "$folder" -maxdepth 1 -type f ! -name '.*' ! -name 'frame_*' -printf '%f %s\n' | LC_ALL=C sort
  sha256sum -- "$renderer" "$scene" "$povinc"/*.inc | cut -d' ' -f1
} | sha256sum | cut -c-16)

part=$folder/$name.$key.png
state=$folder/$name.$key.pov-state  # so POV-Ray calls it
kept=$folder/$name.$key.kept
plain=$folder/$name.$key.plain
log=$folder/$name.$key.log
for left in "$folder/$name".*; do
  if [[ $left != "$folder/$name.$key".* ]]; then rm -f -- "$left"; fi
done
rm -f -- "$part" "$plain"  # not finished, or they would be in their place

povray=''
# shellcheck disable=SC2317  # called by a trap
stop() {
  if [[ -n $povray ]]; then kill -KILL "$povray" 2>/dev/null || true; fi
  rm -f -- "$log" "$part" "$plain"
  exit 143
}
trap stop TERM INT HUP

# POV-Ray removes its state before it writes the picture, which takes long if that is large: a second name keeps it.
: >>"$kept"
ln -f -- "$kept" "$state" 2>/dev/null || true

# POV-Ray parses its options by itself and stumbles over quotes in a path: the includes come through a descriptor.
exec {includes}<"$povinc" {pictures}<"$(dirname -- "$scene")"
library=/proc/self/fd/$includes

# In a session of its own: a signal to the whole group would make POV-Ray end in its own way, with half a picture.
setsid setpriv --pdeathsig KILL -- "$renderer" "+I$scene" "+O$part" +FN8 "+W${size%x*}" "+H${size#*x}" \
  "+L$library" "+L/proc/self/fd/$pictures" "+WT${FROND_THREADS:-1}" +C -D -P "$@" >"$log" 2>&1 </dev/null &
povray=$!
status=0
wait "$povray" || status=$?

# A PNG without its chunks of time and text: POV-Ray writes the hour into its pictures.
timeless() {
  local at=8 end type bytes
  head -c 8 -- "$1"
  while read -r -a bytes < <(od -An -v -tu1 -j "$at" -N 4 -- "$1"); do
    end=$((at + ((bytes[0] * 256 + bytes[1]) * 256 + bytes[2]) * 256 + bytes[3] + 12))
    type=$(head -c $((at + 8)) -- "$1" | tail -c 4)
    if [[ $type == IDAT ]]; then break; fi
    if [[ $type != tIME && $type != tEXt ]]; then head -c "$end" -- "$1" | tail -c $((end - at)); fi
    at=$end
  done
  tail -c +$((at + 1)) -- "$1"
}

if ((status == 0)) && [[ -s $part ]]; then
  timeless "$part" >"$plain"
  mv -f -- "$plain" "$picture"
  rm -f -- "$part" "$log" "$kept"
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
rm -f -- "$log" "$part"
# What was traced before it was killed is good; after any other end it is not trusted.
if ((status != 137)); then rm -f -- "$state" "$kept"; fi
exit 1
