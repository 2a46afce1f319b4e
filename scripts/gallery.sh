#!/usr/bin/env bash
# Renders the pictures of docs/gallery from the presets as they are, only those that changed, and lists them.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/gallery.sh [-o DIR] [--large] [NAME...]

Renders the pictures that docs/gallery/pictures.txt lists, all or those of the names given, at the quality "good". DIR (out/gallery) keeps
what they are made of: interrupted and run again it goes on where it stopped. docs/gallery.md lists all pictures with
the seconds of processor that POV-Ray took, here or where they were rendered last.

--large renders the best of them 1280 pixels wide, into docs/gallery/large, and lists nothing: those of
$best
TEXT
}
best="reef garden forest stone_bridge ivy-brick_wall rocks reef-flight reef-dusk tree-cherry meadow"
work=out/gallery large=''
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    -o) if (($# < 2)); then bad_usage "-o: expected a folder"; fi; work=$2 && shift 2 ;;
    --large) large=yes && shift ;;
    -*) bad_usage "$1: no such option" ;;
    *) break ;;
  esac
done
if [[ -n $large ]]; then
  for name in "$@"; do
    if [[ " $best " != *" $name "* ]]; then bad_usage "$name: no picture of --large; expected some of $best"; fi
  done
  if (($# == 0)); then read -r -a names <<<"$best" && set -- "${names[@]}"; fi
fi
frond=${FROND_BIN:-$root/build/frond}
mkdir -p -- "$work"
work=$(cd -- "$work" && pwd)

pictures() { grep -v '^#' -- "$root/docs/gallery/pictures.txt"; }

# still ITEM SIZE FOLDER: names the picture.
still() {
  local words frame preset set=() word
  IFS=, read -r -a words <<<"$1"
  preset=${words[0]%@*}
  frame=1
  if [[ ${words[0]} == *@* ]]; then frame=${words[0]#*@}; fi
  for word in "${words[@]:1}"; do set+=(--set "$word"); done
  "$frond" generate "$root/presets/$preset.json" -o "$3" --frames "$frame-$frame" --size "$2" --quality good \
    ${set[@]+"${set[@]}"} -q >&2
  (cd -- "$3" && ninja "frames/$(printf 'frame_%04d.png' "$frame")" >&2)
  printf '%s/frames/frame_%04d.png\n' "$3" "$frame"
}

# row_of NAME SIZE ITEMS...: its row of docs/gallery.md; nodes and seconds are those of all its parts.
row_of() {
  local name=$1 size=$2 item presets='' seed='' nodes=0 milliseconds=0 folder i=0 took seconds
  for item in "${@:3}"; do
    folder=$work/$name-$((i++)) item=${item%%,*}
    if [[ $presets != *"${item%@*}.json"* ]]; then presets+="${presets:+, }presets/${item%@*}.json"; fi
    seed=$(sed -nE 's/.*"seed": *([0-9]+).*/\1/p' "$folder/manifest.json" | head -n 1)
    nodes=$((nodes + $(sed -nE 's/.*"nodes": *([0-9]+).*/\1/p' "$folder/manifest.json" | tail -n 1)))
    took=$(tail -n 1 -- "$folder/.times" 2>/dev/null | cut -d' ' -f2 || true)
    if [[ -z $took ]]; then milliseconds=''; fi
    if [[ -n $milliseconds ]]; then milliseconds=$((milliseconds + took)); fi
  done
  # Where a run was killed that could not say what it took, the row keeps what it had.
  if [[ -n $milliseconds ]]; then
    seconds=$(((milliseconds + 500) / 1000))
  else
    seconds=$(sed -nE "s#.*gallery/${name//./\\.}\.jpg.*\| ([0-9]+) \|\$#\1#p" "$root/docs/gallery.md" 2>/dev/null || true)
  fi
  printf '| <img src="gallery/%s.jpg" width="200"> | %s | %s | %s | %d | %s |\n' \
    "$name" "$presets" "$size" "$seed" "$nodes" "${seconds:-?}"
}

mkdir -p -- "$work/rows"
while read -r name size columns items; do
  if (($# > 0)) && [[ " $* " != *" $name "* ]]; then continue; fi
  inputs=() layout='' count=0 place=docs/gallery/$name.jpg made=$work/$name
  if [[ -n $large ]]; then
    size=1280x$(((${size#*x} * 1280 + ${size%x*} / 2) / ${size%x*})) place=docs/gallery/large/$name.jpg made=$work/$name-large
  fi
  for item in $items; do
    picture=$(still "$item" "$size" "$made-$count") || fail 1 "$name could not be rendered"
    inputs+=(-i "$picture")
    row=$((count / columns))
    layout+="${layout:+|}$((count % columns * (${size%x*} + 4)))_$((row * (${size#*x} + 4)))"
    count=$((count + 1))
  done
  sheet=()
  if ((count > 1)); then sheet=(-filter_complex "xstack=inputs=$count:layout=$layout:fill=white"); fi
  part=$made.jpg
  ffmpeg -y -loglevel error "${inputs[@]}" ${sheet[@]+"${sheet[@]}"} -bitexact -q:v 3 "$part" </dev/null
  mkdir -p -- "$root/${place%/*}"
  mv -fT -- "$part" "$root/$place"
  # shellcheck disable=SC2086  # several
  if [[ -z $large ]]; then row_of "$name" "$size" $items >"$work/rows/$name"; fi
  printf '%s\n' "$place"
done < <(pictures)
if [[ -n $large ]]; then exit 0; fi

# The scenes of docs/examples: their first lines hold the commands that make what they include.
for scene in "$root"/docs/examples/*.pov; do
  name=example-$(basename -- "$scene" .pov)
  if (($# > 0)) && [[ " $* " != *" $name "* ]]; then continue; fi
  mkdir -p -- "$work/$name"
  while read -r -a words; do
    for i in "${!words[@]}"; do
      case ${words[i]} in
        presets/*) words[i]=$root/${words[i]} ;;
        *.inc) include=$work/$name/${words[i]} && words[i]=$include ;;
      esac
    done
    [[ -f $include ]] || "$frond" "${words[@]}" -q >&2 || fail 1 "$include could not be made"
  done < <(sed -n 's|^//   frond ||p' "$scene")
  size=$(sed -nE 's|^// Then: .* \+W([0-9]+) \+H([0-9]+) .*|+W\1 +H\2|p' "$scene")
  # shellcheck disable=SC2086  # two words
  (cd -- "$work/$name" && povray "+I$scene" "+O$name.png" $size +A -D >&2 2>/dev/null) || fail 1 "$name could not be rendered"
  ffmpeg -y -loglevel error -i "$work/$name/$name.png" -bitexact -q:v 3 "$work/$name.jpg" </dev/null
  mv -fT -- "$work/$name.jpg" "$root/docs/gallery/$name.jpg"
  printf '%s\n' "docs/gallery/$name.jpg"
done

# The grammars of presets/grammars, each before the studio's wall, with its name below. At this size a draft shows all.
if (($# == 0)) || [[ " $* " == *" grammars "* ]]; then
  mkdir -p -- "$work/grammars"
  list=$work/grammars/list
  : >"$list"
  for grammar in "$root"/presets/grammars/*.json; do
    name=$(basename -- "$grammar" .json) place=$work/grammars/$name
    if [[ $name == algae ]]; then continue; fi # nothing that a turtle would draw
    while IFS= read -r line; do
      case $line in
        @organs@) if grep -q '~b' "$grammar"; then printf '"organs": [{"symbol": "b", "shape": "bud", "size": 0.03, "colors": ["#b8622f"]}],\n'; fi ;;
        @grammar@) cat -- "$grammar" ;;
        *) printf '%s\n' "$line" ;;
      esac
    done <"$root/docs/gallery/grammar.txt" >"$place.json"
    "$frond" generate "$place.json" -o "$place" --size 200x200 --quality draft -q >&2
    (cd -- "$place" && ninja frames/frame_0001.png >&2)
    # Names are of letters, digits and underscores, which need no quotes in a filter.
    ffmpeg -y -loglevel error -i "$place/frames/frame_0001.png" -vf "format=rgb24,pad=iw:ih+28:0:0:0x202020,drawtext=text=$name:\
fontcolor=white:fontsize='clip(w/14,8,16)':x='max(0,(w-tw)/2)':y=h-20" "$place.png" </dev/null
    printf '%s\n' "$place.png" >>"$list"
  done
  "$frond" film "$list" "$work/grammars.png" --columns 8 --width 200
  ffmpeg -y -loglevel error -i "$work/grammars.png" -bitexact -q:v 3 "$work/grammars.jpg" </dev/null
  mv -fT -- "$work/grammars.jpg" "$root/docs/gallery/grammars.jpg"
  printf 'docs/gallery/grammars.jpg\n'
fi

# What was not rendered now keeps its row.
list=$root/docs/gallery.md
{
  printf '# Gallery\n\nEvery picture is made by scripts/gallery.sh from the preset as it is, at the quality "good". Some lead to larger ones.\n\n'
  printf '| picture | preset | size | seed | nodes | seconds of processor |\n| --- | --- | --- | --- | --- | --- |\n'
  while read -r name _; do
    row=$(cat -- "$work/rows/$name" 2>/dev/null || grep -F "gallery/$name.jpg" "$list" 2>/dev/null || true)
    if [[ -z $row ]]; then continue; fi
    if [[ -e $root/docs/gallery/large/$name.jpg && $row != *gallery/large/* ]]; then
      row="| <a href=\"gallery/large/$name.jpg\">${row#| }" row=${row/'width="200">'/'width="200"></a>'}
    fi
    printf '%s\n' "$row"
  done < <(pictures)
} >"$work/gallery.md"
mv -fT -- "$work/gallery.md" "$list"
