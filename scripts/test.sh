#!/usr/bin/env bash
# Installs what is missing, builds everything and runs the tests.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/test.sh [--all | --rest] [CTEST_OPTION...]

Runs the tests; the summary is ctest's. Those labelled "slow", which take seconds each, and "large", which need large
programs, are left out and told unless --all is given. Options go to ctest: -L scripts runs the tests of one label,
-R NAME those of a name.

  --all     all of them, and installs what they need; and then quick ones of the modules that grow and compute once
            more, and the program on some presets, in build-asan, with asserts and the address and undefined behaviour
            sanitizers
  --rest    only what --all adds, for where the others have just been run; a large test that fails runs once more, since
            a browser or a queue of jobs keeps limits of time of its own on a busy machine: ctest shows both runs
  --help    this text

What is labelled "long" only ctest runs: \`ctest --preset release -L long\`.
Tests write nothing into the sources. What has changed there while they ran is named, and counts as a test that failed.

Exit codes: 0 all passed, 1 not.
TEXT
}
# ctest leaves out only what all of several -LE name, so they are made one.
setup=--tests excluded='^long$|^large$|^slow$' rest='' options=()
while (($# > 0)); do
  case $1 in
    -h | --help) usage; exit 0 ;;
    --all) setup=--all excluded='^long$' ;;
    --rest) setup=--all excluded='^long$' rest=yes ;;
    -LE | --label-exclude) excluded+=${excluded:+|}${2:-} && shift ;;
    *) options+=("$1") ;;
  esac
  shift
done

# sources: all files and folders that are no products (.gitignore), with their sizes and times.
sources() {
  find . \( -path './build*' -o -path ./.git -o -path ./out -o -path ./.cache -o -name node_modules \) -prune -o -printf '%p %y %s %T@\n' |
    LC_ALL=C sort
}

"$root/scripts/setup.sh" "$setup" --quiet
"$root/scripts/build.sh" --tests
cd -- "$root"
if [[ $setup != --all ]]; then
  left() { ctest --preset release -N -L "$1" -LE '^long$' | sed -n 's/^ *Test *#[0-9]*: //p'; }
  say "Left out without --all: $(left '^slow$' | wc -l) tests that take seconds each, and what needs large programs:" \
    "$(left '^large$' | paste -sd ' ')"
else
  mkdir -p build-asan
  # With what the tests leave of the processors, as they do where one of them must run alone.
  (tied bash -c "cmake --preset asan && nice -n 19 cmake --build --preset asan -j $(nproc)") >build-asan/build.log 2>&1 &
  asan=$!
fi
before=$(sources)
run() {
  ctest --preset release -j "$(nproc)" --no-tests=error -LE "$excluded" "$@" "${options[@]}" || fail 1 "not all tests passed"
}
if [[ -n $rest ]]; then
  run -L '^slow$'
  run -L '^large$' --repeat until-pass:2
else
  run
fi
if [[ $setup == --all ]]; then
  say "Building with sanitizers"
  wait "$asan" ||
    { tail -n 40 build-asan/build.log >&2 && fail 1 "could not build with sanitizers; the whole log is $root/build-asan/build.log"; }
  ctest --preset asan -j "$(nproc)" --no-tests=ignore "${options[@]}" ||
    fail 1 "not all tests passed with sanitizers"
fi
changed=$(comm -3 <(printf '%s\n' "$before") <(sources) | sed -E 's/^\t?(\.\/)?(.*) [a-z] [0-9]+ [0-9.]+$/\2/' | LC_ALL=C sort -u | paste -sd ,)
[[ -z $changed ]] || fail 1 "the sources have changed while the tests ran, which write nothing there: ${changed//,/, }"
