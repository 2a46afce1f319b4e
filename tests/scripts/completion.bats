#!/usr/bin/env bats
# What shells complete, and the manual page: made from the program's own description.

setup() {
  root=$(cd "$BATS_TEST_DIRNAME/../.." && pwd)
  frond=${FROND_BIN:-$root/build/frond}
  export FROND_HOME=$root
  cd "$BATS_TEST_TMPDIR" || return 1
}

# completed WORD...: what bash offers for the last word, one a line.
completed() {
  COMP_WORDS=("$frond" "$@") COMP_CWORD=$#
  _frond 2>/dev/null
  printf '%s\n' "${COMPREPLY[@]}"
}

@test "bash completes commands, options, their values and presets" {
  compopt() { :; }
  source <("$frond" completion bash)
  [ "$(completed rend)" = render ]
  [ "$(completed con)" = "" ] # only programs call it
  completed render oak --qu | grep -x -- --quality
  [ "$(completed render oak --quality b)" = best ]
  completed render st | grep -x staghorn
  completed new mine --from va | grep -x vase
}

@test "bash completes what can be set of the preset that is named" {
  compopt() { :; }
  source <("$frond" completion bash)
  completed render oak --set /organisms/0/habit/pa | grep -x /organisms/0/habit/pace=
  completed render oak --set /film/fra | grep -x /film/frames=
  [ -z "$(completed render oak --set /organisms/1/)" ] # it has one organism
  echo '{"organisms": [{"kind": "vase"}, {"kind": "rock"}]}' >mine.json
  completed check mine.json --set /organisms/0/hei | grep -x /organisms/0/height=
  [ -z "$(completed check mine.json --set /organisms/1/hei)" ]
}

@test "each pointer that is offered is one that can be set" {
  for pointer in /film/quality= /organisms/0/years= /scene/camera/angle=; do
    "$frond" complete -- check oak --set "$pointer" | grep -qx "$pointer"
  done
  "$frond" check oak --set /organisms/0/years=20
}

@test "the manual page names every command of the help and each of its options" {
  "$frond" man >frond.1
  for command in $("$frond" --help | sed -n 's/^  \([a-z]\{3,\}\)  .*/\1/p'); do
    grep -q "^.SS frond $command$" frond.1
  done
  grep -q 'contact\\-seeds' frond.1
  ! grep -q "^.SS frond confine" frond.1
  if command -v man >/dev/null; then
    run man --warnings -E UTF-8 -l -Tutf8 -Z ./frond.1
    [ "$status" -eq 0 ]
    [[ "$output" != *"warning"* ]]
  fi
}
