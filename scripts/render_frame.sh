#!/usr/bin/env bash
# Renders one frame.
#
# The picture is seen whole or not at all, and has the same bytes however often its rendering was killed: POV-Ray notes
# each block of pixels in a state file, and the next call goes on from there. The state bears a hash of all that makes the
# picture, so that nothing of another scene, size or quality is taken for it.
#
# Where motion is blurred, the picture is the mean light of several exposures, each a scene of its own: frame_0001.pov,
# frame_0001_s2.pov and so on. Those that are drawn are kept until all are.
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
develop=() depth=8 scenes=("$scene")
if [[ $first =~ ' +FN16'('; exposure 1 of '([0-9]+))?'; then frond develop --highlights '([0-9.]+)' --contrast '([0-9.]+)$ ]]; then
  develop=(--highlights "${BASH_REMATCH[3]}" --contrast "${BASH_REMATCH[4]}") depth=16
  for ((i = 2; i <= ${BASH_REMATCH[2]:-1}; ++i)); do scenes+=("${scene%.pov}_s$i.pov"); done
fi
for one in "${scenes[@]}"; do
  [[ -f $one ]] || fail 1 "$scene could not be rendered: its exposure $one is gone"
done

# All that the picture depends on. What lies beside the scene is named by what is in it.
key=$({
  printf '%s\n' "$size" "$@"
  find "$folder" -maxdepth 1 -type f ! -name '.*' ! -name 'frame_*' -printf '%f %s\n' | LC_ALL=C sort
  sha256sum -- "$renderer" "${scenes[@]}" "${light[@]}" "$povinc"/*.inc | cut -d' ' -f1
} | sha256sum | cut -c-16)

plain=$folder/$name.$key.plain
log=$folder/$name.$key.log
large=$folder/$name.$key.large  # where POV-Ray keeps the pixels of a large picture
spent=$folder/$name.$key.spent  # milliseconds that earlier runs took for it; a ? where one was killed before it said
# names NUMBER: those of an exposure's files.
names() {
  local base=$folder/$name.$key
  if ((${#scenes[@]} > 1)); then base+=.$1; fi
  part=$base.png
  state=$base.pov-state  # so POV-Ray calls it
  kept=$base.kept
  exposed=$base.exposed  # a whole exposure
}
names 1
for left in "$folder/$name".*; do
  if [[ $left != "$folder/$name.$key".* ]]; then rm -rf -- "$left"; fi
done
find "$folder" -maxdepth 1 -type l -name "$name.*" -delete  # nothing is written through a link
rm -rf -- "$plain" "$large"  # not finished, or they would be in their place

before=0
if [[ -s $spent && $(<"$spent") != '?' ]]; then
  before=$(<"$spent")
elif find "$folder" -maxdepth 1 \( -name "$name.$key*.kept" -o -name "$name.$key.*.exposed" \) -size +0 | grep -q .; then
  before='?'
fi
{ echo '?' >"$spent"; } 2>/dev/null || true

# Sets $took to the milliseconds of processor that what was started took, now and in earlier runs; empty where that is not
# known.
count_time() {
  local time times=()
  took=$before
  if [[ ! $before =~ ^[0-9]+$ ]]; then took='' && return; fi
  times >"$log"
  { read -r _ && read -r -a times; } <"$log"
  for time in "${times[@]%s}"; do
    took=$((took + ${time%m*} * 60000 + 10#$(printf '%s' "${time#*m}" | tr -d .)))
  done
}
# For the next run, which takes up what was traced.
note_time() {
  count_time
  if [[ -n $took ]]; then printf '%d' "$took" >"$spent"; fi
}

povray='' status=0 drawn=()
# shellcheck disable=SC2317  # called by a trap
stop() {
  if [[ -n $povray ]]; then
    kill -KILL "$povray" 2>/dev/null || true
    { wait "$povray"; } 2>/dev/null || true
  fi
  note_time 2>/dev/null || true
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
  # What was traced before it was killed is good; after any other end it is not trusted.
  if ((status != 0 && status != 137)); then
    rm -f -- "$state" "$kept"
    if ((${#drawn[@]} <= 1)); then rm -f -- "$spent"; fi
  else
    note_time 2>/dev/null || true
  fi
  rm -rf -- "$log" "$part" "$plain" "$large"
  fail 1 "$scene could not be rendered: $why"
}

# POV-Ray parses its options by itself and stumbles over quotes in a path: folders come through descriptors.
exec {includes}<"$povinc" {pictures}<"$(dirname -- "$scene")" {scripts}<"$root/scripts"
library=/proc/self/fd/$includes

confined=()
if [[ -z ${FROND_UNCONFINED:-} ]]; then
  confined=("$root/scripts/confined.pl" --write "$folder" --read "$(dirname -- "$scene")" --read "$povinc"
    --read "$root/scripts/povray.ini" --)
fi

# why: what matters of POV-Ray's many lines: the file, the line and what was wrong.
why() {
  local errors
  errors=$(sed -n "s|$library|povinc|g; /Fatal error\|Render failed/d; /Error:/,\$p" "$log" | grep . | head -n 6 || true)
  if [[ -z $errors ]] && grep -q 'Cannot access data in file' "$log"; then
    errors="povray could not write; is there $no_room?"  # another frame may have made some since
  elif [[ -z $errors ]]; then
    if ((status == 0)); then errors="povray left no whole picture"$'\n'; fi
    if ((status > 128)); then errors="povray was ended by signal $((status - 128)) (out of memory?)"$'\n'; fi
    errors+=$(tail -n 5 "$log")
  fi
  printf '%s' "$errors"
}

# expose SCENE FLAG...: draws it as $part, from where it was left.
expose() {
  local scene=$1
  shift
  status=0
  rm -f -- "$part"
  # POV-Ray removes its state before it writes the picture, which takes long if that is large: a second name keeps it.
  if ! { mkdir -p -- "$large" && : >>"$kept"; } 2>/dev/null; then give_up "$folder: cannot be written to"; fi
  ln -f -- "$kept" "$state" 2>/dev/null || true
  if [[ -s $kept ]]; then "$root/scripts/traced.pl" "$kept"; fi
  # In a session of its own: a signal to the whole group would make POV-Ray end in its own way, with half a picture.
  POVINI=/proc/self/fd/$scripts/povray.ini POV_TEMP_DIR=$large \
    setsid setpriv --pdeathsig KILL --no-new-privs -- ${confined[@]+"${confined[@]}"} \
    "$renderer" "+I$scene" "+O$part" "+FN$depth" "+W${size%x*}" "+H${size#*x}" \
    "+L$library" "+L/proc/self/fd/$pictures" ${light[@]+"+RFI" "+RF${light[0]}"} "+WT${FROND_THREADS:-1}" +C -D -P "$@" >"$log" 2>&1 </dev/null &
  povray=$!
  { wait "$povray"; } 2>/dev/null || status=$?  # without what bash says of one that was killed
  povray=''
  if ((status == 0)) && whole_png "$part" "$size"; then return; fi
  [[ -f $log ]] || give_up "$folder has vanished"
  give_up "$(why)"
}

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

for i in "${!scenes[@]}"; do
  names $((i + 1))
  if ((${#scenes[@]} == 1)); then
    drawn=("$part")
    expose "$scene" "$@"
    break
  fi
  drawn+=("$exposed")
  if whole_png "$exposed" "$size"; then continue; fi
  expose "${scenes[i]}" "$@"
  put_in_place "$part" "$exposed"
  rm -f -- "$kept"
done

names 1
if ((${#develop[@]} > 0)); then
  "${FROND_BIN:-$root/build/frond}" develop "${drawn[@]}" -o "$part" "${develop[@]}" >"$log" 2>&1 || give_up "$(<"$log")"
fi
{ timeless "$part" >"$plain"; } 2>/dev/null || give_up "its picture could not be written"
put_in_place "$plain" "$picture"
# What it took; where a run was killed that could not say it, nothing is noted.
{
  count_time
  noted=$(dirname -- "$folder")/.times
  if [[ -n $took && ! -L $noted ]]; then printf '%s %d %s\n' "${name#.}" "$took" "$size" >>"$noted"; fi
} 2>/dev/null || true
rm -rf -- "$folder/$name.$key".*
