# SPDX-License-Identifier: GPL-3.0-or-later
"""Presets as files: the program, the folders that hold them, their pictures, and what counts for an organism of one.

Nothing here knows Blender. A pointer is a JSON pointer into a preset, as in /organisms/0/height.
"""
import copy
import functools
import json
import os
import pathlib
import re
import shutil
import subprocess

DEEPEST = 8  # bases of bases
COMMENT = re.compile(r'("(?:[^"\\]|\\.)*")|//[^\n]*|/\*.*?\*/', re.S)
NEVER_OF_SPECIES = ("count", "sown", "species"), ("at", "on", "center", "inner", "radius")


def find_program(preferred=""):
    """The path of the program: the preferred one, $FROND_BIN, or that of PATH; None where there is none."""
    given = preferred or os.environ.get("FROND_BIN", "")
    if given:
        return given if os.access(given, os.X_OK) and os.path.isfile(given) else None
    return shutil.which("frond")


def find_home(program):
    """The folder with presets/ and docs/: $FROND_HOME, or the one above that of the program."""
    return pathlib.Path(os.environ.get("FROND_HOME") or pathlib.Path(program).resolve().parent.parent)


def environment(program):
    return {**os.environ, "FROND_HOME": str(find_home(program))}


def descriptions(program):
    """All properties as `frond describe --json` tells them."""
    text = subprocess.run([program, "describe", "--json"], check=True, capture_output=True, env=environment(program)).stdout
    return json.loads(text)


def pictures(home):
    """By name of a preset, as in trees/oak, the file of its picture: those of docs/gallery that show this preset only."""
    found = {}
    listed = home / "docs/gallery/pictures.txt"
    for line in listed.read_text(encoding="utf-8").splitlines() if listed.exists() else []:
        words = line.split()
        if len(words) < 4 or line.startswith(("#", "large:")):
            continue
        shown = {re.split("[@,]", word)[0] for word in words[3:]}
        picture = home / "docs/gallery" / f"{words[0]}.jpg"
        if len(shown) == 1 and picture.exists():
            found.setdefault(shown.pop(), str(picture))
    return found


def parse(text):
    return json.loads(COMMENT.sub(lambda match: match[1] or "", text))


def list_presets(home, own_folder=""):
    """(file, name, title, picture or "") of each preset of Frond and of one's own folder, in the order of their names."""
    shown, found = pictures(home), []
    for folder, of_frond in ((home / "presets", True), (pathlib.Path(own_folder or os.devnull), False)):
        for file in sorted(folder.rglob("*.json")) if folder.is_dir() else []:
            try:
                document = parse(file.read_text(encoding="utf-8"))
            except (OSError, ValueError):
                continue
            if isinstance(document, dict) and {"organisms", "base"} & document.keys():
                name = file.relative_to(folder).with_suffix("").as_posix()
                found.append((str(file), name, str(document.get("title", name)), shown.get(name, "") if of_frond else ""))
    return found


def overlay(below, own):
    """`own` over `below`: objects member by member, lists and all else as a whole."""
    if not (isinstance(below, dict) and isinstance(own, dict)):
        return own
    return {**below, **{key: overlay(below[key], value) if key in below else value for key, value in own.items()}}


def by_date(read_file):
    """Keeps what a function made of a file until the file changes. It is not to be changed."""
    kept = functools.lru_cache(maxsize=64)(lambda file, _changed, *rest: read_file(file, *rest))
    return functools.wraps(read_file)(lambda file, *rest: kept(file, os.stat(file).st_mtime_ns, *rest))


@by_date
def read(file, depth=0):
    """A preset with its bases below it."""
    document = parse(pathlib.Path(file).read_text(encoding="utf-8"))
    if document.get("base") and depth < DEEPEST:
        document = overlay(read(os.path.join(os.path.dirname(file), document["base"]), depth + 1), document)
    return document


def species(file):
    """What a preset says of its first organism, without where that stands."""
    found = copy.deepcopy(organisms(file, 1)[0])  # others of it may be of this species themselves
    for name in NEVER_OF_SPECIES[0]:
        found.pop(name, None)
    for name in NEVER_OF_SPECIES[1]:
        found.get("place", {}).pop(name, None)
    return found


@by_date
def organisms(file, most=None):
    """All that a preset says of each of its organisms, or the first of them: its own values over those of its species and of
    the defaults."""
    document, found = read(file), []
    for own in document.get("organisms", [])[:most]:
        if own.get("species"):
            try:
                own = overlay(species(os.path.join(os.path.dirname(file), own["species"])), own)
            except (OSError, ValueError, IndexError):
                pass  # the program tells what is wrong with it
        found.append(forced(document, overlay(document.get("defaults", {}), own)))
    return found


def forced(document, organism):
    """With the values of the defaults for all that `force` names."""
    organism = copy.deepcopy(organism)
    for path in document.get("force", []):
        *above, last = path.split("/")
        wanted, there = document.get("defaults", {}), organism
        for name in above:
            wanted, there = (node.get(name) if isinstance(node, dict) else None for node in (wanted, there))
        if isinstance(there, dict):
            there.pop(last, None)
            if isinstance(wanted, dict) and last in wanted:
                there[last] = wanted[last]
    return organism


@by_date
def names(file):
    """What each organism is called: its name, or its kind."""
    return [str(one.get("name") or one.get("kind") or f"organism {i + 1}") for i, one in enumerate(organisms(file))]


def left_out(file, only):
    """The numbers of organisms that are not named `only`, nor what those creep on."""
    found, called = organisms(file), names(file)
    kept, wanted = set(), {only}
    while wanted - kept:
        kept |= wanted
        wanted = {host for one, name in zip(found, called) if name in kept for host in one.get("on", [])}
    return [i for i, name in enumerate(called) if name not in kept] if only in called else []


def steps(pointer):
    return [step.replace("~1", "/").replace("~0", "~") for step in pointer.split("/")[1:]]


def value_at(document, pointer):
    """What stands at a pointer, None where nothing does."""
    for step in steps(pointer):
        if isinstance(document, dict):
            document = document.get(step)
        elif isinstance(document, list) and step.isdigit() and int(step) < len(document):
            document = document[int(step)]
        else:
            return None
    return document


def put(document, pointer, value):
    """Sets a value in plain data; objects on the way are made, elements of lists are there."""
    *above, last = steps(pointer)
    for step in above:
        if isinstance(document, list):
            document = document[int(step)]
        else:
            if not isinstance(document.get(step), (dict, list)):
                document[step] = {}
            document = document[step]
    document[int(last) if isinstance(document, list) else last] = value


@by_date
def changed_document(file, changes):
    """A preset with all that counts for its organisms, and with changes, JSON of values by pointer."""
    document = copy.deepcopy({**read(file), "organisms": organisms(file)})
    for pointer, value in json.loads(changes).items():
        try:
            put(document, pointer, value)
        except (IndexError, ValueError, TypeError):
            pass  # a place that the preset no longer has: the program tells
    return document


def export_words(program, file, out, changes, *, only="", frame=0, film=False, detail="", texture=512, instances=False):
    """The command that grows a preset, with changes by pointer."""
    words = [program, "export", file, "-o", out, "--texture", str(texture)]
    if film:
        words += ["--frames", f"1-{frame or read(file).get('film', {}).get('frames', 72)}"]
    else:
        words += ["--frame", str(frame)] if frame else []
        words += ["--instances"] if instances else []
    words += ["--detail", detail] if detail else []
    for pointer, value in {**changes, **{f"/organisms/{i}/count": 0 for i in left_out(file, only)}}.items():
        words += ["--set", f"{pointer}={json.dumps(value)}"]
    return words


def faults(text):
    """(pointer or "", message) of each line that the program said."""
    found = []
    for line in filter(None, map(str.strip, text.splitlines())):
        at = re.match(r"(?:\S.*? )??((?:/[\w~]+)+): (?:(/\S+): )?(.*)", line)
        found.append((at[2] or at[1], at[3]) if at else ("", line))
    return found
