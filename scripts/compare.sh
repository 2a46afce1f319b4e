#!/usr/bin/env bash
# Two films or two pictures side by side, with their difference.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/compare.sh A B [FILE]

Makes FILE (out/compare.png, or out/compare.mp4) of A, B and four times their difference, and says how far they differ.
A and B are two pictures (.png) or two films (.mp4, .webm, .gif) of one size; a folder stands for the film or still in
it. The longer of two films is cut.

Exit codes: 0 compared, 1 could not, 2 wrong input. FROND_FFMPEG names another ffmpeg.
TEXT
}
help_where_asked "$@"
(($# == 2 || $# == 3)) || bad_usage "expected A B [FILE]"

# found PATH: the film or picture that it stands for
found() {
  local name
  if [[ -d $1 ]]; then
    for name in film.mp4 film.webm film.gif still.png; do
      if [[ -f $1/$name ]]; then printf '%s\n' "$1/$name"; return; fi
    done
    fail 2 "$1: a folder without film or still"
  fi
  [[ -f $1 ]] || fail 2 "$1: no such film or picture"
  [[ $1 =~ \.(png|mp4|webm|gif)$ ]] || fail 2 "$1: expected .png, .mp4, .webm or .gif"
  printf '%s\n' "$1"
}
# described FILE: WIDTH,HEIGHT,RATE of it
described() {
  ffprobe -v quiet -select_streams v:0 -show_entries stream=width,height,r_frame_rate -of csv=p=0 "file:$1" | grep . ||
    fail 1 "$1 is damaged"
}
a=$(found "$1") b=$(found "$2")
kind=film end=mp4
if [[ $a == *.png ]]; then kind=picture end=png; fi
if [[ $b == *.png && $kind == film || $b != *.png && $kind == picture ]]; then
  fail 2 "$a and $b: expected two films or two pictures"
fi
out=${3:-out/compare.$end}
[[ $out == *.$end ]] || fail 2 "$out: expected a name that ends in .$end"
is_a=$(described "$a") is_b=$(described "$b")
[[ ${is_a%,*} == "${is_b%,*}" ]] || fail 2 "$a is of ${is_a%,*} pixels, $b of ${is_b%,*}; expected one size"

mkdir -p -- "$(dirname -- "$out")" 2>/dev/null || fail 1 "$out: its folder cannot be made"
out=$(realpath -- "$out")
part=$(part_of "$out")
work=$(mktemp -d)
trap 'rm -rf -- "$work" "$part"' EXIT
a_path=$(realpath -- "$a") b_path=$(realpath -- "$b")
cd -- "$work"
label a "$a" "${is_a%%,*}"
label b "$b" "${is_a%%,*}"
label d "difference x 4" "${is_a%%,*}"

# Films are compared frame by frame, whatever their clocks say.
rate=() how=(-frames:v 1 -update 1 -c:v png -f image2) last=format=rgb24
if [[ $kind == film ]]; then
  rate=(-r "${is_a##*,}")
  how=(-c:v libx264 -preset medium -crf 16 -color_range tv -colorspace bt709 -color_primaries bt709 -f mp4)
  last='pad=ceil(iw/2)*2:ceil(ih/2)*2,scale=out_color_matrix=bt709:out_range=tv,format=yuv420p'
fi
graph="[0:v]format=gbrp,split=3[a1][a2][a3];[1:v]format=gbrp,split=3[b1][b2][b3]
;[a1][b1]psnr=stats_file=figures:shortest=1,nullsink
;[a2][b2]blend=all_mode=difference:shortest=1,lutrgb=r=val*4:g=val*4:b=val*4,format=rgb24,$(labelled d)[d]
;[a3]format=rgb24,$(labelled a)[a];[b3]format=rgb24,$(labelled b)[b];[a][b][d]hstack=3:shortest=1,$last"
if ! said=$("${FROND_FFMPEG:-ffmpeg}" -hide_banner -nostdin -loglevel error -y "${rate[@]}" -i "file:$a_path" \
  "${rate[@]}" -i "file:$b_path" -lavfi "${graph//$'\n'/}" "${how[@]}" "file:$part" 2>&1); then
  if full_disk "$said"; then said=$no_room; fi
  fail 1 "$out could not be made: $said"
fi
put_in_place "$part" "$out"

say "$(tr ' ' '\n' <figures | awk -F: -v kind="$kind" '
  $1 == "n" { ++frames; n = $2 }
  $1 == "mse_avg" { mse = $2 }
  $1 == "psnr_avg" && $2 != "inf" { ++differ; if (mse >= most) { most = mse; worst = n } }
  END {
    if (!differ) print "No pixel differs."
    else if (kind == "film")
      printf "%d of %d frames differ, most of all frame %d: by %.2g of 255 (RMSE).\n", differ, frames, worst, sqrt(most)
    else printf "They differ by %.2g of 255 (RMSE).\n", sqrt(most)
  }')"
printf '%s\n' "$out"
