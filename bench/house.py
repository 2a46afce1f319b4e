#!/usr/bin/env python3
"""How heavy the sources are: the figures that are to fall, or at least not to rise, as Frond does more.

Usage: bench/house.py [ROOT]

Lines are counted as they stand, blank ones and comments too. A function is counted from its first line to the brace
that closes it; those within a class or another function count as part of it.
"""

import re
import sys
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


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parent.parent)
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
        ("gen/ without the page", lines(sources)),
    ]
    for what, figure in rows:
        print(f"{what:42} {figure}")
    for length, where in sorted(long, reverse=True):
        print(f"  {length:4} lines  {where}")


if __name__ == "__main__":
    main()
