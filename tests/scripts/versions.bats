#!/usr/bin/env bats
# What versions there are is told and agrees. Presets of earlier versions, as they were, are told and carried over. tests/upgrade holds them; of the clearing two of eight trees.

bats_require_minimum_version 1.5.0

setup() {
  root=$BATS_TEST_DIRNAME/../..
  frond=${FROND:-$root/build/frond}
  cd "$BATS_TEST_TMPDIR" || exit
  cp "$root"/tests/upgrade/*.json .
}

@test "check names the command that carries an old preset over" {
  for preset in *.json; do
    run "$frond" check "$preset"
    echo "$preset: $output"
    [[ "$output" == *"$preset: is of an earlier version; \`frond check --upgrade '$preset'\` carries it over"* ]]
  done
  run "$frond" info brain.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"brain.json: is of an earlier version; "* ]]
}

@test "check --upgrade makes old presets valid, says each change, and changes nothing the second time" {
  run --separate-stderr "$frond" check --upgrade ./*.json
  echo "$output $stderr"
  [ "$status" -eq 0 ]
  [ -z "$stderr" ]
  for change in "brain.json:20:15: /organisms/0/wave: is called valley" \
    "clearing.json:22:66: /stand/events/1/cut: is an object, which names an organism and has the share" \
    "dandelions.json:10:177: /scene/meadow/hills: is told by /scene/far: {\"relief\": 21}" \
    "reef.json:21:19: /defaults/food/strength: is in degrees: 28.6479 for 0.5 radians" \
    "species.json:47:17: /organisms/13/species: is called \"species/corals/bird_nest.json\""; do
    echo "$change"
    [[ "$output" == *"./$change"* ]]
  done
  cp -r . ../once
  run "$frond" check --upgrade ./*.json
  echo "$output"
  [ "$status" -eq 0 ]
  [ -z "$output" ]
  diff -r . ../once
}

@test "what is carried over keeps comments, layout, rights and links" {
  mv brain.json real.json
  chmod 600 real.json
  ln -s real.json brain.json
  "$frond" check --upgrade brain.json
  [ -L brain.json ]
  [ "$(stat -c %a real.json)" = 600 ]
  # One line has changed.
  [ "$(diff "$root/tests/upgrade/brain.json" real.json | grep -c '^[<>]')" -eq 2 ]
  grep -q '// Pseudodiploria' real.json
  "$frond" check --upgrade clearing.json
  [ "$(diff "$root/tests/upgrade/clearing.json" clearing.json | grep -c '^[<>]')" -le 6 ]
}

@test "check --upgrade ends with 2 where a preset has other faults, and writes nothing of what is none" {
  echo '{"organisms": [{"kind": "massive", "wave": 0.01, "colour": 3}]}' >other.json
  run "$frond" check --upgrade other.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"unknown property \"colour\""* ]]
  grep -q valley other.json
  echo '{"axiom": "F", "rules": []}' >grammar.json
  cp grammar.json before
  "$frond" check --upgrade grammar.json
  cmp grammar.json before
  run "$frond" check --upgrade missing.json
  [ "$status" -eq 2 ]
  [ ! -e missing.json ]
}

@test "--version names Frond, its libraries and the POV-Ray that would render" {
  run "$frond" --version
  echo "$output"
  [ "$status" -eq 0 ]
  [ "${#lines[@]}" -eq 3 ]
  [[ "${lines[0]}" =~ ^frond\ [0-9]+\.[0-9]+\.[0-9]+$ ]]
  for library in OpenVDB oneTBB Embree libpng OpenEXR nlohmann-json GLM fmt meshoptimizer cpp-httplib; do
    echo "$library"
    [[ "${lines[1]}, " =~ $library\ [0-9][0-9.]*,\  ]]
  done
  printf '#!/bin/sh\necho "POV-Ray 3.8.0-beta " >&2\n' >own-povray
  chmod +x own-povray
  FROND_POVRAY=$PWD/own-povray run "$frond" --version
  [ "${lines[2]}" = "POV-Ray 3.8.0-beta ($PWD/own-povray)" ]
  FROND_POVRAY=nowhere run "$frond" --version
  [ "$status" -eq 0 ]
  [ "${lines[2]}" = "POV-Ray: none found as nowhere" ]
}

@test "all that names the version of Frond names the same" {
  version=$("$frond" --version | sed -n 's/^frond //p')
  grep -qF "project(frond VERSION $version " "$root/CMakeLists.txt"
  grep -qx "version: $version" "$root/CITATION.cff"
  grep -qx "version = \"$version\"" "$root/gen/apps/blender/blender_manifest.toml"
  grep -qx "version = \"$version\"" "$root/gen/apps/python/pyproject.toml"
  head -n 1 "$root/scripts/package/changelog" | grep -qF "frond ($version) "
  grep -qF "## $version" "$root/CHANGELOG.md"
}
