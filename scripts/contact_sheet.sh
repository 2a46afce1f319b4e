#!/usr/bin/env bash
# Tiles pictures of one size into a sheet.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/contact_sheet.sh LIST SHEET.png COLUMNS [WIDTH]

Tiles the PNG pictures that LIST names, one a line, row by row, each at most WIDTH pixels (240)
wide. Ends with 1 and makes none where a picture is damaged.
FROND_FFMPEG names another ffmpeg.
TEXT
}
help_where_asked "$@"
[[ ${3:-} =~ ^[1-9][0-9]*$ && ${4:-1} =~ ^[1-9][0-9]*$ ]] || bad_usage "expected LIST SHEET.png COLUMNS [WIDTH]"

list=$1 sheet=$2 columns=$3 width=${4:-240}
part=$(part_of "$sheet")
trap 'rm -f -- "$part"' EXIT

pictures=$(grep -c '' "$list")
rows=$(((pictures + columns - 1) / columns))
while IFS= read -r picture; do
  whole_png "$picture" || fail 1 "$sheet could not be made: $picture is damaged, or no PNG"
done <"$list"

said=$(xargs -d '\n' -a "$list" cat -- |
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -xerror -y -err_detect crccheck+explode \
    -f image2pipe -c:v png -framerate 1 -i pipe:0 \
    -vf "format=gbrp,scale='min(iw,$width)':-1,tile=${columns}x${rows}:padding=4:margin=4:color=0x202020,format=rgb24" \
    -frames:v 1 -update 1 -c:v png -f image2 "file:$part" 2>&1) || failed=$?
if full_disk "$said"; then said=$no_room; fi
if [[ -n ${failed:-} ]] || ! whole_png "$part"; then fail 1 "$sheet could not be made: $said"; fi
put_in_place "$part" "$sheet"
