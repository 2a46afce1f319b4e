#!/usr/bin/env bash
# Makes a film of pictures.
#
# H.264 (.mp4) that plays everywhere: 4:2:0, even size, BT.709 with tags (untagged, players guess other colours), header
# first; VP9 (.webm) with the same colours; or a GIF whose palette is made of the whole film. The same pictures give the
# same bytes.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/encode_film.sh LIST FILM.mp4|FILM.webm|FILM.gif FPS [TITLE [COMMENT]]

Makes a film of the PNG pictures that LIST names, one a line. Ends with 1 and makes none where a picture is damaged.
Title and comment go into its metadata, of a GIF into a comment.
FROND_FFMPEG names another ffmpeg.
TEXT
}
help_where_asked "$@"
(($# >= 3 && $# <= 5)) || bad_usage "expected LIST FILM FPS [TITLE [COMMENT]]"

list=$1 film=$2 fps=$3 title=${4:-} comment=${5:-} format=${2##*.}
part=$(part_of "$film")
trap 'rm -f -- "$part" "$part.png"' EXIT
rm -f -- "$part.png"

even='format=gbrp,pad=ceil(iw/2)*2:ceil(ih/2)*2:0:0:black'
even+=',scale=out_color_matrix=bt709:out_range=tv:flags=accurate_rnd+full_chroma_int,format=yuv420p'
tagged=(-color_range tv -colorspace bt709 -color_primaries bt709 -color_trc iec61966-2-1)
inputs=() first=()
case $format in
  webm) how=(-vf "$even" -c:v libvpx-vp9 -crf 24 -b:v 0 -deadline good -cpu-used 2 -threads 4 "${tagged[@]}") ;;
  gif)
    first=(-vf palettegen=stats_mode=diff -update 1 -c:v png -f image2 "file:$part.png")
    inputs=(-i "file:$part.png")
    how=(-lavfi paletteuse=dither=bayer:bayer_scale=4:diff_mode=rectangle -fps_mode passthrough)
    ;;
  *)
    format=mp4
    how=(-vf "$even" -c:v libx264 -preset slow -crf 16 -threads 4 "${tagged[@]}" -movflags +faststart)
    ;;
esac

# encode ARGUMENT...: ffmpeg on the pictures. The lines of -progress are told from its own words by their `key=`.
encode() {
  xargs -d '\n' -a "$list" cat -- |
    "${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -nostats -progress pipe:1 -xerror -y \
      -err_detect crccheck+explode -f image2pipe -c:v png -framerate "$fps" -i pipe:0 "$@" 2>&1
}
said=$({ ((${#first[@]} == 0)) || encode "${first[@]}"; } &&
  encode ${inputs[@]+"${inputs[@]}"} "${how[@]}" -fflags +bitexact -flags:v +bitexact -map_metadata -1 \
    -metadata "title=$title" -metadata "comment=$comment" -f "$format" "file:$part") || failed=$?
if full_disk "$said"; then fail 1 "$film could not be encoded: $no_room"; fi

# gif_with_comment FILE TEXT: the GIF with a comment, which ffmpeg does not write. It stands behind the first table of
# colours, whose size is in byte 10.
gif_with_comment() {
  local LC_ALL=C text=$2 flags at=13
  flags=$(od -An -tu1 -j 10 -N 1 -- "$1")
  if ((flags & 128)); then ((at += 3 << (flags & 7) + 1)); fi
  head -c "$at" -- "$1"
  printf '\x21\xfe'
  while [[ -n $text ]]; do
    printf '%b%s' "\\x$(printf '%x' $((${#text} < 255 ? ${#text} : 255)))" "${text:0:255}"
    text=${text:255}
  done
  printf '\0'
  tail -c +$((at + 1)) -- "$1"
}
if [[ -z ${failed:-} && $format == gif && -n $title$comment ]]; then
  mv -f -- "$part" "$part.png"
  gif_with_comment "$part.png" "$title${title:+${comment:+; }}$comment" >"$part" || fail 1 "$film could not be written"
fi

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
