#!/usr/bin/env python3
"""Compares what frond generates for the small presets with tests/golden, or renews it.

    scripts/golden.py --check     exit code 1 and a short diff where something differs
    scripts/golden.py --update    renews tests/golden; look at the diff as at code

Each tests/presets/tiny_*.json has tests/golden/<name>/ with manifest.json, build.ninja and some of the frames: those
that are there already, at first the first, a middle and the last one. Of a very long line (a mesh) its beginning,
length and checksum stand there, and so of a long run of lines that begin alike. FROND_BIN names another program than
build/frond.
"""
import argparse
import difflib
import hashlib
import itertools
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
GOLDEN = ROOT / "tests/golden"
LONG_LINE = 600
LONG_LINE_START = 120
LONG_RUN = 20
RUN_START = 10
SHOWN_LINES = 20
SHOWN_WIDTH = 160


def abridged(text):
    """The text with each very long line and each long run of lines that begin alike cut short, in a way that tells any
    two apart."""
    def checksum(whole):
        return hashlib.sha256(whole.encode()).hexdigest()[:16]

    def line(whole):
        if len(whole) <= LONG_LINE:
            return whole
        return f"{whole[:LONG_LINE_START]}... ({len(whole)} characters, {checksum(whole)})"

    lines = []
    for _, run in itertools.groupby(text.split("\n"), key=lambda whole: whole[:RUN_START]):
        run = list(run)
        lines += [line(whole) for whole in run[:LONG_RUN]]
        if rest := run[LONG_RUN:]:
            lines.append(f"... ({len(rest)} lines more, {checksum(chr(10).join(rest))})")
    return "\n".join(lines)


def unnamed(text):
    """The text without the hashes in names of files, which change with the program."""
    return re.sub(r"(?<=_)[0-9a-f]{16}(?=[_.])", "HASH", text)


def generate(frond, preset, out):
    """Files of a preset by name. What depends on where the folder lies is taken out of build.ninja."""
    run = subprocess.run([frond, "generate", preset, "-o", out], capture_output=True, text=True,
                         env={**os.environ, "FROND_HOME": str(ROOT)}, check=False)
    if run.returncode:
        sys.exit(f"{preset}: frond ended with exit code {run.returncode}\n{run.stderr}")
    files = {path.name: abridged(unnamed(path.read_text(encoding="utf-8"))) for path in (out / "frames").glob("*.pov")}
    files["manifest.json"] = unnamed((out / "manifest.json").read_text(encoding="utf-8"))
    ninja = (out / "build.ninja").read_text(encoding="utf-8")
    program = os.path.relpath(pathlib.Path(frond).resolve(), out.resolve())
    files["build.ninja"] = ninja.replace(program, "PROGRAM").replace(os.path.relpath(ROOT, out.resolve()), "ROOT")
    return files


def kept(files, folder):
    """Names of the golden files: the frames that are golden already, or at first three of them."""
    frames = sorted(path.name for path in folder.glob("frame_*.pov"))
    if not frames:
        listed = [pathlib.Path(frame["file"]).name for frame in json.loads(files["manifest.json"])["frames"]]
        frames = sorted({listed[0], listed[len(listed) // 2], listed[-1]})
    return ["manifest.json", "build.ninja", *frames]


def short_diff(name, golden, found):
    lines = list(difflib.unified_diff(golden.splitlines(), found.splitlines(), f"golden {name}", f"now {name}",
                                      n=1, lineterm=""))
    shown = [line if len(line) <= SHOWN_WIDTH else line[:SHOWN_WIDTH] + "..." for line in lines[:SHOWN_LINES]]
    if len(lines) > SHOWN_LINES:
        shown.append(f"... and {len(lines) - SHOWN_LINES} lines more")
    return "\n".join(shown)


def compare(folder, files):
    """One text a difference."""
    for name in kept(files, folder):
        path = folder / name
        shown = f"{folder.name}/{name}"
        if not path.exists():
            yield f"{shown}: is not in tests/golden"
        elif name not in files:
            yield f"{shown}: is no longer generated"
        elif (golden := path.read_text(encoding="utf-8")) != files[name]:
            yield short_diff(shown, golden, files[name])


def renew(folder, files):
    """Writes the golden files; the number of those that changed."""
    names = [name for name in kept(files, folder) if name in files]
    if not any(name.startswith("frame_") for name in names):
        shutil.rmtree(folder, ignore_errors=True)
        names = kept(files, folder)
    changed = 0
    folder.mkdir(parents=True, exist_ok=True)
    for path in folder.iterdir():
        if path.name not in names:
            path.unlink()
    for name in names:
        path = folder / name
        if not path.exists() or path.read_text(encoding="utf-8") != files[name]:
            path.write_text(files[name], encoding="utf-8")
            changed += 1
    return changed


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    what = parser.add_mutually_exclusive_group(required=True)
    what.add_argument("--check", action="store_true", help="compare")
    what.add_argument("--update", action="store_true", help="renew tests/golden")
    arguments = parser.parse_args()
    frond = os.environ.get("FROND_BIN") or str(ROOT / "build/frond")
    presets = sorted((ROOT / "tests/presets").glob("tiny_*.json"))

    differences, changed = [], 0
    for preset in presets:
        with tempfile.TemporaryDirectory(prefix="frond-golden-") as out:
            files = generate(frond, preset, pathlib.Path(out))
        folder = GOLDEN / preset.stem
        if arguments.update:
            changed += renew(folder, files)
        else:
            differences.extend(compare(folder, files))
    known = {preset.stem for preset in presets}
    for folder in sorted(path for path in GOLDEN.glob("tiny_*") if path.name not in known):
        if arguments.update:
            shutil.rmtree(folder)
        else:
            differences.append(f"{folder.name}: has no preset in tests/presets any more")

    if arguments.update:
        print(f"{len(presets)} presets, {changed} golden files changed")
    elif differences:
        print("\n\n".join(differences))
        print(f"\n{len(differences)} differences. Where they are meant: scripts/golden.py --update")
        sys.exit(1)
    else:
        print(f"{len(presets)} presets are as tests/golden says")


if __name__ == "__main__":
    main()
