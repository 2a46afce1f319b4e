"""Frames are written in seconds wherever the camera is, or the preset is refused with a reason; and no step before the first
frame is silent.

    far_cameras_test.py FROND SOURCE [--all]

Without --all a few places of each setting; with it forty, from 0.1 m to 1 km, and beyond.
"""
import json
import math
import os
import subprocess
import sys
import tempfile
from pathlib import Path

MOST = 30  # seconds of processor
SETTINGS = ["studio", "underwater", "meadow", "garden", "forest"]


def preset(setting, far, angle, turn):
    high = 0.7 * far if int(turn * 10) % 3 == 0 else 1 + 0.02 * far
    scene = {"setting": setting, "camera": {"location": [far * math.cos(turn), high, far * math.sin(turn)],
                                            "look_at": [0, 0.5, 0], "angle": angle}}
    if setting not in ("studio", "underwater"):
        scene["rain"] = {"rate": 0, "fallen": 20}
    return {"film": {"frames": 1, "size": [64, 36]}, "scene": scene,
            "organisms": [{"kind": "vase", "name": "v", "height": 2}]}


def seconds(command):
    """Of the processor, with what was said; nothing where it took too long."""
    child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True)
    said = child.stderr.read()
    _, status, used = os.wait4(child.pid, 0)
    return used.ru_utime + used.ru_stime, os.waitstatus_to_exitcode(status), said


def far_places(every):
    for i in range(0, 40, every):
        far = 0.1 * 50000 ** (i / 39)
        yield far, 0.5 * 340 ** ((7 * i % 40) / 39), 2.4 * i


def main():
    frond, source = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    every = 1 if "--all" in sys.argv else 20
    os.environ["FROND_HOME"] = str(source.resolve())
    wrong = []
    with tempfile.TemporaryDirectory() as folder:
        def check(name, what):
            path = Path(folder) / "far.json"
            path.write_text(json.dumps(what))
            took, status, said = seconds([frond, "generate", path, "-o", Path(folder) / "out"])
            fine = took < MOST and (status == 0 or status == 2 and "/scene/camera/" in said)
            print(f"{name:40} {took:6.2f} s, {'refused' if status == 2 else status}", flush=True)
            if not fine:
                wrong.append(f"{name}: {took:.1f} s, exit code {status}\n{said}")

        # Those that were slow: a narrow view of a garden from afar, and puddles below a camera far off.
        check("garden from 400 m", {
            "film": {"frames": 1, "size": [320, 180]},
            "scene": {"setting": "garden", "camera": {"location": [0, 5, 400], "look_at": [0, 5, 0], "angle": 4},
                      "meadow": {"extent": 16}},
            "organisms": [{"kind": "vase", "name": "v", "height": 2}]})
        check("a wet meadow from 300 m", {
            "film": {"frames": 1, "size": [64, 36]},
            "scene": {"setting": "meadow", "camera": {"location": [0, 300, 300], "look_at": [0, 0, 0]},
                      "rain": {"rate": 0, "fallen": 20}}, "organisms": []})
        for setting in SETTINGS:
            for far, angle, turn in far_places(every):
                check(f"{setting} from {far:.4g} m, {angle:.3g} degrees", preset(setting, far, angle, turn))
    assert not wrong, "\n".join(wrong)


if __name__ == "__main__":
    main()
