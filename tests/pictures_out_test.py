#!/usr/bin/env python3
"""What pictures are written as, for who prints and composes: usage pictures_out_test.py FROND SOURCE_DIR."""

import os
import pathlib
import struct
import subprocess
import sys
import tempfile

frond, source = sys.argv[1], pathlib.Path(sys.argv[2])
WIDTH, HEIGHT = 96, 64
PRESET = """{"film": {"frames": 1, "size": [96, 64]}, "palettes": {"leaf": ["#7a9a30", "darkolivegreen"]},
  "scene": {"setting": "studio", "camera": {"location": [0, 0.5, 2], "look_at": [0, 0.3, 0], "angle": 34}},
  "organisms": [{"kind": "rock", "size": 0.35, "buried": 0, "place": {"at": [[-0.15, 0]]}},
    {"kind": "plant", "height": 0.7, "place": {"at": [[0.45, 0]]},
     "bark": {"colors": ["palette:leaf"], "second": "palette:leaf/1"},
     "grammar": {"axiom": "A", "steps": 4, "angle": 28, "rules": ["A -> F[+A][-A]FA"]}}]}"""


def run(*words, ends=0):
    done = subprocess.run([frond, *map(str, words)], capture_output=True, text=True)
    assert done.returncode == ends, f"{words}: {done.returncode}\n{done.stderr}"
    return done.stderr


def pixels(path, kind="rgba"):
    data = subprocess.run(["ffmpeg", "-nostdin", "-loglevel", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", kind, "-"],
                          check=True, capture_output=True).stdout
    return [data[i:i + 4] for i in range(0, len(data), 4)] if kind == "rgba" else data


def header(path):
    """Width, height, bits, kind of colours; and metres of a PNG's pHYs."""
    data = path.read_bytes()
    at = data.find(b"pHYs")
    return struct.unpack(">IIBB", data[16:26]), struct.unpack(">I", data[at + 4:at + 8])[0] if at > 0 else 0


def still(folder, name, *options):
    run("render", folder / "plant.json", "-o", folder / name, "--jobs", 2, *options)
    return folder / name / "still.png"


def transparent(folder):
    """Where a plant covers a pixel wholly it is as in the ordinary picture; at an edge it has its own colour."""
    fine = ("--quality", "good", "--no-resolve")  # a draft takes fewer samples where nothing is seen beside an edge
    whole, alone = pixels(still(folder, "fine", *fine)), pixels(still(folder, "alone", "--transparent", *fine))
    covered = [(a, b) for a, b in zip(whole, alone) if b[3] == 255]
    assert len(covered) > 300 and sum(b[3] == 0 for b in alone) > 2000
    assert max(abs(x - y) for a, b in covered for x, y in zip(a[:3], b[:3])) <= 1
    # An edge of the lit stone is not darker than the stone beside it: its colour is not mixed with black.
    edges = [(i, b) for i, b in enumerate(alone) if 20 < b[3] < 235]
    assert len(edges) > 40
    near = 0
    for i, b in edges:
        inner = [alone[j] for j in (i - 1, i + 1, i - WIDTH, i + WIDTH) if 0 <= j < len(alone) and alone[j][3] == 255]
        near += bool(inner) and max(b[:3]) > 0.55 * min(max(c[:3]) for c in inner)
    assert near > 0.7 * sum(1 for i, b in edges if any(
        0 <= j < len(alone) and alone[j][3] == 255 for j in (i - 1, i + 1, i - WIDTH, i + WIDTH))), near
    message = run("render", folder / "plant.json", "-o", folder / "no", "--transparent", "--resolve", ends=2)
    assert "--resolve: frames are not resolved with a transparent background" in message, message
    # Tones keep the opacity, and 16 bits are those of 8.
    toned = ("--transparent", *fine, "--set", "/scene/camera/highlights=1")
    eight, sixteen = still(folder, "eight", *toned), still(folder, "sixteen", "--depth", 16, *toned)
    assert header(eight)[0][2:] == (8, 6) and header(sixteen)[0][2:] == (16, 6)
    deep = pixels(sixteen, "rgba64be")
    for i, b in enumerate(pixels(eight)):
        for c in range(4):
            assert b[3] == 0 or abs(struct.unpack_from(">H", deep, 8*i + 2*c)[0]/257 - b[c]) <= 1, (i, c)
    assert [b[3] for b in pixels(eight)] == [b[3] for b in alone]


def film(folder):
    words = ("--transparent", "--set", "/film/frames=2")
    run("render", folder / "plant.json", "-o", folder / "film", *words)
    shown = subprocess.run(["ffprobe", "-v", "error", "-show_entries", "stream=pix_fmt", "-of", "csv=p=0",
                            folder / "film/film.mov"], check=True, capture_output=True, text=True).stdout
    assert "yuva444p" in shown, shown
    message = run("render", folder / "plant.json", "-o", folder / "film", "--format", "mp4", *words, ends=2)
    assert "an mp4 has no opacity" in message, message


def crops(folder):
    """A part has the pixels of the whole."""
    whole = pixels(still(folder, "whole"))
    for name, crop, (x, y, w, h) in (("a", "37,21,33x30", (37, 21, 33, 30)), ("b", "50%,0,25%x50%", (48, 0, 24, 32))):
        picture = still(folder, f"crop_{name}", "--crop", crop)
        assert header(picture)[0][:2] == (w, h)
        wanted = [whole[(y + j)*WIDTH + x + i] for j in range(h) for i in range(w)]
        assert pixels(picture) == wanted, crop
    assert "expected a part of 96x64" in run("generate", folder / "plant.json", "--crop", "90,0,10x10", ends=2)
    assert "is no part of a picture" in run("generate", folder / "plant.json", "--crop", "90,0,10", ends=2)


def prints(folder):
    picture = still(folder, "print", "--print", "2cm", "--dpi", 100, "--quality", "draft")
    assert header(picture) == ((79, 52, 8, 2), 3937), header(picture)
    assert header(still(folder, "whole"))[1] == 0
    for words, told in ((("--print", "2cm", "--size", "96x64"), "--size does"), (("--print", "2"), "is no size on paper"),
                        (("--print", "9x"), "is no size on paper"), (("--print", "5m"), "is no size on paper"),
                        (("--print", "30in", "--dpi", "1200"), "expected sides from 16 to 16384")):
        message = run("generate", folder / "plant.json", "-o", folder / "no", *words, ends=2)
        assert told in message, message


def drawn(folder):
    """Ink lies on the plant and not beside it, the same at any number of threads."""
    run("draw", folder / "plant.json", "-o", folder / "drawn")
    run("draw", folder / "plant.json", "-o", folder / "again", "--threads", 1)
    run("draw", folder / "plant.json", "-o", folder / "clear", "--transparent")
    file = "frame_0001.png"
    assert (folder / "drawn" / file).read_bytes() == (folder / "again" / file).read_bytes()
    paper, clear = pixels(folder / "drawn" / file), pixels(folder / "clear" / file)
    alone = pixels(still(folder, "alone", "--transparent", "--quality", "good"))
    assert all(abs(255 - a[1] - b[3]*(1 - 0.08)) <= 1.5 for a, b in zip(paper, clear))
    ink = [b[3] for b in clear]
    there = [i for i, b in enumerate(alone) if b[3] > 0]
    about = {i + step for i in there for step in (-1 - WIDTH, -WIDTH, 1 - WIDTH, -1, 0, 1, WIDTH - 1, WIDTH, WIDTH + 1)}
    assert sum(ink[i] for i in about if 0 <= i < len(ink)) > 0.97*sum(ink) > 0
    shade = sum(ink[i] for i in there)/255/len(there)
    assert 0.05 < shade < 0.6, shade


with tempfile.TemporaryDirectory() as name:
    work = pathlib.Path(name)
    (work / "plant.json").write_text(PRESET)
    os.environ["FROND_HOME"] = str(source)
    os.environ["XDG_CACHE_HOME"] = name
    (work / "frond").mkdir()
    (work / "frond" / "pace").write_text("machine 2 2\n")
    for test in (transparent, film, crops, prints, drawn):
        test(work)
        print(f"{test.__name__}: ok")
