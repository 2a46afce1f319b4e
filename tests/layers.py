#!/usr/bin/env python3
"""Holds gen/ to the layers of gen/CMakeLists.txt and to what is banned there.

    tests/layers.py [ROOT]

Prints one line a fault; exit code 1 where there is one.
"""
import pathlib
import re
import sys

MAX_LINES = 400

# What stands on top of all modules: the command line, and the module for Python.
PROGRAMS = ("cli", "python")

# A kind of organism is a folder of its own below this module; nobody outside knows its parameters.
KINDS = "organisms"

# What only some files may include: header -> who may.
RESERVED = {
    "nlohmann/": lambda path: path.parent.name == "studio" or (path.parent.name, path.name) == ("geometry", "glb.cpp"),
    "httplib.h": lambda path: path.parent.name == "studio" and path.stem in ("server", "connections", "wire"),
    "tbb/": lambda path: path.parent.name == "core" and path.name == "parallel.cpp",
    "oneapi/tbb": lambda path: path.parent.name == "core" and path.name == "parallel.cpp",
    "meshoptimizer.h": lambda path: path.parent.name == "geometry" and path.name == "far.cpp",
    "embree3/": lambda path: (path.parent.name, path.name) == ("creeping", "triangle_surface.cpp") or path.parent.name == "passes",
    "openvdb/": lambda path: path.parent.name == "field" and path.suffix == ".cpp",
    "OpenEXR/": lambda path: (path.parent.name, path.name) == ("images", "exr.cpp"),
    "Imath/": lambda path: (path.parent.name, path.name) == ("images", "exr.cpp"),
    "CLI/": lambda path: path.parent.name == "cli",
    "pybind11/": lambda path: path.parent.name == "python",
}

BANNED = {
    r"(?<![\w.>:])(?:std::)?s?rand\s*\(": "rand(): randomness comes from a Seed",
    r"\brandom_device\b": "random_device: randomness comes from a Seed",
    r"\bstd::(?:mt19937\w*|default_random_engine)\b": "an engine of std: randomness comes from a Seed",
    r"\bstd::\w+_distribution\b": "a distribution of std differs from one library to the next: Seed has its own",
    r"\b(?:system|steady|high_resolution)_clock\b": "a clock: the same input must give the same output",
    r"(?<![\w.>:])(?:std::)?(?:time|clock)\s*\(\s*(?:NULL|nullptr|0|&\w+)?\s*\)": "a clock: the same input must give the same output",
    r"\bunordered_(?:multi)?(?:map|set)\b": "an unordered container: its order differs from one library to the next",
}
# These tell people how long something takes; nothing that they make depends on it.
MAY_BREAK = {module: {r"\b(?:system|steady|high_resolution)_clock\b"} for module in ("studio", "cli", "pipeline")}
# Looked for in comments, too.
LEFT_BEHIND = {r"\b(?:TODO|FIXME|XXX)\b": "left behind: do it"}


def read_modules(text):
    """name -> its group, and name -> what it may include, itself among them: the DEPENDS of gen_module(), which stand
    above it, so that neither modules nor groups go in a circle.
    What a header brings along is held to that too, since each file on the way is."""
    groups, direct, group = {}, {}, None
    for call in re.finditer(r"^gen_(group|module)\(\s*(\w+)([^)]*)\)", text, re.MULTILINE):
        name = call.group(2)
        if call.group(1) == "group":
            group = name
            continue
        depends = re.search(r"DEPENDS((?:\s+[a-z_]+)+)", call.group(3))
        groups[name], direct[name] = group, depends.group(1).split() if depends else []

    def reach(name):
        return {name}.union(*map(reach, direct[name]))

    for name in direct:
        for below in direct[name]:
            if below not in direct or list(direct).index(below) >= list(direct).index(name):
                sys.exit(f"gen/CMakeLists.txt: {name} depends on {below}, which does not stand above it")
    return groups, {name: reach(name) for name in direct}


def without_comments(text):
    """The text with comments and string contents blanked, its lines kept."""
    def blank(match):
        found = match.group(0)
        return re.sub(r"[^\n]", " ", found) if found[0] == "/" else '""' + "\n" * found.count("\n")

    raw = r'R"([^(\s]*)\((?:.|\n)*?\)\1"'
    return re.sub(raw + r"|//[^\n]*|/\*(?:.|\n)*?\*/|\"(?:\\.|[^\"\\\n])*\"", blank, text)


def line_of(text, position):
    return text.count("\n", 0, position) + 1


def check_kind(path, shown, text):
    """A kind includes no other kind, and what stands outside includes none and names no parameters of one."""
    kind = shown.parts[3] if len(shown.parts) == 5 else None
    for include in re.finditer(rf'^\s*#\s*include\s*"{KINDS}/(\w+)/', text, re.MULTILINE):
        if include.group(1) != kind:
            yield f"{shown}:{line_of(text, include.start(1))}: the kind {include.group(1)} is known in its own folder only"
    if kind is None:
        for name in re.finditer(r"\b(?!WebP)[A-Z]\w*Params\b", without_comments(text)):  # libwebp has such names, too
            yield f"{shown}:{line_of(text, name.start())}: {name.group(0)} is known to its kind only"


def check_file(path, shown, modules):
    text = path.read_text(encoding="utf-8")
    module = shown.parts[2]
    yield from check_kind(path, shown, text)
    lines = text.count("\n")
    if lines > MAX_LINES:
        yield f"{shown}: {lines} lines; a file has at most {MAX_LINES}"
    for include in re.finditer(r'^\s*#\s*include\s*(["<])([^">]+)[">]', text, re.MULTILINE):
        where = f"{shown}:{line_of(text, include.start(2))}"
        name = include.group(2)
        for reserved, allowed in RESERVED.items():
            if name.startswith(reserved) and not allowed(path):
                yield f"{where}: <{name}> is not for this file"
        if include.group(1) == "<":
            continue
        target = name.split("/")[0]
        if "/" not in name or target not in modules and target not in PROGRAMS:
            yield f'{where}: "{name}" is not in a module; project headers are named "module/file.h"'
        elif module not in PROGRAMS and target not in modules.get(module, ()):
            yield f"{where}: {module} must not include {target}; see gen/CMakeLists.txt"
    for table, searched in ((BANNED, without_comments(text)), (LEFT_BEHIND, text)):
        for pattern, why in table.items():
            if pattern in MAY_BREAK.get(module, ()):
                continue
            for found in re.finditer(pattern, searched):
                yield f"{shown}:{line_of(searched, found.start())}: {found.group(0).strip()}: {why}"


def types_of(text):
    """The types that a file defines straight in a named namespace: two of one name are undefined behaviour."""
    inside, coming = [], None
    pattern = (r"[{};]|\bnamespace\b\s*(?P<space>[\w:]*)\s*(?=\{)|\b(?:struct|class|enum class|enum|union)\s+"
               r"(?P<type>\w+)(?!\w|\s*::)(?:\s+final)?\s*(?::[^;{]*)?(?=\{)")
    for found in re.finditer(pattern, without_comments(text)):
        token = found.group(0)
        if token == "{":
            inside.append(coming)
            coming = None
        elif token == "}":
            inside = inside[:-1]
        elif found.group("space") is not None:
            coming = "named" if found.group("space") else "anonymous"
        elif found.group("type"):
            if all(around == "named" for around in inside):
                yield found.group("type")
            coming = "type"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[1]).resolve()
    groups, modules = read_modules((root / "gen/CMakeLists.txt").read_text(encoding="utf-8"))
    if not modules:
        sys.exit("gen/CMakeLists.txt: no gen_module() found")
    faults, files, defined = [], 0, {}
    for path in sorted(root.glob("gen/**/*")):
        if path.suffix not in (".h", ".cpp"):
            continue
        files += 1
        shown = path.relative_to(root)
        if len(shown.parts) < 4 or len(shown.parts) > (5 if shown.parts[2] == KINDS else 4):
            faults.append(f"{shown}: gen/ has three levels, gen/<group>/<module>/<file>, and {KINDS} a fourth, its kinds")
            continue
        group, module = shown.parts[1:3]
        if groups.get(module, "apps" if module in PROGRAMS else None) != group:
            faults.append(f"{shown}: {module} is no module of {group} in gen/CMakeLists.txt")
        faults.extend(check_file(path, shown, modules))
        if module == "frond":  # its types stand in a namespace of their own
            continue
        for name in types_of(path.read_text(encoding="utf-8")):
            if defined.setdefault(name, shown) != shown:
                faults.append(f"{shown}: {name} is a type of {defined[name]} already: one of them wants another name")
    print("\n".join(faults) if faults else f"{files} files in {len(modules)} modules and {len(set(groups.values()))} groups keep to the layers")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
