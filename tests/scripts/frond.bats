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

@test "plan draws the plans of several seeds" {
  run "$frond" plan "$root/presets/garden/walled.json" --seeds 3 -o plans.svg
  [ "$status" -eq 0 ]
  [ "$output" = plans.svg ]
  [ "$(grep -c '<g ' plans.svg)" -eq 3 ]
  run "$frond" plan "$root/presets/bush.json"
  [ "$status" -eq 2 ]
  [[ "$output" == *"bush.json: the preset has no plan" ]]
}

@test "stand plots the years of a wood" {
  run "$frond" stand "$root/presets/forest/clearing.json" --set /stand/years=30 --set /events=[] \
    --set '/stand/area=[40, 40]' --year 20 -o stand.svg
  [ "$status" -eq 0 ]
  [ "$output" = stand.svg ]
  grep -q 'The stand in year 20:' stand.svg
  "$frond" stand "$root/presets/forest/clearing.json" --set /stand/years=30 --set /events=[] \
    --set '/stand/area=[40, 40]' -o stand.csv
  [ "$(wc -l <stand.csv)" -eq 7 ]
  run "$frond" stand "$root/presets/bush.json"
  [ "$status" -eq 2 ]
  [[ "$output" == *"bush.json: the preset has no stand and no reef" ]]
  run "$frond" stand "$root/presets/forest/clearing.json" --year 300
  [ "$status" -eq 2 ]
  [[ "$output" == *"--year 300 is after the last year, 200" ]]
}

@test "stand plots the years of a reef" {
  run "$frond" stand "$root/presets/reef/century.json" --set /reef/years=34 --set '/reef/area=[3, 3]' --year 33.5
  [ "$status" -eq 0 ]
  [ "$output" = century_reef.svg ]
  grep -q 'The reef in year 33.5:' century_reef.svg
  "$frond" stand "$root/presets/reef/century.json" --set /reef/years=34 --set '/reef/area=[3, 3]' -o reef.csv
  [ "$(wc -l <reef.csv)" -eq 36 ]
  run "$frond" stand "$root/presets/reef/century.json" --year 101
  [ "$status" -eq 2 ]
  [[ "$output" == *"--year 101 is after the last year, 100" ]]
}

@test "grammars of other tools are read" {
  printf 'Lsystem: 1\nderivation length: 3\nAxiom: A\nA --> AB\nB --> A\nendlsystem\n' > algae.l
  run --separate-stderr "$frond" derive algae.l
  [ "$status" -eq 0 ]
  [ "$output" = "ABAAB" ]
  "$frond" turtle algae.l
  run --separate-stderr "$frond" info algae.l
  [ "$output" = "exact: after 3 steps 5 modules, 0 segments, 60 bytes" ]
  printf 'Lsystem: 1\nderivation length: 9\nAxiom: A(1)\nA(x) : {n = n + 1;} * -->\n\tA(n)\nendlsystem\n' > own.l
  run --separate-stderr "$frond" derive own.l
  [ "$output" = "A(9)" ]
  printf 'Lsystem: 1\nAxiom: FF[+F]{.f.+f}\nA --> A\nendlsystem\n' > lines.l
  run --separate-stderr "$frond" turtle lines.l
  python3 -c 'import json, sys; m = json.load(sys.stdin); assert m["segments"] == 3 and m["polygons"] == 1, m' <<<"$output"
  "$frond" turtle lines.l --svg lines.svg
  grep -q '<polygon' lines.svg
  printf 'surface: l none.s\n' > lines.v
  run "$frond" turtle lines.l
  [ "$status" -eq 0 ]
  [[ "$output" == *'there is no file "none.s" in the model'*'~l draws nothing, as in cpfg'* ]]
  printf 'contour: 1 none.con\n' > lines.v
  run "$frond" turtle lines.l
  [ "$status" -eq 2 ]
  [[ "$output" == *'lines.v: line 1: there is no file "none.con" in the model'* ]]
}

@test "grammars of LParser and Houdini become presets" {
  printf '2.5\n30\n10\nA\nA=F[+A]t(0.2)>A\n@\n' > bush.ls
  run --separate-stderr "$frond" derive bush.ls --steps 2
  [ "$output" = "F[+F[+A]t(0.2)>A]t(0.2)>F[+A]t(0.2)>A" ]
  run --separate-stderr "$frond" info bush.ls
  [[ "$output" == "exact: after 2.5 steps "* ]]
  run --separate-stderr "$frond" turtle bush.ls --steps 1 --angle 90
  python3 -c 'import json, sys; m = json.load(sys.stdin); assert m["segments"] == 1 and m["total_length"] == 100, m' <<<"$output"
  plain=$("$frond" derive bush.ls) mutated=$("$frond" derive bush.ls --mutate 4 --seed 5)
  [ "$plain" != "$mutated" ]
  "$frond" import bush.ls --mutate 4 --seed 5 -o bush.json
  "$frond" check bush.json
  [ "$("$frond" derive bush.json)" = "$mutated" ]
  "$frond" generate bush.json -o out -q --size 16x16
  grep -q sphere_sweep out/frames/frame_0001.pov

  printf 'premise: A(0)\ngenerations: 3\nA(i)=F(1,0.1)[+J(2)]/(90)A(i+1)\nrows: 4\n' > herb.txt
  run "$frond" import herb.txt
  [ "$status" -eq 0 ]
  [[ "$output" == *'herb.txt: file: `rows` has no effect here'* ]]
  "$frond" check herb.json
  grep -q '"symbol": "J"' herb.json
  run "$frond" derive herb.txt --mutate 1
  [ "$status" -eq 2 ]
  printf 'module A(float);\nAxiom: A(1);\n' > growth.txt
  run "$frond" derive growth.txt
  [ "$status" -eq 2 ]
  [ "${#lines[@]}" -eq 1 ]
  printf 'Axiom: A\nderivation length: 3\nproduction:\nA:\n  produce B\n' > growth.lpy
  for command in derive info turtle import; do
    run "$frond" "$command" growth.lpy
    [ "$status" -eq 2 ]
    [[ "${lines[*]}" == *"this is a model of L-Py, a program in Python"*"write each of its productions as"* ]]
    [ "${#lines[@]}" -eq 1 ]
  done
}

@test "a model of cpfg becomes a preset" {
  printf 'Lsystem: 1\nderivation length: 3\nAxiom: A\nA --> F[+F]/A\nendlsystem\n' > twig.l
  mkdir presets
  "$frond" import twig.l -o presets/twig.json
  "$frond" check presets/twig.json
  "$frond" generate presets/twig.json -o out -q --size 16x16
  grep -q sphere_sweep out/frames/frame_0001.pov
  printf 'Lsystem: 1\nAxiom: A\nA --> A\nendlsystem\n' > nothing.l
  run "$frond" import nothing.l
  [ "$status" -eq 2 ]
  [[ "$output" == *"nothing.l: its turtle draws nothing"* ]]
  printf 'no grammar' > wrong.l
  preset='{"organisms": [{"kind": "plant", "grammar": {"file": "%s"%s}}]}'
  # shellcheck disable=SC2059
  printf "$preset" wrong.l "" > wrong.json
  run "$frond" check wrong.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"wrong.json:1:"*": /organisms/0/grammar/file: "*"cannot be read; "* ]]
  # shellcheck disable=SC2059
  printf "$preset" twig.l ', "angle": 30' > more.json
  run "$frond" check more.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"/organisms/0/grammar: a model of cpfg has all else in its own files"* ]]
}

@test "a picture is developed as the first line of its scene says" {
  "$frond" generate "$root/tests/presets/tiny_still.json" -o out -q --set /scene/setting=meadow --size 20x16 \
    --set /scene/camera/highlights=2 --set /scene/camera/contrast=1.1
  [[ "$(head -n 1 out/frames/frame_0001.pov)" == *' +FN16; then frond develop --highlights 2 --contrast 1.1' ]]
  (cd out && ninja frames/frame_0001.png)
  [ "$(od -An -tu1 -j 24 -N 1 out/frames/frame_0001.png | tr -d ' ')" = 8 ]
  run "$frond" develop out/frames/frame_0001.pov -o x.png
  [ "$status" -eq 1 ]
  [[ "$output" == *"frame_0001.pov: no PNG"* ]]
  [ ! -e x.png ]
  "$frond" generate "$root/tests/presets/tiny_still.json" -o grey -q --set /scene/setting=meadow --size 20x16 \
    --set /scene/camera/saturation=0 --set /scene/camera/vignette=0.5
  [[ "$(head -n 1 grey/frames/frame_0001.pov)" == *'--highlights 0 --contrast 1 --saturation 0 --vignette 0.5' ]]
  (cd grey && ninja frames/frame_0001.png)
  ffmpeg -v error -i grey/frames/frame_0001.png -f rawvideo -pix_fmt rgb24 grey.rgb
  python3 -c 'x = open("grey.rgb", "rb").read(); assert len(x) == 960 and max(x) > 40 and x[0::3] == x[1::3] == x[2::3]'
}

@test "look offers six composed views, each of which is asked for by what it says" {
  run --separate-stderr "$frond" look "$root/tests/presets/staghorn.json" --size 64x48 --views
  [ "$status" -eq 0 ]
  [ "$output" = staghorn_views.png ]
  [ "$(od -An -tx1 -j 16 -N 8 staghorn_views.png | tr -d ' ')" = 0000008400000098 ]
  [ "$(grep -c -- '--set /scene/camera/compose/light=' <<<"$stderr")" -eq 6 ]
  read -ra set <<<"$(sed -n 's/^row 1, left: //p' <<<"$stderr")"
  "$frond" look "$root/tests/presets/staghorn.json" --size 64x48 "${set[@]}" -o one.png
  # The first of the six, which is pasted at the upper left, is that picture.
  for file in one staghorn_views; do
    ffmpeg -v error -y -i $file.png -vf crop=64:48:0:0 -f rawvideo -pix_fmt rgb24 $file.rgb
  done
  cmp one.rgb staghorn_views.rgb
}

@test "look draws a picture and says how large all has grown" {
  run --separate-stderr "$frond" look "$root/tests/presets/staghorn.json" --size 64x48 --set '/scene/camera/fit=["all"]'
  [ "$status" -eq 0 ]
  [ "$output" = staghorn_look.png ]
  [[ "$stderr" == *" high, "*" wide, stem of "* ]]
  [ "$(od -An -tx1 -j 16 -N 8 staghorn_look.png | tr -d ' ')" = 0000004000000030 ]
  run "$frond" info "$root/tests/presets/staghorn.json" --sizes --json
  [ "$status" -eq 0 ]
  python3 -c 'import json, sys; size = json.load(sys.stdin)["sizes"][0]; assert size["height"] > 0.05 and size["stem"] > 0' <<<"$output"
  run "$frond" look "$root/tests/presets/staghorn.json" -o picture.jpg
  [ "$status" -eq 2 ]
  [[ "$output" == *"expected .png"* ]]
  run "$frond" look "$root/tests/presets/staghorn.json" --set '/scene/camera/fit=["stag"]'
  [ "$status" -eq 2 ]
  [[ "$output" == *"/scene/camera/fit/0: no organism \"stag\" to fit"* ]]
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

@test "turtle refuses the steps that info refuses" {
  # Its segments pass the limit, its modules do not; and a step of it is not told by a matrix.
  echo '{"axiom": "A(0)", "steps": 3, "rules": ["A(x) : x >= 0 -> A(x+1)A(x+1)"], "limits": {"modules": 1000}}' >twice.json
  run "$frond" info twice.json
  [ "$status" -eq 0 ]
  run "$frond" turtle twice.json --steps 12
  [ "$status" -eq 2 ]
  [[ "$output" == *"would have"*"past the limit of 1000 modules"* ]]
  echo '{"axiom": "A", "rules": ["A -> AA"], "interpretation": ["A -> FFFF"], "limits": {"modules": 100}}' >long.json
  run "$frond" turtle long.json --steps 6
  [ "$status" -eq 2 ]
  [[ "$output" == *"step 5 would have 128 modules or segments, past the limit of 100 modules"* ]]
}

@test "info answers of many steps, and of some frames of a film" {
  echo '{"organisms": [{"kind": "plant", "grammar": {"axiom": "A", "steps": 100000, "rules": ["A -> FA"]}}]}' >line.json
  run "$frond" info line.json
  [ "$status" -eq 0 ]
  [[ "$output" == *"100001 modules"* ]]
  written() { "$frond" info "$root/tests/presets/tiny_film.json" --json "$@" | sed 's/.*"bytes_a_frame": \([0-9]*\), .*"disk_bytes": \([0-9]*\).*/\1 \2/'; }
  read -r frame all <<<"$(written --frames 1-2)"
  read -r same one <<<"$(written --frames 1)"
  [ "$frame" -eq "$same" ]
  # Less is written of what has not grown yet: of what is grown from the first, each frame is as large.
  ((all > one && all <= one + frame + 1))
  read -r frame all <<<"$(written --set /organisms/0/growth/duration=0 --frames 1-2)"
  read -r same one <<<"$(written --set /organisms/0/growth/duration=0 --frames 1)"
  [ "$frame" -eq "$same" ]
  apart=$((all - one - frame))
  [ "${apart#-}" -le 1 ]  # rounded
  run "$frond" info "$root/tests/presets/tiny_film.json" --frames 900
  [ "$status" -eq 2 ]
}

@test "info says the same bytes in words and to machines" {
  "$frond" info "$root/presets/bush.json" >words
  "$frond" info "$root/presets/bush.json" --json >numbers
  megabytes=$(sed 's/.*"bytes_a_frame": \([0-9]*\).*/\1/' numbers | awk '{ printf "%.3g", $1 / 1e6 }')
  grep -F "frames of $megabytes MB" words
}

@test "what explodes names the file and the place" {
  printf '{"axiom": "F",\n "steps": 60, "rules": ["F -> FF"]}' > wild.json
  for command in info derive turtle; do
    run "$frond" $command wild.json
    [ "$status" -eq 2 ]
    [[ "$output" == *"wild.json:2:11: /steps: step 28 would have"* ]]
  done
  echo '{"axiom": "F(1)", "rules": ["A -> A"], "decomposition": ["F(x) : x > 0 -> F(x+1)X"]}' > endless.json
  for command in info derive turtle; do
    run "$frond" $command endless.json
    [ "$status" -eq 2 ]
    [[ "$output" == *"endless.json:1:"*"/decomposition/0: step 1: "* ]]
  done
}

@test "expansion needs no deep stack of the machine" {
  echo '{"axiom": "A(90000)", "steps": 1, "decomposition": ["A(i) : i > 0 -> A(i-1)B", "A(i) -> *"]}' > deep.json
  ulimit -s 256
  run "$frond" derive deep.json --format counts
  [ "$status" -eq 0 ]
  [ "$output" = "B 90000" ]
}

@test "numbers in what turtle and info print are JSON" {
  echo '{"axiom": "F(1e308)F(1e308)"}' > far.json
  run "$frond" turtle far.json
  [ "$status" -eq 2 ]
  [[ "$output" == "far.json:"*"the turtle walks beyond all that can be drawn"* ]]
  run "$frond" turtle far.json --svg far.svg
  [ "$status" -eq 2 ]
  [ ! -e far.svg ]
  run "$frond" turtle koch.json --steps nan
  [ "$status" -eq 2 ]
  echo '{"axiom": "F", "steps": 100000, "rules": ["F -> FFFFFFFF"]}' > wild.json
  run --separate-stderr "$frond" info wild.json --json
  [ "$status" -eq 2 ]
  python3 -c 'import json, sys; json.loads(sys.argv[1], parse_constant=sys.exit)' "$output"
}

@test "symbols that nothing knows are told, once" {
  echo '{"axiom": "A", "steps": 2, "rules": ["A -> F[+X]A"]}' > idle.json
  run --separate-stderr "$frond" derive idle.json
  [ "$status" -eq 0 ]
  [ "$stderr" = 'note: idle.json:1:38: /rules/0: column 9: `X` does nothing: no rule rewrites it and the turtle does not know it; in `A -> F[+X]A`' ]
  echo '{"organisms": [{"kind": "plant", "grammar": {"axiom": "A", "steps": 2, "rules": ["A -> F[+X]A"]}}]}' > herb.json
  for command in check info derive; do
    run --separate-stderr "$frond" $command herb.json
    [ "$status" -eq 0 ]
    [ "${#stderr_lines[@]}" -eq 1 ]
    [[ "$stderr" == "note: herb.json:1:"*"/organisms/0/grammar/rules/0: column 9: "* ]]
  done
}

@test "a mistake in a rule names the file, the rule and the column" {
  echo '{"axiom": "F", "rules": ["F -> F[+F"]}' > broken.json
  run "$frond" derive broken.json
  [ "$status" -eq 2 ]
  [[ "$output" == "broken.json:1:"*"/rules/0: column 7:"* ]]
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

# A preset of one body from a file: body_preset FILE
body_preset() {
  printf '{"film": {"frames": 1}, "scene": {"setting": "studio"},\n "organisms": [{"kind": "mesh",\n  "file": "%s"}]}\n' "$1"
}

@test "with --assets nothing is read but below the preset's folder and that one, and nothing of it is shown" {
  mkdir mine shared secret
  printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n' | tee mine/own.obj shared/lent.obj >secret/hidden.obj
  echo 'v hunter2 1 2' >secret/password
  ln -s ../secret/hidden.obj mine/link.obj
  for name in own.obj ../shared/lent.obj lent.obj; do
    body_preset "$name" >mine/preset.json
    "$frond" check --assets shared mine/preset.json
    "$frond" info --assets shared mine/preset.json
    "$frond" generate --assets shared mine/preset.json -o out -q
    "$frond" export --assets=shared mine/preset.json -o out/body.obj -q
  done
  for name in ../secret/hidden.obj link.obj "$PWD/secret/hidden.obj" ../secret/nothing; do
    body_preset "$name" >mine/preset.json
    for command in check info generate "export -o out/x.obj" textures; do
      # shellcheck disable=SC2086
      run "$frond" $command --assets shared mine/preset.json
      [ "$status" -eq 2 ]
      [[ "$output" == "mine/preset.json:3:11: /organisms/0/file: "*" lies outside of what may be read; "* ]]
    done
  done
  body_preset ../secret/hidden.obj >mine/preset.json
  "$frond" check mine/preset.json
  body_preset ../secret/password >mine/preset.json
  run "$frond" check mine/preset.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"/organisms/0/file: mine/../secret/password:1: a place whose number 1 is none"* ]]
  [[ "$output" != *hunter2* ]]
  run "$frond" check --assets nowhere mine/preset.json
  [ "$status" -eq 2 ]
  [[ "$output" == '--assets: "nowhere" is no folder'* ]]
}

@test "render hands --assets on" {
  printf '#!/bin/sh\necho "$@" >args\nexit 2\n' >fake
  chmod +x fake
  mkdir shared
  cp "$root/tests/cases/17-gable-ngon/gable.obj" body.obj
  body_preset body.obj >preset.json
  FROND_BIN=$PWD/fake run "$frond" render preset.json --assets shared -o out
  [ "$status" -eq 2 ]
  grep -q -- ' --assets=shared' args
}

@test "a file that is not there is told with the property that names it and the folders that were searched" {
  mkdir there
  body_preset none.obj >there/preset.json
  run "$frond" check there/preset.json
  [ "$output" = "there/preset.json:3:11: /organisms/0/file: there is no file \"none.obj\"; looked for in there and in $PWD" ]
}

@test "guides are looked for where all other files are" {
  mkdir there
  printf 'v 0 0 0\nv 0 1 0\nl 1 2\n' >way.obj
  echo '{"axiom": "?F", "guide": {"file": "way.obj"}}' >there/grammar.json
  echo '{"organisms": [{"kind": "plant", "grammar": {"axiom": "?F", "guide": {"file": "way.obj"}}}]}' >there/preset.json
  "$frond" derive there/grammar.json
  "$frond" check there/preset.json
  run "$frond" derive there/grammar.json --assets there
  [ "$status" -eq 2 ]
  [[ "$output" == 'there/grammar.json:1:35: /guide/file: there is no file "way.obj"; looked for in there' ]]
}

@test "nothing of a preset steers the terminal, and messages are short but keep their place" {
  printf '{"film": {"\\u001b[31m%s\\u202e": 1}, "scene": {"setting": "\\u009b2J"}}' "$(head -c 100000 /dev/zero | tr '\0' x)" >loud.json
  run "$frond" check loud.json
  [ "$status" -eq 2 ]
  [ "${#output}" -lt 5000 ]
  [[ "${lines[0]}" == 'loud.json:1:11: /film/\x1b[31mxxx'* ]]
  run "$frond" check "$(printf 'no\033[2Jthing')"
  [[ "$output" == 'no\x1b[2Jthing: cannot be read'* ]]
  run "$frond" check --wrong"$(printf '\033[2J')" loud.json
  [ "$status" -eq 2 ]
  [[ "$output" != *$'\033'* ]]
  python3 -c 'print("{\"organisms\": [" + ",".join(["{\"kind\": 1}"] * 5000) + "]}")' >many.json
  run "$frond" check many.json
  [ "${#lines[@]}" -eq 101 ]
  [ "${lines[100]}" = "and 4900 more" ]
}

@test "a file whose name begins with a dash is taken" {
  cp "$root/tests/presets/tiny_still.json" ./-still.json
  "$frond" check -still.json
  "$frond" check -- -still.json
  "$frond" generate -still.json --out=-out -q
  [ -s ./-out/frames/frame_0001.pov ]
  run "$frond" check -nothing.json
  [ "$status" -eq 2 ]
}

@test "options of the command line are named as they were given" {
  still=$root/tests/presets/tiny_still.json
  run "$frond" check "$still"
  run "$frond" info "$still" --quality high
  [ "$output" = '--quality: found the text "high"; expected one of draft, good, best' ]
  run "$frond" info "$still" --size 8x200
  [ "$output" = "--size: found 8x200; expected sides from 16 to 16384 pixels" ]
  run "$frond" info "$still" --set /film/quality=high
  [ "$output" = '--set /film/quality: found the text "high"; expected one of draft, good, best' ]
}

@test "what does nothing in a preset is noted by check and generate" {
  echo '{"film": {"frames": 1}, "scene": {"setting": "studio", "water": {"shafts": 0}}, "organisms": []}' >idle.json
  run "$frond" check idle.json
  [ "$status" -eq 0 ]
  [ "$output" = "note: idle.json:1:65: /scene/water: does nothing here: the setting is studio; it is for underwater" ]
  run "$frond" generate idle.json -o out -q
  [ "$status" -eq 0 ]
  [[ "$output" == "note: idle.json:1:65: "* ]]
}

@test "a budget of growth in seconds is counted once for a film" {
  echo '{"film": {"frames": 1, "size": [20, 16]}, "scene": {"setting": "forest"}, "organisms": [
    {"kind": "tree", "years": 60, "budget": {"seconds": 0.02}, "place": {"at": [[0, 0]]}}]}' > tree.json
  run "$frond" generate tree.json -o out -q
  [ "$status" -eq 0 ]
  [[ "$output" == *"/organisms/0/budget: 0.02 s are counted as "*" internodes"* ]]
  grep -q '"budgets": \[{"pointer": "/organisms/0/budget", "seconds": 0.02, "internodes": ' out/manifest.json
  # What a folder says counts, and gives the bytes that the number in the preset gives.
  sed -i 's/"internodes": [0-9]*/"internodes": 321/' out/manifest.json
  "$frond" generate tree.json -o out -q 2> said
  grep -q "counted as 321 internodes" said
  cp out/frames/frame_0001.pov again.pov
  "$frond" generate tree.json -o out -q
  cmp again.pov out/frames/frame_0001.pov
  "$frond" generate tree.json -o given -q --set /organisms/0/budget/internodes=321
  cmp again.pov given/frames/frame_0001.pov
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

@test "what another run of generate has half written is left to it" {
  tiny="$root/tests/presets/tiny_still.json"
  "$frond" generate "$tiny" -o out -q
  touch out/manifest.json.tmp7
  exec {other}<out/frames
  flock --shared "$other"  # as another run holds it
  "$frond" generate "$tiny" -o out -q
  [ -e out/manifest.json.tmp7 ]
  exec {other}<&-
  "$frond" generate "$tiny" -o out -q
  [ ! -e out/manifest.json.tmp7 ]
}

@test "a damaged texture is drawn again" {
  "$frond" generate "$root/tests/presets/all_phases.json" -o out -q --frames 1
  leaf=$(find out/frames -name 'leaf_*.png' | head -n 1)
  cp "$leaf" whole.png
  truncate -s -20 "$leaf"
  "$frond" generate "$root/tests/presets/all_phases.json" -o out -q --frames 1
  cmp whole.png "$leaf"
}

@test "a species of Arbaro grows in place of what the preset says" {
  cat >aspen.xml <<XML
<?xml version='1.0'?><arbaro><species name='aspen'>
<param name='Levels' value='2'/><param name='Scale' value='4'/><param name='Leaves' value='0'/>
<param name='1Branches' value='7'/><param name='1Length' value='0.3'/>
</species></arbaro>
XML
  echo '{"organisms": [{"kind": "weber_penn", "arbaro": "aspen.xml", "tree": {"scale": 30}}]}' >aspen.json
  run --separate-stderr "$frond" export aspen.json -o aspen.obj
  [ "$status" -eq 0 ]
  top=$(awk '$1 == "v" && $3 > y { y = $3 } END { print int(y + 0.5) }' aspen.obj)
  [ "$top" -eq 4 ]
}

@test "an unknown command is told with those there are and the nearest" {
  run "$frond" genrate x.json
  [ "$status" -eq 2 ]
  [[ "$output" == 'genrate: no such command; expected one of new, describe, '*', check, import, studio, try, look, '*'; did you mean "generate"?' ]]
  run "$frond" preview
  [ "$status" -eq 2 ]
  [[ "$output" == 'preview: no such command; expected one of new, describe, '* ]]
}

@test "an unknown option is told with the nearest that its command has" {
  for row in "generate x.json --sise 3x4|--sise: no such option of frond generate; did you mean \"--size\"?" \
    "info --jsn x.json|--jsn: no such option of frond info; did you mean \"--json\"?" \
    "export x.json --format=glb -o x|--format: no such option of frond export" "--verson|--verson: no such option of frond; did you mean \"--version\"?"; do
    # shellcheck disable=SC2086
    run "$frond" ${row%%|*}
    echo "$row: $output"
    [ "$status" -eq 2 ]
    [[ "${lines[0]}" == "${row#*|}"* ]]
    [ "${lines[1]}" = "Run with --help for more information." ]
  done
}

@test "a preset that is not there is told with the nearest that is shipped" {
  cd "$root"
  for command in check info files "export -o $BATS_TEST_TMPDIR/x.obj" generate look; do
    # shellcheck disable=SC2086
    run "$frond" $command trees/oka.json
    [ "$status" -eq 2 ]
    [ "$output" = 'trees/oka.json: cannot be read: No such file or directory; did you mean "presets/trees/oak.json"?' ]
  done
  run "$frond" check bosh
  [[ "$output" == *'; did you mean "presets/bush.json" or "presets/garden/bush.json"?' ]]
  run "$frond" check nothing_of_the_kind.json
  [[ "$output" == *"No such file or directory" ]]
  run "$frond" studio reff.json
  [[ "$output" == 'reff.json: is no file; did you mean "presets/reef.json"?' ]]
  cd "$BATS_TEST_TMPDIR"
  run "$frond" check oka
  [[ "$output" == *"/presets/trees/oak.json\"?" ]]
}

@test "what comes next is what can be run from here" {
  run --separate-stderr "$frond" new one --from vase
  [[ "$stderr" == *"  $root/scripts/render.sh one.json  "*"  $frond studio one.json "* ]]
  run "$frond"
  [[ "$output" == *"  $root/scripts/render.sh my_tree.json "*"  $frond studio my_tree.json "* ]]
  # A folder of Frond that holds the program's files alone.
  mkdir -p own
  cp -r "$root/templates" "$root/povinc" "$root/presets" "$root/docs" own
  FROND_HOME=$PWD/own run --separate-stderr "$frond" new two --from vase
  [[ "$stderr" != *render.sh* ]]
  cp -r "$root/scripts" own
  cd own
  FROND_HOME=$PWD run --separate-stderr "$frond" new three --from vase
  [[ "$stderr" == *"  scripts/render.sh three.json  "* ]]
}

@test "the folder of Frond is named in the help, and where it is none" {
  run "$frond" --help
  [[ "$output" == *"FROND_HOME"* ]]
  FROND_HOME=/nowhere run "$frond" list
  [ "$status" -eq 1 ]
  [[ "$output" == *"set FROND_HOME"* ]]
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
  [[ "$output" == *"expected one of .obj, .ply, .glb, .vdb, .inc" ]]
  run "$frond" export "$root/tests/presets/tiny_film.json" --frame 4000 -o out/late.ply
  [ "$status" -eq 2 ]
  [[ "$output" == "--frame: 4000 is no frame of this film; expected 1-"* ]]
  for wrong in "x.obj --frames 1-3" "x.ply --lods 2" "x.glb --frames 1-3 --lods 2" "x.glb --frames 2-2" \
    "x.glb --frames 1-3 --frame 2" "x.glb --seeds 2" "x.glb --lods 2 --instances" "x.glb --detail 10px" "x.glb --detail fine"; do
    run "$frond" export "$root/tests/presets/tiny_film.json" -o $wrong
    [ "$status" -eq 2 ]
    [[ "$output" =~ ^--(frame|frames|lods|seeds|detail|instances)(:|\ does\ not\ go\ with\ --) ]]
    [ ! -e "${wrong%% *}" ]
  done
  [ ! -e out/late.ply ]
}

@test "an export shows what has grown, and names what has not yet" {
  echo '{"film": {"frames": 12}, "organisms": [
    {"kind": "coral", "name": "late", "count": 2, "steps": 3, "growth": {"start": 0.1, "duration": 0.3}},
    {"kind": "rock", "depth": 4}]}' >film.json
  for kind in obj ply glb; do
    run "$frond" export film.json -o "grown.$kind"
    echo "$output"
    [ "$status" -eq 0 ]
    [[ "$output" != *"nothing has grown"* ]]
    "$frond" export film.json --frame 12 -o "last.$kind" -q
    [ "$kind" = obj ] || cmp "grown.$kind" "last.$kind"
    run "$frond" export film.json --frame 1 -o "early.$kind"
    [ "$status" -eq 0 ]
    [[ "$output" == *"note: at frame 1 of 12 nothing has grown yet of late" ]]
    [ "$(stat -c %s "early.$kind")" -lt "$(stat -c %s "grown.$kind")" ]
  done
  grep -q 'late_branches' grown.obj
}

@test "a volume past its limit is refused before it is made" {
  run "$frond" export "$root/tests/presets/tiny_film.json" -o out/coral.ply \
    --set /organisms/0/body='{"build": "fused", "voxel": 0.00001}'
  [ "$status" -eq 2 ]
  [[ "$output" == *"more than the limit of 4 GB"* ]]
}

@test "textures draws trees that grow by light, as it does the others" {
  echo '{"organisms": [{"kind": "tree", "name": "oak", "coat": {"pixels": 16},
    "leaves": {"picture": {"shape": "oak", "pixels": 32}}}]}' >tree.json
  run "$frond" textures tree.json -q -o pictures
  [ "$status" -eq 0 ]
  [ -s pictures/oak_bark_color.png ]
  [ -s pictures/oak_sprig.png ]
  echo '{"organisms": [{"kind": "tree"}]}' >plain.json
  run "$frond" textures plain.json -q -o pictures
  [ "$status" -eq 2 ]
  [[ "$output" == *"tree with a coat or leaves.picture"* ]]
}

@test "every preset that a help names is there" {
  for command in generate export textures check info; do
    for preset in $("$frond" "$command" --help | grep -o 'presets/[a-z_/]*\.json'); do
      [ -e "$root/$preset" ]
    done
  done
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
  run "$frond" info "$root/tests/presets/staghorn.json" --set /film/frames=100000
  figure=$output
  [[ "$figure" == *"100000 frames of "*" GB in all"* ]]
  run "$frond" generate "$root/tests/presets/staghorn.json" --set /film/frames=100000 --set /film/size=[64,36] -o /proc/none -q
  [ "$status" -eq 2 ]
  [[ "$output" == *"of the disk are free"* ]]
}

@test "new writes a preset of each kind and of presets that name files, and each is right" {
  local kind
  for kind in $("$frond" list --json | python3 -c 'import json, sys; print(*(r["name"] for r in json.load(sys.stdin) if r["group"] == "growers"))'); do
    echo "$kind"
    [ -f "$root/templates/new/$kind.json" ]
    run --separate-stderr "$frond" new "my_$kind" --from "$kind"
    [ "$status" -eq 0 ]
    [ "$output" = "my_$kind.json" ]
    grep -q '^ *// ' "my_$kind.json"
  done
  for kind in any_mesh autumn presets/lsystems/bush-1.25.json; do
    "$frond" new "deep/my_$(basename "$kind")" --from "$kind" -q
  done
  run "$frond" check my_*.json deep/*.json
  [ "$status" -eq 0 ]
  [ "$output" = "" ]
}

@test "new takes no name that is taken and no beginning that is none" {
  "$frond" new mine --from vase -q
  cp mine.json before.json
  run "$frond" new mine.json --from tree
  [ "$status" -eq 2 ]
  [[ "$output" == "mine.json: is there already; expected a name that is free" ]]
  cmp mine.json before.json
  run "$frond" new other --from trea
  [ "$status" -eq 2 ]
  [[ "$output" == *'did you mean "tree"?'* ]]
}

@test "new lays out a bed of species by any of their names, the tall ones behind" {
  "$frond" new bed --with "snowdrop,Lavandula angustifolia,tulip" -q
  run "$frond" check bed.json
  [ "$status" -eq 0 ]
  [ "$output" = "" ]
  "$frond" info bed.json --json --sizes > sizes.json
  python3 - <<'END'
import json, re
heights = {row["name"]: row["height"] for row in json.load(open("sizes.json"))["sizes"]}
text = re.sub(r"^ *//.*", "", open("bed.json").read(), flags=re.M)
depth = {}
for one in json.loads(text)["organisms"]:
    at = one["place"]["at"]
    assert len(at) == one["count"] > 1
    depth[one["name"]] = sum(z for _, z in at) / len(at)
assert sorted(heights, key=heights.get) == sorted(depth, key=depth.get, reverse=True), (heights, depth)
END
  run "$frond" new other --with lavendre,table_coral
  [ "$status" -eq 2 ]
  [[ "$output" == *'did you mean "lavender"?'* ]]
  [[ "$output" == *'"table_coral" lives under water'* ]]
  [ ! -e other.json ]
  run "$frond" new other
  [ "$status" -ne 0 ]
  [[ "$output" == *"--from or --with"* ]]
}

@test "a species is found by its Latin name and by an everyday one" {
  "$frond" list --json | python3 -c 'import json, sys; rows = [r for r in json.load(sys.stdin) if r["group"] == "species"]
assert len(rows) > 30 and any("Lavandula" in r["doc"] for r in rows)'
  run "$frond" check "lavandula angustifolia" "English lavender"
  [ "$status" -eq 0 ]
  run "$frond" describe Lavandula
  [[ "$output" == *"species/plants/lavender.json"* ]]
}

@test "describe says what a property does, by name and by word" {
  run "$frond" describe tree/habit/internode
  [ "$status" -eq 0 ]
  [ "${lines[0]}" = "tree/habit/internode  (number, 0.005 to 2 m; default 0.1)" ]
  [ "${#lines[@]}" -eq 2 ]
  run "$frond" describe leaf size
  [[ "$output" == *"ivy/leaves/size"* ]]
  run "$frond" describe
  [[ "$output" == *"weber_penn"*"underwater"*"organism/place"*"film"* ]]
  run "$frond" describe coral/grammar
  [[ "${lines[1]}" == *'"form": "own"'* ]]
  run "$frond" describe no-such-word
  [ "$status" -eq 2 ]
  [ "${#lines[@]}" -eq 1 ]
  [[ "$output" == *'; see `frond describe`' ]]
  run "$frond" describe tree/habbit
  [ "$status" -eq 2 ]
  [ "$output" = 'tree/habbit: no property has this name, and none has these words; did you mean "tree/habit"?' ]
}

@test "alone it says what to do next" {
  run "$frond"
  [ "$status" -eq 0 ]
  [[ "$output" == *"frond new"*"frond describe"* ]]
}

@test "an include stands alone and says so where nothing is there" {
  "$frond" new vase --from vase -q
  run --separate-stderr "$frond" export vase.json -o my-vase.inc
  [ "$status" -eq 0 ]
  [[ "$stderr" == *'my-vase.inc: '*'object { Frond_My_Vase(0, 0) }' ]]
  ! grep -q '#include "frond' my-vase.inc
  run "$frond" export "$root/presets/ivy/column.json" --frame 1000 -o ivy.inc
  [ "$status" -eq 2 ]
  [ ! -e ivy.inc ]
}

@test "render.sh alone lists the presets with their titles" {
  run "$root/scripts/render.sh"
  [ "$status" -eq 0 ]
  [[ "$output" == *"presets/reef.json  "*" A reef"* ]]
  [[ "$output" != *"presets/grammars/"* ]]
  [ "$(grep -c '^presets/' <<<"$output")" -eq "$(find "$root/presets" -name '*.json' ! -path '*/grammars/*' | wc -l)" ]
}

@test "an organism with a very long name is exported, with files of names that can be" {
  long=$(printf 'n%.0s' {1..400})
  printf '{"organisms": [{"kind": "vase", "name": "%s", "height": 0.4}]}' "$long" >long.json
  for format in obj ply glb inc; do
    run "$frond" export long.json --texture 32 --detail 400 -o "long.$format"
    echo "$output"
    [ "$status" -eq 0 ]
    [ -s "long.$format" ]
  done
  [ -s long.mtl ]
  awk '/^map_Kd/ {print $2}' long.mtl | while read -r picture; do [ -s "$picture" ]; done
}

@test "help lists commands as people work, and none that only programs call" {
  run "$frond" --help
  [ "$status" -eq 0 ]
  [[ $output == *$'\nMake:\n  new '*$'\nLook:\n  look '*$'\nRender:\n  render '*$'\nGive to other programs:\n  export '* ]]
  for hidden in confine develop frame gallery task; do
    [[ $output != *$'\n'"  $hidden "* ]]
    "$frond" "$hidden" --help
  done
}
