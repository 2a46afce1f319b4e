#!/usr/bin/env bats
# The program from the command line: what it prints and how it ends.

bats_require_minimum_version 1.5.0

setup() {
  load common
  frond=${FROND_BIN:-$BATS_TEST_DIRNAME/../../build/frond}
  root=$(cd -- "$BATS_TEST_DIRNAME/../.." && pwd)
  export FROND_HOME=$root
  cd "$BATS_TEST_TMPDIR" || return
  echo '{"axiom": "F", "angle": 90, "steps": 2, "rules": ["F -> F+F-F-F+F"]}' > koch.json
}

@test "derive prints the word or its counts" {
  run "$frond" derive koch.json --steps 1
  [ "$status" -eq 0 ]
  [ "$output" = "F+F-F-F+F" ]
  run "$frond" derive koch.json --format counts
  [ "${lines[0]}" = "F 25" ]
}

@test "turtle measures the way" {
  run "$frond" turtle koch.json
  [ "$status" -eq 0 ]
  [[ "$output" == *'"segments": 25, "total_length": 25, "end_position": [0, 9, 0]'* ]]
}

@test "steps need not be whole for the turtle, but for words" {
  run "$frond" turtle koch.json --steps 1.5
  [ "$status" -eq 0 ]
  [[ "$output" == *'"segments": 25, "total_length": 1'* ]]
  run "$frond" derive koch.json --steps 1.5
  [ "$status" -eq 2 ]
}

@test "pictures are SVG files" {
  "$frond" turtle koch.json --svg way.svg
  "$frond" derive koch.json --tree tree.svg
  [[ "$(head -c 4 way.svg)" == "<svg" ]]
  [ "$(grep -c '<text' tree.svg)" -ge 9 ]
}

@test "grammars of other tools are read" {
  printf 'Lsystem: 1\nderivation length: 3\nAxiom: A\nA --> AB\nB --> A\nendlsystem\n' > algae.l
  run --separate-stderr "$frond" derive algae.l
  [ "$status" -eq 0 ]
  [ "$output" = "ABAAB" ]
}

@test "info foresees and refuses" {
  run "$frond" info koch.json --json
  [ "$status" -eq 0 ]
  [[ "$output" == *'"modules": 49, "segments": 25'* ]]
  echo '{"axiom": "F", "steps": 60, "rules": ["F -> FF"]}' > wild.json
  run "$frond" info wild.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"step 28 would have"* ]]
  run "$frond" derive wild.json
  [ "$status" -eq 2 ]
}

@test "a mistake in a rule names the file, the rule and the column" {
  echo '{"axiom": "F", "rules": ["F -> F[+F"]}' > broken.json
  run "$frond" derive broken.json
  [ "$status" -eq 2 ]
  [[ "$output" == "broken.json: rule 1: column 7:"* ]]
}

@test "check tells all faults and ends with 2" {
  printf '{\n "film": {"fps": -1},\n "organisms": [{"kind": "corl"}]\n}\n' > wrong.json
  run "$frond" check wrong.json "$root/presets/reef.json"
  [ "$status" -eq 2 ]
  [ "${#lines[@]}" -eq 2 ]
  [[ "${lines[0]}" == "wrong.json:2:"*"/film/fps: "* ]]
  [[ "${lines[1]}" == *'did you mean "coral"?' ]]
}

@test "wrong words on the command line end with 2" {
  run "$frond" generate
  [ "$status" -eq 2 ]
  run "$frond" generate "$root/tests/presets/tiny_still.json" -o out --frames 2-5
  [ "$status" -eq 2 ]
  run "$frond" generate "$root/tests/presets/tiny_still.json" -o out --size 12
  [ "$status" -eq 2 ]
  [ ! -e out ]
  run "$frond" --help
  [ "$status" -eq 0 ]
}

@test "a frame generated alone is the frame of the whole film" {
  "$frond" generate "$root/tests/presets/tiny_film.json" -o all -q --threads 2
  "$frond" generate "$root/tests/presets/tiny_film.json" -o one -q --frames 4 --threads 1
  cmp all/frames/frame_0004.pov one/frames/frame_0004.pov
}

@test "what no frame reads any more goes, but only where all went well" {
  all="$root/tests/presets/all_phases.json"
  "$frond" generate "$all" -o out -q --frames 1
  ls out/frames >before
  touch out/manifest.json.tmp7 out/frames/{leaf_0123456789abcdef.png,model_0123456789abcdef_2.inc,frame_0001.pov.tmp12,frame_0003.pov,frame_0003.png,mine.png}
  run "$frond" generate "$all" -o out -q --frames 900
  [ "$status" -eq 2 ]
  [ -e out/frames/leaf_0123456789abcdef.png ]
  "$frond" generate "$all" -o out -q --frames 1
  rm out/frames/frame_0003.* out/frames/mine.png  # frames of another range are left alone, and what is not ours
  diff before <(ls out/frames)
  [ ! -e out/manifest.json.tmp7 ]
}

@test "list and schema are for machines too" {
  "$frond" list --json | python3 -c 'import json, sys; assert any(r["name"] == "coral" for r in json.load(sys.stdin))'
  "$frond" schema | cmp - "$root/docs/preset.schema.json"
}

@test "the manual of the turtle is that of its table" {
  "$frond" list --json | python3 -c '
import json, sys
manual = open(sys.argv[1]).read()
for row in json.load(sys.stdin):
    if row["group"] == "symbols":
        line = "| `%s` | %s |" % tuple(row[key].replace("|", "\\|") for key in ("name", "doc"))
        assert line in manual, line
' "$root/docs/grammars.md"
}

@test "export writes each format and refuses wrong words" {
  for kind in obj ply glb vdb; do
    "$frond" export "$root/tests/presets/tiny_film.json" --frame 2 -o "out/coral.$kind" -q
    [ -s "out/coral.$kind" ]
  done
  [ -s out/coral.mtl ]
  [ "$(head -c 4 out/coral.glb)" = "glTF" ]
  run "$frond" export "$root/tests/presets/tiny_film.json" -o out/coral.stl
  [ "$status" -eq 2 ]
  [[ "$output" == *"expected one of .obj, .ply, .glb, .vdb"* ]]
  run "$frond" export "$root/tests/presets/tiny_film.json" --frame 4000 -o out/late.ply
  [ "$status" -eq 2 ]
  [[ "$output" == "--frame: 4000 is no frame of this film; expected 1-"* ]]
  [ ! -e out/late.ply ]
}

@test "a volume past its limit is refused before it is made" {
  run "$frond" export "$root/tests/presets/tiny_film.json" -o out/coral.ply \
    --set /organisms/0/body='{"build": "fused", "voxel": 0.00001}'
  [ "$status" -eq 2 ]
  [[ "$output" == *"more than the limit of 4 GB"* ]]
}

@test "a full or closed stdout ends each command with 1 and one message" {
  for command in "turtle koch.json" "derive koch.json" "derive koch.json --format counts" "info koch.json" \
    "info $root/presets/bush.json --json" "list" "list --json" "schema" "--help" "--version"; do
    for where in ">/dev/full" ">&-"; do
      run bash -c "'$frond' $command 2>message $where"
      [ "$status" -eq 1 ]
      [[ "$(cat message)" == "stdout: cannot be written: "* ]]
      [ "$(wc -l <message)" -eq 1 ]
    done
  done
}

@test "a full or closed stderr loses words and nothing else" {
  for where in "2>/dev/full" "2>&-"; do
    run bash -c "'$frond' generate '$root/tests/presets/tiny_still.json' -o out $where"
    [ "$status" -eq 0 ]
    [ -s out/frames/frame_0001.pov ]
    rm -r out
  done
}

@test "no file is written into in place of a closed stdout" {
  run bash -c "'$frond' generate '$root/tests/presets/tiny_still.json' -o out -q 0<&- >&- 2>&-"
  [ "$status" -eq 0 ]
  head -c 200 out/frames/frame_0001.pov | grep -q '^//'
}

@test "what the memory cannot hold is refused with the figure before it is grown" {
  sed 's/"steps": [0-9]*/"steps": 11/' >large.json <<'JSON'
{"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{"kind": "plant", "smoothing": 1,
 "grammar": {"axiom": "F", "angle": 25, "steps": 1, "rules": ["F -> F[+F][-F]F"]}}]}
JSON
  run bash -c "ulimit -v 400000; '$frond' generate large.json -o out -q --threads 1"
  [ "$status" -eq 2 ]
  [[ "$output" == "large.json: the run would take about "*" of memory, and "*" can be had"* ]]
  [ ! -e out ]
}

@test "memory that runs out is told with what was being done" {
  echo '{"axiom": "F(1)", "steps": 24, "rules": ["F(x) : x > 0 -> F(x)F(x)"]}' >words.json
  run bash -c "ulimit -v 300000; '$frond' derive words.json --format counts"
  [ "$status" -eq 1 ]
  [[ "$output" == "frond: memory ran out while deriving the word: "* ]]
}

@test "a film that the disk cannot hold is refused" {
  run "$frond" info "$root/presets/staghorn.json" --set /film/frames=100000
  figure=$output
  [[ "$figure" == *"100000 frames of "*" GB in all"* ]]
  run "$frond" generate "$root/presets/staghorn.json" --set /film/frames=100000 --set /film/size=[64,36] -o /proc/none -q
  [ "$status" -eq 2 ]
  [[ "$output" == *"of the disk are free"* ]]
}
