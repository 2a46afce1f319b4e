#!/usr/bin/env python3
"""Exports a preset as an include and shows it to POV-Ray in a scene that includes it twice over, its details in a row.

  pov_include_test.py FROND ROOT PRESET [--set POINTER=VALUE]...

No error and no warning but the one that any scene with light through leaves has; and the shape fills the box that the
include declares: at each detail it is seen in that box, and not beside it.
"""
import pathlib
import re
import struct
import subprocess
import sys
import tempfile
import zlib

BACKSIDE = "backside illumination"
SIDE = 120  # of each detail's part of the picture, pixels

SCENE = """#version 3.7;
global_settings {{ assumed_gamma 1 }}
#declare Frond_Unit = 2;
#declare Frond_Ambient = 1;
#include "{name}.inc"
#include "{name}.inc"
#local Low = {macro}_Low;
#local High = {macro}_High;
#local Middle = (Low + High)/2;
#local Far = vlength(High - Low) + 1;
// The last one is the first mirrored in all axes about its middle: nothing of it may vanish.
#for (Show, 0, 3)
  object {{ {macro}(0, mod(Show, 3)) translate -Middle #if (Show = 3) scale -1 #end translate Middle + x*2*Far*(Show - 1.5) }}
#end
object {{ {macro}(7, 0) translate y*1000*Far }}
camera {{ orthographic location Middle - z*2*Far direction z up y*2*Far right x*8*Far }}
light_source {{ Middle - z*9*Far rgb 1 }}
#debug concat("HEIGHT ", str({macro}_Height, 0, 4), "\\n")
"""


def pixels(path):
    """Rows of whether a pixel differs from the first, which is of the background."""
    data = path.read_bytes()
    width, height, depth, kind = struct.unpack(">IIBB", data[16:26])
    body = b"".join(m[1] for m in chunks(data) if m[0] == b"IDAT")
    raw = zlib.decompress(body)
    step = {2: 3, 6: 4}[kind] * depth // 8
    rows, before = [], bytearray(width * step)
    for y in range(height):
        line = bytearray(raw[y * (width * step + 1) + 1:(y + 1) * (width * step + 1)])
        how = raw[y * (width * step + 1)]
        for i in range(len(line)):
            left = line[i - step] if i >= step else 0
            corner = before[i - step] if i >= step else 0
            up = before[i]
            guess = left + up - corner
            paeth = min((left, up, corner), key=lambda v: abs(guess - v))
            line[i] = (line[i] + [0, left, up, (left + up) // 2, paeth][how]) & 255
        rows.append([bytes(line[x * step:x * step + step]) for x in range(width)])
        before = line
    first = rows[0][0]
    return [[p != first for p in row] for row in rows]


def chunks(data):
    at = 8
    while at < len(data):
        size = struct.unpack(">I", data[at:at + 4])[0]
        yield data[at + 4:at + 8], data[at + 8:at + 8 + size]
        at += 12 + size


def main(frond, root, preset, *sets):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        name = pathlib.Path(preset).stem
        made = subprocess.run([frond, "export", preset, "-q", "-o", folder / f"{name}.inc", *sets], cwd=root)
        if made.returncode != 0:
            return f"{preset}: export ended with {made.returncode}"
        macro = re.search(r"^#declare (Frond_\w+)_Unit", (folder / f"{name}.inc").read_text(), re.M)[1]
        if list(folder.glob("*.models")):
            return f"{preset}: files of models are left over"
        (folder / "scene.pov").write_text(SCENE.format(name=name, macro=macro))
        picture = folder / "show.png"
        run = subprocess.run(
            ["povray", "+Iscene.pov", f"+O{picture}", f"+W{4*SIDE}", f"+H{SIDE}", "-D", "-A", "+FN"],
            cwd=folder, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        if run.returncode != 0:
            return f"{preset}: POV-Ray ended with {run.returncode}\n{run.stdout[-2000:]}"
        warned = [w for w in re.findall(r"[^\n]*Warning:.*?(?:\n[^\n]+)?\n", run.stdout) if BACKSIDE not in w]
        if warned:
            return f"{preset}: POV-Ray warns: {warned[0]}"
        rows = pixels(picture)
        # The box takes no more than the middle half of its part.
        inside = range(SIDE // 4 - 2, SIDE - SIDE // 4 + 2)
        counts = []
        for show in range(4):
            seen = [(x, y) for y in range(SIDE) for x in range(SIDE) if rows[y][show*SIDE + x]]
            if not seen:
                return f"{preset}: detail {show % 3}: nothing is seen of it"
            counts.append(len(seen))
            if beside := [p for p in seen if p[0] not in inside or p[1] not in inside]:
                return f"{preset}: detail {show % 3}: {len(beside)} pixels lie outside of the declared box"
        if counts[3] < 0.9 * counts[0]:
            return f"{preset}: mirrored by scale -1 it is seen in {counts[3]} pixels of {counts[0]}"
        print(f"{preset}: as it should be")
        return 0


sys.exit(main(*sys.argv[1:]))
