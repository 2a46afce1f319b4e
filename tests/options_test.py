#!/usr/bin/env python3
"""Every option of a command is read by it: with another value the command writes something else, or refuses it.

Usage: options_test.py FROND ROOT. An option that --help shows and the table below does not know is a failure, too.
"""
import functools
import hashlib
import os
import re
import subprocess
import sys
import tempfile

FROND, ROOT = os.path.abspath(sys.argv[1]), os.path.abspath(sys.argv[2])
PRESETS = os.path.join(ROOT, "tests", "presets")
STILL = os.path.join(PRESETS, "tiny_still.json")
FILM = os.path.join(PRESETS, "tiny_film.json")
PLANT = os.path.join(PRESETS, "tiny_plant.json")
TREE = os.path.join(ROOT, "presets", "aspen.json")
PLAN = os.path.join(ROOT, "presets", "garden", "walled.json")
WOOD = os.path.join(ROOT, "presets", "forest", "clearing.json")
KOCH = os.path.join(ROOT, "presets", "grammars", "koch_curve.json")

# Options that change no result, wherever they stand.
WITHOUT_RESULT = {"--help", "--threads", "--quiet", "--out", "--assets"}
# What commands are asked for that start other programs, or go on for long, is tested with them.
ELSEWHERE = {"render", "sheet", "farm", "resolve", "gallery", "studio", "task", "frame", "film", "compare", "develop",
             "confine", "check", "describe", "new", "import", "list", "schema", "completion", "man",
             "try"}

SIZE = {"--size": "48x32", "--scale": "2", "--quality": "best", "--fps": "5", "--seconds": "0.3"}
PRINT = {"--print": "1cm", "--transparent": None}
PICTURES = {**SIZE, **PRINT, "--crop": "0,0,50%x50%", "--depth": "16"}
SEED = {"--set": "/seed=77"}

# Of each command: the words of a call, and for each option its value (None: a flag), or all words of another call,
# the last of which is the option.
COMMANDS = {
    "generate": ([FILM, "-o", "out", "-q", "--no-resolve"],
                 {**SEED, **PICTURES, "--frames": "2-3", "--film-only": None,
                  "--dpi": [FILM, "-o", "out", "-q", "--print=1cm", "--dpi=72"],
                  "--resolve": [FILM, "-o", "out", "-q", "--resolve"],
                  "--no-resolve": [FILM, "-o", "out", "-q", "--quality=good", "--no-resolve"],
                  "--alone": [FILM, "-o", "out", "-q", "--resolve", "--frames=3-3", "--alone"]}),
    "look": ([FILM, "-o", "out/look.png"], {**SEED, **SIZE, "--frame": "2", "--views": None}),
    "passes": ([FILM, "-o", "out"], {**SEED, **SIZE, "--frames": "2", "--side": "2", "--albedo": None, "--views": None}),
    "draw": ([FILM, "-o", "out"], {**SEED, **SIZE, **PRINT, "--frames": "2", "--pen": "3", "--hatch": "9",
                                     "--dpi": [FILM, "-o", "out", "--print=1cm", "--dpi=72"]}),
    "export": ([STILL, "-o", "out/a.glb", "-q"],
               {**SEED, "--sides": "4", "--detail": "400", "--lods": "2", "--texture": "64", "--seeds": "2",
                "--frame": [FILM, "-o", "out/a.glb", "--frame=2"], "--frames": [FILM, "-o", "out/a.glb", "--frames=1-3"],
                "--keys": [FILM, "-o", "out/a.glb", "--frames=1-6", "--keys=2"],
                "--voxel": [STILL, "-o", "out/a.vdb", "--voxel=0.05"],
                "--instances": [PLANT, "-o", "out/a.glb", "--instances"]}),
    "info": ([FILM], {**SEED, **SIZE, "--frames": "1-2", "--json": None, "--sizes": None, "--frame": "2",
              "--fps": [FILM, "--seconds=1", "--fps=5"]}),
    "files": ([STILL], {"--set": "/base=" + FILM}),
    "plan": ([PLAN, "-o", "out/plan.svg"], {**SEED, "--seeds": "2"}),
    "stand": ([WOOD, "-o", "out/stand.svg", "--set=/stand/years=20", "--set=/events=[]", "--set=/stand/area=[30, 30]"],
              {**SEED, "--year": "5"}),
    "textures": ([TREE, "-o", "out"], SEED),
    "derive": ([KOCH, "--steps", "1"],
               {"--steps": "2", "--seed": None, "--angle": None, "--mutate": None, "--format": "counts", "--tree": "out/a.svg", "--system": None}),
    "turtle": ([KOCH, "--steps", "1"],
               {"--steps": "2", "--seed": None, "--angle": "30", "--mutate": None, "--svg": "out/a.svg", "--system": None}),
}
# Of these two commands what only other grammars read.
ONLY_OF_SOME = {("derive", "--seed"), ("derive", "--angle"), ("derive", "--mutate"), ("turtle", "--seed"),
                ("turtle", "--mutate"), ("textures", "--set"), ("derive", "--system"), ("turtle", "--system")}


def options_of(command):
    text = subprocess.run([FROND, command, "--help"], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"^\s+(?:-\w,)?(--[a-z-]+)", text, re.M))


def commands():
    text = subprocess.run([FROND, "--help"], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"^  ([a-z]+)  ", text, re.M))


def result_of(command, words, cache):
    """A hash of all that a call writes, says and returns; and what it says."""
    with tempfile.TemporaryDirectory() as folder:
        os.mkdir(os.path.join(folder, "out"))
        ran = subprocess.run([FROND, command, *words], cwd=folder, capture_output=True, timeout=300,
                             env={**os.environ, "FROND_HOME": ROOT, "XDG_CACHE_HOME": cache, "NO_COLOR": "1"})
        all_of = hashlib.sha256(ran.stdout + bytes([ran.returncode]))
        if command in ("info", "look", "export"):
            all_of.update(ran.stderr)
        for where, _, names in sorted(os.walk(folder)):
            for name in sorted(names):
                all_of.update(os.path.relpath(os.path.join(where, name), folder).encode())
                with open(os.path.join(where, name), "rb") as file:
                    all_of.update(file.read())
        return all_of.hexdigest(), ran.stderr.decode(errors="replace")


def words_with(words, option, value):
    if isinstance(value, list):
        return value
    drop = option in words  # where the call has it with another value
    kept = [w for i, w in enumerate(words) if not (drop and (w == option or (i and words[i - 1] == option)))]
    return kept + ([option] if value is None else [f"{option}={value}"])


def main():
    with tempfile.TemporaryDirectory() as cache:  # pictures of leaves and bark are drawn once for all calls
        return judge(functools.cache(lambda command, *words: result_of(command, words, cache)))


def judge(result):
    faults = [f"{command}: neither in the table nor tested elsewhere" for command in commands() - ELSEWHERE - set(COMMANDS)]
    for command, (words, values) in COMMANDS.items():
        shown = options_of(command)
        faults += [f"{command} {option}: not in the table" for option in sorted(shown - WITHOUT_RESULT - set(values))]
        faults += [f"{command} {option}: is no option of it" for option in sorted(set(values) - shown)]
        usual, _ = result(command, *words)
        for option, value in values.items():
            if option not in shown or (command, option) in ONLY_OF_SOME:
                continue
            base = usual
            if isinstance(value, list):
                base, _ = result(command, *value[:-1])
            got, said = result(command, *words_with(words, option, value))
            if got == base:
                faults.append(f"{command} {option}: changes nothing")
            elif "Run with --help" in said:
                faults.append(f"{command} {option}: {said.splitlines()[0]}")
    print("\n".join(faults) or "every option is read")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
