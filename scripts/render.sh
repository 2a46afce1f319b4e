#!/usr/bin/env bash
# From a preset to a film: installs what is missing, builds, generates the scenes, renders and encodes them.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"
# shellcheck source-path=SCRIPTDIR source=lib_progress.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib_progress.sh"

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
  --every K                   renders each K-th frame first, then those between, with a film preview.mp4 of what there is
  --plot FILE.svg             draws nodes, bytes and seconds of each frame
  --why N                     renders nothing; says why frame N is out of date
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

# near_presets NAME: the presets of that name or, where there is none, of the nearest.
near_presets() {
  local here=$root/presets
  if [[ $PWD -ef $root ]]; then here=presets; fi
  { find "$here" -name '*.json' ! -path "$here/grammars/*" 2>/dev/null || true; } | LC_ALL=C sort |
    sed -E 's,(.*/)?(.*)\.json$,\2\t&,' | nearest "$1"
}

# all_presets: the presets that there are, a line each, with their titles.
all_presets() {
  local file
  printf 'Usage: scripts/render.sh PRESET [options], see scripts/render.sh --help\n\n'
  find "$root/presets" -name '*.json' ! -path "$root/presets/grammars/*" | LC_ALL=C sort | while read -r file; do
    printf '%-42s %s\n' "${file#"$root/"}" "$(sed -nE '0,/"title"/s/.*"title": *"([^"]*)".*/\1/p' "$file")"
  done
  printf '\nA preset of your own to begin with: build/frond new my_tree --from tree\n'
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

if (($# == 0)); then all_presets; exit 0; fi

preset='' out='' jobs='' format=mp4 every=1 plot='' why='' pass=()
set_preset() {
  [[ -z $preset ]] || bad_usage "one preset at a time: '$preset', and then '$1'"
  [[ -n $1 ]] || bad_usage "the preset's name is empty"
  preset=$1
}
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) shift; for argument in "$@"; do set_preset "$argument"; done; break ;;
    -o | --out | --frames | --size | --scale | --quality | --set | --assets | --jobs | --threads | --format | --every | --plot | \
      --why)
      (($# > 1)) || bad_usage "$1 needs a value"
      option=$1 value=$2
      shift 2
      ;;
    --out=* | --frames=* | --size=* | --scale=* | --quality=* | --set=* | --assets=* | --jobs=* | --threads=* | --format=* | \
      --every=* | --plot=* | --why=*)
      option=${1%%=*} value=${1#*=}
      shift
      ;;
    -?*) unknown_option "$1" ;;
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
    --every | --why)
      [[ $value =~ ^[1-9][0-9]{0,8}$ ]] || bad_usage "$option needs a number from 1 on, not '$value'"
      if [[ $option == --every ]]; then every=$value; else why=$value; fi
      ;;
    --plot)
      [[ $value == *.svg ]] || bad_usage "--plot needs a name that ends in .svg, not '$value'"
      plot=$(realpath -m -- "$value")
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

renderer=${FROND_POVRAY:-povray}
command -v "$renderer" >/dev/null || fail 1 "$renderer: no such program; it is what renders"
mkdir -p -- "$out" 2>/dev/null || fail 1 "$out: the folder cannot be made"
no_link "$out/.lock"
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

if [[ -n $why ]]; then
  old_scene=$(mktemp)
  trap 'rm -f -- "$old_scene"' EXIT
  cp -- "$(printf '%s/frames/frame_%04d.pov' "$out" "$why")" "$old_scene" 2>/dev/null || true
fi
export FROND_HOME=${FROND_HOME:-$root}  # templates and includes, wherever the program lies
"$root/scripts/pace.sh" || true
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
if [[ -n $why ]]; then
  "$root/scripts/why.sh" "$out" "$why" "$old_scene"
  exit
fi
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

mapfile -t pictures < <(targets frame | sort -V)
frames=${#pictures[@]}
for picture in "${pictures[@]}"; do
  [[ -f ${picture%.png}.pov ]] || fail 1 "$out/${picture%.png}.pov is gone; the same command writes it again"
done
if [[ -f $film && $(frames_in "$film") != "$frames" ]]; then rm -f "$film"; fi  # damaged, or another film's
mapfile -t numbers < <(NINJA_STATUS='' ninja -n "${results[@]}" | sed -n 's/^frame //p')
to_do=${#numbers[@]}
if ((to_do == 0)); then
  say "Nothing to render: all $frames frames are up to date."
elif ((to_do < frames)); then
  say "Rendering $to_do of $frames frames; the others are up to date."
else
  say "Rendering $frames frame$( ((frames == 1)) || echo s)."
fi
jobs=${jobs:-$(nproc)}
size=$(sed -n 's/^size = //p' build.ninja)
begin_progress "$size" "$jobs" < <(printf '%s\n' ${numbers[@]+"${numbers[@]}"})
if [[ -f .times ]]; then timed=$(grep -c '' .times || true); else timed=0; fi

said=$SECONDS pause=10 tenth=-1
# shellcheck disable=SC2154  # of lib_progress.sh
step() {  # FINISHED ALL SECONDS WHAT
  local what=$4 left text
  if [[ $what != frame\ * ]]; then return; fi
  frame_done "${what#frame }"
  look_at_notes
  text="frame $((frames - to_do + frames_now)) of $frames" left=$(seconds_left)
  if ((frames_now == to_do)); then text+=", rendered in $(clock "$(seconds_taken)")"
  elif [[ -n $left ]]; then text+=", about $(clock "$left") left"; fi
  if on_terminal; then
    draw_bar "$((frames - to_do + frames_now))" "$frames" "$text"
  elif ((frames_now == to_do || to_do <= 200 || SECONDS >= said + 5)); then
    said=$SECONDS
    say "$text"
  fi
  if ((frames_now == to_do)) && [[ -z $still ]]; then say "Encoding the film"; fi
}

# What is said while no frame ends: how much of those at work is traced.
idle() {
  local percent left text
  if ((frames_now >= to_do)); then return; fi
  look_at_notes
  percent=$(percent_done) left=$(seconds_left)
  text="$percent % of the $( ((to_do == 1)) && echo picture || echo "$to_do frames")"
  if [[ -n $left ]]; then text+=", about $(clock "$left") left"; fi
  if [[ -z $_read ]]; then text+=", reading the scene"; fi
  if on_terminal; then
    draw_bar "$percent" 100 "$text"
  elif ((to_do == 1 && percent / 10 > tenth || SECONDS >= said + pause)); then
    tenth=$((percent / 10)) said=$SECONDS pause=$((pause < 60 ? pause * 2 : pause))
    say "$text"
  fi
}

# Processors that no frame of their own keeps busy help with another.
export FROND_THREADS=$((to_do > 0 && jobs > to_do ? jobs / to_do : 1))
room_told='' faults=0
tell() {
  if full_disk "$1"; then set -- "ninja: $no_room"; fi
  if [[ $1 == *": $no_room" ]]; then
    if [[ -n $room_told ]]; then return; fi  # once is enough, and no other frame would fare better
    room_told=yes
    kill -TERM "$ninja_pid" 2>/dev/null || true
  fi
  if [[ $1 == error:* ]]; then faults=$((faults + 1)); fi
  if ((faults == 6)); then say "What else fails is not shown."; faults=7; fi
  if ((faults < 6)); then say "$1"; fi
}

# make TARGET...: a frame that fails does not stop the others. What has failed stands in $broken.
broken='' stopped=''
make() {
  if [[ -n $stopped || $# == 0 ]]; then return; fi
  start_ninja -k 0 -j "$jobs" "$@"
  if follow_ninja step tell idle; then return; fi
  broken+=$failed
  if [[ -z $failed || -n $room_told ]]; then stopped=yes; fi
}
# pictures_of K: each K-th of all pictures, but for those that have failed
pictures_of() {
  local i
  for ((i = 0; i < frames; i += $1)); do
    if [[ " $broken " != *" ${pictures[i]} "* ]]; then printf '%s\n' "${pictures[i]}"; fi
  done
}

fps=$(sed -n 's/^fps = //p' build.ninja)
for ((k = every < frames ? every : frames; k > 1 && to_do > 0; k /= 2)); do
  before=$frames_now
  mapfile -t wanted < <(pictures_of "$k")
  make "${wanted[@]}"
  if [[ -n $broken$stopped ]] || ((frames_now == before || frames_now == to_do)); then continue; fi
  printf '%s\n' "${wanted[@]}" >preview.mp4.list
  "$root/scripts/encode_film.sh" preview.mp4.list preview.mp4 "$(awk -v fps="$fps" -v k="$k" 'BEGIN { print fps / k }')" preview
  rm -f preview.mp4.list
  say "One of $k frames is there, and a film of them: $out/preview.mp4"
done
if [[ -z $broken ]]; then
  make "${results[@]}"
else
  mapfile -t wanted < <(pictures_of 1)
  make "${wanted[@]}"
fi
if [[ -n $stopped || -n $broken ]]; then
  mapfile -t which < <(tr ' ' '\n' <<<"$broken" | sed -n 's/^frames\/frame_0*\([0-9]*\)\.png$/\1/p' | sort -nu)
  if ((${#which[@]} > 0)); then
    list=${which[*]:0:12}
    if ((${#which[@]} > 12)); then list+=" ..."; fi
    fail 1 "of $out these frames could not be rendered: ${list// /, }; those that are finished are kept"
  fi
  [[ $broken != *film.* ]] || fail 1 "the film could not be encoded; the frames of $out are kept"
  fail 1 "not all of $out could be made; the frames that are finished are kept"
fi
if [[ -z $still ]]; then
  encoded=$(frames_in "$film")
  [[ $encoded == "$frames" ]] || fail 1 "$out/$film holds ${encoded:-0} of $frames frames"
fi
find frames -maxdepth 1 -name '.frame_*' -exec rm -rf -- {} +  # unfinished pictures that are no part of this film
rm -f preview.mp4 preview.mp4.list
if ((frames_now > 0)); then "$root/scripts/pace.sh" . "$timed" || true; fi
if ((frames_now > 1)); then
  tail -n +$((timed + 1)) .times 2>/dev/null | sort -k2,2nr | awk '
    { all += $2; if (NR <= 3) slow = slow sprintf("%s%d (%.1f s)", NR > 1 ? ", " : "", substr($1, 7), $2 / 1000) }
    END { if (NR) printf "%.0f s of processor; the slowest frames: %s\n", all / 1000, slow }' >&2
fi

if [[ -n $plot ]]; then "$root/scripts/plot.sh" . "$plot"; fi
for result in "${results[@]}"; do printf '%s\n' "$out/$result"; done
