#!/usr/bin/env bash
# Formats the C++ sources, or tells which are not formatted.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/format.sh [--check]

Formats the C++ files of gen/, tests/ and bench/ by .clang-format. With --check it changes nothing: exit code 1
where a file is not formatted, 0 otherwise.
TEXT
}

how=(-i)
case ${1:-} in
  '') ;;
  --check) how=(--dry-run --Werror) ;;
  -h | --help) usage; exit 0 ;;
  *) bad_usage "unknown argument '$1'" ;;
esac
cd -- "$root"
find gen tests bench \( -name '*.cpp' -o -name '*.h' \) -print0 | xargs -0 -r clang-format "${how[@]}" ||
  fail 1 "not formatted as .clang-format says; scripts/format.sh does it"
