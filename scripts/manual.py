#!/usr/bin/env python3
"""Usage: scripts/manual.py [--check | --strips [--again NAME...]]

Writes docs/kinds/*.md and docs/settings/*.md from what `frond describe --json` says, docs/species.md from what `frond list
--json` says, docs/library.md from the header of the library, and renders the strips of kinds and settings.

  scripts/manual.py              the pages, with the strips that there are
  scripts/manual.py --check      whether the pages are those of the program; writes nothing
  scripts/manual.py --strips     renders the strips that are missing, most telling first, then the pages
  scripts/manual.py --strips --again NAME...   renders those anew, as tree-habit-branching_angle

A strip is three small pictures of one preset, which differ in one value, as docs/kinds/strips.json lists. Stopped and
run again it goes on where it was.
"""
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
FROND = os.environ.get("FROND_BIN", str(ROOT / "build" / "frond"))
os.environ.setdefault("FROND_HOME", str(ROOT))
SIZE = "160x120"

# bases: where a strip's preset comes from, and what is simpler in it than there; nearer: what is nearer to the camera
# than in its preset; scenes: the bases in which settings are shown; strips: the property and its three values, most
# telling first, in organisms[0], of ivy in organisms[1].
LISTED = json.loads((ROOT / "docs/kinds/strips.json").read_text())
BASES, NEARER, SCENES, STRIPS = (LISTED[name] for name in ("bases", "nearer", "scenes", "strips"))


def describe():
    return json.loads(subprocess.run([FROND, "describe", "--json"], check=True, capture_output=True).stdout)


def listed(*groups):
    """What there is of each group, as pairs of a name and what is said of it."""
    rows = json.loads(subprocess.run([FROND, "list", "--json"], check=True, capture_output=True).stdout)
    return [[(row["name"], row["doc"]) for row in rows if row["group"] == group] for group in groups]


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


# The page of the library.
HEADER = ROOT / "gen" / "api" / "frond" / "frond.h"
EXAMPLE = ROOT / "docs" / "examples" / "library"

HEAD = """# The library

`cmake --install build --prefix PREFIX` installs the program with its presets, the shared library, its header, and what `find_package(Frond)` needs.
The header is all that others see; it stands on nothing but the standard library of C++20.

"""


def comment_of(lines):
    """The text of lines of `//` or `///`; indented ones are code."""
    return "\n".join(re.sub(r"^\s*///? ?", "", line) for line in lines).strip("\n")


def declarations(text):
    """Comments before a declaration at the outermost level, and its lines."""
    comment, body, depth = [], [], 0
    for line in text.splitlines():
        if not body and line.startswith("///"):
            comment.append(line)
        elif body or line.strip():
            body.append(line)
            depth += line.count("{") - line.count("}")
            if depth == 0 and line.rstrip().endswith((";", "}")):
                yield comment_of(comment), "\n".join(body)
                comment, body = [], []


def title_of(body):
    """What a declaration is called on the page."""
    found = re.search(r"^(class|struct) (\w+)", body)
    return found.group(2) if found else re.search(r"(\w+)\(", body).group(1)


def without_private(body):
    """A class as others see it."""
    return re.sub(r"\n+ private:\n.*(?=\n};)", "", body, flags=re.S)


def library_page():
    text = HEADER.read_text()
    before, inside = text.split("namespace frond::api {\n", 1)
    intro = [line for line in before.splitlines() if line.startswith("//")][2:]
    page = HEAD + comment_of(intro)
    page += "\n\nA program that grows an oak, `docs/examples/library/main.cpp`:\n\n```cpp\n" + (EXAMPLE / "main.cpp").read_text()
    page += "```\n\nand its `CMakeLists.txt`:\n\n```cmake\n" + (EXAMPLE / "CMakeLists.txt").read_text() + "```\n"
    for comment, body in declarations(inside.rsplit("}  // namespace frond::api", 1)[0]):
        page += f"\n## {title_of(body)}\n\n" + (comment + "\n\n" if comment else "") + f"```cpp\n{without_private(body)}\n```\n"
    return page


SPECIES = """# Species

Plants by their names: each is a preset that renders by itself, found by its file's name, its Latin name or any everyday
name, and that other scenes name as the species of their own plants.

    frond render lavender
    frond render "Lavandula angustifolia"
    frond describe daisy
    frond new my_garden --with rose,lavender,apple

The last one writes a preset of a bed in which these stand, the tall ones behind, in drifts of as many as suit their sizes,
before a camera that frames them. In a preset:

    {"species": "lavender", "count": 30, "place": {"radius": 2}}
    {"species": "wheat", "count": 20000, "sown": {"models": 6, "where": {"radius": 0.03}}}

All that a species says of how it grows and looks may be given anew there; its flowers are told in [flowers](flowers.md). `taxon` in its preset has the names, the usual
sizes of the plant, its leaves, flowers and fruit, the months of both, and where these figures come from. A test grows one
plant of each and holds it to them.

[species_cost.csv](species_cost.csv) has what each costs by itself and as a thousand copies, memory, bytes and seconds, as
`frond info` reckons it on a machine of two slow processors: half of them less than 14 MB a frame and 560 MB of memory by
themselves, and less than 9 MB and 210 MB as a thousand copies. `bench/species_cost.py` makes it anew.
"""


def species_page(species):
    page = SPECIES
    for sheet in sorted((ROOT / "docs/gallery").glob("species-*.jpg")):
        page += f"\n![{sheet.stem.removeprefix('species-').replace('_', ' ')}](gallery/{sheet.name})\n"
    page += "\n| species | Latin name | also called | flowers | fruit |\n| --- | --- | --- | --- | --- |\n"
    for name, doc in species:
        taxon, *times = doc.split("; ")
        latin, names = taxon.split(": ")
        months = dict(time.split(" ", 1) for time in times)
        page += f"| `{name}` | *{latin}* | {names} | {months.get('flowers', '')} | {months.get('fruit', '')} |\n"
    return page


def sentence_of(text):
    return text[0].upper() + text[1:] + "."


def pages():
    topics = describe()
    growers, settings, species = listed("growers", "settings", "species")
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
                                      "setting.", topics,
                                      ["film", "taxon", "scene/camera", "scene/wind", "events", "plan", "stand", "reef"],
                                      "## The top\n\n" + table([t for t in topics if "/" not in t["path"]], "") + MADE)
    index = "".join(f"* [{name}]({name}.md): {doc}\n" for name, doc in settings)
    made["settings/README.md"] = ("# Settings\n\n" + index +
                                  "* [preset](preset.md): film, camera, wind, events and the rest of a preset\n" + MADE)
    made["library.md"] = library_page() + MADE
    made["species.md"] = species_page(species) + MADE
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
