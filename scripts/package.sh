#!/usr/bin/env bash
# Makes Debian packages of what is built.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/package.sh [DIR]

Installs what is missing, builds, and writes into DIR (out/packages):

  frond           the program, its presets, macros and manual page, and what completes its words in shells; the
                  page of \`frond try\`, too, where scripts/setup.sh --try has built it
  frond-studio    its studio in the menu of the desktop
  libfrond0, libfrond-dev   the library, and what programs in C++ need to use it
  python3-frond   the module for Python, where pybind11-dev, python3-dev and python3-numpy are installed

  apt install ./out/packages/frond_*.deb     installs them, with all that they need

The same commit gives the same bytes.
TEXT
}
case ${1:-} in
  -h | --help) usage; exit 0 ;;
  -*) unknown_option "$1" ;;
esac
out=${1:-out/packages}
mkdir -p -- "$out"
out=$(cd -- "$out" && pwd)
"$root/scripts/setup.sh" --package --quiet
"$root/scripts/build.sh" packaged
# The page takes a compiler of its own, which nothing else needs: it is in the package where somebody has built it.
if [[ -f $root/build/try/build.ninja ]]; then
  "$root/scripts/setup.sh" --try --quiet
elif [[ ! -f $root/build/try/page/index.html ]]; then
  say "The package will be without the page of \`frond try\`; scripts/setup.sh --try builds it."
fi
cd -- "$root"
# Times within packages are those of the commit.
SOURCE_DATE_EPOCH=${SOURCE_DATE_EPOCH:-$(git log -1 --format=%ct 2>/dev/null || date +%s)}
export SOURCE_DATE_EPOCH
cd build
cpack -G DEB -B "$out" >cpack.log 2>&1 || fail 1 "cpack made no packages; its words are in $root/build/cpack.log"
rm -rf -- "$out/_CPack_Packages"
ls -1 "$out"/*.deb
