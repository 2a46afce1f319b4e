#!/usr/bin/env bash
# Makes a film of pictures.
#
# H.264 that plays everywhere: 4:2:0, even size, BT.709 with tags (untagged, players guess other colours), header
# first. The same pictures give the same bytes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/encode_film.sh LIST FILM.mp4 FPS [TITLE]

Makes a film of the PNG pictures that LIST names, one a line. Ends with 1 and makes none where a picture is damaged.
FROND_FFMPEG names another ffmpeg.
TEXT
}
help_where_asked "$@"
(($# == 3 || $# == 4)) || bad_usage "expected LIST FILM.mp4 FPS [TITLE]"

list=$1 film=$2 fps=$3 title=${4:-}
part=$(dirname -- "$film")/.$(basename -- "$film").part
trap 'rm -f -- "$part"' EXIT

filter='format=gbrp,pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:black'
filter+=',scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p'

# The lines of -progress are told from ffmpeg's own words by their `key=`.
said=$(xargs -d '\n' -a "$list" cat -- |
  "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -nostats -progress pipe:1 -xerror -y \
    -err_detect crccheck+explode -f image2pipe -c:v png -framerate "$fps" -i pipe:0 -vf "$filter" \
    -c:v libx264 -preset slow -crf 16 -threads 4 -color_range tv -colorspace bt709 -color_primaries bt709 \
    -color_trc iec61966-2-1 -movflags +faststart -fflags +bitexact -flags:v +bitexact \
    -map_metadata -1 -metadata "title=$title" -f mp4 "file:$part" 2>&1) || failed=$?
if full_disk "$said"; then fail 1 "$film could not be encoded: $no_room"; fi

asked=$(grep -c '' "$list")
encoded=$(sed -n 's/^frame= *//p' <<<"$said" | tail -n 1)
if [[ -n ${failed:-} || $encoded != "$asked" ]]; then
  while IFS= read -r picture; do
    if ! whole_png "$picture"; then say "$picture is damaged, or no PNG"; fi
  done <"$list"
  grep -vE '^[a-z0-9_]+=' <<<"$said" | head -n 6 >&2 || true
  fail 1 "$film could not be encoded: ${encoded:-0} of $asked frames"
fi
put_in_place "$part" "$film"
