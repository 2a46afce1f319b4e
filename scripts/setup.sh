#!/usr/bin/env bash
# Installs what building, rendering and testing need (Debian 12, apt).
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

build_packages=(g++ cmake ninja-build ccache libglm-dev nlohmann-json3-dev libfmt-dev libtbb-dev libcli11-dev
  libpng-dev libturbojpeg0-dev libwebp-dev libpugixml-dev libembree-dev libopenvdb-dev
  libboost-iostreams-dev libxxhash-dev libcpp-httplib-dev libmeshoptimizer-dev libopenexr-dev pkgconf)
run_packages=(povray ffmpeg)
test_packages=(libgtest-dev libvalijson-dev libbenchmark-dev libtinyobjloader-dev bats clang-format shellcheck python3 webp)
# A node that came from elsewhere does, so its programs are looked for, not its packages.
node_packages=()
command -v node >/dev/null || node_packages+=(nodejs)
command -v npm >/dev/null || node_packages+=(npm)
# Debian's take what they trust from there, and only recommend it.
if ((${#node_packages[@]} > 0)); then node_packages+=(ca-certificates); fi
try_packages=(emscripten)
# cpack asks the one what a file is, and the other what it needs.
making_packages=(file dpkg-dev)
large_packages=(blender python3-numpy chromium slurmctld slurmd slurm-client parallel openssh-client openssh-server
  pybind11-dev python3-dev python3-pip python3-wheel python3-matplotlib python3-nbformat mypy)

usage() {
  cat <<TEXT
Usage: scripts/setup.sh [--tests] [--studio] [--try] [--package] [--all] [--quiet]

Installs the Debian packages that are missing, as root or through sudo. Where nothing is missing it does nothing
and needs neither root nor network.

  --tests   also what scripts/test.sh needs
  --studio  also node and npm, and builds the page of \`frond studio\` with them; scripts/build.sh then takes it in
  --try     also emscripten, node and npm, and builds the page of \`frond try\` with them, some ten minutes
  --package also what scripts/package.sh makes Debian packages with
  --all     also what scripts/test.sh --all needs: the page, Chromium, Blender, emscripten, pybind11, judges from
            npm in build/, and Slurm, GNU parallel and sshd, of which the tests start their own
  --quiet   one line only, and none where nothing is missing; apt's own words are shown if it fails
  --help    this text

to build:  ${build_packages[*]}
to render: ${run_packages[*]}
to test:   ${test_packages[*]}
TEXT
}

tests='' studio='' try='' package='' all='' quiet=''
for argument in "$@"; do
  case $argument in
    --tests) tests=yes ;;
    --studio) studio=yes ;;
    --try) try=yes ;;
    --package) package=yes ;;
    --all) tests=yes studio=yes package=yes all=yes ;;
    --quiet) quiet=yes ;;
    -h | --help) usage; exit 0 ;;
    *) unknown_option "$argument" ;;
  esac
done

packages=("${build_packages[@]}" "${run_packages[@]}")
if [[ -n $tests ]]; then packages+=("${test_packages[@]}"); fi
if [[ -n $studio$try ]]; then packages+=("${node_packages[@]}"); fi
if [[ -n $try$all ]]; then packages+=("${try_packages[@]}"); fi
if [[ -n $package ]]; then packages+=("${making_packages[@]}"); fi
if [[ -n $all ]]; then packages+=("${large_packages[@]}"); fi

# npm_packages FROM TO: the pinned packages of a folder, where they are not there yet.
npm_packages() {
  if cmp -s "$1/package-lock.json" "$2/node_modules/installed-lock.json"; then return 0; fi
  say "Installing npm packages of ${1#"$root/"}"
  mkdir -p -- "$2"
  if ! [[ $1 -ef $2 ]]; then cp -- "$1/package.json" "$1/package-lock.json" "$2/"; fi
  npm --prefix "$2" ci --no-audit --no-fund --loglevel=error >/dev/null || fail 1 "npm could not install $1/package.json"
  cp -- "$1/package-lock.json" "$2/node_modules/installed-lock.json"
}

# The page of the studio, made anew where a source of it is newer.
build_page() {
  local page=$root/gen/apps/studio/page
  local built=$page/dist/index.html
  npm_packages "$page" "$page"
  if [[ -f $built && -z $(find "$page" -path "$page/node_modules" -prune -o -path "$page/dist" -prune -o -type f -newer "$built" -print -quit) ]]; then
    return 0
  fi
  say "Building the page of the studio"
  npm --prefix "$page" run --silent build >/dev/null || fail 1 "the page could not be built by node $(node --version), it takes 20.19 or later, which Debian 12 has not: npm --prefix $page run build"
}

# The page to try things on, which takes the packages of the studio's; ninja makes anew what is older than its sources.
build_try() {
  local made=$root/build/try
  npm_packages "$root/gen/apps/studio/page" "$root/gen/apps/studio/page"
  mkdir -p -- "$made"
  say "Building the page to try things on"
  if ! { emcmake cmake -S "$root/docs/try" -B "$made" -G Ninja && cmake --build "$made"; } >"$made/build.log" 2>&1; then
    tail -n 20 "$made/build.log" >&2
    fail 1 "the page to try things on could not be built; the whole log is $made/build.log"
  fi
}

from_npm() {
  if [[ -n $try ]]; then build_try; fi
  if [[ -n $studio ]]; then build_page; fi
  if [[ -z $all ]]; then return 0; fi
  npm_packages "$root/tests/gltf" "$root/build/gltf"
  npm_packages "$root/tests/studio" "$root/build/studio"
}

command -v dpkg-query >/dev/null || fail 1 "dpkg-query is missing: only Debian is known here. Needed: ${packages[*]}"

# Installed is what has the state "i" (install or hold, and then installed).
installed=$(dpkg-query -W -f='${db:Status-Abbrev} ${Package}\n' "${packages[@]}" 2>/dev/null || true)
missing=()
for package in "${packages[@]}"; do
  if ! grep -qxE ".i +$(printf %s "$package" | sed 's/[+.]/\\&/g')" <<<"$installed"; then missing+=("$package"); fi
done

if ((${#missing[@]} == 0)); then
  from_npm
  if [[ -z $quiet ]]; then say "Nothing to install: all ${#packages[@]} packages are there."; fi
  exit 0
fi

as_root=()
if [[ $(id -u) != 0 ]]; then
  command -v sudo >/dev/null ||
    fail 1 "packages are missing and there is neither root nor sudo. As root: apt-get install ${missing[*]}"
  as_root=(sudo)
fi
apt=("${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get -q -y
  -o DPkg::Lock::Timeout=500 -o Acquire::Retries=3 -o Dpkg::Use-Pty=0)

log=$(mktemp)
trap 'rm -f "$log"' EXIT
run() {
  if [[ -n $quiet ]]; then "$@" >>"$log" 2>&1 </dev/null; else "$@" </dev/null; fi
}
install() { run "${apt[@]}" install --no-install-recommends "${missing[@]}"; }
# The lists of packages are only fetched where they are missing or too old to install from.
known() { "${apt[@]}" --simulate install --no-install-recommends "${missing[@]}" >/dev/null 2>&1; }

say "Installing ${#missing[@]} packages: ${missing[*]}"
if ! { known && install; }; then
  if ! { run "${apt[@]}" update && install; }; then
    tail -n 20 "$log" >&2
    fail 1 "apt-get could not install: ${missing[*]}"
  fi
fi
from_npm
say "Installed in $(clock "$SECONDS")."
