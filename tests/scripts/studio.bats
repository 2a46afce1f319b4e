#!/usr/bin/env bats
# `frond studio` from the command line; what the page does is tested in a browser.

bats_require_minimum_version 1.5.0

setup() {
  load common
  frond=${FROND_BIN:-$BATS_TEST_DIRNAME/../../build/frond}
  root=$(cd -- "$BATS_TEST_DIRNAME/../.." && pwd)
  export FROND_HOME=$root
  cd "$BATS_TEST_TMPDIR" || return
}

@test "the studio wants a preset that is there" {
  run "$frond" studio missing.json
  [ "$status" -eq 2 ]
  [[ "$output" == *"missing.json: is no file"* ]]
}

@test "a port that cannot be had is told" {
  run "$frond" studio --port 99999
  [ "$status" -eq 2 ]
}

@test "without its page the studio says what to run, and with it the address, and ends when it is told to" {
  coproc STUDIO { exec "$frond" studio 2>said; }
  studio=$STUDIO_PID address=''
  read -r address <&"${STUDIO[0]}" || true  # comes back when there is a line, or the program has ended
  if [[ -n $address ]]; then
    [[ $address =~ ^http://127\.0\.0\.1:[0-9]+/#token=[0-9a-f]{32}$ ]]
    kill -TERM "$studio"
    wait "$studio"
  else
    status=0
    wait "$studio" || status=$?
    [ "$status" -eq 1 ]
    grep -q 'scripts/setup.sh --studio' said
  fi
}
