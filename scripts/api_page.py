"""docs/library.md: the public header as a page."""
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
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
