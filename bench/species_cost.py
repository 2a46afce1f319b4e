#!/usr/bin/env python3
"""What each species, or those of the presets named, costs as a near plant and as a thousand copies, as CSV: what `frond info` says of a frame.

Usage: bench/species_cost.py [--program build/frond] [PRESET...] > species_cost.csv

The near plant is the species' own preset, a still of 480 x 270 pixels. The copies are of four models and stand, each in
a circle a third as wide as the species is high and at most 6 m wide (what swims is one school), before a camera at eye level in a meadow, or two metres above the sea
floor. Columns: megabytes of memory of the program and POV-Ray together, megabytes of a frame, seconds of processor to
generate and to render it.
"""

import argparse
import concurrent.futures
import csv
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
SIZE = ["--set", "/film/frames=1", "--set", "/film/size=[480,270]"]
FIGURES = {"memory_mb": r"([\d.]+) (kB|MB|GB) of memory", "frame_mb": r"frames of ([\d.]+) (kB|MB|GB)",
           "generate_s": r"([\d.]+) (s|min|h) of processor to generate", "render_s": r"([\d.]+) (s|min|h) to render"}
UNITS = {"kB": 0.001, "MB": 1, "GB": 1000, "s": 1, "min": 60, "h": 3600}


def cost(program, arguments):
    said = subprocess.run([program, "info", *arguments], capture_output=True, text=True, check=True).stdout
    found = {name: re.search(pattern, said) for name, pattern in FIGURES.items()}
    return {name: round(float(match[1]) * UNITS[match[2]], 3) for name, match in found.items() if match}


def copies(path):
    """A preset of a thousand of a species."""
    height = taxon(path).get("height", [1, 1])[1]
    swims = preset_in(path)["organisms"][0].get("kind") == "school"
    room = min(height / 3, 6)
    sea = path.parent.name in ("corals", "fishes", "reef", "reef_animals", "shells")
    sown = {"models": 4, "where": {"radius": round(room / 2, 4), "reach": round(22 * room, 3)}}
    camera = {"location": [0, 2 if sea else 1.7, 0.5 * room + 3 * height], "look_at": [0, height / 2, 0]}
    return {"film": {"frames": 1, "size": [480, 270]},
            "scene": {"setting": "underwater" if sea else "meadow", "camera": camera},
            "organisms": [{"species": str(path), "count": 1000, **({} if swims else {"sown": sown})}]}


def preset_in(path):
    return json.loads(re.sub(r"^\s*//.*$", "", path.read_text(encoding="utf-8"), flags=re.M))


def taxon(path):
    return preset_in(path).get("taxon", {})


def main():
    parser = argparse.ArgumentParser(usage="bench/species_cost.py [--program build/frond] [PRESET...] > species_cost.csv")
    parser.add_argument("--program", default=str(ROOT / "build/frond"))
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    presets = {str(path.relative_to(ROOT / "presets").with_suffix("")): path
               for path in sorted((ROOT / "presets").rglob("*.json")) if taxon(path)}

    def row(name):
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            json.dump(copies(presets[name]), file)
            file.flush()
            try:
                near = cost(arguments.program, [str(presets[name]), *SIZE])
                many = cost(arguments.program, [file.name])
            except subprocess.CalledProcessError as error:
                sys.exit(f"{name}: {error.stderr}")
        return [name, *(near.get(figure, "") for figure in FIGURES), *(many.get(figure, "") for figure in FIGURES)]

    out = csv.writer(sys.stdout, lineterminator="\n")
    out.writerow(["species", *(f"near_{figure}" for figure in FIGURES), *(f"thousand_{figure}" for figure in FIGURES)])
    with concurrent.futures.ThreadPoolExecutor() as pool:
        out.writerows(pool.map(row, arguments.names or presets))


if __name__ == "__main__":
    main()
