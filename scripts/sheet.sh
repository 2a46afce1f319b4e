#!/usr/bin/env bash
# A sheet of stills of one preset, over seeds or over a value of it.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/sheet.sh PRESET --sweep POINTER=FROM:TO:COUNT [options of render.sh]
       scripts/sheet.sh PRESET --contact-seeds N [options of render.sh]

Leaves DIR/sheet.png: a labelled picture for each of COUNT values of the preset at that JSON pointer, or for the seeds
1 to N. Two of these options make a grid, the first from left to right. Of a film it takes the last frame.
Pictures are kept in DIR/pictures: the next sheet renders only those that it does not find there.

  -o DIR         where to (out/<preset name>-sheet)
  --frames N-N   of a film, this frame

Examples:
  scripts/sheet.sh presets/trees/oak.json --contact-seeds 9 --size 320x240 --quality draft
  scripts/sheet.sh presets/thicket.json --sweep /organisms/0/pitch=10:60:6 --sweep /organisms/0/steps=2:4:3
TEXT
}

preset='' out='' frame='' pass=() about=() pointers=() lists=()
# sweep POINTER=FROM:TO:COUNT: notes the values
sweep() {
  local number='-?[0-9]+(\.[0-9]+)?([eE][-+]?[0-9]+)?'
  [[ $1 =~ ^(/.*)=($number):($number):([1-9][0-9]?)$ ]] ||
    bad_usage "--sweep needs POINTER=FROM:TO:COUNT, as in /organisms/0/pitch=10:60:6, not '$1'"
  ((${#pointers[@]} < 2)) || bad_usage "a sheet has two directions, not three"
  pointers+=("${BASH_REMATCH[1]}")
  lists+=("$(awk -v a="${BASH_REMATCH[2]}" -v b="${BASH_REMATCH[5]}" -v n="${BASH_REMATCH[8]}" \
    'BEGIN { for (i = 0; i < n; ++i) printf "%.6g ", a + (n > 1 ? i * (b - a) / (n - 1) : 0) }')")
}
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --) shift; preset=${1:-}; break ;;
    --*=*) option=${1%%=*} value=${1#*=}; shift ;;
    -?*)
      (($# > 1)) || bad_usage "$1 needs a value"
      option=$1 value=$2
      shift 2
      ;;
    *)
      [[ -z $preset ]] || bad_usage "one preset at a time: '$preset', and then '$1'"
      preset=$1
      shift
      continue
      ;;
  esac
  case $option in
    -o | --out) out=$value ;;
    --frames)
      frame=${value%%-*}
      [[ $frame =~ ^[1-9][0-9]*$ && ($value == "$frame" || $value == "$frame-$frame") ]] ||
        bad_usage "--frames needs one frame, as in 40-40, not '$value'"
      ;;
    --sweep) sweep "$value" ;;
    --contact-seeds)
      [[ $value =~ ^[1-9][0-9]?$ ]] || bad_usage "--contact-seeds needs a number from 1 to 99, not '$value'"
      sweep "/seed=1:$value:$value"
      ;;
    *)
      pass+=("$option=$value")
      if [[ $option != --jobs && $option != --threads && $option != --format ]]; then about+=("$option=$value"); fi
      ;;
  esac
done
[[ -n $preset ]] || bad_usage "which preset?"
((${#pointers[@]} > 0)) || bad_usage "over what? --sweep or --contact-seeds"
if [[ ! -f $preset ]]; then exec "$root/scripts/render.sh" -- "$preset"; fi  # which knows what there is
out=${out:-out/$(basename -- "$preset" .json)-sheet}
[[ $preset == -* ]] && preset=./$preset
[[ $out == -* ]] && out=./$out

"$root/scripts/setup.sh" --quiet
if [[ -z ${FROND_BIN:-} ]]; then (tied "$root/scripts/build.sh"); fi
export FROND_BIN=${FROND_BIN:-$root/build/frond} FROND_HOME=${FROND_HOME:-$root}
if [[ -z $frame ]]; then
  frame=$("$FROND_BIN" info "$preset" --json ${about[@]+"${about[@]}"} | sed -n 's/.*"frames": \([0-9]*\).*/\1/p') || exit 2
fi
printf -v picture 'frames/frame_%04d.png' "$frame"

# What a picture is called by: the last step of its pointer, with the one before where that is an index.
names=()
for pointer in "${pointers[@]}"; do
  name=${pointer##*/}
  if [[ $name =~ ^[0-9]+$ ]]; then name=${pointer%/*} name=${name##*/}/${pointer##*/}; fi
  names+=("$name")
done
if [[ ${names[0]} == "${names[1]:-}" ]]; then names=("${pointers[@]}"); fi

no_link "$out/pictures"
mkdir -p -- "$out/pictures" 2>/dev/null || fail 1 "$out: the folder cannot be made"
out=$(realpath -- "$out")
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
read -r -a across <<<"${lists[0]}"
read -r -a down <<<"${lists[1]:-none}"
all=$((${#across[@]} * ${#down[@]})) texts=() folders=()
for second in "${down[@]}"; do
  for first in "${across[@]}"; do
    sets=("--set=${pointers[0]}=$first") text="${names[0]} $first"
    if [[ $second != none ]]; then sets+=("--set=${pointers[1]}=$second") text+="   ${names[1]} $second"; fi
    texts+=("$text")
    say "Picture ${#texts[@]} of $all: $text"
    # Its folder is named by what is set, so that another sheet finds it.
    folder=$out/pictures/$(printf '%s\n' "${sets[@]}" | sha256sum | cut -c-12)
    (tied "$root/scripts/render.sh" "$preset" -o "$folder" ${pass[@]+"${pass[@]}"} "${sets[@]}" "--frames=$frame-$frame") >/dev/null ||
      fail $? "picture ${#texts[@]} of $all ($text) could not be made; those before it are kept"
    folders+=("$folder")
  done
done

cd -- "$work"
width=$(sed -n 's/^size = \([0-9]*\)x.*/\1/p' "$folder/build.ninja")
for i in "${!texts[@]}"; do label "label$i." "${texts[i]}" "$width"; done
for i in "${!folders[@]}"; do
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -y -i "file:${folders[i]}/$picture" \
    -vf "format=rgb24,$(labelled "label$i.")" -frames:v 1 -update 1 "$i.png" || fail 1 "${folders[i]}/$picture could not be labelled"
  printf '%s\n' "$work/$i.png" >>list
done

columns=${#across[@]}
if [[ $second == none ]]; then
  columns=1
  while ((columns * columns < all)); do columns=$((columns + 1)); done
fi
"$root/scripts/contact_sheet.sh" "$work/list" "$out/sheet.png" "$columns" 16384
printf '%s\n' "$out/sheet.png"
