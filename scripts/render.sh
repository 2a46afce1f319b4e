#!/usr/bin/env bash
# From a preset to a film: installs what is missing, builds, generates the scenes, renders and encodes them.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<'TEXT'
Usage: scripts/render.sh PRESET [options]

       scripts/render.sh PRESET --contact-seeds N | --sweep POINTER=FROM:TO:COUNT [options]   see scripts/sheet.sh --help
       scripts/render.sh --compare A B [FILE]                                                 see scripts/compare.sh --help

Leaves DIR/film.mp4 and DIR/contact.png, or DIR/still.png where the preset is a still. Renders only what changed:
interrupted or killed at any moment and run again it goes on where it stopped, also within a picture.

  -o DIR                      where to (out/<preset name>)
  --frames A-B                only these frames
  --size WxH                  size of the pictures, in pixels
  --scale N                   multiplies it, by 1 to 16: --scale 4 for the wall, --scale 1.5
  --quality draft|good|best   how well they are rendered
  --format mp4|webm|gif       of the film (mp4)
  --set POINTER=VALUE         overrides one value of the preset; may be given again
  --assets DIR                reads no file but below the preset's own folder and DIR
  --jobs N                    how many processors render (all): frames at once, or parts of a picture
  --threads N                 how many threads generate the scenes (as many)
  -h, --help                  this text

Examples:
  scripts/render.sh presets/reef.json
  scripts/render.sh presets/reef.json --frames 1-48 --size 320x180 --quality draft -o out/check
  scripts/render.sh presets/reef.json --size 1280x720 --quality best --set /seed=8 -o out/reef-8
  scripts/render.sh presets/trees/oak.json --scale 4

The files made are named on stdout, all else goes to stderr.
Exit codes: 0 done, 1 could not (disk, POV-Ray), 2 wrong input, 130 interrupted.
NO_COLOR=1 keeps messages plain. FROND_BIN, FROND_POVRAY and FROND_FFMPEG name other programs than build/frond,
povray and ffmpeg.
TEXT
}

# near_presets NAME: the presets of that name or, where there is none, of the nearest, by Levenshtein's distance.
near_presets() {
  local here=$root/presets
  if [[ $PWD -ef $root ]]; then here=presets; fi
  { find "$here" -name '*.json' ! -path "$here/grammars/*" 2>/dev/null || true; } | LC_ALL=C sort | awk -v name="$1" '
    function least(a, b) { return a < b ? a : b }
    function distance(a, b,   i, j, row, last, up) {
      for (j = 0; j <= length(b); ++j) row[j] = j
      for (i = 1; i <= length(a); ++i) {
        last = row[0]
        row[0] = i
        for (j = 1; j <= length(b); ++j) {
          up = row[j]
          row[j] = least(least(up, row[j - 1]) + 1, last + (substr(a, i, 1) != substr(b, j, 1)))
          last = up
        }
      }
      return row[length(b)]
    }
    BEGIN { best = 1 + int(length(name) / 3) }
    {
      stem = $0
      gsub(/.*\/|\.json$/, "", stem)
      d = distance(tolower(name), stem)
      if (d < best) { best = d; found = "" }
      if (d == best) found = found (found ? " and " : "") $0
    }
    END { print found }'
}

# What is not one run of one preset has a script of its own.
for argument in "$@"; do
  case $argument in
    --) break ;;
    --compare) [[ $1 == --compare ]] || bad_usage "--compare comes first: --compare A B"
      exec "$root/scripts/compare.sh" "${@:2}" ;;
    --contact-seeds | --contact-seeds=* | --sweep | --sweep=*) exec "$root/scripts/sheet.sh" "$@" ;;
  esac
done

preset='' out='' jobs='' format=mp4 pass=()
set_preset() {
  [[ -z $preset ]] || bad_usage "one preset at a time: '$preset', and then '$1'"
  [[ -n $1 ]] || bad_usage "the preset's name is empty"
  preset=$1
}
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) shift; for argument in "$@"; do set_preset "$argument"; done; break ;;
    -o | --out | --frames | --size | --scale | --quality | --format | --set | --assets | --jobs | --threads)
      (($# > 1)) || bad_usage "$1 needs a value"
      option=$1 value=$2
      shift 2
      ;;
    --out=* | --frames=* | --size=* | --scale=* | --quality=* | --format=* | --set=* | --assets=* | --jobs=* | --threads=*)
      option=${1%%=*} value=${1#*=}
      shift
      ;;
    -?*) bad_usage "unknown option '$1'" ;;
    *) set_preset "$1"; shift; continue ;;
  esac
  case $option in
    -o | --out)
      [[ -n $value ]] || bad_usage "$option needs a folder"
      out=$value
      ;;
    --jobs)
      [[ $value =~ ^[1-9][0-9]{0,3}$ ]] || bad_usage "--jobs needs a number from 1 on, not '$value'"
      jobs=$value
      ;;
    --format)
      [[ $value =~ ^(mp4|webm|gif)$ ]] || bad_usage "--format needs mp4, webm or gif, not '$value'"
      format=$value
      ;;
    *) pass+=("$option=$value") ;;  # frond knows what is right
  esac
done

[[ -n $preset ]] || bad_usage "which preset?"
if [[ ! -f $preset ]]; then
  near=$(near_presets "$(basename -- "$preset" .json)")
  fail 2 "$preset: no such preset${near:+; there is $near}"
fi
if [[ -z $out ]]; then out=out/$(basename -- "$preset" .json); fi
# A name that begins with a dash is a path, not an option.
[[ $preset == -* ]] && preset=./$preset
[[ $out == -* ]] && out=./$out

"$root/scripts/setup.sh" --quiet
if [[ -z ${FROND_BIN:-} ]]; then (tied "$root/scripts/build.sh"); fi

mkdir -p -- "$out" 2>/dev/null || fail 1 "$out: the folder cannot be made"
{ exec {lock}>"$out/.lock"; } 2>/dev/null || fail 1 "$out: cannot be written to"
if ! flock --nonblock "$lock"; then
  say "Another run is at work in $out; waiting for it"
  flock "$lock"
fi

ninja_pid='' frond_pid=''
interrupted() {
  local running
  for running in $ninja_pid $frond_pid; do
    kill -TERM "$running" 2>/dev/null || true
    wait "$running" 2>/dev/null || true
  done
  say "Interrupted. What is finished is kept: the same command goes on from there."
  exit 130
}
trap interrupted INT TERM HUP

export FROND_HOME=${FROND_HOME:-$root}  # templates and includes, wherever the program lies
say "Generating $out"
status=0
# As a child that is waited for, so that a signal to this script alone is heeded at once.
(tied "${FROND_BIN:-$root/build/frond}" generate "$preset" "--out=$out" ${pass[@]+"${pass[@]}"}) &
frond_pid=$!
wait "$frond_pid" || status=$?
frond_pid=''
case $status in
  0) ;;
  1 | 2) exit "$status" ;;
  130 | 143) interrupted ;;
  *) fail 1 "frond ended with exit code $status" ;;
esac
cd -- "$out"

targets() { ninja -t targets rule "$1" 2>/dev/null || true; }
still=$(targets still)
film=film.$format
results=("$film" contact.png)
if [[ -n $still ]]; then results=(still.png); fi
for result in "${results[@]}"; do
  if [[ -d $result ]]; then fail 1 "$out/$result is a folder; expected a file, or none"; fi
done
# What others of the kind there are is no longer of these frames, unless ninja knows it to be.
for result in film.{mp4,webm,gif} contact.png still.png; do
  if [[ -f $result && " ${results[*]} " != *" $result "* && $(ninja -n "$result" 2>&1) != *'no work to do'* ]]; then
    rm -f -- "$result"
  fi
done

frames=$(targets frame | grep -c '' || true)
if [[ -f $film && $(frames_in "$film") != "$frames" ]]; then rm -f "$film"; fi  # damaged, or another film's
to_do=$(NINJA_STATUS='' ninja -n "${results[@]}" | grep -c '^frame ' || true)
if ((to_do == 0)); then
  say "Nothing to render: all $frames frames are up to date."
elif ((to_do < frames)); then
  say "Rendering $to_do of $frames frames; the others are up to date."
else
  say "Rendering $frames frame$( ((frames == 1)) || echo s)."
fi

done_now=0 said=0
step() {  # FINISHED ALL SECONDS WHAT
  local seconds=$3 what=$4 left text
  if [[ $what != frame\ * ]]; then return; fi
  done_now=$((done_now + 1))
  left=$(((seconds * (to_do - done_now) + done_now - 1) / done_now))
  text="frame $((frames - to_do + done_now)) of $frames"
  if ((done_now < to_do)); then text+=", about $(clock "$left") left"; else text+=", rendered in $(clock "$seconds")"; fi
  if on_terminal; then
    draw_bar "$((frames - to_do + done_now))" "$frames" "$text"
  elif ((done_now == to_do || to_do <= 200 || seconds >= said + 5)); then
    said=$seconds
    say "$text"
  fi
  if ((done_now == to_do)) && [[ -z $still ]]; then say "Encoding the film"; fi
}

# Where one picture is all there is to do: how much of it is traced, by the bytes that POV-Ray has noted of it.
size=$(sed -n 's/^size = //p' build.ninja)
whole=$((${size%x*} * ${size#*x} * 20)) first='' started=0 tenth=-1
picture() {
  local now percent text
  if ((to_do != 1 || done_now > 0)); then return; fi
  now=$(cat frames/.frame_*.kept 2>/dev/null | wc -c)
  percent=$((now < whole ? now * 100 / whole : 99))
  text="$percent % of the picture"
  if [[ $now == "${first:-$now}" ]]; then  # it still reads the scene
    first=$now started=$SECONDS
  else
    text+=", about $(clock $(((SECONDS - started) * (now < whole ? whole - now : 0) / (now - first)))) left"
  fi
  if on_terminal; then
    draw_bar "$percent" 100 "$text"
  elif ((percent / 10 > tenth)); then
    tenth=$((percent / 10))
    say "$text"
  fi
}

if on_terminal && ((to_do > 1)); then draw_bar "$((frames - to_do))" "$frames" "frame $((frames - to_do)) of $frames"; fi
jobs=${jobs:-$(nproc)}
# Processors that no frame of their own keeps busy help with another.
export FROND_THREADS=$((to_do > 0 && jobs > to_do ? jobs / to_do : 1))
start_ninja -j "$jobs" "${results[@]}"
room_told=''
tell() {
  if full_disk "$1"; then set -- "ninja: $no_room"; fi
  if [[ $1 == *": $no_room" && -n $room_told ]]; then return; fi  # once is enough
  if [[ $1 == *": $no_room" ]]; then room_told=yes; fi
  say "$1"
}
follow_ninja step tell picture || case $failed in
  *frames/*) fail 1 "not all frames of $out could be rendered; those that are finished are kept" ;;
  *film.*) fail 1 "the film could not be encoded; the frames of $out are kept" ;;
  *) fail 1 "not all of $out could be made; the frames that are finished are kept" ;;
esac
if [[ -z $still ]]; then
  encoded=$(frames_in "$film")
  [[ $encoded == "$frames" ]] || fail 1 "$out/$film holds ${encoded:-0} of $frames frames"
fi
find frames -maxdepth 1 -name '.frame_*' -exec rm -rf -- {} +  # unfinished pictures that are no part of this film

for result in "${results[@]}"; do printf '%s\n' "$out/$result"; done
