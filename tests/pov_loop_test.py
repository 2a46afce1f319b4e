#!/usr/bin/env python3
"""Exports the loop of a film as an include and plays it in a film of POV-Ray's own.

  pov_loop_test.py FROND ROOT

Which frame is shown at which time, inside of the loop and outside of it; and with +KC the last picture leads to the
first as each one leads to the next, without a stop and without a jump.
"""
import math
import pathlib
import re
import subprocess
import sys
import tempfile

FRAMES = 24  # a loop of a second
TIMES = [0.5, 0.97, 1, 1.5, -0.2, -0.01, -1, 2.98, -5000.2] + [i / 60 for i in range(60)]

LOOK = """#version 3.7;
global_settings { assumed_gamma 1 }
#include "tufted.inc"
object { Frond_Tufted_Loop(0, clock) }
plane { y, 0 pigment { srgb 0.5 } }
background { srgb <0.3, 0.5, 0.7> }
light_source { <-30, 50, -20>, rgb 1.3 }
camera { location <0, 0.8, -2.6> look_at <0, 0.4, 0> angle 40 right x*image_width/image_height }
"""

ASK = """#version 3.7;
global_settings {{ assumed_gamma 1 }}
#include "tufted.inc"
#macro Frond_Tufted_Shape(Seed, Detail, Frame)
  #debug concat("SHOWN ", str(Frame, 0, 3), "\\n")
  sphere {{ 0, 1 }}
#end
#local Times = array[{count}] {{ {times} }};
#for (I, 0, {count} - 1)
  object {{ Frond_Tufted_At(0, Times[I]) }}
  object {{ Frond_Tufted_Loop(0, Times[I]) }}
#end
"""


def povray(folder, *words):
    run = subprocess.run(["povray", *words, "-D"], cwd=folder, text=True, stdout=subprocess.PIPE,
                         stderr=subprocess.STDOUT)
    if run.returncode != 0:
        sys.exit(f"POV-Ray ended with {run.returncode}\n{run.stdout[-2000:]}")
    return run.stdout


def samples(path):
    """The bytes of a picture as PPM, behind its header, which POV-Ray comments."""
    return re.match(rb"P6\s+(?:#[^\n]*\n)*\d+\s+\d+\s+255\s(.*)", path.read_bytes(), re.S)[1]


def main(frond, root):
    with tempfile.TemporaryDirectory() as scratch:
        folder = pathlib.Path(scratch)
        subprocess.run([frond, "export", "presets/tufted.json", "--set", f"/film/frames={FRAMES}", "--set",
                        '/organisms/0/wave={"amplitude": 12, "speed": 1}', "--set", "/organisms/0/growth/duration=0",
                        "--frames", f"1-{FRAMES}", "-q", "-o", folder / "tufted.inc"], cwd=root, check=True)
        (folder / "ask.pov").write_text(ASK.format(count=len(TIMES), times=", ".join(f"{t:.9f}" for t in TIMES)))
        told = povray(folder, "+Iask.pov", "-F", "+W4", "+H4")
        shown = [float(n) for n in re.findall(r"^SHOWN (\S+)", told, re.M)]
        assert len(shown) == 2 * len(TIMES), told[-2000:]
        for time, held, looped in zip(TIMES, shown[::2], shown[1::2]):
            nearest = math.floor(FRAMES * time + 0.5 + 1e-6)
            # At a time half-way between two frames either is the nearest.
            near = {nearest, math.floor(FRAMES * time + 0.5)}
            assert held in {max(0, min(FRAMES - 1, n)) for n in near}, f"at {time} it holds frame {held}"
            assert looped == nearest % FRAMES, f"at {time} the loop shows frame {looped}"
        (folder / "look.pov").write_text(LOOK)
        povray(folder, "+Ilook.pov", "+KFI1", f"+KFF{FRAMES}", "+KC", "+W80", "+H60", "+A", "+FP", "+Olook.ppm")
        pictures = [samples(path) for path in sorted(folder.glob("look*.ppm"))]
        assert len(pictures) == FRAMES, f"{len(pictures)} pictures"
        steps = [sum(abs(a - b) for a, b in zip(one, pictures[(i + 1) % FRAMES])) / len(one)
                 for i, one in enumerate(pictures)]
        print("mean change from each picture to the next:", *(f"{s:.2f}" for s in steps))
        assert max(steps) < 3.5 * min(steps), "it stops or jumps"
        assert 0.5 < steps[-1] / (0.5 * (steps[-2] + steps[0])) < 2, "it does not close"
        print("as it should be")


main(*sys.argv[1:])
