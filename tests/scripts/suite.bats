# scripts/test.sh with a setup.sh, a build.sh, a cmake and a ctest that only pretend.

setup() {
  load common
  tree=$BATS_TEST_TMPDIR/tree calls=$BATS_TEST_TMPDIR/calls
  export CALLS=$calls
  mkdir -p "$tree"/{scripts,.ci,build,tests}
  cp "$ROOT"/scripts/{test,lib}.sh "$tree/scripts"
  cp "$ROOT/.ci/run" "$tree/.ci"
  stand_in "$tree/scripts/setup.sh" 'echo "setup $*" >>"$CALLS"'
  stand_in "$tree/scripts/build.sh" 'echo "build $*" >>"$CALLS"'
  mkdir "$BATS_TEST_TMPDIR/bin"
  stand_in "$BATS_TEST_TMPDIR/bin/cmake" :
  stand_in "$BATS_TEST_TMPDIR/bin/ctest" '[[ $* == *" -N "* ]] || { echo "ctest $*" >>"$CALLS"; eval "${WHILE_TESTING:-}"; }'
  stand_in "$BATS_TEST_TMPDIR/bin/nproc" 'echo 2'
  PATH=$BATS_TEST_TMPDIR/bin:$PATH
}

stand_in() {
  printf '#!/bin/bash\n%s\n' "$2" >"$1"
  chmod +x "$1"
}

@test "tests that write into the sources fail, whatever they write" {
  run "$tree/scripts/test.sh"
  echo "$output"
  [ "$status" -eq 0 ]
  local row
  for row in "mkdir -p gen/page/node_modules|., gen, gen/page" "echo x >>scripts/lib.sh|scripts/lib.sh" \
    "echo x >'tests/new file'|tests, tests/new file" "touch tests/gone; rm tests/gone|tests"; do
    cp -r "$tree" "$BATS_TEST_TMPDIR/copy"
    WHILE_TESTING=${row%|*} run "$BATS_TEST_TMPDIR/copy/scripts/test.sh"
    echo "$row: $output"
    [ "$status" -eq 1 ]
    [[ $output == *"the sources have changed while the tests ran, which write nothing there: "*"${row#*|}" ]]
    rm -r "$BATS_TEST_TMPDIR/copy"
  done
  # What is made of the sources is none.
  WHILE_TESTING='mkdir -p build/gltf build-asan/x; echo x >build/log' run "$tree/scripts/test.sh" --all
  echo "$output"
  [ "$status" -eq 0 ]
}

@test "continuous integration runs the plain tests as README.md says it, and none of them twice" {
  "$tree/.ci/run"
  cat "$calls"
  diff "$calls" - <<'TEXT'
setup --tests --quiet
build --tests
ctest --preset release -j 2 --no-tests=error -LE ^long$|^large$|^slow$
setup --all --quiet
build --tests
ctest --preset release -j 2 --no-tests=error -LE ^long$ -L ^slow$
ctest --preset release -j 2 --no-tests=error -LE ^long$ -L ^large$ --repeat until-pass:2
ctest --preset asan -j 2 --no-tests=ignore
TEXT
  grep -qx '    scripts/test.sh .*' "$ROOT/README.md"
}

@test "with --all all tests run, and a label that is left out is left out beside the long ones" {
  "$tree/scripts/test.sh" --all -LE slow -R x
  cat "$calls"
  grep -qxF 'ctest --preset release -j 2 --no-tests=error -LE ^long$|slow -R x' "$calls"
  grep -qxF 'ctest --preset asan -j 2 --no-tests=ignore -R x' "$calls"
}

@test "the workflow runs what README.md says, makes packages and tries them" {
  workflow=$ROOT/.github/workflows/ci.yml
  while read -r command; do
    echo "$command"
    grep -qF "    $command" "$ROOT/README.md"
    grep -qxF "      - run: $command" "$workflow"
  done <<'COMMANDS'
scripts/test.sh
scripts/render.sh presets/reef.json
COMMANDS
  grep -qxF "      - run: ctest --preset release -j 2 -L '^slow$' -LE '^long$'" "$workflow"
  grep -qF -- "- run: scripts/package.sh" "$workflow"
  grep -qF -- "- run: tests/package_test.sh --apt out/packages" "$workflow"
  # All that it calls is there.
  for script in $(grep -oE '(scripts|tests)/[a-z_]+\.sh' "$workflow" "$ROOT/Containerfile" -h | sort -u); do
    echo "$script"
    [ -x "$ROOT/$script" ]
  done
}
