#!/usr/bin/env bash
# Installs what was built into a folder of its own, builds docs/examples/library against that alone, and runs it and
# the installed program as somebody who has no sources: install_test.sh BUILD EXAMPLE
set -euo pipefail
build=$1 example=$2
work=$(mktemp -d)
trap 'rm -rf -- "$work"' EXIT
unset FROND_HOME FROND_BIN
cmake --install "$build" --prefix "$work/usr" >"$work/install.log"
cmake -S "$example" -B "$work/build" -DCMAKE_PREFIX_PATH="$work/usr" >"$work/configure.log"
cmake --build "$work/build" >"$work/build.log" || { cat "$work/build.log" && exit 1; }
cd "$work"
[[ $(build/grow_oak 3 oak.glb) == "oak: "*" nodes" ]]
[[ $(head -c 4 oak.glb) == glTF ]]
! build/grow_oak -3 no.glb 2>faults
grep -q "/organisms/0/years" faults
[[ ! -e no.glb ]]
usr/bin/frond check oak
usr/bin/frond generate vases --size 32x18 --out vases -q
grep -q "usr/bin/frond" vases/build.ninja
# Nothing in what is installed names the folder where it was built.
! grep -rlF "$(realpath -- "$build")" usr
