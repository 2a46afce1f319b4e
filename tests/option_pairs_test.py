#!/usr/bin/env python3
"""Every pair of options of a command is judged before work begins: it is refused at once, by words that name one of
them, and leaves nothing behind, or it goes through. Below stands which pairs are refused; an option that is not
listed here fails the test, so that nobody adds one without asking what it goes with.

    option_pairs_test.py FROND ROOT [COMMAND ...]
"""

import itertools
import os
import pathlib
import re
import subprocess
import sys
import tempfile

FROND, ROOT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve()
WRONG_INPUT = 2
JUDGED = "nowhere/povray: no such program"  # what render says where all it was asked for is well

PRESET = """{
  "film": {"frames": 2, "size": [32, 24], "quality": "draft"},
  "scene": {"setting": "studio", "camera": {"location": [0, 0.4, 2], "look_at": [0, 0.2, 0]}},
  "organisms": [{"kind": "plant", "name": "shoot", "height": 0.4, "place": {"at": [[0, 0]]},
                 "grammar": {"axiom": "F", "steps": 2, "rules": ["F -> F[+F]F"]}}]
}"""

# Values that go through alone, several where they matter.
VALUES = {
    "--set": ["/seed=2"], "--size": ["40x30"], "--scale": ["2"], "--quality": ["draft"], "--fps": ["12"],
    "--seconds": ["0.2"], "--print": ["1cm"], "--dpi": ["100"], "--crop": ["0,0,8x8"], "--depth": ["16"],
    "--transparent": [None], "--assets": ["."], "--out": ["made"], "--frames": ["1"], "--jobs": ["1"], "--threads": ["1"],
    "--resolve": [None], "--no-resolve": [None], "--format": ["mp4", "webm", "gif", "mov"], "--every": ["2"],
    "--watch": [None], "--plot": ["plot.svg"], "--why": ["1"], "--compare": ["a.png b.png"], "--sweep": ["/seed=1:2:2"],
    "--contact-seeds": ["2"], "--alone": [None], "--film-only": [None], "--quiet": [None], "--frame": ["2"],
    "--side": ["2"], "--albedo": [None], "--views": [None], "--pen": ["2"], "--hatch": ["0"], "--keys": ["3"],
    "--seeds": ["2"], "--sides": ["6"], "--voxel": ["0.05"], "--detail": ["2000"], "--lods": ["2"], "--texture": ["16"],
    "--instances": [None], "--json": [None], "--sizes": [None], "--tree": ["tree.svg"], "--svg": ["figure.svg"],
    "--seed": ["2"], "--angle": ["20"], "--mutate": ["1"], "--steps": ["1"], "--openjd": ["job.json"],
    "--opencue": ["cue.xml"], "--chunk": ["1"], "--bands": ["1"], "--site": ["site.json"], "--hosts": ["a"],
    "--partition": ["p"], "--status": [None], "--cancel": [None], "--logs": [None], "--columns": ["2"],
    "--width": ["20"], "--title": ["t"], "--comment": ["c"], "--alpha": [None],
    "--system": ["Bush"], "--upgrade": [None],
}
OF_COMMAND = {
    "export": {"--out": ["a.obj", "a.ply", "a.glb", "a.vdb", "a.inc"], "--frames": ["1-2"]},
    "look": {"--out": ["look.png"]}, "derive": {"--format": ["counts"]},
}
# What stands on the line besides options.
WORDS = {"derive": ["grammar.json"], "turtle": ["grammar.json"], "film": ["list", "film.webm"]}

SHEET = ["--sweep", "--contact-seeds"]
OF_FILM = ["--format", "--every", "--watch", "--plot"]
PICTURES = [("--print", "--size"), ("--print", "--scale")]
RESOLVED = [("--resolve", "--no-resolve"), ("--resolve", "--crop"), ("--resolve", "--transparent")]

# Pairs that are refused: of options, or of options with a value.
REFUSED = {
    "render": PICTURES + RESOLVED + [("--format=mp4", "--transparent")] + list(itertools.product(SHEET, OF_FILM)) +
              [("--why", other) for other in OF_FILM + SHEET + ["--jobs"]] + [("--compare", "*")],
    "sheet": PICTURES + RESOLVED, "generate": PICTURES + RESOLVED, "look": PICTURES, "passes": PICTURES,
    "draw": PICTURES, "info": PICTURES, "check": [],
    "export": PICTURES + [("--frame", "--frames"), ("--frames", "--lods"), ("--frames", "--instances"),
                          ("--lods", "--instances")] +
              [(f"--out=a.{mesh}", option) for mesh in ("obj", "ply") for option in
               ("--frames", "--lods", "--seeds", "--voxel", "--keys")] +
              [("--out=a.glb", "--seeds"), ("--out=a.glb", "--voxel")] +
              [("--out=a.vdb", option) for option in ("--frames", "--lods", "--seeds", "--sides", "--keys")] +
              [("--out=a.inc", option) for option in ("--lods", "--voxel", "--instances", "--keys")],
    "derive": [("--tree", "--format")], "turtle": [],
    "film": [("--columns", option) for option in ("--fps", "--title", "--comment", "--alpha", "--dpi")],
}
# Refused alone, and with all but these.
ALONE = {
    "render": {"--format=mov": ["--transparent"]},
    "sheet": {option: SHEET for option in []},
    "export": {"--keys": ["--frames"]},
    "derive": {"--mutate": [], "--system": []}, "turtle": {"--mutate": [], "--system": []},
    "film": {"--width": ["--columns"]},
}
# One of these has to be there for the command to do anything.
NEEDED = {"sheet": ["--contact-seeds=2"], "export": ["--out=a.glb"]}


def options_of(command):
    """The options that its help names, each with its values: (name, value)."""
    text = subprocess.run([FROND, command, "--help"], capture_output=True, text=True, check=True).stdout
    names = [name for name in dict.fromkeys(re.findall(r"^\s+(?:-\w,)?(--[a-z-]+)", text, re.M)) if name != "--help"]
    unknown = [name for name in names if name not in VALUES]
    assert not unknown, f"{command}: no value and no pairs are known of {', '.join(unknown)}; tell them in this test"
    return [(name, value) for name in names for value in OF_COMMAND.get(command, {}).get(name, VALUES[name])]


def matches(rule, option):
    name, value = option
    return rule in ("*", name, f"{name}={value}")


def is_refused(command, options):
    refused = any(matches(a, one) and matches(b, other) for a, b in REFUSED[command]
                  for one, other in itertools.permutations(options, 2) if one[0] != other[0])
    for rule, rescue in ALONE.get(command, {}).items():
        alone = [option for option in options if matches(rule, option)]
        refused = refused or (alone and not any(option[0] in rescue for option in options))
    return bool(refused)


def call(command, options, folder):
    words = [FROND, command, *WORDS.get(command, ["preset.json"])]
    for name, value in options:
        words += [name, *value.split(" ")] if name == "--compare" else [name if value is None else f"{name}={value}"]
    environment = {**os.environ, "XDG_CACHE_HOME": str(folder.parent / "cache"), "FROND_HOME": str(ROOT)}
    if command == "render":
        environment["FROND_POVRAY"] = "nowhere/povray"
    return subprocess.run(words, cwd=folder, capture_output=True, text=True, env=environment, timeout=120)


def begin(folder):
    folder.mkdir()
    (folder / "preset.json").write_text(PRESET)
    (folder / "grammar.json").write_text('{"axiom": "F", "steps": 2, "rules": ["F -> F+F"]}')
    (folder / "list").write_text("".join(f"{ROOT}/docs/gallery/none{i}.png\n" for i in (1, 2)))
    return sorted(folder.iterdir())


def judge(command, options, top, number):
    """What is wrong with how a call ends; empty where nothing is."""
    folder = top / f"{command}_{number}"
    before = begin(folder)
    needed = [tuple(word.split("=")) for word in NEEDED.get(command, [])]
    options = options + [option for option in needed if not any(o[0] in (option[0], *SHEET) for o in options)]
    done = call(command, options, folder)
    told = " ".join(name if value is None else f"{name}={value}" for name, value in options)
    said = f"{command} {told}: exit code {done.returncode}: {done.stderr.strip()[-300:]}"
    if is_refused(command, options):
        named = any(name.lstrip("-") in done.stderr for name, _ in options)
        wrote = sorted(folder.iterdir()) != before
        return [f"{said} (expected to be refused{', and left files' if wrote else ''})"] \
            if done.returncode != WRONG_INPUT or not named or wrote else []
    if command == "render":
        if options[0][0] == "--compare":  # of pictures that are not there
            return [] if "a.png: no such film" in done.stderr else [said]
        sheet = any(name in SHEET for name, _ in options)
        return [] if JUDGED in done.stderr or (sheet and "povray" in done.stderr) else [said + " (expected to go on)"]
    if command == "sheet":
        return []  # its pictures are rendered as others
    if command == "film":  # whose pictures are not there
        return [] if "none1.png" in done.stderr else [said]
    return [] if done.returncode == 0 else [said]


def main():
    commands = sys.argv[3:] or ["render", "generate", "look", "passes", "draw", "export", "info", "check", "derive",
                                "turtle", "film"]
    wrong = count = 0
    with tempfile.TemporaryDirectory() as top:
        for command in commands:
            options = options_of(command)
            calls = [[one] for one in options]
            calls += [list(pair) for pair in itertools.combinations(options, 2) if pair[0][0] != pair[1][0]]
            for options in calls:
                count += 1
                for said in judge(command, options, pathlib.Path(top), count):
                    wrong += 1
                    print(said, flush=True)
    print(f"{count} calls, {wrong} of them other than expected")
    return 1 if wrong else 0


sys.exit(main())
