#!/usr/bin/env bash
# Renders the pictures of docs/gallery from the presets as they are, only those that changed, and lists them.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/gallery.sh [-o DIR] [--large] [NAME...]

Renders the pictures of docs/gallery, all or those of the names given, at the quality "good". DIR (out/gallery) keeps
what they are made of: interrupted and run again it goes on where it stopped. docs/gallery.md lists all pictures with
the seconds of processor that POV-Ray took, here or where they were rendered last.

--large renders the best of them 1280 pixels wide, into docs/gallery/large, and lists nothing: those of
$best
TEXT
}
best="reef garden forest stone_bridge ivy-brick_wall rocks reef-flight reef-dusk tree-cherry meadow"
help_where_asked "$@"
work=out/gallery large=''
while (($# > 0)); do
  case $1 in
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

# NAME WIDTHxHEIGHT COLUMNS PRESET[@FRAME][,POINTER=VALUE]...: several make a sheet of so many columns.
pictures() {
  cat <<'TEXT'
reef 800x450 1 reef@96
garden 960x540 1 garden/garden@48
tree-oak 640x480 1 trees/oak
ivy-brick_wall 800x450 1 ivy/brick_wall@120
heart_tree 480x480 1 heart_tree
stone_bridge 720x405 1 garden/stone_bridge
rocks 720x450 1 garden/rocks
vases 720x405 1 garden/vases
fused 640x400 1 fused
voxel 800x500 1 voxel
tree-birch 540x720 1 trees/birch
tree-spruce 480x640 1 trees/spruce
tree-willow 560x420 1 trees/willow
tree-acacia 640x427 1 trees/acacia
tree-poplar 480x640 1 trees/poplar
tree-beech 600x600 1 trees/beech
tree-maple 600x600 1 trees/maple
tree-pine 480x640 1 trees/pine
tree-cherry 640x507 1 trees/cherry
tree-olive 640x507 1 trees/olive
tree-cypress 480x640 1 trees/cypress
tree-cedar 640x560 1 trees/cedar
tree-larch 480x640 1 trees/larch
tree-dead_tree 720x540 1 trees/dead_tree
tree-light_race 560x420 1 trees/light_race@120
trees-ages 320x300 3 trees/oak,/organisms/0/years=8,/scene/camera/fit=["all"] trees/oak,/organisms/0/years=33,/scene/camera/fit=["all"] trees/oak,/scene/camera/fit=["all"]
trees-young 220x220 4 trees/beech,/organisms/0/years=14,/scene/camera/fit=["all"] trees/birch,/organisms/0/years=11,/scene/camera/fit=["all"] trees/pine,/organisms/0/years=28,/scene/camera/fit=["all"] trees/spruce,/organisms/0/years=18,/scene/camera/fit=["all"] trees/willow,/organisms/0/years=9,/scene/camera/fit=["all"] trees/poplar,/organisms/0/years=9,/scene/camera/fit=["all"] trees/acacia,/organisms/0/years=17,/scene/camera/fit=["all"] trees/maple,/organisms/0/years=11,/scene/camera/fit=["all"] trees/cherry,/organisms/0/years=8,/scene/camera/fit=["all"] trees/olive,/organisms/0/years=13,/scene/camera/fit=["all"] trees/cypress,/organisms/0/years=11,/scene/camera/fit=["all"]
trees-old 220x220 4 trees/beech,/organisms/0/years=300,/scene/camera/fit=["all"] trees/birch,/organisms/0/years=150,/scene/camera/fit=["all"] trees/pine,/organisms/0/years=380,/scene/camera/fit=["all"] trees/spruce,/organisms/0/years=200,/scene/camera/fit=["all"] trees/willow,/organisms/0/years=89,/scene/camera/fit=["all"] trees/poplar,/organisms/0/years=109,/scene/camera/fit=["all"] trees/acacia,/organisms/0/years=350,/scene/camera/fit=["all"] trees/maple,/organisms/0/years=200,/scene/camera/fit=["all"] trees/cherry,/organisms/0/years=89,/scene/camera/fit=["all"] trees/olive,/organisms/0/years=450,/scene/camera/fit=["all"] trees/cypress,/organisms/0/years=300,/scene/camera/fit=["all"]
trees-winter 320x300 4 trees/oak,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/beech,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/birch,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/maple,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/cherry,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/willow,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/poplar,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"] trees/acacia,/organisms/0/season={"at":0.03},/scene/meadow/hour=11,/scene/meadow/day=20,/scene/camera/fit=["all"]
trees-seasons 404x304 2 trees/seasons@40 trees/seasons@110 trees/seasons@200 trees/seasons@235
photograph-grass 800x500 1 photographs/grass
photograph-bark 800x500 1 photographs/bark
photograph-path 800x500 1 photographs/path
photograph-hillside 800x500 1 photographs/hillside
photograph-star_moss 800x500 1 photographs/star_moss
photograph-dandelions 800x500 1 photographs/dandelions
photograph-maple_leaf 800x500 1 photographs/maple_leaf
photograph-yellow_flower 800x500 1 photographs/yellow_flower
aspen 420x525 1 aspen
black_oak 400x320 1 black_oak
weeping_willow 340x340 1 weeping_willow
forest-anemone 640x426 1 forest/anemone
forest-fern 640x426 1 forest/fern
forest-log 640x426 1 forest/log
forest-rock 640x426 1 forest/rock
forest-sedge 640x426 1 forest/sedge
forest-blueberry 480x320 1 forest/blueberry
forest-bracken 480x320 1 forest/bracken
forest-bramble 480x320 1 forest/bramble
forest-mushrooms 480x320 1 forest/mushrooms
forest-sapling 480x320 1 forest/sapling
forest-undergrowth 286x190 3 forest/fern forest/bracken forest/bramble forest/blueberry forest/sedge forest/anemone forest/mushrooms forest/rock forest/log
ivy-any_mesh 800x450 1 ivy/any_mesh@120
ivy-column 800x450 1 ivy/column@120
ivy-rocks 800x450 1 ivy/rocks@120
bridge 704x396 1 garden/bridge
garden-bush 440x330 1 garden/bush
garden-guided_bush 440x330 1 garden/guided_bush
garden-guided_palm 480x360 1 garden/guided_palm
garden-palm 330x440 1 garden/palm
meadow 640x360 1 garden/meadow
garden-tree 560x280 1 garden/tree
garden-hours 320x180 3 garden/garden@1,/scene/garden/hour=6.5 garden/garden@1,/scene/garden/hour=12 garden/garden@1,/scene/garden/hour=20
reef-species 192x160 5 species/corals/staghorn species/corals/blue_staghorn species/corals/bottlebrush species/corals/bird_nest species/corals/club species/corals/whip species/corals/brain species/corals/grooved_brain species/corals/star species/corals/honeycomb species/corals/lobe species/corals/finger species/corals/cauliflower species/corals/hood species/corals/pillar species/corals/horn species/corals/lettuce_coral species/corals/plate_coral species/corals/table_coral species/corals/encrusting_coral species/corals/tube_sponge species/corals/organ_pipe_coral species/corals/barrel_sponge species/corals/mushroom_coral species/corals/sea_fan
reef-flight 640x360 1 reef_flight@70
reef-dusk 640x360 1 reef_dusk@192
feeding 320x180 3 feeding@40 feeding@80 feeding@130
asking 400x225 3 asking/light asking/surface asking/food
thicket 480x270 1 thicket@96
reef-life 288x192 4 reef/chromis reef/fishes reef/anemone reef/starfish reef/urchin reef/sea_grass reef/kelp
reef-clam 640x426 1 reef/clam
shells 720x450 1 shells
shell-species 192x144 4 species/shells/turritella species/shells/nautilus species/shells/top_shell species/shells/olive species/shells/cone species/shells/cockle species/shells/scallop species/shells/giant_clam
staghorn 480x360 1 staghorn
bush 480x360 1 bush
fan 480x360 1 fan
tufted 480x360 1 tufted
anabaena-1.38 480x270 1 lsystems/anabaena-1.38
bush-1.25 480x360 1 lsystems/bush-1.25
crocus-3 480x320 1 lsystems/crocus-3
dragon-1.10a 480x360 1 lsystems/dragon-1.10a
field-1.27 480x270 1 lsystems/field-1.27
growing-tree-2.6 240x180 4 lsystems/growing-tree-2.6@24 lsystems/growing-tree-2.6@48 lsystems/growing-tree-2.6@72 lsystems/growing-tree-2.6@96
hilbert-1.19 480x360 1 lsystems/hilbert-1.19
hogeweg-hesper-1.31 480x240 1 lsystems/hogeweg-hesper-1.31
inflorescence-3 440x528 1 lsystems/inflorescence-3
koch-1.6 480x360 1 lsystems/koch-1.6
plants-1.24 480x240 1 lsystems/plants-1.24
row-of-trees-1.37 480x270 1 lsystems/row-of-trees-1.37
sunflower-4 480x360 1 lsystems/sunflower-4
trees-2.6 480x240 1 lsystems/trees-2.6
trees-2.7 480x270 1 lsystems/trees-2.7
trees-2.8 540x304 1 lsystems/trees-2.8
forest 960x540 1 forest
forest-autumn 640x360 1 forest/autumn
forest-flight 648x368 1 forest/flight@120
TEXT
}

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
  put_in_place "$part" "$root/$place"
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
  put_in_place "$work/$name.jpg" "$root/docs/gallery/$name.jpg"
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
    {
      cat <<'TEXT'
{
  "seed": 2,
  "scene": {
    "setting": "studio",
    "camera": {"location": [0.5, 0.75, 4], "look_at": [0, 0.5, 0], "angle": 30, "fit": ["all"]},
    "studio": {"wall": "#e6e2d8", "distance": 1, "key": [-0.9, 0.85, 0.8]}
  },
  "organisms": [
    {
      "kind": "plant", "name": "all", "height": 1, "stand": "middle", "smoothing": 2,
      "place": {"at": [[0, 0]], "lean": 0, "size_variation": 0, "turn_variation": 0},
      "thickness": {"from": "turtle", "least": 0.004},
      "bark": {"kind": "stem", "colors": ["#5d7a34", "#6f9a34", "#8aa846", "#b8622f", "#d8a32c", "#7450b0", "#4274b8"]},
      "blades": {"colors": ["#5d7a34", "#6f9a34", "#8aa846", "#b8622f", "#d8a32c", "#7450b0", "#4274b8"]},
TEXT
      if grep -q '~b' "$grammar"; then
        printf '      "organs": [{"symbol": "b", "shape": "bud", "size": 0.03, "colors": ["#b8622f"]}],\n'
      fi
      printf '      "grammar":\n'
      cat -- "$grammar"
      printf '    }\n  ]\n}\n'
    } >"$place.json"
    "$frond" generate "$place.json" -o "$place" --size 200x200 --quality draft -q >&2
    (cd -- "$place" && ninja frames/frame_0001.png >&2)
    # Names are of letters, digits and underscores, which need no quotes in a filter.
    ffmpeg -y -loglevel error -i "$place/frames/frame_0001.png" -vf "format=rgb24,pad=iw:ih+28:0:0:0x202020,drawtext=text=$name:\
fontcolor=white:fontsize='clip(w/14,8,16)':x='max(0,(w-tw)/2)':y=h-20" "$place.png" </dev/null
    printf '%s\n' "$place.png" >>"$list"
  done
  "$frond" film "$list" "$work/grammars.png" --columns 8 --width 200
  ffmpeg -y -loglevel error -i "$work/grammars.png" -bitexact -q:v 3 "$work/grammars.jpg" </dev/null
  put_in_place "$work/grammars.jpg" "$root/docs/gallery/grammars.jpg"
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
put_in_place "$work/gallery.md" "$list"
