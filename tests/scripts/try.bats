#!/usr/bin/env bats
# `frond try` from the command line; what the page does is tested in a browser.

bats_require_minimum_version 1.5.0

setup() {
  frond=${FROND_BIN:-$BATS_TEST_DIRNAME/../../build/frond}
  cd "$BATS_TEST_TMPDIR" || return
  mkdir -p home/templates bin
  touch home/templates/frame.pov
  export FROND_HOME=$BATS_TEST_TMPDIR/home
  printf '#!/bin/sh\necho "$1" >"%s/opened"\n' "$BATS_TEST_TMPDIR" >bin/xdg-open
  chmod +x bin/xdg-open
}

@test "where the page was not built, try says what builds it" {
  run -2 "$frond" try
  [ "$output" = "try: the page was not built; in a checkout of Frond scripts/setup.sh --try does it" ]
  run -2 "$frond" try --print
}

@test "try opens the page of a checkout, and rather that of an installation" {
  mkdir -p home/build/try/page home/try
  echo page >home/build/try/page/index.html
  run --separate-stderr env PATH="$PWD/bin:$PATH" "$frond" try
  [ "$status" -eq 0 ]
  [ "$output" = "$FROND_HOME/build/try/page/index.html" ]
  for _ in $(seq 100); do [ -s opened ] && break || sleep 0.05; done
  [ "$(cat opened)" = "$output" ]
  echo page >home/try/index.html
  run -0 "$frond" try --print
  [ "$output" = "$FROND_HOME/try/index.html" ]
}

@test "without a desktop try says where the page is" {
  mkdir -p home/try
  echo page >home/try/index.html
  run --separate-stderr env PATH="$PWD" "$(command -v "$frond")" try
  [ "$status" -eq 1 ]
  [ "$output" = "$FROND_HOME/try/index.html" ]
  [ "$stderr" = "xdg-open: there is none; open the file by hand" ]
}
