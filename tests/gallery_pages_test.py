#!/usr/bin/env python3
"""The pages of scripts/gallery_pages.py: each is well-formed, and what it links and shows is there.

Usage: gallery_pages_test.py FROND ROOT
"""
import html.parser
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile
import urllib.parse

FROND, ROOT = os.path.abspath(sys.argv[1]), pathlib.Path(sys.argv[2]).resolve()
VOID = {"meta", "link", "img", "br", "hr", "input"}
# What a <p>, a heading, an <a> or a <span> may hold.
PHRASE = {"a", "code", "span", "strong", "em", "img", "br"}
HOLDS_PHRASES = {"p", "h1", "h2", "a", "span", "code", "strong", "pre", "figcaption", "title"}
KNOWN = VOID | PHRASE | HOLDS_PHRASES | {"html", "head", "body", "nav", "main", "section", "ul", "li", "figure", "div", "footer"}


class Page(html.parser.HTMLParser):
    def __init__(self, file):
        super().__init__(convert_charrefs=True)
        self.file, self.open, self.faults, self.links, self.ids, self.asked, self.commands = file, [], [], [], set(), set(), []
        self.feed(file.read_text())
        self.close()
        self.faults += [f"<{tag}> is not closed" for tag in self.open]
        self.faults += [f"no element has the id {name}" for name in self.asked - self.ids]

    def fault(self, what):
        self.faults.append(f"line {self.getpos()[0]}: {what}")

    def handle_decl(self, decl):
        if decl.lower() != "doctype html" or self.getpos() != (1, 0):
            self.fault(f"<!{decl}>")

    def handle_starttag(self, tag, attributes):
        names = [name for name, _ in attributes]
        given = dict(attributes)
        if tag not in KNOWN:
            self.fault(f"unknown element {tag}")
        if len(set(names)) < len(names):
            self.fault(f"an attribute of <{tag}> is there twice")
        if self.open and self.open[-1] in HOLDS_PHRASES and tag not in PHRASE:
            self.fault(f"<{tag}> in <{self.open[-1]}>")
        if tag == "a" and "a" in self.open:
            self.fault("a link in a link")
        if tag == "li" and self.open[-1] != "ul":
            self.fault("<li> outside of a list")
        if tag == "img" and not {"alt", "width", "height"} <= set(names):
            self.fault("a picture without alt, width or height")
        if "id" in given:
            if given["id"] in self.ids:
                self.fault(f"the id {given['id']} is there twice")
            self.ids.add(given["id"])
        if "aria-labelledby" in given:
            self.asked.add(given["aria-labelledby"])
        for name in ("href", "src"):
            if name in given:
                self.links.append(given[name])
        if tag not in VOID:
            self.open.append(tag)

    def handle_endtag(self, tag):
        if not self.open or self.open.pop() != tag:
            self.fault(f"</{tag}> closes nothing")

    def handle_data(self, data):
        if self.open and self.open[-1] == "code":
            self.commands.append(data)


def check(site, has_try):
    files = sorted(site.glob("*.html")) + sorted(site.glob("presets/*.html"))
    assert len(files) > 150, f"{len(files)} pages"
    reached = set()
    for file in files:
        page = Page(file)
        assert not page.faults, f"{file}: {page.faults[:5]}"
        links = [link for link in page.links if link != "data:,"]
        for link in links:
            target = (file.parent / urllib.parse.unquote(link)).resolve()
            assert target.is_relative_to(site) and target.is_file(), f"{file}: {link} is not there"
            reached.add(target)
        first = next(link for link in links if not link.endswith("style.css"))
        assert first.endswith("try/index.html") == has_try, f"{file}: the first link is {first}"
        for command in page.commands:
            words = shlex.split(command)
            assert words[:2] == ["frond", "render"] and (ROOT / "presets" / f"{words[2]}.json").is_file(), f"{file}: {command}"
    assert set(files) <= reached | {site / "index.html"}, "a page that none leads to"
    for picture in site.glob("pictures/*"):
        assert picture in reached, f"{picture} is on no page"


def shown(text, of):
    assert of in text, of


def main():
    script = [sys.executable, str(ROOT / "scripts/gallery_pages.py")]
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name).resolve()
        done = subprocess.run([*script, "site", "--try", "none"], cwd=folder, capture_output=True, text=True, check=True)
        assert done.stdout == "site/index.html\n" and "scripts/setup.sh --try builds it" in done.stderr, done
        check(folder / "site", False)
        (folder / "page").mkdir()
        (folder / "page/index.html").write_text("<!DOCTYPE html><title>page</title>")
        done = subprocess.run([*script, "site", "--try", "page"], cwd=folder, capture_output=True, text=True, check=True)
        assert done.stderr == "", done.stderr
        check(folder / "site", True)
        brain = (folder / "site/presets/species-corals-brain.html").read_text()
        shown(brain, '<span class="comment">// Pseudodiploria: a dome of long valleys')
        shown(brain, 'title="Distance from one ridge, or one cup, to the next (m)">"valley"</span>')
        oak = (folder / "site/presets/trees-oak.html").read_text()
        shown(oak, "<code>frond render trees/oak</code>")
        # A command of a picture is one that the program takes.
        command = next(c for c in Page(folder / "site/presets/trees-oak.html").commands if "--set" in c)
        words = shlex.split(command)
        sets = [word for i, word in enumerate(words) if "--set" in (word, words[i - 1])]
        subprocess.run([FROND, "check", words[2], *sets], env={**os.environ, "FROND_HOME": str(ROOT)}, check=True)
        # Nothing of others is taken away.
        (folder / "mine").mkdir()
        (folder / "mine/thesis.txt").write_text("words")
        done = subprocess.run([*script, "mine"], cwd=folder, capture_output=True, text=True)
        assert done.returncode == 1 and "holds something else" in done.stderr and (folder / "mine/thesis.txt").is_file()
    print("ok")


if __name__ == "__main__":
    main()
