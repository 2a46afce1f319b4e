#!/usr/bin/env python3
"""Kills runs at random moments and takes them up again; the end must have the same bytes as a run that nobody disturbed.

    kill_test.py generate|render FROND SOURCE_DIR [KILLS]
"""

import os
import pathlib
import random
import shutil
import signal
import subprocess
import sys
import tempfile
import time

what, frond, source = sys.argv[1], pathlib.Path(sys.argv[2]).resolve(), pathlib.Path(sys.argv[3]).resolve()
KILLS = int(sys.argv[4]) if len(sys.argv) > 4 else 2  # of each phase of generate, of each film of render
STOPS = 2  # within a picture
TRIES = 20  # at that
IN_A_ROW = 2  # kills before a run may end
chance = random.Random(6)


def files(folder):
    """All that a folder holds, but for the notes of ninja, of the lock and of times."""
    return {str(path.relative_to(folder)): path.read_bytes() for path in sorted(folder.rglob("*"))
            if path.is_file() and path.name not in (".ninja_log", ".ninja_deps", ".lock", ".times")}


def same(a, b, when):
    assert a.keys() == b.keys(), f"{when}: other files: {sorted(a.keys() ^ b.keys())}"
    for name, bytes_of in a.items():
        assert bytes_of == b[name], f"{when}: {name} has other bytes"


def start(command):
    return subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
                            start_new_session=True, env={**os.environ, "FROND_BIN": str(frond),
                                 "XDG_CACHE_HOME": str(source / "build" / "cache")})


def follow(run, until=None):
    """Reads what a run says up to the end of a phase, or to its own: when each phase ended, in seconds from now."""
    begun, ends = time.monotonic(), {}
    for line in run.stderr:
        phase, _, steps = line.strip().partition(" ")
        done, _, total = steps.partition("/")
        if done == total and total.isdigit():
            ends[phase] = time.monotonic() - begun
            if phase == until:
                break
    return ends


def kill(run, with_signal):
    """Ends the whole group, as closing a terminal or a batch system does."""
    os.killpg(run.pid, with_signal)
    run.stderr.close()
    run.wait()


def finish(command, when):
    run = start(command)
    said = run.stderr.read()
    assert run.wait() == 0, f"{when}: exit code {run.returncode}\n{said}"
    return said


def kill_generate(folder):
    def command(out, threads, *sets):
        return [frond, "generate", source / "tests/presets/all_phases.json", "-o", out, "--threads", str(threads),
                *(f"--set={value}" for value in sets)]

    whole = folder / "whole"
    run = start(command(whole, 1))
    ends = follow(run)
    assert run.wait() == 0 and list(ends) == ["place", "grow", "surround", "texture", "models", "frames"], ends
    expected = files(whole)
    # What is there before a phase, from earlier runs, so that the phase is what a run does after growing.
    before = {"models": ["*.png"], "frames": ["*.png", "model_*.inc"]}
    begins = dict(zip(ends, [0, *ends.values()]))
    for phase in ends:
        for number in range(0, KILLS, IN_A_ROW):
            out = folder / f"{phase}{number}"
            (out / "frames").mkdir(parents=True)
            for pattern in before.get(phase, []):
                for path in (whole / "frames").glob(pattern):
                    shutil.copy(path, out / "frames")
            for _ in range(IN_A_ROW):
                run = start(command(out, 2))
                if phase != "place":
                    follow(run, {"grow": "place", "surround": "grow"}.get(phase, "surround"))
                time.sleep(chance.uniform(0, ends[phase] - begins[phase]))
                kill(run, chance.choice([signal.SIGKILL, signal.SIGTERM]))
            when = f"killed in phase {phase}, times {number} and before"
            finish(command(out, 2), when)
            same(expected, files(out), when)
            shutil.rmtree(out)
    keep_models(command, folder / "models")


def keep_models(command, out):
    """Models are grown anew where they are others, and only then."""
    far = "/scene/camera/location=[0,9,99]"  # one level of detail is enough for all

    def grow(*sets):
        said = finish(command(out, 2, far, *sets), sets)
        grown = [line for line in said.splitlines() if line.startswith("models ")][-1:]
        return grown, {path.name: path.stat().st_mtime_ns for path in (out / "frames").glob("model_*.inc")}

    grown, first = grow()
    assert grown == ["models 2/2"] and len(first) == 2, (grown, first)
    assert grow("/seed=9") == ([], first), "another placement"
    grown, again = grow("/organisms/2/sown/seeds=[5,7]")
    kept = first.items() & again.items()
    assert grown == ["models 1/1"] and len(again) == 2 and len(kept) == 1, (grown, first, again)


def kill_render(folder):
    runs = [("studio", "tiny_still", ["--set", "/scene/setting=studio", "--quality", "good", "--no-resolve", "--scale", "1.5"]),
            ("forest", "all_phases", ["--set", "/film/frames=1", "--quality", "draft"]), ("film", "tiny_film", []),
            ("resolved", "tiny_film", ["--quality", "good"])]
    for name, preset, options in runs:
        def command(out, jobs):
            return [source / "scripts/render.sh", source / f"tests/presets/{preset}.json", "-o", folder / name / out,
                    "--jobs", str(jobs), *options]

        begun = time.monotonic()
        finish(command("whole", 1), name)
        length = time.monotonic() - begun
        killed = folder / name / "killed"
        for _ in range(KILLS):
            run = start(command("killed", 2))
            time.sleep(chance.uniform(0, length))
            kill(run, chance.choice([signal.SIGKILL, signal.SIGTERM]))
        finish(command("killed", 2), f"{name}, killed {KILLS} times")
        same(files(folder / name / "whole"), files(killed), f"{name}, killed {KILLS} times")
        stop_within(lambda out: command(out, 2), folder / name)


def traced(folder):
    """How many bytes of unfinished pictures a run keeps."""
    size = 0
    for path in folder.glob("*/.*.kept"):
        try:
            size += path.stat().st_size
        except FileNotFoundError:
            pass  # finished meanwhile
    return size


def stop_within(command, folder):
    """One that is killed twice, as soon as it has traced some more, goes on from there."""
    block = 10000  # bytes, less than the smallest that these pictures have
    for attempt in range(TRIES):  # where the machine is busy, one may end before it is seen
        stopped = folder / f"stopped{attempt}"
        before = stops = 0
        while stops < STOPS:
            run = start(command(stopped.name))
            while run.poll() is None and traced(stopped) < before + block:
                time.sleep(0.002)
            if run.poll() is not None:
                run.stderr.close()
                break
            kill(run, signal.SIGKILL)
            before, stops = traced(stopped), stops + 1
        if stops == STOPS:
            break
    assert stops == STOPS, "no picture was left unfinished"
    finish(command(stopped.name), "stopped within a picture")
    same(files(folder / "whole"), files(stopped), "stopped within a picture")


with tempfile.TemporaryDirectory() as name:
    {"generate": kill_generate, "render": kill_render}[what](pathlib.Path(name))
