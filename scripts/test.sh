#!/usr/bin/env bash
# Installs what is missing, builds everything and runs every test.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/test.sh [CTEST_OPTION...]

Runs every test; the summary is ctest's. Options go to ctest: -L scripts runs the tests of one label, -LE slow
leaves the slow ones out, -R NAME runs those of a name.
Exit codes: 0 all passed, 1 not.
TEXT
}
case ${1:-} in -h | --help) usage; exit 0 ;; esac

"$root/scripts/setup.sh" --tests --quiet
"$root/scripts/build.sh" --tests
cd -- "$root"
ctest --preset release -j "$(nproc)" --no-tests=error "$@" || fail 1 "not all tests passed"
