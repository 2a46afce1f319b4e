#!/usr/bin/env python3
"""Usage: scripts/manual.py [--check | --strips [--again NAME...]]

Writes docs/kinds/*.md and docs/settings/*.md from what `frond describe --json` says, and renders their strips.

  scripts/manual.py              the pages, with the strips that there are
  scripts/manual.py --check      whether the pages are those of the program; writes nothing
  scripts/manual.py --strips     renders the strips that are missing, most telling first, then the pages
  scripts/manual.py --strips --again NAME...   renders those anew, as tree-habit-branching_angle

A strip is three small pictures of one preset, which differ in one value. Stopped and run again it goes on where it was.
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FROND = os.environ.get("FROND_BIN", str(ROOT / "build" / "frond"))
os.environ.setdefault("FROND_HOME", str(ROOT))
SIZE = "160x120"

# Where a strip's preset comes from, and what is simpler in it than there.
BARE = ["/scene/meadow/blade=0", "/scene/meadow/clouds=0"]
BASES = {
    "coral": ("templates/new/coral.json", ["/scene/water/particles=0"]),
    "plant": ("templates/new/plant.json", BARE),
    "rock": ("templates/new/rock.json", BARE),
    "pebbles": ("templates/new/pebbles.json", BARE),
    "wall": ("templates/new/wall.json", BARE),
    "column": ("templates/new/column.json", BARE),
    "mesh": ("templates/new/mesh.json", BARE),
    "bridge": ("templates/new/bridge.json", BARE),
    "vase": ("templates/new/vase.json", []),
    "weber_penn": ("templates/new/weber_penn.json", BARE + ["/scene/camera/angle=50"]),
    "colonized": ("templates/new/colonized.json", BARE),
    "tree": ("templates/new/tree.json", BARE),
    "ivy": ("templates/new/ivy.json", BARE),
    "shell": ("templates/new/shell.json", []),
    "school": ("templates/new/school.json", ["/scene/water/particles=0"]),
}

# What is nearer to the camera than in its preset.
NEARER = {
    "coral/skin/pores/cell": ["/scene/camera/angle=11"],
    "coral/skin/kind": ["/scene/camera/angle=11"],
    "coral/thickness/knob": ["/scene/camera/angle=20"],
    "plant/organs/bend": ["/scene/camera/angle=14"],
    "plant/bark/kind": ["/scene/camera/angle=8", "/scene/camera/look_at=[0,0.25,0]"],
    "wall/wear": ["/scene/camera/angle=14"],
    "wall/weathering": ["/scene/camera/angle=24"],
    "column/broken": ["/scene/camera/angle=46"],
    "column/flutes": ["/scene/camera/angle=12"],
    "ivy/leaves/size": ["/scene/camera/angle=22"],
}

# The strips, most telling first: the property, and its three values. In organisms[0], of ivy in organisms[1].
STRIPS = [
    ("coral/pitch", [15, 30, 50]),
    ("coral/steps", [2, 3, 5]),
    ("tree/years", [8, 15, 24]),
    ("tree/habit/branching_angle", [30, 55, 85]),
    ("tree/habit/apical_control", [0.5, 0.66, 0.85]),
    ("vase/profile", [[[0.1, 0], [0.1, 0.3]], [[0.06, 0], [0.2, 0.12], [0.05, 0.3]],
                      [[0.03, 0], [0.05, 0.1], [0.06, 0.15], [0.2, 0.3]]]),
    ("rock/weathering/facets", [0, 8, 24]),
    ("rock/weathering/strata", [0, 0.4, 0.9]),
    ("coral/thickness/knob", [0.5, 1, 1.8]),
    ("coral/skin/pores/cell", [0.01, 0.02, 0.045]),
    ("plant/grammar/steps", [3, 6, 9]),
    ("plant/organs/bend", [0, 40, 120]),
    ("tree/habit/tropism", [-0.3, 0.3, 1.2]),
    ("tree/habit/shade_tolerance", [0.2, 0.5, 0.9]),
    ("tree/leaves/size", [0.12, 0.28, 0.5]),
    ("colonized/envelope/shape", ["ball", "cone", "cylinder"]),
    ("colonized/colonize/attractors", [400, 1500, 5000]),
    ("weber_penn/tree/shape", ["conical", "hemispherical", "inverse_conical"]),
    ("weber_penn/tree/base_size", [0.05, 0.25, 0.5]),
    ("wall/ruin", [0, 0.4, 0.8]),
    ("wall/wear", [0, 0.4, 1]),
    ("wall/weathering", [0, 0.5, 1]),
    ("column/broken", [0, 0.35, 0.7]),
    ("column/flutes", [0, 12, 24]),
    ("ivy/crawl/max_age", [40, 90, 150]),
    ("ivy/crawl/wander", [5, 25, 60]),
    ("ivy/crawl/branch_every", [0.15, 0.4, 1]),
    ("ivy/leaves/size", [0.03, 0.07, 0.12]),
    ("bridge/height", [0.4, 1.1, 2]),
    ("bridge/style", ["wood", "stone", None]),
    ("vase/material", ["ceramic", "terracotta", "glass"]),
    ("vase/gloss", [0, 0.5, 1]),
    ("pebbles/number", [30, 120, 400]),
    ("mesh/matter", ["limestone", "brick", "plaster"]),
    ("rock/stone/kind", ["granite", "limestone", "basalt"]),
    ("rock/stone/moss", [0, 0.4, 1]),
    ("coral/lift", [-0.08, 0.05, 0.25]),
    ("coral/distortion/strength", [0, 0.1, 0.3]),
    ("coral/skin/kind", ["stony", "fan", "soft"]),
    ("plant/bark/kind", ["stem", "bark", "wax"]),
    ("tree/habit/wander", [0, 12, 35]),
    ("tree/habit/droop", [0, 0.2, 0.8]),
    ("tree/wood/exponent", [1.9, 2.4, 3]),
    ("meadow/sun", [[-1, 0.15, 0.3], [-0.6, 0.8, 0.5], [0.2, 1, 0.1]]),
    ("meadow/clouds", [0, 0.4, 0.9]),
    ("meadow/blade", [0.04, 0.12, 0.35]),
    ("meadow/haze", [30, 200, 4000]),
    ("water/visibility", [3, 8, 25]),
    ("water/shafts", [0, 0.5, 1]),
    ("garden/hour", [6.5, 12, 20]),
    ("forest/hour", [7, 12, 19.5]),
    ("studio/softness", [0, 1, 3]),
    ("studio/key", [[-1, 0.3, 0.6], [-0.8, 0.75, 0.7], [0.6, 1, -0.3]]),
]
# The scenes in which settings are shown.
SCENES = {"meadow": "plant", "water": "coral", "garden": "bridge", "forest": "rock", "studio": "vase"}


def describe():
    return json.loads(subprocess.run([FROND, "describe", "--json"], check=True, capture_output=True).stdout)


def kinds():
    listed = json.loads(subprocess.run([FROND, "list", "--json"], check=True, capture_output=True).stdout)
    names = {group: [(row["name"], row["doc"]) for row in listed if row["group"] == group]
             for group in ("growers", "settings")}
    return names["growers"], names["settings"]


def strip_name(path):
    return path.replace("/", "-")


def pictures_of(path):
    return ROOT / "docs" / ("settings" if path.split("/")[0] in SCENES else "kinds") / "pictures"


def sets_of(path):
    """The preset of a strip, what is simpler in it, and the pointer of the property."""
    first, rest = path.split("/", 1)
    if first in SCENES:
        base, sets = BASES[SCENES[first]]
        if first == "forest":
            sets = ['/scene/setting="forest"']
        if first in ("meadow", "water", "garden"):
            sets = []
        return base, sets, f"/scene/{first}/{rest}"
    base, sets = BASES[first]
    at = 1 if first == "ivy" else 0
    rest = rest.replace("organs/", "organs/0/")
    return base, sets, f"/organisms/{at}/{rest}"


def render(path, values):
    base, sets, pointer = sets_of(path)
    strip = pictures_of(path) / (strip_name(path) + ".jpg")
    strip.parent.mkdir(parents=True, exist_ok=True)
    values = [v for v in values if v is not None]
    with tempfile.TemporaryDirectory() as scratch:
        inputs = []
        for i, value in enumerate(values):
            out = pathlib.Path(scratch) / str(i)
            words = [FROND, "generate", base, "-o", out, "-q", "--size", SIZE, "--quality", "draft"]
            for one in sets + NEARER.get(path, []) + [f"{pointer}={json.dumps(value)}"]:
                words += ["--set", one]
            subprocess.run(words, check=True, cwd=ROOT)
            subprocess.run(["ninja", "-C", out, "frames/frame_0001.png"], check=True, capture_output=True)
            inputs += ["-i", out / "frames" / "frame_0001.png"]
        part = pathlib.Path(scratch) / "strip.jpg"
        subprocess.run(["ffmpeg", "-y", "-loglevel", "error", *inputs, "-filter_complex", f"hstack={len(values)}",
                        "-bitexact", "-q:v", "5", part], check=True, stdin=subprocess.DEVNULL)
        shutil.move(part, strip)
    print(strip.relative_to(ROOT), flush=True)


def cell(text):
    return text.replace("|", "\\|").replace("<", "&lt;")


def values_text(topic):
    text = topic["kind"]
    if "choices" in topic:
        return "one of " + ", ".join(f"`{name}`" for name in topic["choices"])
    if "range" in topic:
        text += ", " + topic["range"]
    return text + (" " if "range" in topic else ", ") + topic["unit"] if "unit" in topic else text


def table(topics, above, root=""):
    """The properties right below a path, and a strip below the table for each that has one; `root` is that of the page."""
    lines, strips = [], []
    for topic in topics:
        if not topic["path"].startswith(above) or "/" in topic["path"][len(above):]:
            continue
        sentence = topic["sentence"] + "."
        described = [f"`{name}`: {doc}" for name, doc in topic.get("choices", {}).items() if doc]
        if described:
            sentence += " " + "; ".join(described) + "."
        initial = f"`{topic['default']}`" if "default" in topic else ""
        values = cell(values_text(topic))
        if root and any(t["path"].startswith(topic["path"] + "/") for t in topics):
            values = f"[{values}](#{topic['path'][len(root) + 1:].replace('/', '')})"
        lines.append(f"| `{topic['path'][len(above):]}` | {cell(sentence)} | {values} | {cell(initial)} |")
        short = topic["path"].removeprefix("scene/")
        for path, values in STRIPS:
            picture = pictures_of(path) / (strip_name(path) + ".jpg")
            if path == short and picture.exists():
                shown = ", ".join(json.dumps(v) for v in values if v is not None)
                strips.append(f"`{short.split('/', 1)[1]}` {shown}:\n\n![{short}](pictures/{picture.name})\n")
    head = "| property | what it is | values | default |\n| --- | --- | --- | --- |\n"
    return (head + "\n".join(lines) + "\n" + "".join("\n" + s for s in strips)) if lines else ""


def page(title, doc, topics, roots, more=""):
    text = f"# {title}\n\n{doc}\n\n"
    for root in roots:
        inside = [t for t in topics if t["path"] == root or t["path"].startswith(root + "/")]
        if inside[0]["path"] == root:
            text += f"## {root.split('/')[-1]}\n\n{inside[0]['sentence']}.\n\n"
        text += table(inside, root + "/", root) + "\n"
        for topic in inside:
            below = table(inside, topic["path"] + "/", root)
            if topic["path"] != root and below:
                depth = topic["path"][len(root) + 1:]
                text += f"## {depth}\n\n{topic['sentence']}.\n\n{below}\n"
    return (text + more).rstrip("\n") + "\n"


MADE = "\nThis page is made by `scripts/manual.py` from the descriptions in the code; `frond describe` shows the same.\n"


def sentence_of(text):
    return text[0].upper() + text[1:] + "."


def pages():
    topics = describe()
    growers, settings = kinds()
    made = {}
    for name, doc in growers:
        common = "\nAll kinds share [these properties](organism.md).\n"
        made[f"kinds/{name}.md"] = page(name, sentence_of(doc), topics, [name], common + MADE)
    made["kinds/organism.md"] = page("What all organisms have", "An entry of `organisms` has these properties, "
                                     "whatever its kind.", topics, ["organism"], MADE)
    index = "".join(f"* [{name}]({name}.md): {doc}\n" for name, doc in growers)
    made["kinds/README.md"] = ("# Kinds of organisms\n\n" + index +
                               "* [organism](organism.md): what all of them have\n" + MADE)
    blocks = {"underwater": ["scene/water", "scene/floor"], "meadow": ["scene/meadow", "scene/floor"],
              "garden": ["scene/garden", "scene/meadow", "scene/floor"], "forest": ["scene/forest", "scene/meadow"]}
    for name, doc in settings:
        made[f"settings/{name}.md"] = page(name, sentence_of(doc), topics, blocks.get(name, [f"scene/{name}"]), MADE)
    made["settings/preset.md"] = page("The preset itself", "What every preset has besides its organisms and its "
                                      "setting.", topics, ["film", "scene/camera"],
                                      "## The top\n\n" + table([t for t in topics if "/" not in t["path"]], "") + MADE)
    index = "".join(f"* [{name}]({name}.md): {doc}\n" for name, doc in settings)
    made["settings/README.md"] = ("# Settings\n\n" + index +
                                  "* [preset](preset.md): film, camera and the rest of a preset\n" + MADE)
    return made


def main(words):
    if "-h" in words or "--help" in words:
        print(__doc__)
        return 0
    known = words[:words.index("--again")] if "--again" in words else words
    if any(word not in ("--check", "--strips") for word in known):
        print(__doc__, file=sys.stderr)
        return 2
    if "--strips" in words:
        again = words[words.index("--again") + 1:] if "--again" in words else []
        for path, values in STRIPS:
            there = (pictures_of(path) / (strip_name(path) + ".jpg")).exists()
            if strip_name(path) in again or not (there or again):
                render(path, values)
    stale = []
    for name, text in pages().items():
        file = ROOT / "docs" / name
        if file.exists() and file.read_text() == text:
            continue
        stale.append(f"docs/{name}")
        if "--check" not in words:
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
    if stale and "--check" in words:
        print("not as the program describes it; scripts/manual.py writes it anew: " + ", ".join(stale))
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
