#!/usr/bin/env bash
# Notes how fast POV-Ray is on this machine, for what `frond info` and `frond generate` foretell.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/pace.sh [FOLDER LINES]

Notes in \$XDG_CACHE_HOME/frond/pace (~/.cache) what the frames in FOLDER/.times took, but for its first LINES, and what
was foretold of them; the last 50 presets are kept. Without arguments, and where nothing is noted yet, it renders a
small picture, which takes a second or two.
TEXT
}
help_where_asked "$@"
(($# == 0 || $# == 2)) || bad_usage "expected FOLDER LINES, or nothing"

cache=${XDG_CACHE_HOME:-${HOME:-/}/.cache}/frond
file=$cache/pace
part='' work=''
trap 'rm -rf -- "$part" "$work"' EXIT

# note KEY FORETOLD TAKEN
note() {
  { mkdir -p -- "$cache" && part=$(mktemp -- "$cache/pace.XXXXXX"); } 2>/dev/null || return 0  # a cache need not be
  {
    if [[ -f $file ]]; then awk -v key="$1" '$1 != key' "$file" | tail -n 49; fi
    printf '%s %s %s\n' "$@"
  } >"$part" 2>/dev/null || return 0
  mv -fT -- "$part" "$file"
}

if (($# == 0)); then
  if [[ -s $file ]]; then exit 0; fi
  work=$(mktemp -d)
  cat >"$work/scene.pov" <<'TEXT'
#version 3.7;
global_settings { assumed_gamma 1 }
camera { location <0, 3, -6> look_at 0 }
light_source { <4, 8, -6>, 1 area_light 2*x, 2*y, 5, 5 adaptive 1 }
plane { y, -1 pigment { granite scale 2 } }
#declare Turn = 0;
#while (Turn < 400)
  sphere { <mod(Turn * 0.618, 1) * 6 - 3, mod(Turn * 0.414, 1) * 2 - 1, mod(Turn * 0.732, 1) * 6 - 3>, 0.15
    pigment { bozo scale 0.05 } }
  #declare Turn = Turn + 1;
#end
TEXT
  cd -- "$work"
  "${FROND_POVRAY:-povray}" +Iscene.pov +Oscene.png +W160 +H90 +A0.1 +AM2 +R3 -J -D +WT1 >/dev/null 2>&1 </dev/null || exit 0
  times >spent
  taken=$(sed -n 2p spent | awk '{ split($1, part, /[ms]/); print part[1] * 60 + part[2] }')
  note machine 2 "$taken"  # seconds that it took where scenes were measured
  exit 0
fi

manifest=$1/manifest.json
key=$(sed -n 's/^  "preset": "\(.*\)",$/\1/p' "$manifest" | tr -d '\n' | LC_ALL=C tr -c 'A-Za-z0-9._-' _)
foretold=$(sed -n 's/^  "render_seconds": \([0-9.]*\),$/\1/p' "$manifest")
read -r frames taken < <(tail -n "+$(($2 + 1))" "$1/.times" | awk '{ all += $2; ++n } END { print n + 0, all / 1000 }')
if ((frames > 0)); then note "$key" "$(awk -v a="$foretold" -v n="$frames" 'BEGIN { print a * n }')" "$taken"; fi
