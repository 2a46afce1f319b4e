#!/usr/bin/env python3
"""How heavy the sources are: the figures that are to fall, or at least not to rise, as Frond does more.

Usage: bench/house.py [--compile] [--compile-tests] [ROOT]

  --compile        also builds the program in a new folder, without the compiler cache, and says how many seconds of
                   processor that takes: some minutes
  --compile-tests  the same of the program and all tests

Lines are counted as they stand, blank ones and comments too. A function is counted from its first line to the brace
that closes it; those within a class or another function count as part of it. What a source parses is found by the
includes of our own files; how many compiles that makes, many of which are of several sources, is what the compiler
noted in build/, if that is there.
"""

import argparse
import functools
import os
import re
import resource
import subprocess
import tempfile
from pathlib import Path

LONG = 60  # lines of a function from which on it is named
LOOK = re.compile(r"\b(?:look|branches)\.(?:skin|bark|coat)\b")
# What paints in C++ what a macro of povinc/ draws for POV-Ray.
MIRRORS = ["matter_tile", "tile", "look", "palette", "pattern", "materials"]


def lines(paths):
    return sum(path.read_text(encoding="utf-8").count("\n") for path in paths)


def functions(text):
    """Name and length of each function that begins at the left margin."""
    found, begin, name = [], None, ""
    for number, line in enumerate(text.splitlines()):
        if begin is None and re.match(r"[A-Za-z_].*\(", line) and not line.startswith(("namespace", "using", "static_assert", "TEST")):
            begin, name = number, re.search(r"([\w:~]+)\(", line)
        if begin == number and line.endswith((";", "}")):
            begin = None  # a declaration, or a function of one line
        if begin is not None and line.startswith("}"):
            found.append((name[1] if name else "", number - begin + 1))
            begin = None
    return found


def parsed_by(root, sources, header):
    """The sources that parse a header ("preset/reader.h"), through others or not."""
    place = {"/".join(p.relative_to(root / "gen").parts[1:]): p for p in sources if p.suffix == ".h"}
    included = {p: re.findall(r'^#include "([^"]+)"', p.read_text(encoding="utf-8"), re.M) for p in sources}

    @functools.cache
    def parses(path):
        return any(name == header or (name in place and parses(place[name])) for name in included[path])

    return [p for p in sources if p.suffix == ".cpp" and parses(p)]


def compiles_that_parse(build, header):
    """How many compiles of the program parse a header, of how many, by what ninja has noted of them."""
    if not (build / "build.ninja").exists():
        return None
    # Of each compile a line "object: #deps 3, ..." and then, indented, a line for each file.
    noted = re.split(r"\n(?=\S)", subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True).stdout)
    ours = [one for one in noted if one.strip().startswith("gen/")]
    return sum(re.search(rf"\s\S*/{re.escape(header)}$", one, re.M) is not None for one in ours), len(ours)


def virtual_functions(text, name):
    """How many virtual functions a class declares, besides its destructor."""
    body = re.search(rf"^class {name} .*?^}};", text, re.M | re.S)
    return len(re.findall(r"^  virtual (?!~)", body[0], re.M)) if body else 0


def seconds_to_compile(root, targets):
    """Seconds of processor to build targets from nothing."""
    environment = dict(os.environ, CCACHE_DISABLE="1")
    with tempfile.TemporaryDirectory() as build:
        tests = f"-DFROND_TESTS={'OFF' if targets == ['frond'] else 'ON'}"
        subprocess.run(["cmake", "--preset", "release", "-B", build, tests], cwd=root, env=environment, check=True, capture_output=True)
        before = resource.getrusage(resource.RUSAGE_CHILDREN)
        subprocess.run(["ninja", "-C", build, *targets], env=environment, check=True, capture_output=True)
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    arguments = argparse.ArgumentParser(usage=__doc__)
    arguments.add_argument("--compile", action="store_true")
    arguments.add_argument("--compile-tests", action="store_true")
    arguments.add_argument("root", nargs="?", type=Path, default=Path(__file__).resolve().parent.parent)
    given = arguments.parse_args()
    root = given.root
    sources = [p for p in sorted((root / "gen").rglob("*")) if p.suffix in (".cpp", ".h") and "page" not in p.parts]
    texts = {p: p.read_text(encoding="utf-8") for p in sources}
    uses = {p: len([line for line in text.splitlines() if LOOK.search(line)]) for p, text in texts.items()}
    long = [(n, f"{p.relative_to(root)}: {name}") for p, text in texts.items() for name, n in functions(text) if n > LONG]
    mirrors = [p for p in sources if p.parent.name == "export" and p.stem in MIRRORS]
    scripts = [p for p in sorted((root / "scripts").iterdir()) if p.is_file()]
    rows = [
        ("lines with look.skin, look.bark, look.coat", f"{sum(uses.values())} in {sum(n > 0 for n in uses.values())} files"),
        ("C++ that mirrors macros", lines(mirrors)),
        ("gen/output/emit", lines(p for p in sources if p.parent.name == "emit")),
        ("scripts/", lines(scripts)),
        (f"functions over {LONG} lines", len(long)),
        ("lines of C++ in gen/", lines(sources)),
        ("folders directly in gen/", sum(p.is_dir() for p in (root / "gen").iterdir())),
        ("groups", len(re.findall(r"^gen_group\(", (root / "gen/CMakeLists.txt").read_text(), re.M))),
        ("sources that parse preset/reader.h", len(parsed_by(root, sources, "preset/reader.h"))),
        ("virtual functions of Grower", virtual_functions(texts[root / "gen/scene/organisms/grower.h"], "Grower")),
    ]
    if compiles := compiles_that_parse(root / "build", "preset/reader.h"):
        rows.append(("compiles that parse it, by build/", f"{compiles[0]} of {compiles[1]}"))
    if given.compile:
        rows.append(("seconds of processor for the program", round(seconds_to_compile(root, ["frond"]))))
    if given.compile_tests:
        rows.append(("seconds of processor with all tests", round(seconds_to_compile(root, ["all"]))))
    for what, figure in rows:
        print(f"{what:42} {figure}")
    for length, where in sorted(long, reverse=True):
        print(f"  {length:4} lines  {where}")


if __name__ == "__main__":
    main()
