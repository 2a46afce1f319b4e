#!/usr/bin/env bash
# Copies the picture of a still to its place.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/keep_still.sh PICTURE.png STILL.png

Copies a picture, so that it is seen whole or not at all.
TEXT
}
help_where_asked "$@"
(($# == 2)) || bad_usage "expected PICTURE.png STILL.png"

part=$(part_of "$2")
trap 'rm -f -- "$part"' EXIT
if ! said=$(cp -T -- "$1" "$part" 2>&1); then
  full_disk "$said" && said=$no_room
  fail 1 "$2 could not be written: $said"
fi
whole_png "$part" || fail 1 "$1 is damaged, or no PNG"
put_in_place "$part" "$2"
