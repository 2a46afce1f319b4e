#!/usr/bin/env bats
# Files as people bring them: pasted from pages, kept since DOS, of other programs. Each folder of tests/cases is one kind.

bats_require_minimum_version 1.5.0

setup() {
  load common
  frond=${FROND_BIN:-$BATS_TEST_DIRNAME/../../build/frond}
  root=$(cd -- "$BATS_TEST_DIRNAME/../.." && pwd)
  export FROND_HOME=$root
  cases=$root/tests/cases
  cd "$BATS_TEST_TMPDIR" || return
}

@test "a minus sign of a web page is named with its place and the sign that is meant" {
  for file in fern_minus_only fern_pasted; do
    run "$frond" turtle "$cases/02-unicode-paste/$file.json"
    [ "$status" -eq 2 ]
    [[ "$output" == *"/rules/0: column "*'`−` (U+2212) is not `-`, which is meant'* ]]
  done
  run "$frond" derive "$cases/02-unicode-paste/fern_greek.json" --steps 1
  [ "$output" = 'F[+ω][-ω]' ]
}

@test "odd signs in an axiom are named, too" {
  echo '{"axiom": "F−F", "rules": ["F -> FF"]}' > odd.json
  run "$frond" derive odd.json
  [ "$status" -eq 2 ]
  [[ "$output" == *'axiom: column 2: `−` (U+2212) is not `-`'* ]]
  echo '{"axiom": "F［+F］", "rules": ["F -> FF"]}' > odd.json
  run "$frond" turtle odd.json
  [ "$status" -eq 2 ]
  [[ "$output" == *'axiom: column 2: `［` (U+FF3B) is not `[`'* ]]
}

@test "grammars of DOS days give the word of those of today" {
  run --separate-stderr "$frond" derive "$cases/03-dos-lparser/BUSH.LS" --steps 2
  [ "$status" -eq 0 ]
  upper=$output
  run --separate-stderr "$frond" derive "$cases/03-dos-lparser/bush.ls" --steps 2
  [ "$output" = "$upper" ]
  run --separate-stderr "$frond" derive "$cases/03-dos-lparser/bush5.ls" --steps 2
  [ "$status" -eq 0 ]
  [[ "$stderr" == *'line 5: `trope` of lsuss has no effect here'* ]]
  five=$output
  run --separate-stderr "$frond" derive "$cases/03-dos-lparser/bush5_spaces.ls" --steps 2
  [ "$output" = "$five" ]
  run "$frond" import "$cases/03-dos-lparser/BUSH.LS" -o bush.json
  [ "$status" -eq 0 ]
}

@test "numbers of parameters that nothing rewrites are told with rule and column" {
  run --separate-stderr "$frond" derive "$cases/04-arity-and-pairs/bare_axiom.json"
  [[ "$stderr" == *'axiom: column 1: `A` has 0 parameters here and is rewritten with 1 (rule 1, column 1) only'* ]]
  run --separate-stderr "$frond" derive "$cases/04-arity-and-pairs/two_and_three.json"
  [[ "$stderr" == *'`B` has 2 parameters here and is rewritten with 3 (rule 1, column 1) or with 1 (rule 2, column 1) only'* ]]
  run "$frond" derive "$cases/04-arity-and-pairs/pair.json"
  [ "$status" -eq 2 ]
  [[ "$output" == *"contexts"*"cpfg"* ]]
  run "$frond" derive "$cases/04-arity-and-pairs/pair.l" --steps 1
  [ "$output" = "S(30)S(60)" ]
}

@test "a division by zero is told of the rule that divides" {
  for command in derive turtle; do
    run "$frond" $command "$cases/04-arity-and-pairs/zero.json"
    [ "$status" -eq 2 ]
    [[ "$output" == *"/rules/0: "*"column 11: division by zero in"* ]]
  done
}

@test "models of L-Py are named, whatever their files are called" {
  for file in massart.lpy massart_renamed.l; do
    run "$frond" derive "$cases/05-lpy-massart-ply/$file"
    [ "$status" -eq 2 ]
    [[ "$output" == *"L-Py"*"-->"* ]]
  done
  run "$frond" info "$cases/05-lpy-massart-ply/massart.json"
  [[ "$output" == *"197 segments"* ]]
}

@test "a PLY is read to its last byte" {
  run "$frond" export "$cases/05-lpy-massart-ply/massart_preset.json" -o tree.ply
  [ "$status" -eq 0 ]
  python3 "$cases/05-lpy-massart-ply/strict_ply.py" tree.ply
}

@test "in() of Houdini is refused with its place and the ways round" {
  run "$frond" turtle "$cases/06-houdini-inside/dome_in.txt"
  [ "$status" -eq 2 ]
  [[ "$output" == *'line 6: column 6: `in` '*"x, y and z"*"colonized"*"?E"* ]]
  run --separate-stderr "$frond" turtle "$cases/06-houdini-inside/dome_xyz.txt"
  [ "$status" -eq 0 ]
}

@test "a measured skeleton is drawn as it was measured, and imported in metres" {
  run --separate-stderr "$frond" turtle "$cases/07-swc-skeleton/vine.swc"
  [ "$status" -eq 0 ]
  [[ "$output" == *'"segments": 24,'* ]]
  run "$frond" import "$cases/07-swc-skeleton/vine.swc" -o vine.json
  [ "$status" -eq 0 ]
  run "$frond" check vine.json
  [ "$status" -eq 0 ]
}

@test "a measured skeleton leads plants, trees and ivy" {
  cp "$cases/07-swc-skeleton/vine.swc" .
  echo '{"axiom": "A(40)", "steps": 41, "rules": ["A(n) : n > 0 -> ?FA(n-1)"],
    "guide": {"file": "vine.swc", "tolerance": 0.02, "leniency": 1}}' > led.json
  run --separate-stderr "$frond" turtle led.json
  [ "$status" -eq 0 ]
  [[ "$output" == *'"turtles_at_end": 3,'* ]]
  echo '{"scene": {"setting": "studio"}, "organisms": [
    {"kind": "colonized", "guide": {"file": "vine.swc"}, "place": {"at": [[0, 0]]}}]}' > colonized.json
  run "$frond" check colonized.json
  [ "$status" -eq 0 ]
  echo '{"scene": {"setting": "garden"}, "organisms": [
    {"kind": "ivy", "crawl": {"guides": [{"file": "vine.swc", "width": 0.1}]}}]}' > ivy.json
  run "$frond" check ivy.json
  [ "$status" -eq 0 ]
  echo "1 0 0 0 0 secret" > vine.swc
  run "$frond" check colonized.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"is a skeleton that cannot be read"* && "$output" != *"secret"* ]]
}

@test "levels of detail keep the box, the leaves and the trunk of the first" {
  for tree in birch spruce; do
    echo '{"scene": {"setting": "meadow"}, "organisms": [{"species": "trees/'$tree'", "years": 12}]}' >$tree.json
    run "$frond" export $tree.json --lods 4 --texture 0 -o $tree.glb
    [ "$status" -eq 0 ]
    python3 "$cases/11-lod-silhouette/levels.py" $tree.glb
  done
}

@test "a tree for laser scans has leaves of true size at any detail, and steady names" {
  for detail in 100000 1000000 1000000000; do
    run "$frond" export "$root/presets/trees/birch.json" --set /organisms/0/years=12 --texture 0 --detail $detail -o $detail.obj
    [ "$status" -eq 0 ]
  done
  python3 "$cases/12-lidar-leaves/leaves.py" 100000.obj 1000000.obj 1000000000.obj
  run "$frond" export "$root/presets/trees/birch.json" --set /organisms/0/years=7 --set /seed=9 --texture 0 -o other.obj
  [ "$status" -eq 0 ]
  [ "$(grep newmtl 100000.mtl | sort)" = "$(grep newmtl other.mtl | sort)" ]
  grep -q "Simulators that take z as up" "$root/docs/export.md"
}

@test "close nodes between long pieces make no knob" {
  run "$frond" export "$cases/23-pov-close-nodes/cane.json" --sides 32 -o cane.obj
  [ "$status" -eq 0 ]
  python3 - cane.obj <<'P'
import sys
points = [tuple(map(float, line.split()[1:4])) for line in open(sys.argv[1]) if line.startswith("v ")]
for axis in (0, 2):
    low, high = min(p[axis] for p in points), max(p[axis] for p in points)
    assert 0.196 < high < 0.204 and -0.204 < low < -0.196, (axis, low, high)
assert max(p[1] for p in points) < 6.21, "runs past its end"
P
}

@test "a stem that turns back on itself has pieces as short as one likes" {
  for smoothing in 1 3 8; do
    run "$frond" generate "$cases/23-pov-close-nodes/kink.json" --set "/organisms/0/smoothing=$smoothing" -q -o "kink$smoothing"
    [ "$status" -eq 0 ]
    run grep -rniE '[<, ]-?(nan|inf)[,> ]' "kink$smoothing"
    [ "$status" -eq 1 ]
  done
}
