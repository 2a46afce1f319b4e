#!/usr/bin/env bash
# The extension for Blender as a zip: the manifest, the licence and the modules of gen/apps/blender, the same bytes each time.
set -euo pipefail
# shellcheck source-path=SCRIPTDIR source=lib.sh
. "$(dirname -- "${BASH_SOURCE[0]}")/lib.sh"

usage() {
  cat <<TEXT
Usage: scripts/blender_extension.sh [-o FILE.zip]

Writes the extension for Blender (frond_blender.zip).
TEXT
}

out=frond_blender.zip
while (($#)); do
  case $1 in
    -o) out=${2:?-o: a file is missing}; shift 2 ;;
    -h | --help) usage; exit 0 ;;
    *) unknown_option "$1" ;;
  esac
done
python3 - "$root/gen/apps/blender" "$out" <<'PYTHON'
import pathlib
import sys
import zipfile

folder, out = map(pathlib.Path, sys.argv[1:])
with zipfile.ZipFile(out, "w") as archive:
    for file in sorted([folder / "LICENSE", folder / "blender_manifest.toml", *folder.glob("*.py")]):
        entry = zipfile.ZipInfo(file.name, (1980, 1, 1, 0, 0, 0))
        entry.external_attr = 0o644 << 16
        archive.writestr(entry, file.read_bytes(), zipfile.ZIP_DEFLATED, 9)
PYTHON
echo "$out"
