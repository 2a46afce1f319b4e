#!/usr/bin/env bash
# Renders one frame.
#
# The picture is seen whole or not at all, and has the same bytes however often its rendering was killed: POV-Ray notes
# each block of pixels in a state file, and the next call goes on from there. The state bears a hash of all that makes the
# picture, so that nothing of another scene, size or quality is taken for it.
#
# A scene is a program that may open files: POV-Ray is kept to the folders of the film and of the includes. Its own I/O
# restrictions (povray.conf) are no help: in Debian's 3.7.0.10 the setting "restricted" is read and never heeded.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/render_frame.sh SCENE.pov PICTURE.png WIDTHxHEIGHT [POVRAY_FLAG...]

Renders one frame. Called by ninja in the folder of the film; when ninja ends, so does this.

Adds a line to .times in that folder: the frame, milliseconds of processor that it took, and its size.

FROND_THREADS is how many threads trace it (1); the pixels do not depend on it. FROND_POVRAY names another povray.
FROND_UNCONFINED=1 lets POV-Ray open any file that you may open, where the kernel has no Landlock (Linux 5.13).
TEXT
}
help_where_asked "$@"
[[ ${3:-} =~ ^[0-9]+x[0-9]+$ ]] || bad_usage "expected SCENE.pov PICTURE.png WIDTHxHEIGHT [POVRAY_FLAG...]"

if [[ ${FROND_TIED:-} != "$$" ]]; then FROND_TIED=$$ tied "$BASH" "$0" "$@"; fi

scene=$1 picture=$2 size=$3
shift 3
povinc=$root/povinc
folder=$(dirname -- "$picture")
name=.$(basename -- "$picture" .png)
renderer=$(command -v "${FROND_POVRAY:-povray}") || fail 1 "${FROND_POVRAY:-povray}: no such program"

[[ -f $scene ]] || fail 1 "$scene could not be rendered: it is gone"

# The soft light that the scene's first line names lies beside it.
first=$(head -n 1 -- "$scene" | tr -d '\0')
light=()
if [[ $first =~ \+RF([a-z0-9_]+\.rca) ]]; then
  light=("$(dirname -- "$scene")/${BASH_REMATCH[1]}")
  [[ -f ${light[0]} ]] || fail 1 "$scene could not be rendered: ${light[0]} is gone"
fi

# Where it says how the picture is developed, POV-Ray draws it finer.
develop=() depth=8
if [[ $first =~ ' +FN16; then frond develop --highlights '([0-9.]+)' --contrast '([0-9.]+)$ ]]; then
  develop=(--highlights "${BASH_REMATCH[1]}" --contrast "${BASH_REMATCH[2]}") depth=16
fi

# All that the picture depends on. What lies beside the scene is named by what is in it.
key=$({
  printf '%s\n' "$size" "$@"
  find "$folder" -maxdepth 1 -type f ! -name '.*' ! -name 'frame_*' -printf '%f %s\n' | LC_ALL=C sort
  sha256sum -- "$renderer" "$scene" "${light[@]}" "$povinc"/*.inc | cut -d' ' -f1
} | sha256sum | cut -c-16)

part=$folder/$name.$key.png
state=$folder/$name.$key.pov-state  # so POV-Ray calls it
kept=$folder/$name.$key.kept
plain=$folder/$name.$key.plain
log=$folder/$name.$key.log
large=$folder/$name.$key.large  # where POV-Ray keeps the pixels of a large picture
for left in "$folder/$name".*; do
  if [[ $left != "$folder/$name.$key".* ]]; then rm -rf -- "$left"; fi
done
rm -rf -- "$part" "$plain" "$large"  # not finished, or they would be in their place

povray='' status=0
# shellcheck disable=SC2317  # called by a trap
stop() {
  if [[ -n $povray ]]; then kill -KILL "$povray" 2>/dev/null || true; fi
  rm -rf -- "$log" "$part" "$plain" "$large"
  exit 143
}
trap stop TERM INT HUP

# POV-Ray does not tell a full disk from others; so it is tried what still fits, up to what this picture needs.
no_room_left() {
  local bytes=$((${size%x*} * ${size#*x} * 4))
  full_disk "$({ head -c $((bytes < 1 << 24 ? bytes : 1 << 24)) /dev/zero 2>&1 >"$plain"; } 2>/dev/null)"
}
give_up() {
  local why=$1
  if no_room_left; then why=$no_room; fi
  rm -rf -- "$log" "$part" "$plain" "$large"
  # What was traced before it was killed is good; after any other end it is not trusted.
  if ((status != 0 && status != 137)); then rm -f -- "$state" "$kept"; fi
  fail 1 "$scene could not be rendered: $why"
}

# POV-Ray removes its state before it writes the picture, which takes long if that is large: a second name keeps it.
if ! { mkdir -p -- "$large" && : >>"$kept"; } 2>/dev/null; then give_up "$folder: cannot be written to"; fi
ln -f -- "$kept" "$state" 2>/dev/null || true
if [[ -s $kept ]]; then "$root/scripts/traced.pl" "$kept"; fi
taken_up=''
if [[ -s $kept ]]; then taken_up=yes; fi

# POV-Ray parses its options by itself and stumbles over quotes in a path: folders come through descriptors.
exec {includes}<"$povinc" {pictures}<"$(dirname -- "$scene")" {scripts}<"$root/scripts"
library=/proc/self/fd/$includes

confined=()
if [[ -z ${FROND_UNCONFINED:-} ]]; then
  confined=("$root/scripts/confined.pl" --write "$folder" --read "$(dirname -- "$scene")" --read "$povinc"
    --read "$root/scripts/povray.ini" --)
fi
# In a session of its own: a signal to the whole group would make POV-Ray end in its own way, with half a picture.
POVINI=/proc/self/fd/$scripts/povray.ini POV_TEMP_DIR=$large \
  setsid setpriv --pdeathsig KILL --no-new-privs -- ${confined[@]+"${confined[@]}"} \
  "$renderer" "+I$scene" "+O$part" "+FN$depth" "+W${size%x*}" "+H${size#*x}" \
  "+L$library" "+L/proc/self/fd/$pictures" ${light[@]+"+RFI" "+RF${light[0]}"} "+WT${FROND_THREADS:-1}" +C -D -P "$@" >"$log" 2>&1 </dev/null &
povray=$!
{ wait "$povray"; } 2>/dev/null || status=$?  # without what bash says of one that was killed

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

# Notes the time that this process and its children took; where another one began the picture it says nothing.
note_time() {
  local user system spent=0 time
  if [[ -n $taken_up ]]; then return; fi
  times >"$log"
  { read -r _ && read -r user system; } <"$log"
  for time in "${user%s}" "${system%s}"; do
    spent=$((spent + ${time%m*} * 60000 + 10#$(printf '%s' "${time#*m}" | tr -d .)))
  done
  printf '%s %d %s\n' "${name#.}" "$spent" "$size" >>"$(dirname -- "$folder")/.times"
}

if ((status == 0)) && whole_png "$part" "$size"; then
  if ((${#develop[@]} > 0)); then
    "${FROND_BIN:-$root/build/frond}" develop "$part" -o "$part" "${develop[@]}" >"$log" 2>&1 || give_up "$(<"$log")"
  fi
  { timeless "$part" >"$plain"; } 2>/dev/null || give_up "its picture could not be written"
  put_in_place "$plain" "$picture"
  note_time 2>/dev/null || true
  rm -rf -- "$part" "$log" "$kept" "$large"
  exit 0
fi
[[ -f $log ]] || give_up "$folder has vanished"
# What matters of POV-Ray's many lines: the file, the line and what was wrong.
errors=$(sed -n "s|$library|povinc|g; /Fatal error\|Render failed/d; /Error:/,\$p" "$log" | grep . | head -n 6 || true)
if [[ -z $errors ]] && grep -q 'Cannot access data in file' "$log"; then
  errors="povray could not write; is there $no_room?"  # another frame may have made some since
elif [[ -z $errors ]]; then
  if ((status == 0)); then errors="povray left no whole picture"$'\n'; fi
  if ((status > 128)); then errors="povray was ended by signal $((status - 128)) (out of memory?)"$'\n'; fi
  errors+=$(tail -n 5 "$log")
fi
give_up "$errors"
