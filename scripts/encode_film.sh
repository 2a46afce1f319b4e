#!/usr/bin/env bash
# Makes a film of pictures: encode_film.sh LIST FILM.mp4 FPS [TITLE]; LIST holds a PNG a line.
#
# H.264 that plays everywhere: 4:2:0, even size, BT.709 with tags (untagged, players guess other colours), header
# first. The same pictures give the same bytes. FROND_FFMPEG names another ffmpeg.
set -euo pipefail

list=$1 film=$2 fps=$3 title=${4:-}
part=$(dirname -- "$film")/.$(basename -- "$film").part
trap 'rm -f -- "$part"' EXIT

filter='format=gbrp,pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:black'
filter+=',scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p'

xargs -d '\n' -a "$list" cat -- |
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -y \
    -f image2pipe -c:v png -framerate "$fps" -i pipe:0 -vf "$filter" \
    -c:v libx264 -preset slow -crf 16 -threads 4 -color_range tv -colorspace bt709 -color_primaries bt709 \
    -color_trc iec61966-2-1 -movflags +faststart -fflags +bitexact -flags:v +bitexact \
    -map_metadata -1 -metadata "title=$title" -f mp4 "file:$part"
mv -f -- "$part" "$film"
