#!/usr/bin/env bash
# Draws what the frames of a film hold and took.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/plot.sh FOLDER [FILE.svg]

Draws, over the frames of the film in a folder, the nodes that have grown, the bytes of the scenes and the seconds of
processor that POV-Ray took, as far as they were measured, to FILE.svg (FOLDER/plot.svg).
TEXT
}
help_where_asked "$@"
(($# == 1 || $# == 2)) || bad_usage "expected FOLDER [FILE.svg]"
folder=$1 file=${2:-$1/plot.svg}
[[ -f $folder/manifest.json ]] || fail 2 "$folder: holds no manifest.json; expected the folder of a run"
[[ $file == *.svg ]] || fail 2 "$file: expected a name that ends in .svg"
if [[ -d $file ]]; then fail 1 "$file is a folder; expected a file, or none"; fi
part=$(part_of "$file")
trap 'rm -f -- "$part"' EXIT

# rows: NUMBER NODES BYTES SECONDS of each frame, `-` where it is not known
rows() {
  local sizes times=$folder/.times
  sizes=$(find "$folder/frames" -maxdepth 1 -name 'frame_*.pov' -printf 'bytes %f %s\n' 2>/dev/null || true)
  if [[ ! -f $times ]]; then times=/dev/null; fi
  { printf '%s\n' "$sizes"; sed 's/^/time /' "$times"; cat -- "$folder/manifest.json"; } | awk '
    $1 == "bytes" { sub(/\.pov$/, "", $2); bytes[$2] = $3 }
    $1 == "time" { seconds[$2] = $3 / 1000 }
    /^ *\{"number": / {
      match($0, /"number": [0-9]+/); n = substr($0, RSTART + 10, RLENGTH - 10)
      match($0, /"nodes": [0-9]+/); nodes = substr($0, RSTART + 9, RLENGTH - 9)
      name = sprintf("frame_%04d", n)
      print n, nodes, (name in bytes ? bytes[name] : "-"), (name in seconds ? seconds[name] : "-")
    }'
}

{ rows | awk '
  function chart(column, title,   i, top, y, x, d, down) {
    for (i = 1; i <= count; ++i) if (row[i, column] != "-" && row[i, column] > top) top = row[i, column] + 0
    y = 30 + 150 * (column - 2)
    printf "<text x=\"60\" y=\"%d\">%s</text>\n", y - 8, title
    printf "<path class=\"axis\" d=\"M60 %dV%dH620\"/>\n", y, y + 100
    printf "<text class=\"tick\" x=\"54\" y=\"%d\">%.4g%s</text><text class=\"tick\" x=\"54\" y=\"%d\">0</text>\n", y + 8, (top < 1e6 ? top : top / 1e6), (top < 1e6 ? "" : " M"), y + 104
    for (i = 1; i <= count; ++i) {
      if (row[i, column] == "-") { down = 0; continue }
      x = 60 + (last > first ? 560 * (row[i, 1] - first) / (last - first) : 0)
      d = d sprintf("%s%.1f %.1f", down ? "L" : "M", x, y + 100 - (top ? 100 * row[i, column] / top : 0))
      if (!down) d = d sprintf("h.1")
      down = 1
    }
    printf "<path class=\"line\" d=\"%s\"/>\n", d
  }
  { ++count; for (i = 1; i <= 4; ++i) row[count, i] = $i }
  END {
    if (!count) exit 1
    first = row[1, 1]; last = row[count, 1]
    print "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 470\" font-family=\"sans-serif\" font-size=\"12\">"
    print "<style>.axis{fill:none;stroke:#888}.line{fill:none;stroke:#c2552d;stroke-width:1.5;stroke-linecap:round}.tick{text-anchor:end;fill:#666}</style>"
    print "<rect width=\"640\" height=\"470\" fill=\"#fff\"/>"
    chart(2, "nodes"); chart(3, "bytes of the scene"); chart(4, "seconds of processor")
    printf "<text class=\"tick\" x=\"620\" y=\"450\">frames %d to %d</text>\n</svg>\n", first, last
  }' >"$part"; } 2>/dev/null || fail 1 "$file could not be written"
put_in_place "$part" "$file"
printf '%s\n' "$file"
