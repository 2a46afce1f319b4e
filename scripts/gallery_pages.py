#!/usr/bin/env python3
"""Usage: scripts/gallery_pages.py [--try DIR] [DIR]

Writes a page for each preset of docs/gallery/pictures.txt, with its pictures, the command that renders each, and the preset
with its comments, and a page of all of them: plain HTML in DIR (build/site) that opens from the disk or from any web server.
The page of `frond try` is its first link: DIR of --try (build/try/page) is copied; where it is not there, a note says so.
"""
import argparse
import html
import json
import os
import pathlib
import re
import shlex
import shutil
import struct
import sys
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent
GALLERY = ROOT / "docs/gallery"
# Sections of the index, by the beginning of a preset's name; what none of them begins is of the first.
SECTIONS = [("", "Corals, trees and other films"), ("species/corals/", "Corals"), ("reef/", "In the reef"), ("species/fishes/", "Fishes"),
            ("species/reef_animals/", "Animals of the reef"), ("species/shells/", "Shells"),
            ("trees/", "Trees"), ("forest/", "Forests"), ("garden/", "Gardens"), ("ivy/", "Ivy"), ("photographs/", "After photographs"),
            ("lsystems/", "Grammars of books and other programs"), ("asking/", "Grammars that ask the world")]


class Shown(NamedTuple):
    """A preset as a picture shows it: which picture, and where in it that is if the picture is a sheet."""
    picture: str
    size: tuple
    columns: int
    place: int
    parts: int
    frame: int
    sets: list


def pictures():
    """All that is shown of each preset, in the order of the list."""
    shown = {}
    for line in (GALLERY / "pictures.txt").read_text().splitlines():
        words = line.split()
        if not words or words[0].startswith("#") or words[0] == "large:":
            continue
        name, size, columns, *parts = words
        for place, part in enumerate(parts):
            preset, *sets = part.split(",/")
            preset, _, frame = preset.partition("@")
            shown.setdefault(preset, []).append(Shown(name, tuple(map(int, size.split("x"))), int(columns), place, len(parts), int(frame or 1),
                                                      ["/" + s for s in sets]))
    return shown


def jpeg_size(file):
    data, at = file.read_bytes(), 2
    while at < len(data):
        marker, length = data[at + 1], struct.unpack(">H", data[at + 2:at + 4])[0]
        if 0xC0 <= marker <= 0xCF and marker not in (0xC4, 0xC8, 0xCC):
            high, wide = struct.unpack(">HH", data[at + 5:at + 9])
            return wide, high
        at += 2 + length
    raise SystemExit(f"{file}: no size in this picture")


def plain(text):
    """JSON without its comments, each as long as it was."""
    blank = lambda m: m[0] if m[0].startswith('"') else re.sub(r"[^\n]", " ", m[0])
    return re.sub(r'"(?:[^"\\]|\\.)*"|//[^\n]*|/\*.*?\*/', blank, text, flags=re.S)


# What the schema says of a property


class Descriptions:
    def __init__(self):
        self.schema = json.loads((ROOT / "docs/preset.schema.json").read_text())
        organisms = self.schema["properties"]["organisms"]["items"]
        self.common = organisms["properties"]
        self.kinds = {rule["if"]["properties"]["kind"]["const"]: rule["then"]["properties"] for rule in organisms["allOf"]}

    def below(self, schema, step):
        """The schema of a member or an item; empty where it is not known."""
        for option in [schema, *schema.get("anyOf", [])]:
            if isinstance(step, int) and isinstance(option.get("items"), dict):
                return option["items"]
            if step in option.get("properties", {}):
                return option["properties"][step]
        return {}

    def of(self, path, kinds):
        if path[0] == "organisms" and len(path) > 2:
            own = self.kinds.get(kinds[path[1]] if path[1] < len(kinds) else "", {})
            schema = {"properties": {**self.common, **{name: inner for name, inner in own.items() if inner is not True}}}
            path = path[2:]
        else:
            schema = self.schema
        for step in path:
            schema = self.below(schema, step)
        return schema.get("description", "")


def kind_of(entry, folder, depth=0):
    if "kind" in entry or "species" not in entry or depth > 8:
        return entry.get("kind", "")
    file = folder / entry["species"]
    preset = json.loads(plain(file.read_text())) if file.is_file() else {}
    first = (preset.get("organisms") or [{}])[0]
    return kind_of(first, file.parent, depth + 1)


TOKENS = re.compile(r'(?P<comment>//[^\n]*|/\*.*?\*/)|(?P<text>"(?:[^"\\]|\\.)*")|(?P<number>-?\d[\d.eE+-]*|true|false|null)|(?P<sign>[\[\]{},:])|\s+|.', re.S)


def colored(text, descriptions, kinds):
    """The text as HTML: comments, names with what they are for, values."""
    out, stack, name_next = [], [], False  # of the stack: [step, is an object]

    def span(kind, word, title=""):
        tip = f' title="{html.escape(title)}"' if title else ""
        out.append(f'<span class="{kind}"{tip}>{html.escape(word, quote=False)}</span>')

    for token in TOKENS.finditer(text):
        word, kind = token[0], token.lastgroup
        if kind == "sign":
            if word in "[{":
                stack.append([None if word == "{" else 0, word == "{"])
            elif word in "]}" and stack:
                stack.pop()
            elif word == "," and stack and not stack[-1][1]:
                stack[-1][0] += 1
            name_next = bool(stack) and stack[-1][1] and word in "{,"
            out.append(word)
        elif kind == "text" and name_next:
            stack[-1][0], name_next = json.loads(word), False
            span("name", word, descriptions.of([step for step, _ in stack], kinds))
        elif kind in ("comment", "text", "number"):
            span(kind, word)
        else:
            out.append(html.escape(word, quote=False))
    return "".join(out)


# Pages


def page(title, body, up=""):
    return f"""<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{html.escape(title)}</title>
<link rel="icon" href="data:,">
<link rel="stylesheet" href="{up}style.css">
</head>
<body>
{body}
</body>
</html>
"""


def bar(has_try, up=""):
    first = f'<a class="try" href="{up}try/index.html">Try it in the browser</a>\n' if has_try else ""
    home = f'<a href="{up}index.html">All presets</a>\n' if up else ""
    return f'<nav aria-label="Site">\n<strong>Frond</strong>\n{first}{home}</nav>'


def tile(shown, up, alt):
    """A picture, or what a sheet shows of this preset."""
    source = f"{up}pictures/{shown.picture}.jpg"
    wide, high = jpeg_size(GALLERY / f"{shown.picture}.jpg")
    if shown.parts == 1:
        return f'<img src="{source}" width="{wide}" height="{high}" alt="{html.escape(alt)}" loading="lazy">'
    rows = -(-shown.parts // shown.columns)
    x, y = shown.place % shown.columns, shown.place // shown.columns
    # Between the pictures of a sheet there are gaps.
    part = [shown.size[0], shown.size[1]]
    gaps = [(wide - part[0] * shown.columns) / max(1, shown.columns - 1), (high - part[1] * rows) / max(1, rows - 1)]
    left, top = x * (part[0] + gaps[0]), y * (part[1] + gaps[1])
    # Of a card, which is wider or higher than 4 to 3, as much as fills it.
    cover = max(100, 75 * part[0] / part[1])
    style = f"aspect-ratio: {part[0]} / {part[1]}; --own: {part[0]}px; --cover: {cover:.2f}%; --width: {100 * wide / part[0]:.2f}%; --left: {-100 * left / part[0]:.2f}%; --top: {-100 * top / part[1]:.2f}%"
    return f'<span class="part" style="{style}"><img src="{source}" width="{wide}" height="{high}" alt="{html.escape(alt)}" loading="lazy"></span>'


def command(preset, read, shown):
    still = read.get("film", {}).get("frames") == 1
    words = ["frond", "render", preset, *([] if still else ["--frames", f"{shown.frame}-{shown.frame}"]), "--size", f"{shown.size[0]}x{shown.size[1]}"]
    for setting in shown.sets:
        words += ["--set", setting]
    return shlex.join(words)


def file_of(preset):
    return preset.replace("/", "-") + ".html"


def title_of(preset, read):
    return read.get("title") or preset.rsplit("/", 1)[-1].replace("_", " ")


def preset_page(preset, text, read, all_shown, neighbours, descriptions, has_try):
    title = title_of(preset, read)
    kinds = [kind_of(entry, (ROOT / "presets" / preset).parent) for entry in read.get("organisms", [])]
    figures = []
    for i, shown in enumerate(all_shown):
        more = f"<figcaption><code>{html.escape(command(preset, read, shown), quote=False)}</code></figcaption>"
        figures.append(f'<figure>\n{tile(shown, "../", f"{title}, picture {i + 1}" if i else title)}\n{more}\n</figure>')
    before, after = neighbours
    links = [f'<a href="{file_of(other)}" rel="{rel}">{html.escape(name)}</a>' for other, name, rel in
             ((before and before[0], before and before[1], "prev"), (after and after[0], after and after[1], "next")) if other]
    body = f"""{bar(has_try, "../")}
<main class="preset">
<h1>{html.escape(title)}</h1>
<p class="run">All of it: <code>frond render {preset}</code></p>
<div class="figures">
{chr(10).join(figures)}
</div>
<section aria-labelledby="text">
<h2 id="text">The preset</h2>
<p class="hint"><a href="../presets/{preset}.json" download>{preset}.json</a>. A name tells under the pointer what it is for.</p>
<pre tabindex="0" aria-label="The preset">{colored(text.rstrip(), descriptions, kinds)}</pre>
</section>
<footer>{" ".join(links)}</footer>
</main>"""
    return page(f"{title} · Frond", body, "../")


def best(all_shown):
    """What stands for a preset: a picture of its own, as it is, late in its film."""
    return min(all_shown, key=lambda one: (one.parts > 1, bool(one.sets), -one.frame))


def section_of(preset):
    return next((i for i, (beginning, _) in reversed(list(enumerate(SECTIONS))) if preset.startswith(beginning) and beginning), 0)


def index_page(listed, has_try):
    parts = []
    for i, (_, heading) in enumerate(SECTIONS):
        cards = [f'<li><a href="presets/{file_of(preset)}"><span class="frame">{tile(best(shown), "", "")}</span><span>{html.escape(title_of(preset, read))}</span></a></li>'
                 for preset, _, read, shown in listed if section_of(preset) == i]
        if cards:
            parts.append(f'<section aria-labelledby="section-{i}">\n<h2 id="section-{i}">{heading}</h2>\n<ul class="cards">\n{chr(10).join(cards)}\n</ul>\n</section>')
    body = f"""{bar(has_try)}
<main>
<h1>Plants and corals, grown from presets</h1>
<p class="hint">Each picture is rendered from the preset on its page by one command.</p>
{chr(10).join(parts)}
</main>"""
    return page("Frond: gallery", body)


def write(out, try_page):
    shown = pictures()
    listed = []
    for preset, all_shown in shown.items():
        text = (ROOT / "presets" / f"{preset}.json").read_text()
        # Its own pictures first, as the preset is, and not those of a sheet.
        listed.append((preset, text, json.loads(plain(text)), sorted(all_shown, key=lambda one: (one.parts > 1, bool(one.sets)))))
    listed.sort(key=lambda row: section_of(row[0]))
    shutil.rmtree(out, ignore_errors=True)
    for folder in ("pictures", "presets"):
        (out / folder).mkdir(parents=True)
    has_try = (try_page / "index.html").is_file()
    if has_try:
        shutil.copytree(try_page, out / "try")
    else:
        print(f"note: {try_page} holds no page to try things on, so none is linked; scripts/setup.sh --try builds it", file=sys.stderr)
    shutil.copyfile(GALLERY / "pages.css", out / "style.css")
    for name in {one.picture for all_shown in shown.values() for one in all_shown}:
        shutil.copyfile(GALLERY / f"{name}.jpg", out / "pictures" / f"{name}.jpg")
    descriptions = Descriptions()
    for i, (preset, text, read, all_shown) in enumerate(listed):
        file = out / "presets" / f"{preset}.json"
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)
        near = [(listed[k][0], title_of(listed[k][0], listed[k][2])) if 0 <= k < len(listed) else None for k in (i - 1, i + 1)]
        (out / "presets" / file_of(preset)).write_text(preset_page(preset, text, read, all_shown, near, descriptions, has_try))
    (out / "index.html").write_text(index_page(listed, has_try))
    print(os.path.relpath(out / "index.html"))


def main():
    options = argparse.ArgumentParser(usage=__doc__.split("\n", 1)[0].removeprefix("Usage: "), description=__doc__.split("\n", 2)[2],
                                      formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("dir", nargs="?", type=pathlib.Path, default=ROOT / "build/site", help=argparse.SUPPRESS)
    options.add_argument("--try", dest="try_page", type=pathlib.Path, default=ROOT / "build/try/page", help=argparse.SUPPRESS)
    arguments = options.parse_args()
    out = arguments.dir.resolve()
    # What is there is taken away: only a folder that this has made.
    if out.exists() and any(out.iterdir()) and not (out / "pictures").is_dir():
        raise SystemExit(f"error: {arguments.dir} holds something else; expected a new folder")
    write(out, arguments.try_page)


if __name__ == "__main__":
    main()
