# What the scripts say to one who is new to them.

setup() {
  load common
  need_frond
  cd "$BATS_TEST_TMPDIR"
}

@test "every script has help, and says what it wants" {
  for script in "$ROOT"/scripts/*; do
    case $script in */lib*.sh | *.ini | */package | */__pycache__) continue ;; esac
    run "$script" --help
    echo "$script: $output"
    [ "$status" -eq 0 ]
    [[ ${output,,} == *usage:* ]]
  done
  for command in frame film sheet compare confine; do
    run "$FROND_BIN" "$command"
    echo "$command: $output"
    [ "$status" -eq 2 ]
    [[ $output == *"is required"*"Run with --help for more information." ]]
  done
}

@test "a preset that is not there is looked for under all presets" {
  run "$RENDER" oka.json
  [ "$status" -eq 2 ]
  [[ $output == 'error: oka.json: no such preset; did you mean "'*'presets/trees/oak.json"?' ]]
  cd "$ROOT"
  for row in "oka presets/trees/oak.json" "presets/Oak.json presets/trees/oak.json" "birhc presets/trees/birch.json" \
    "brick-wall presets/ivy/brick_wall.json"; do
    run "$RENDER" "${row% *}"
    echo "$row: $output"
    [ "$output" = "error: ${row% *}: no such preset; did you mean \"${row#* }\"?" ]
  done
  run "$RENDER" bosh
  [ "$output" = 'error: bosh: no such preset; did you mean "presets/bush.json" or "presets/garden/bush.json"?' ]
  run "$RENDER" nothing_of_the_kind
  [ "$output" = "error: nothing_of_the_kind: no such preset" ]
}

@test "an unknown option is told with the nearest" {
  local row
  for row in "build --test|--tests" "setup --studo|--studio"; do
    # shellcheck disable=SC2086
    run "$ROOT/scripts/${row%% *}.sh" $(cut -d' ' -f2 <<<"${row%|*}")
    echo "$row: $output"
    [ "$status" -eq 2 ]
    [[ $output == "error: unknown option '--"*"'; did you mean ${row#*|}?"* ]]
  done
  for row in "--sise|--size" "--qualty=good|--quality" "--frame|--frames"; do
    run "$RENDER" "${row%|*}"
    echo "$row: $output"
    [ "$status" -eq 2 ]
    [[ $output == "--"*": no such option of frond render; did you mean \"${row#*|}\"?"* ]]
  done
  run "$ROOT/scripts/farm.sh" --partion
  [ "$status" -eq 2 ]
  [[ $output == "--partion: no such option of frond farm; did you mean \"--partition\"?"* ]]
  run "$RENDER" --nothing-like-it
  [[ $output == "--nothing-like-it: no such option of frond render"$'\n'* ]]
}

@test "what the environment may say is in a help or in the docs" {
  cd "$ROOT"
  local name
  for name in $({ grep -rhoE '(getenv|environment_or|program_variable)\("FROND_[A-Z]+' gen; grep -hoE '\$\{FROND_[A-Z]+' scripts/*.sh; } | grep -oE 'FROND_[A-Z]+' | sort -u); do
    echo "$name"
    grep -rqE "\b$name\b" docs/*.md README.md CONTRIBUTING.md
  done
}

@test "how far a run is renews one line on a terminal, and is a line for each tenth elsewhere" {
  generate=("$FROND_BIN" generate "$ROOT/tests/presets/tiny_film.json")
  "${generate[@]}" --out plain 2>words
  grep -qx 'frames 5/6' words
  [[ $(<words) != *$'\r'* ]]
  python3 -c 'import pty, sys; sys.exit(pty.spawn(sys.argv[1:]))' "${generate[@]}" --out shown >words </dev/null
  grep -q $'\rframes 5/6\rframes 6/6' words
}

@test "a copied checkout configures itself, not the one it was copied from" {
  mkdir -p bin one/build
  cp -r "$ROOT/scripts" one
  cat >bin/cmake <<'SH'
#!/bin/sh
echo "$PWD: $*" >>"$CALLS"
printf 'CMAKE_HOME_DIRECTORY:INTERNAL=%s\nCMAKE_CACHEFILE_DIR:INTERNAL=%s/build\n' "$PWD" "$PWD" >build/CMakeCache.txt
: >build/build.ninja
SH
  printf '#!/bin/sh\nexit 0\n' >bin/ninja
  chmod +x bin/*
  export CALLS=$PWD/calls PATH=$PWD/bin:$PATH
  one/scripts/build.sh
  one/scripts/build.sh
  [ "$(cat calls)" = "$PWD/one: --preset release -DFROND_TESTS=OFF" ]
  cp -r one two
  run two/scripts/build.sh
  echo "$output"
  [ "$status" -eq 0 ]
  [[ $output == *"build/ was configured for $PWD/one; configuring it afresh"* ]]
  [ "$(tail -n 1 calls)" = "$PWD/two: --fresh --preset release -DFROND_TESTS=OFF" ]
  mv two three
  three/scripts/build.sh
  [ "$(tail -n 1 calls)" = "$PWD/three: --fresh --preset release -DFROND_TESTS=OFF" ]
  mkdir link && ln -s "$PWD/three" link/three  # another name of the same folder
  link/three/scripts/build.sh
  [ "$(grep -c '' calls)" -eq 3 ]
}

@test "the pictures of README.md are there, and none twice" {
  cd "$ROOT"
  grep -o 'docs/gallery/[^)]*' README.md | sort >"$BATS_TEST_TMPDIR/shown"
  [ -z "$(uniq -d "$BATS_TEST_TMPDIR/shown")" ]
  xargs ls <"$BATS_TEST_TMPDIR/shown" >/dev/null
}

@test "README.md is short, and what README.md and docs link to is there" {
  cd "$ROOT"
  [ "$(grep -c '' README.md)" -le 120 ]
  local page link
  for page in README.md CONTRIBUTING.md CHANGELOG.md docs/*.md; do
    for link in $(sed '/^    /d' "$page" | grep -oE '\]\([^) ]+\)' | sed 's/^](//; s/)$//; s/#.*//' | grep -vE '^[a-z]+:' | sort -u); do
      [ -e "$(dirname "$page")/$link" ] || { echo "$page: $link" && return 1; }
    done
  done
}

@test "large pictures of the gallery are those of its list" {
  run "$ROOT/scripts/gallery.sh" --large vases
  [ "$status" -eq 2 ]
  [[ $output == *"vases: no picture of --large; expected some of reef ivy-brick_wall"* ]]
  run "$ROOT/scripts/gallery.sh" --huge
  [ "$status" -eq 2 ]
  local name
  for name in $(sed -n 's/^large: //p' "$ROOT/docs/gallery/pictures.txt"); do
    grep -q "^$name [0-9]*x[0-9]* 1 " "$ROOT/docs/gallery/pictures.txt"
  done
}
