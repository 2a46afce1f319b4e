#!/usr/bin/env python3
"""What frames cost and how good they are: nine samples a pixel against raw frames that are resolved, side by side.

Usage: bench/frames.py [-h] [--frames N] [--reference N] [--out DIR] [FILM...]

For each film and still: bytes that POV-Ray reads for a frame, seconds of processor to read and to trace it (one thread), to resolve
it, error and flicker of both against N * N random samples a pixel, as `frond compare` has them. A table in Markdown.
Pictures stay in DIR. Nothing else should be running; all films take hours, one some minutes.
"""

import argparse
import json
import os
import re
import subprocess
import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
FROND = os.environ.get("FROND_BIN", str(ROOT / "build" / "frond"))
# Preset, size, and the first of the frames that are looked at; 0: a still.
FILMS = {
    "thicket": ("thicket", "320x180", 90),
    "reef": ("reef", "384x216", 60),
    "flight": ("reef_flight", "1280x720", 60),
    "walk": ("forest/flight", "320x180", 40),
    "garden": ("garden/garden", "320x180", 20),
    "oak": ("trees/oak", "640x360", 0),
    "still_reef": ("reef", "640x360", 0),
    "wood": ("forest", "640x360", 0),
}
RAW, NINE = ["-A", "-J", "+FN16"], ["+A0.0", "+AM1", "+R3", "-J"]


def run(words, folder="."):
    """What a program says, and the seconds of processor that it takes."""
    process = subprocess.Popen(list(map(str, words)), cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                               env={**os.environ, "FROND_HOME": str(ROOT)})
    said = process.stdout.read()
    _, status, used = os.wait4(process.pid, 0)
    if status:
        sys.exit(f"{' '.join(map(str, words))}\n{said[-2000:]}")
    return said, used.ru_utime + used.ru_stime


def bytes_read(frames, name):
    """Of a scene and of what it includes, each once."""
    todo, known = [name], set()
    while todo:
        file = todo.pop()
        if file in known or not (frames / file).exists():
            continue
        known.add(file)
        todo += re.findall(r'#include "([^"]+)"', (frames / file).read_text(errors="replace"))
    return sum((frames / file).stat().st_size for file in known)


def draw(folder, number, size, flags, picture):
    """A frame of a folder by POV-Ray: seconds of processor to read it, and in all."""
    frames, name = folder / "frames", f"frame_{number:04}.pov"
    light = re.search(r"\+RFI \+RF\S+", (frames / name).open().readline())
    picture.parent.mkdir(parents=True, exist_ok=True)
    width, height = size
    said, seconds = run(["povray", f"+L{ROOT / 'povinc'}", *(light[0].split() if light else []), f"+I{name}", f"+O{picture}",
                         f"+W{width}", f"+H{height}", "-D", "+WT1", *flags], frames)
    parsed = re.search(r"Parse Time:.*?\(([0-9.]+) seconds\)", said, re.S)
    return float(parsed[1]), seconds


def measure(name, count, side, out):
    preset, size_text, first = FILMS[name]
    size = tuple(map(int, size_text.split("x")))
    still = first == 0
    numbers = [1] if still else list(range(first, first + count))
    words = [ROOT / f"presets/{preset}.json", "--size", size_text, "--quality", "good"]
    if still:
        words += ["--set", "/film/frames=1"]
    chosen = ["--frames", f"{numbers[0]}-{numbers[-1]}"]
    plain, raw, many = out / name / "nine", out / name / "resolved", out / name / "many"
    run([FROND, "generate", *words, *chosen, "--no-resolve", "-q", "-o", plain])
    run([FROND, "generate", *words, *chosen, "-q", "-o", raw])
    manifest = json.loads((raw / "manifest.json").read_text())
    drawn = tuple(2 * side for side in size) if still else size
    costs = [draw(raw, number, drawn, RAW, raw / f"raw/frame_{number:04}.png")
             for number in range(manifest["raw"][0], manifest["raw"][1] + 1)]
    _, resolving = run([FROND, "resolve", *words, *chosen, "--film", raw, "--threads", "1"])
    nine = []
    for number in numbers:
        nine.append(draw(plain, number, size, NINE, plain / f"pictures/frame_{number:04}.png"))
        draw(plain, number, size, ["+A0.0", "+AM1", f"+R{side}", "+J1"], many / f"frame_{number:04}.png")
    pictures = raw / "pictures"
    pictures.mkdir(exist_ok=True)
    for number in numbers:
        (pictures / f"frame_{number:04}.png").write_bytes((raw / f"frames/frame_{number:04}.png").read_bytes())
    figures = []
    for made in (plain / "pictures", pictures):
        told = json.loads(run([FROND, "compare", many, made, "--json"])[0])
        flicker = f" ({told['flicker']:.1f})" if told.get("flicker") is not None else ""
        figures.append(f"{told['error']:.1f}{flicker}")
    mean = [sum(column) / len(costs) for column in zip(*costs)]
    nines = sum(total for _, total in nine) / len(nine)
    read = bytes_read(raw / "frames", f"frame_{numbers[0]:04}.pov") / 1e6
    return (f"| {name} {size_text} | {read:.1f} | {nines:.1f} s, {figures[0]} | {mean[0]:.1f} + {mean[1] - mean[0]:.1f} + "
            f"{resolving / len(numbers):.1f} s, {figures[1]} |")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("films", nargs="*", metavar="FILM", help=f"of {', '.join(FILMS)} (all)")
    parser.add_argument("--frames", type=int, default=4, help="how many of a film, at least 3 for flicker (4)")
    parser.add_argument("--reference", type=int, default=6, help="N: N * N samples a pixel (6)")
    parser.add_argument("--out", type=Path, default=Path("out/bench_frames"), help="folder of the pictures (out/bench_frames)")
    asked = parser.parse_args()
    if wrong := set(asked.films) - set(FILMS):
        parser.error(f"no film {', '.join(sorted(wrong))}; expected some of {', '.join(FILMS)}")
    print("| film | MB | nine samples: seconds, error (flicker) | raw: to read + to trace + to resolve, error (flicker) |")
    print("| --- | --- | --- | --- |")
    for name in asked.films or FILMS:
        print(measure(name, asked.frames, asked.reference, asked.out.resolve()), flush=True)


if __name__ == "__main__":
    main()
