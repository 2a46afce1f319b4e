#!/usr/bin/env python3
"""Runs the commands that README and docs show, small and without rendering.

  docs_test.py FROND ROOT pages             those of fenced blocks, page by page, in the order of the page; files that it shows are
                                            written first
  docs_test.py FROND ROOT lines [PAGE...]   all others, one by one

POV-Ray is a stand-in in what scripts/render.sh runs: what it makes of scenes is tested elsewhere. A command that installs,
builds, serves or needs other machines is not run: its script must know every option of it.
"""
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

FROND, ROOT, WHAT = pathlib.Path(sys.argv[1]).resolve(), pathlib.Path(sys.argv[2]).resolve(), sys.argv[3]
ONLY = sys.argv[4:]
NOT_RUN = ("scripts/setup.sh", "scripts/build.sh", "scripts/test.sh", "scripts/farm.sh", "scripts/blender_extension.sh", "scripts/gallery_pages.py",
           "scripts/package.sh", "cmake", "ninja", "git", "cd")
SMALL_TREES = ["--set", "/organisms/0/years=5"]


def environment(scratch):
    """A folder that looks like Frond's own, with a stand-in for POV-Ray."""
    for name in "scripts", "presets", "templates", "docs", "povinc", "bench":
        (scratch / name).symlink_to(ROOT / name)
    (scratch / "build").mkdir()
    (scratch / "build" / "frond").symlink_to(FROND)
    make = f'BATS_TEST_DIRNAME={ROOT}/tests/scripts BATS_FILE_TMPDIR=. BATS_TEST_TMPDIR=$PWD; ' \
           f'. {ROOT}/tests/scripts/common.bash; make_fake_povray'
    subprocess.run(["bash", "-c", make], cwd=scratch, check=True)
    return {**os.environ, "FROND_HOME": str(ROOT), "FROND_BIN": str(FROND), "FROND_UNCONFINED": "1", "NO_COLOR": "1",
            "FROND_POVRAY": str(scratch / "fake-povray"), "RENDERED": str(scratch / "rendered"),
            "XDG_CACHE_HOME": str(scratch / "cache"), "PATH": f"{scratch}/build:{os.environ['PATH']}"}


def known(words):
    """A command that is not run: its script and its options are there."""
    script = ROOT / words[0]
    if not words[0].startswith("scripts/"):
        return
    text = script.read_text()
    if called := re.search(r"^call_frond (\w+)", text, re.M):  # it has the options of that
        text = subprocess.run([FROND, called[1], "--help"], text=True, stdout=subprocess.PIPE, check=True).stdout
    for word in words[1:]:
        if word.startswith("--"):
            assert word.split("=")[0] in text, f"{words[0]} knows no {word}"


def small(words):
    """The same command with less to do."""
    script = words[0].endswith("render.sh")
    if "presets/trees/" in " ".join(words) and "textures" not in words:
        words = words + SMALL_TREES
    if "bench/forest.json" in words:
        return ["frond", "check", "bench/forest.json"]
    if words[1] == "export":  # of the corals that grow together, few stand for all
        words = ["presets/thicket.json" if w == "presets/reef.json" else w for w in words]
    if not script or "--compare" in words:
        return [re.sub(r"^1-96$", "1-2", w) for w in words]
    for i, word in enumerate(words):
        if word in ("--size", "--scale"):
            words = words[:i] + words[i + 2:]
            break
    words = [re.sub(r"frames=\d+$", "frames=2", re.sub(r"^(/\S+:\S+):\d+$", r"\1:2", w)) for w in words]
    if "--contact-seeds" in words:
        words[words.index("--contact-seeds") + 1] = "2"
    words += ["--size", "32x24", "--jobs", "1"]
    reef = next((word for word in words if word in ("presets/reef.json", "presets/thicket.json")), None)
    if reef:  # one coral of it stands for all
        words[words.index(reef)] = "tests/presets/staghorn.json"
        words += ["--set", "/film/frames=96"] + ([] if "-o" in words else ["-o", "out/reef"])
    sheet = any(w.startswith(("--contact", "--sweep")) for w in words)
    film = any(w.endswith("frames=2") for w in words)
    return words if sheet or film or "--frames" in words or "--why" in words else words + ["--frames", "1-1"]


def run(command, folder, env):
    for part in command.split("&&"):
        words = shlex.split(part, comments=True)
        if not words or words[0] == "export":
            continue
        if words[0] in NOT_RUN or "studio" in words or words[1:] == ["try"] or "..." in part:
            known(words)
            continue
        words = small(words)
        if words[0] == "build/frond":
            words[0] = "frond"
        done = subprocess.run(words, cwd=folder, env=env, text=True, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
        assert done.returncode == 0, f"{command}\n{shlex.join(words)}\nended with {done.returncode}:\n{done.stdout[-1500:]}"
        print("ok", command, flush=True)


def check_page(page):
    with tempfile.TemporaryDirectory() as name:
        scratch = pathlib.Path(name)
        env = environment(scratch)
        for kind, file, body in re.findall(r"^```(\w+) ?(\S*)\n(.*?)^```$", page.read_text(), re.M | re.S):
            if file:
                (scratch / file).write_text(body)
            elif kind == "sh":
                for line in body.splitlines():
                    run(line, scratch, env)


def check_lines():
    starts = re.compile(r"^    +((?:scripts/|build/frond |frond |ninja |cmake ).*)$")
    with tempfile.TemporaryDirectory() as name:
        scratch = pathlib.Path(name)
        env = environment(scratch)
        (scratch / "tree.json").write_text('{"axiom": "A", "steps": 3, "angle": 30, "rules": ["A -> F[+A]F[-A]A"]}')
        (scratch / "curves.l").write_text("Koch { Angle 6\n Axiom F--F--F\n F=F+F--F+F\n}\nOdd { Angle 5\n Axiom F\n F=F|F\n}\n")
        (scratch / "vine.swc").write_text("1 3 0 0 0 0.05 -1\n2 3 0 0.5 0.1 0.04 1\n3 3 0.2 0.5 0.8 0.02 2\n")
        (scratch / "scan.swc").write_text("1 3 0 0 0 0.05 -1\n2 3 0 0.1 0.5 0.04 1\n3 3 0.2 0.3 0.9 0.02 2\n")
        (scratch / "plant.l").write_text("Lsystem: 1\nderivation length: 3\nAxiom: A\nA --> F[+A]A\nendlsystem\n")
        for page in [ROOT / "README.md", ROOT / "CONTRIBUTING.md", *sorted((ROOT / "docs").rglob("*.md"))]:
            if ONLY and page.stem not in ONLY:
                continue
            for line in re.sub(r"^```.*?^```$", "", page.read_text(), flags=re.M | re.S).splitlines():
                if not (found := starts.match(line)):
                    continue
                command = re.sub(r"\s{3,}[^-\s].*$", "", found[1])
                if "compare" in command:
                    command = command.replace("out/reef-8", "out/reef")
                run(command, scratch, env)


try:
    if WHAT == "pages":
        for page in "start", "recipes":
            check_page(ROOT / "docs" / f"{page}.md")
    else:
        check_lines()
except AssertionError as fault:
    sys.exit(str(fault))
