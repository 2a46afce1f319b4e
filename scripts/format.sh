#!/usr/bin/env bash
# Formats the C++ sources, or tells which are not formatted.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/format.sh [--check]

Formats the C++ files of gen/, tests/, bench/ and docs/ by .clang-format. With --check it changes nothing: exit code 1
where a file is not formatted, 0 otherwise.
TEXT
}

check=''
case ${1:-} in
  '') ;;
  --check) check=yes ;;
  -h | --help) usage; exit 0 ;;
  *) bad_usage "unknown argument '$1'" ;;
esac
cd -- "$root"
sources() { find gen tests bench docs \( -name '*.cpp' -o -name '*.h' \) -print0; }
if [[ -z $check ]]; then
  sources | xargs -0 -r clang-format -i
  exit 0
fi
# One line a file.
if ! faults=$(sources | xargs -0 -r clang-format --dry-run -Werror 2>&1); then
  sed -nE 's/^(.+\.(cpp|h)):[0-9]+:[0-9]+: error:.*/\1/p' <<<"$faults" | sort -u >&2
  fail 1 "these are not formatted as .clang-format says; scripts/format.sh does it"
fi
