#!/usr/bin/env bash
# Builds build/frond; quick where nothing changed.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/build.sh [--tests] [TARGET...]

Configures and builds in build/ (by default the target frond), with the log in build/build.log.

  --tests   configures the tests, too, and builds all targets
  --help    this text

Exit codes: 0 built, 1 not, 2 wrong option.
TEXT
}

targets=()
tests=''
for argument in "$@"; do
  case $argument in
    -h | --help) usage; exit 0 ;;
    --tests) tests=yes ;;
    -*) unknown_option "$argument" ;;
    *) targets+=("$argument") ;;
  esac
done
if ((${#targets[@]} == 0)); then
  if [[ -n $tests ]]; then targets=(all); else targets=(frond); fi
fi

cd -- "$root"
mkdir -p build
log=build/build.log
exec {lock}>build/.lock
flock "$lock"
: >"$log"

give_up() {
  end_bar
  tail -n 40 -- "$log" >&2
  fail 1 "could not $1; the whole log is $root/$log"
}

# The notes of a build name its folder: those of a copied or moved checkout are another's.
fresh=()
noted() { sed -n "s/^$1:INTERNAL=//p" build/CMakeCache.txt; }
if [[ -f build/CMakeCache.txt ]] && ! [[ $(noted CMAKE_HOME_DIRECTORY) -ef . && $(noted CMAKE_CACHEFILE_DIR) -ef build ]]; then
  say "build/ was configured for $(noted CMAKE_HOME_DIRECTORY); configuring it afresh"
  fresh=(--fresh)
  rm -f build/build.ninja
fi
if [[ ! -f build/build.ninja ]] || { [[ -n $tests ]] && ! grep -qx 'FROND_TESTS:BOOL=ON' build/CMakeCache.txt; }; then
  say "Configuring the build"
  cmake ${fresh[@]+"${fresh[@]}"} --preset release "-DFROND_TESTS=$([[ -n $tests ]] && echo ON || echo OFF)" >>"$log" 2>&1 || give_up "configure the build"
fi

# Ninja's own lines are marked, so that they are told from what compilers say.
quarter=-1
export NINJA_STATUS=$'\001%f %t '
(tied ninja -C build -j "$(nproc)" -- "${targets[@]}") 2>&1 | {
  while IFS= read -r line; do
    printf '%s\n' "${line#$'\001'}" >>"$log"
    if [[ $line != $'\001'* ]]; then continue; fi
    read -r step all _ <<<"${line#?}"
    if ((step == 0)); then continue; fi  # only a look at which files there are
    if on_terminal; then
      draw_bar "$step" "$all" "building, $step of $all"
    elif ((4 * step / all != quarter)); then
      quarter=$((4 * step / all))
      say "Building: $step of $all"
    fi
  done
  end_bar
} || give_up "build"
