#!/usr/bin/env python3
"""What `frond info` foretells of one frame of a preset, held against `frond generate` in a fresh folder.

Usage: cost_estimate_test.py FROND ROOT [--all | --random COUNT [SEED] | PRESET...]

--random draws so many presets of each kind: the one that `frond new` begins with, each number of its organism changed by up
to a factor of two and a half. What the program refuses is drawn again.

Prints a table: seconds of processor (user and system time of the whole run), the most memory that it held and bytes
that it wrote, each with what was estimate as a multiple of it. Seconds and memory are held to a factor of 2, bytes to
one of 1.5. The last frame is written, in which all has grown.

Seconds differ from machine to machine and with what else it does. So a few presets whose work is of every kind are
run first; the middle of their ratios is the pace of this machine, and all seconds estimate are corrected by it. A run
that is out of bounds is made again, and its least figures count. Exit codes: 0 within bounds, 1 not.
"""
import json
import os
import random
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

SECONDS, MEMORY, BYTES = 2.0, 2.0, 1.5
# What is so small that nobody asks: start of the program, files read, the layout of a frame.
LEAST_SECONDS, LEAST_BYTES = 0.25, 20_000
PACE = ["bush", "garden/bush", "species/corals/honeycomb", "lsystems/trees-2.6"]
SMALL = ["fan", "lsystems/koch-1.6", "lsystems/inflorescence-3", "garden/palm", "species/corals/brain", "species/corals/finger",
         "ivy/brick_wall", "forest/mushrooms"]
# What is known to be worse, in bytes: furrows that are cut near the camera are not counted, nor are the cells of light
# along what stands close before it; corals that crowd each other are smaller than estimated; polyps that are open are
# not counted.
BYTES_OF = {"photographs/bark": 3.5, "reef_dusk": 2.7, "reef_flight": 1.75, "garden/rocks": 1.8, "reef/kelp": 1.9}
ATTEMPTS = 3
RANDOM = 3.0  # the bound of all three of presets that are drawn, which nobody has tuned anything to


def presets(root):
    """All that are shipped: below presets/grammars lie grammars, which are none."""
    names = [str(p.relative_to(root / "presets").with_suffix("")) for p in sorted((root / "presets").rglob("*.json"))]
    return [n for n in names if not n.startswith("grammars/")]


def estimate(frond, path, frame):
    out = subprocess.run([frond, "info", path, "--json", "--frames", str(frame)], check=True, capture_output=True, text=True).stdout
    said = json.loads(out)
    return said["seconds"], said["memory_bytes"], said["written_bytes"]


def frames(frond, path):
    said = subprocess.run([frond, "info", path, "--json"], check=True, capture_output=True, text=True).stdout
    return json.loads(said)["frames"]


def generated(frond, path, frame):
    """Seconds, bytes of memory and bytes written of one run."""
    with tempfile.TemporaryDirectory() as out:
        child = subprocess.Popen([frond, "generate", path, "-o", out, "--frames", str(frame), "-q"])
        _, status, used = os.wait4(child.pid, 0)
        if status:
            raise SystemExit(f"{path}: generate failed")
        size = sum(f.stat().st_size for f in (Path(out) / "frames").iterdir())
        return used.ru_utime + used.ru_stime, 1024 * used.ru_maxrss, size


def ratio(said, true, least=0.0):
    return (said + least) / (true + least)


def within(ratio, bound):
    return 1 / bound <= ratio <= bound


def changed(value, dice):
    """A value with each number in it, but of places and colours, changed; whole ones stay whole."""
    if isinstance(value, dict):
        return {k: v if k in ("place", "growth", "count") else changed(v, dice) for k, v in value.items()}
    if isinstance(value, list):
        return [changed(v, dice) for v in value]
    if isinstance(value, bool) or not isinstance(value, (int, float)):
        return value
    other = value * 2.5 ** dice.uniform(-1, 1)
    return max(1, round(other)) if isinstance(value, int) and value > 1 else value if isinstance(value, int) else other


def drawn(frond, template, dice, path):
    """Writes a random preset of a kind that the program accepts; whether there is one."""
    for _ in range(20):
        preset = json.loads(template.read_text())
        preset["organisms"] = [changed(organism, dice) for organism in preset["organisms"]]
        preset["film"]["size"] = [160, 120]
        path.write_text(json.dumps(preset))
        checked = subprocess.run([frond, "info", path, "--json"], capture_output=True, cwd=template.parent)
        if checked.returncode == 0 and json.loads(checked.stdout)["seconds"] < 60:
            return True
    return False


class Judge:
    def __init__(self, frond, root, bounds=(SECONDS, MEMORY, BYTES)):
        self.frond, self.root, self.pace, self.bounds = frond, root, 1.0, bounds

    def measure(self, name):
        """What was estimate and, of up to some runs, the least that was true."""
        path = name if isinstance(name, Path) else str(self.root / "presets" / f"{name}.json")
        frame = frames(self.frond, path)
        said = estimate(self.frond, path, frame)
        true = None
        for _ in range(ATTEMPTS):
            now = generated(self.frond, path, frame)
            true = now if true is None else tuple(map(min, true, now))
            if self.good(name, said, true):
                break
        return said, true

    def ratios(self, said, true):
        return (ratio(said[0] * self.pace, true[0], LEAST_SECONDS), ratio(said[1], true[1]),
                ratio(said[2], true[2], LEAST_BYTES))

    def good(self, name, said, true):
        seconds, memory, written = self.bounds
        return all(map(within, self.ratios(said, true), (seconds, memory, BYTES_OF.get(name, written))))

    def find_pace(self):
        runs = [self.measure(name) for name in PACE]
        self.pace = 1 / statistics.median(ratio(said[0], true[0], LEAST_SECONDS) for said, true in runs)
        print(f"pace of this machine: {self.pace:.2f}")

    def row(self, name):
        said, true = self.measure(name)
        ratios, good = self.ratios(said, true), self.good(name, said, true)
        print(f"{str(name):36} {true[0]:8.2f} s {ratios[0]:5.2f} {true[1] / 1e6:8.0f} MB {ratios[1]:5.2f} "
              f"{true[2] / 1e6:9.2f} MB {ratios[2]:5.2f}{'' if good else '  OUT OF BOUNDS'}", flush=True)
        return good


def random_ones(judge, root, count, seed):
    judge.bounds, wrong = (RANDOM,) * 3, 0
    for template in sorted((root / "templates/new").glob("*.json")):
        for number in range(count):
            dice = random.Random(f"{template.stem} {seed} {number}")
            with tempfile.NamedTemporaryFile(suffix=f"_{template.stem}_{number}.json", dir=root / "build") as file:
                path = Path(file.name)
                if not drawn(judge.frond, template, dice, path):
                    print(f"{template.stem}: nothing that was drawn is accepted")
                elif not judge.row(path):
                    print(path.read_text())
                    wrong += 1
    return 1 if wrong else 0


def main():
    frond, root, *names = sys.argv[1:]
    judge = Judge(frond, Path(root))
    judge.find_pace()
    if names[:1] == ["--random"]:
        return random_ones(judge, Path(root), int(names[1]), int(names[2]) if len(names) > 2 else 1)
    if names == ["--all"]:
        names = presets(Path(root))
    wrong = [name for name in names or SMALL if not judge.row(name)]
    if wrong:
        print("out of bounds: " + ", ".join(wrong))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
