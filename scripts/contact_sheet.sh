#!/usr/bin/env bash
# Tiles pictures of one size into a sheet: contact_sheet.sh LIST SHEET.png COLUMNS; LIST holds a PNG a line.
# FROND_FFMPEG names another ffmpeg.
set -euo pipefail

list=$1 sheet=$2 columns=$3
part=$(dirname -- "$sheet")/.$(basename -- "$sheet").part
trap 'rm -f -- "$part"' EXIT

pictures=$(grep -c '' "$list")
rows=$(((pictures + columns - 1) / columns))

xargs -d '\n' -a "$list" cat -- |
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -y -f image2pipe -c:v png -framerate 1 -i pipe:0 \
    -vf "format=gbrp,scale='min(iw,240)':-1,tile=${columns}x${rows}:padding=4:margin=4:color=0x202020,format=rgb24" \
    -frames:v 1 -update 1 -c:v png -f image2 "file:$part"
mv -f -- "$part" "$sheet"
