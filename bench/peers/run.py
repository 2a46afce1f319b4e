#!/usr/bin/env python3
"""Frond beside other programs that grow plants: the same jobs, on the same machine, in one run.

Usage: bench/peers/run.py [--help] [--self-test] [--out DIR] [--tools DIR] [--repeats N] [--limit SECONDS] [--quick] [--only JOB...]

Installs what Debian and npm have of Frond's peers, gives them and Frond the same jobs by turns, and writes DIR/peers.md and
DIR/peers.json (out/peers): medians of seconds, of processor time, of memory and of what is written. Packages are unpacked into a
temporary folder, or into --tools, which stays; only Blender is installed, by apt, where it is missing and this runs as root.
What cannot be had is named and left out.

  --repeats N      how often each is run (3)
  --limit SECONDS  of processor that a run may take (120), and four times as many by the clock
  --quick          only the smallest size of each job
  --only JOB...    of: derive, stochastic, context, draw, tree, ivy
  --self-test      Frond alone at the smallest sizes, and the sums of the table; installs nothing and takes seconds

FROND_BIN is the program that is measured (build/frond).
"""

import argparse
import hashlib
import json
import math
import os
import platform
import re
import resource
import shutil
import signal
import statistics
import struct
import subprocess
import sys
import tempfile
import threading
import time
from pathlib import Path

HERE = Path(__file__).resolve().parent
ROOT = HERE.parent.parent
FROND = os.environ.get("FROND_BIN", str(ROOT / "build" / "frond"))
HOME = {"FROND_HOME": os.environ.get("FROND_HOME", str(ROOT))}
UNPACKED = ["inkscape", "python3-cssselect", "python3-lxml", "python3-tinycss2", "python3-webencodings", "contextfree", "libagg2"]
FROM_NPM = ["lindenmayer@1.5.4", "@dgreenheck/ez-tree@1.1.0", "three@0.187.0"]

# Fibonacci's words, three ways: where A and B stand differs by chance in the second, lengths never do.
WORDS = {
    "derive": (["A -> AB", "B -> A"], {"A": "AB", "B": "A"}),
    "stochastic": (["A ->(0.5) AB", "A ->(0.5) BA", "B -> A"],
                   {"A": {"successors": [{"weight": 0.5, "successor": s} for s in ("AB", "BA")]}, "B": "A"}),
    "context": (["A -> AB", "A < B -> A"], {"A": "AB", "A<B": "A"}),
}
STEPS, ORDERS = [19, 24, 28, 33], [6, 7, 8, 9]
# Levels, shoots on a twig, Frond's leaves on a stem and nodes on a segment, so that both trees have about as many of all.
TREES = [(2, 10, 17, 5), (3, 10, 11, 4), (4, 25, 7, 2)]
FACTORS = [1, 2.3, 5]
# Metres for IvyGen; for Frond roots, steps and as many triangles as IvyGen makes.
IVIES = [(1, 1, 125, 57_000), (2.4, 1, 400, 440_000), (6.5, 18, 400, 5_400_000)]

TITLES = {
    "derive": "Words of an L-system, A → AB, B → A, written as text; elements are symbols",
    "stochastic": "The same with chance, A → AB or BA; elements are symbols",
    "context": "The same with contexts, A → AB, A < B → A; elements are symbols",
    "draw": "F → F[+F]F[-F]F drawn to an SVG; elements are segments",
    "tree": "An aspen, and ez-tree's oak, to an OBJ without pictures; elements are triangles",
    "ivy": "Ivy on a wall to an OBJ without pictures; elements are leaves",
}
# Why a peer takes less than Frond where it does.
IDLE = "Of any preset Frond tells properties without effect; for that it writes and reads its schema, 0.1 s of processor"
WHY = {"draw": "Frond has all libraries of its other commands in memory, 44 MB, when it starts; Context Free has less to load.",
       "tree": f"{IDLE}; Sapling has grown a small tree by then.", "ivy": f"{IDLE}; IvyGen's leaves and strands do not look for room."}
MADE = ("bytes", "elements", "triangles", "hash", "told")
PEERS = ("lindenmayer", "Context Free", "Inkscape", "Blender", "ez-tree")


class Tools:
    """Programs, where they are, and what could not be had."""

    def __init__(self, folder, install):
        self.folder, self.unpacked, self.missing = Path(folder), Path(folder) / "debian", {}
        self.folder.mkdir(parents=True, exist_ok=True)
        if install:
            self.install()
        self.versions = {"Frond": first_line([FROND, "--version"], **HOME)}
        self.cfdg = f"{self.unpacked}/usr/bin/cfdg"
        self.libraries = {"LD_LIBRARY_PATH": f"{self.unpacked}/usr/lib/{platform.machine()}-linux-gnu"}
        self.offer("Context Free", [self.cfdg, "--version"], **self.libraries)
        self.extensions = self.unpacked / "usr/share/inkscape/extensions"
        self.python = {"PYTHONPATH": f"{self.unpacked}/usr/lib/python3/dist-packages"}
        asked = f"import sys; sys.path.insert(0, '{self.extensions}'); import lindenmayer, inkex; print(inkex.__version__)"
        self.offer("Inkscape", ["/usr/bin/python3", "-c", asked], **self.python)
        self.offer("Blender", ["blender", "--version"])
        for name, package in ("lindenmayer", "lindenmayer"), ("ez-tree", "@dgreenheck/ez-tree"):
            file = self.folder / "node_modules" / package / "package.json"
            self.offer(name, ["node", "-p", f"require('{file}').version"])
        self.offer("node", ["node", "--version"])

    def offer(self, name, words, **env):
        try:
            self.versions[name] = first_line(words, **env)
        except (OSError, subprocess.CalledProcessError) as fault:
            self.missing[name] = str(fault)[:200]

    def install(self):
        if not shutil.which("blender") and os.geteuid() == 0:
            attempt(["apt-get", "install", "-y", "--no-install-recommends", "blender"])
        if not self.unpacked.exists():
            for package in UNPACKED:
                attempt(["apt-get", "download", package], self.folder)
            for deb in self.folder.glob("*.deb"):
                attempt(["dpkg", "-x", deb, self.unpacked])
                deb.unlink()
        if not (self.folder / "node_modules").exists():
            (self.folder / "package.json").write_text("{}")
            attempt(["npm", "install", "--no-audit", "--no-fund", "--ignore-scripts", *FROM_NPM], self.folder)


def attempt(words, folder="."):
    """What fails is seen later, by what is missing."""
    try:
        subprocess.run(list(map(str, words)), cwd=folder, check=True, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    except (OSError, subprocess.CalledProcessError) as fault:
        print(f"{' '.join(map(str, words))}: {getattr(fault, 'stderr', '') or fault}", file=sys.stderr)


def first_line(words, **env):
    done = subprocess.run(words, env={**os.environ, **env}, check=True, stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)
    return " ".join(next(iter((done.stdout or done.stderr).strip().splitlines()), "").split())


def measure(words, out, log, limit, env):
    """Runs a program by itself: how it ended, seconds by the clock and of processor, and bytes of memory at most.

    The memory that wait4 tells is never less than that of this process, which therefore reads no file as a whole.
    """
    def limited():
        resource.setrlimit(resource.RLIMIT_CPU, (math.ceil(limit), math.ceil(limit) + 1))

    start = time.perf_counter()
    process = subprocess.Popen(list(map(str, words)), stdout=out, stderr=log, stdin=subprocess.DEVNULL, preexec_fn=limited,
                               env={**os.environ, **HOME, **env})
    timer = threading.Timer(4 * limit, os.kill, (process.pid, signal.SIGKILL))
    timer.start()
    _, status, used = os.wait4(process.pid, 0)
    seconds = time.perf_counter() - start
    timer.cancel()
    process.returncode = code = os.waitstatus_to_exitcode(status)
    ended = "done" if code == 0 else "late" if code == -signal.SIGXCPU or seconds >= 4 * limit else "failed"
    return {"ended": ended, "seconds": seconds, "processor": used.ru_utime + used.ru_stime, "memory": used.ru_maxrss * 1024}


def tree_preset(levels, shoots, leaves, nodes):
    """Quaking aspen by the figures of Weber and Penn, with as many stems and leaves as Sapling makes of its own preset."""
    tree = {"shape": "tend_flame", "levels": levels, "scale": 13, "scale_v": 3, "base_size": 0.4, "ratio": 0.015, "ratio_power": 1.2,
            "attraction_up": 0.5, "smoothing": nodes, "leaves": leaves, "leaf_scale": 0.17, "leaf_scale_x": 1,
            "trunk": {"length": 1, "curve_res": 3, "curve_v": 20},
            "branches": {"branches": 30, "length": 0.3, "down_angle": 60, "down_angle_v": -50, "rotate": 140, "curve_res": 5, "curve": -40,
                         "curve_v": 50},
            "twigs": {"branches": 30, "length": 0.6, "down_angle": 45, "down_angle_v": 10, "rotate": 140, "curve_res": 3, "curve": -40,
                      "curve_v": 75},
            "shoots": {"branches": shoots, "length": 0.45, "down_angle": 45, "down_angle_v": 10, "rotate": 77, "curve_res": 1}}
    return [{"kind": "weber_penn", "name": "aspen", "place": {"at": [[0, 0]], "lean": 0, "size_variation": 0}, "tree": tree,
             "leaves": {"shape": "aspen", "detail": 3}}]


def ivy_preset(roots, steps):
    still = {"at": [[0, 0]], "turn_variation": 0, "lean": 0, "size_variation": 0}
    return [{"kind": "mesh", "name": "wall", "file": "wall.obj", "size": 40, "place": still},
            {"kind": "ivy", "on": ["wall"], "count": roots, "place": {"at": [[0, 0.1]]}, "leaves": {"detail": "leaves"},
             "crawl": {"max_age": steps}}]


def jobs(tools, folder):
    """For each job and size the programs that do it: name, words, variables of the environment. OUT is what they write."""
    blender = ["blender", "-b", "--factory-startup", "--python-exit-code", "1", "-P"]

    def write(name, value):
        (folder / name).write_text(value if isinstance(value, str) else json.dumps(value))
        return folder / name

    def preset(name, organisms):
        return write(name, {"seed": 1, "film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": organisms})

    def export(file, detail=1_000_000_000):
        return [FROND, "export", file, "--texture", "0", "--sides", "4", "--detail", str(detail), "-q", "-o", "OUT.obj"]

    starts = [("Frond", [FROND, "--version"], {}), ("node", ["node", "-e", "0"], {}),
              ("Blender", ["blender", "-b", "--factory-startup", "--python-expr", "0"], {}),
              ("Context Free", [tools.cfdg, "--version"], tools.libraries)]
    page = write("page.svg", '<svg xmlns="http://www.w3.org/2000/svg" width="100" height="100" xmlns:s="http://sodipodi.sourceforge.net/'
                             'DTD/sodipodi-0.dtd"><s:namedview/></svg>')

    def inkscape(order):
        return ["/usr/bin/python3", tools.extensions / "lindenmayer.py", "--axiom", "F", "--rules", "F=F[+F]F[-F]F", "--order", str(order),
                "--langle", "25", "--rangle", "25", "--step", "1", "--output", "OUT.svg", page]

    yield "start", 0, [*starts, ("Inkscape", inkscape(0), tools.python)]
    for job, (rules, productions) in WORDS.items():
        file = write(f"{job}.json", {"axiom": "A", "rules": rules})
        for size, steps in enumerate(STEPS):
            peer = ["node", HERE / "lindenmayer.mjs", tools.folder, "OUT.txt", steps, json.dumps(productions)]
            yield job, size, [("Frond", [FROND, "derive", file, "--steps", str(steps)], {}), ("lindenmayer", peer, {})]
    file = write("draw.json", {"axiom": "F", "angle": 25, "rules": ["F -> F[+F]F[-F]F"]})
    for size, order in enumerate(ORDERS):
        free = [tools.cfdg, "-q", "-V", "-x", "0.0000001", "-m", "100000000", f"-Ddepth={order}",
                HERE / "plant.cfdg", "OUT.svg"]
        yield "draw", size, [("Frond", [FROND, "turtle", file, "--steps", str(order), "--svg", "OUT.svg"], {}),
                             ("Context Free", free, tools.libraries), ("Inkscape", inkscape(order), tools.python)]
    for size, (tree, factor) in enumerate(zip(TREES, FACTORS)):
        yield "tree", size, [("Frond", export(preset(f"tree{size}.json", tree_preset(*tree))), {}),
                             ("Blender", [*blender, HERE / "sapling.py", "--", "OUT.obj", *tree[:2]], {}),
                             ("ez-tree", ["node", HERE / "ez_tree.mjs", tools.folder, "OUT.obj", factor], {})]
    write("wall.obj", "v -20 0 0\nv 20 0 0\nv 20 20 0\nv -20 20 0\nf 1 2 3 4\n")
    for size, (metres, roots, steps, triangles) in enumerate(IVIES):
        file = preset(f"ivy{size}.json", ivy_preset(roots, steps))
        yield "ivy", size, [("Frond", export(file, triangles), {}), ("Frond, finer", export(file), {}),
                            ("Blender", [*blender, HERE / "ivygen.py", "--", "OUT.obj", metres], {})]


def organs_of(file, scratch):
    """How many organs a preset of Frond grows: an export with instances names the places of each."""
    glb = scratch / "organs.glb"
    subprocess.run([FROND, "export", file, "--texture", "0", "--instances", "-q", "-o", glb], check=True, env={**os.environ, **HOME})
    with open(glb, "rb") as stream:
        length, = struct.unpack("<12xI4x", stream.read(20))
        said = json.loads(stream.read(length))
    glb.unlink()
    places = [node.get("extensions", {}).get("EXT_mesh_gpu_instancing") for node in said["nodes"]]
    return sum(said["accessors"][p["attributes"]["TRANSLATION"]]["count"] for p in places if p)


def look_at(job, size, run, words, outs, scratch):
    """What a run has made: bytes, elements, triangles, and the hash of a word."""
    run["bytes"] = sum(out.stat().st_size for out in outs)
    for out in outs:
        if job in WORDS:
            with open(out, "rb") as stream:
                run["hash"] = hashlib.file_digest(stream, "sha256").hexdigest()
            run["elements"] = run["bytes"] - 1
        elif out.suffix == ".obj":
            with open(out, "rb") as stream:
                run["triangles"] = sum(len(line.split()) - 3 for line in stream if line.startswith(b"f "))
            run["elements"] = run["triangles"]
    if job == "draw":
        run["elements"] = 5 ** ORDERS[size]
    if job == "ivy":
        run["elements"] = int(run.get("told") or organs_of(words[2], scratch))


def one_run(job, size, program, words, env, limit, scratch, known):
    folder, log = scratch / "run", scratch / "log"
    folder.mkdir()
    words = [str(folder / word) if str(word).startswith("OUT.") else word for word in words]
    with open(log, "w", encoding="utf-8") as said, open(folder / "word.txt" if job in WORDS and program == "Frond" else log, "a") as out:
        run = measure(words, out, said, limit, env)
    run |= {"job": job, "size": size, "program": program}
    if run["ended"] == "failed":
        run["said"] = log.read_text(errors="replace")[-500:]
    elif run["ended"] == "done" and job != "start":
        if said := re.search(r"^measured (\S+) (\S+)$", log.read_text(errors="replace"), re.M):
            run["inner"], run["told"] = float(said[1]), float(said[2])
        if known is None:
            look_at(job, size, run, words, sorted(folder.iterdir()), scratch)
        else:  # what the first run has made, this one has made, too
            run |= {key: known[key] for key in MADE if key in known}
    shutil.rmtree(folder)
    return run


def measure_all(tools, options, scratch):
    """All runs, programs by turns. What has failed is not tried at larger sizes, what took half of the limit not again."""
    runs, late, long = [], set(), set()
    for job, size, programs in jobs(tools, scratch):
        if job != "start" and (job not in options.only or (options.quick and size)):
            continue
        first = {}
        for _ in range(options.repeats):
            for name, words, env in programs:
                program = name.split(",")[0]
                if program not in tools.versions or (job, name) in late or (job, size, name) in long:
                    continue
                run = one_run(job, size, name, words, env, options.limit, scratch, first.get(name))
                first.setdefault(name, run)
                runs.append(run)
                if run["ended"] != "done":
                    late.add((job, name))
                long |= {(job, size, name)} if run["processor"] > options.limit / 2 else set()
                print(job, size, name, run["ended"], f"{run['seconds']:.2f} s", flush=True)
    return runs


def summary(runs):
    """A row for each job, size and program."""
    groups, rows = {}, []
    for run in runs:
        groups.setdefault((run["job"], run["size"], run["program"]), []).append(run)
    for (job, size, program), group in groups.items():
        row = {"job": job, "size": size, "program": program, "ended": "done"}
        row |= {key: statistics.median(run[key] for run in group) for key in ("seconds", "processor", "memory")}
        if bad := [run for run in group if run["ended"] != "done"]:
            row["ended"] = bad[0]["ended"]
        elif job != "start":
            row |= {key: group[0][key] for key in MADE if key in group[0]}
            start = next((r["processor"] for r in rows if r["job"] == "start" and r["program"] == program.split(",")[0]), 0)
            inner = [run["inner"] for run in group if "inner" in run]
            row["net"] = statistics.median(inner) if inner else max(0.0, row["processor"] - start)
            before = next((r for r in rows if (r["job"], r["program"], r["size"]) == (job, program, size - 1)), None)
            if before and before.get("net", 0) >= 0.05 and row["net"] > 0:
                row["tenfold"] = 10 ** (math.log(row["net"] / before["net"]) / math.log(row["elements"] / before["elements"]))
        rows.append(row)
    return rows


def figure(value):
    return f"{value:.2f}" if value < 9.995 else f"{value:.1f}" if value < 99.95 else f"{value:,.0f}"


def line_of(row, frond, triangles):
    """What a program took beside what Frond took; bold where a peer took less."""
    def bold(text, less):
        return f"**{text}**" if less and row["program"] in PEERS else text

    def ratio(key):
        times = row[key] / row["elements"] / (frond[key] / frond["elements"]) if frond[key] >= 0.05 else 0
        return bold(figure(times), times < 1) if times and row is not frond else ""

    cells = [row["program"], f"{row['elements']:,}", *([f"{row['triangles']:,}"] if triangles else []),
             *(figure(row[key]) for key in ("seconds", "processor", "net")),
             bold(f"{row['memory'] / 1e6:.0f}", row["memory"] < frond["memory"]), figure(row["bytes"] / 1e6),
             ratio("seconds"), ratio("net"), figure(row["tenfold"]) if "tenfold" in row else ""]
    return f"| {' | '.join(cells)} |"


def table(rows, limit):
    """In Markdown; below the words whether they are the same."""
    text = ["### Nothing but starting", "", "| program | seconds | of processor | memory, MB |", "| --- | --- | --- | --- |"]
    text += [f"| {row['program']} | {row['seconds']:.2f} | {row['processor']:.2f} | {row['memory'] / 1e6:.0f} |"
             for row in rows if row["job"] == "start"]
    for job in [job for job in TITLES if any(row["job"] == job for row in rows)]:
        mine = [row for row in rows if row["job"] == job]
        heads = ["program", "elements", *(["triangles"] if job == "ivy" else []), "seconds", "of processor", "without start", "memory, MB",
                 "written, MB", "seconds an element to Frond's", "without start to Frond's", "tenfold costs"]
        text += ["", f"### {TITLES[job]}", "", f"| {' | '.join(heads)} |", "| --- " * len(heads) + "|"]
        for row in mine:
            frond = next((r for r in mine if (r["size"], r["program"], r["ended"]) == (row["size"], "Frond", "done")), row)
            if row["ended"] == "done":
                text.append(line_of(row, frond, job == "ivy"))
            else:
                word = f"more than {limit:g} s of processor" if row["ended"] == "late" else "failed"
                text.append(f"| {row['program']} | as above | {word}" + " |" * (len(heads) - 2))
        if job in WHY and "**" in "".join(text[-len(mine):]):
            text += ["", f"Less than Frond's is bold. {WHY[job]}"]
        if job in WORDS:
            what, key = ("Lengths", "elements") if job == "stochastic" else ("Words", "hash")
            pairs = {(row["size"], row[key]) for row in mine if key in row}
            text += ["", f"{what} are {'' if len(pairs) == len({size for size, _ in pairs}) else 'NOT '}the same."]
    return "\n".join(text) + "\n"


def self_test(scratch):
    """That Frond still does the jobs, and that the table is summed up as it should be."""
    options = argparse.Namespace(only=list(TITLES), quick=True, repeats=1, limit=120)
    tools = Tools(scratch / "tools", install=False)
    tools.versions = {"Frond": tools.versions["Frond"]}
    runs = measure_all(tools, options, scratch)
    assert all(run["ended"] == "done" for run in runs), runs
    known = {run["job"]: run.get("elements") for run in runs}
    assert known["derive"] == known["stochastic"] == known["context"] == 10946, known
    assert 7000 < known["tree"] < 12000 and 700 < known["ivy"] < 1500, known
    made = [{"job": "draw", "size": s, "program": p, "ended": "done", "seconds": 10.0 ** s * f, "processor": 10.0 ** s * f, "memory": 1e6,
             "elements": 10 ** s, "bytes": 1} for s in (1, 2) for p, f in (("Frond", 1), ("Inkscape", 0.5))]
    text = table(summary(made), 120)
    assert "| Inkscape | 100 | 50.0 | 50.0 | 50.0 | 1 | 0.00 | **0.50** | **0.50** | 10.0 |" in text, text
    print("ok")


def main():
    parser = argparse.ArgumentParser(add_help=False)
    for word in "--help", "--self-test", "--quick":
        parser.add_argument(word, action="store_true")
    parser.add_argument("--out", type=Path, default=Path("out/peers"))
    parser.add_argument("--tools", type=Path)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--limit", type=float, default=120)
    parser.add_argument("--only", nargs="+", choices=list(TITLES), default=list(TITLES))
    options = parser.parse_args()
    if options.help:
        return print(__doc__.strip())
    if not shutil.which(FROND):
        sys.exit(f"error: {FROND}: no such program; scripts/build.sh makes it, or FROND_BIN says where it is")
    with tempfile.TemporaryDirectory(prefix="frond-peers-") as name:
        scratch = Path(name)
        if options.self_test:
            return self_test(scratch)
        tools = Tools((options.tools or scratch / "tools").resolve(), install=True)
        load = os.getloadavg()[0]
        runs = measure_all(tools, options, scratch)
    rows = summary(runs)
    options.out.mkdir(parents=True, exist_ok=True)
    machine = {"processors": os.cpu_count(), "system": platform.platform(), "load": [load, os.getloadavg()[0]]}
    told = {"machine": machine, "versions": tools.versions, "missing": tools.missing}
    (options.out / "peers.json").write_text(json.dumps(told | {"rows": rows, "runs": runs}, indent=1))
    (options.out / "peers.md").write_text(table(rows, options.limit))
    print((options.out / "peers.md").read_text(), json.dumps(told, indent=1), sep="\n")


if __name__ == "__main__":
    main()
