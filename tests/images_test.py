#!/usr/bin/env python3
"""Renders small frames with POV-Ray and measures them: usage images_test.py FROND SOURCE_DIR."""

import math
import os
import pathlib
import re
import subprocess
import sys
import tempfile

frond, source = sys.argv[1], pathlib.Path(sys.argv[2])
WIDTH, HEIGHT = 64, 48


def soft_light(scene):
    """The options that the first line of a scene names."""
    name = re.search(r"[+]RF(\w+[.]rca)", scene.read_text().split("\n", 1)[0])
    return ["+RFI", f"+RF{scene.parent / name[1]}"] if name else []


def picture_of(scene, flags, folder, own_light=None):
    """A scene as a list of (red, green, blue); `own_light` is a folder of includes whose light POV-Ray works out."""
    light = [f"+L{own_light}"] if own_light else soft_light(scene)
    picture = folder / "picture.ppm"
    run = subprocess.run(
        ["povray", *light, f"+L{source / 'povinc'}", f"+L{scene.parent}", f"+I{scene}", f"+O{picture}",
         f"+W{WIDTH}", f"+H{HEIGHT}", *flags, "+FP8", "-D", "-GA", "+WT1"], capture_output=True, text=True)
    assert run.returncode == 0, run.stderr[-2000:]
    sampled = re.search(r"Radiosity samples calculated: +(\d+)", run.stderr)
    assert own_light or not sampled or int(sampled[1]) < 0.005*WIDTH*HEIGHT, f"{scene}: light was missing at {sampled[1]} places"
    assert "Warning" not in run.stderr.replace("Warning Stream", ""), run.stderr[-2000:]
    data = picture.read_bytes()[-3 * WIDTH * HEIGHT:]
    return [tuple(data[i:i + 3]) for i in range(0, len(data), 3)]


def render(preset, frames, folder, quality=("+A0.3",), sets=()):
    """The frames of a preset."""
    subprocess.run([frond, "generate", source / preset, "-o", folder, "-q"] + [w for s in sets for w in ("--set", s)],
                   check=True)
    return {frame: picture_of(folder / "frames" / f"frame_{frame:04}.pov", list(quality), folder) for frame in frames}


def linear(byte):
    return byte / 255 / 12.92 if byte <= 10 else ((byte / 255 + 0.055) / 1.055) ** 2.4


def encoded(light):
    return 255 * (12.92 * light if light <= 0.0031308 else 1.055 * light ** (1 / 2.4) - 0.055)


def png_of(path):
    data = subprocess.run(["ffmpeg", "-nostdin", "-loglevel", "error", "-i", path, "-f", "rawvideo", "-pix_fmt", "rgb24", "-"],
                          check=True, capture_output=True).stdout
    return [tuple(data[i:i + 3]) for i in range(0, len(data), 3)]


OWN_LIGHT = """#declare Frond_Ambient = 0;
#macro Light_All_Round(Bound)
  radiosity {
    pretrace_start 0.08 pretrace_end 0.02 count 150 nearest_count 4 error_bound 0.6 recursion_limit 3
    minimum_reuse 0.006 maximum_reuse 0.1
  }
#end
"""


def frond_flags(folder, quality):
    """The build file of a small film of that quality."""
    subprocess.run([frond, "generate", source / "tests/presets/tiny_still.json", "-o", folder, "--quality", quality,
                    "--no-resolve", "-q"], check=True)
    return (folder / "build.ninja").read_text()


def mean(picture):
    return sum(map(sum, picture)) / (3 * len(picture))


def deviation(picture):
    middle = mean(picture)
    return (sum((sum(p) / 3 - middle) ** 2 for p in picture) / len(picture)) ** 0.5


def difference(a, b):
    return sum(abs(x - y) for p, q in zip(a, b) for x, y in zip(p, q)) / (3 * len(a))


def distance(a, b):
    """The root of the mean square of the difference."""
    return (sum((x - y) ** 2 for p, q in zip(a, b) for x, y in zip(p, q)) / (3 * len(a))) ** 0.5


def check(name, holds, figure):
    print(f"{'ok  ' if holds else 'FAIL'} {name}: {figure}")
    return holds


def air_before(folder, metres, height, haze):
    """The light of the air before something black so far away and high, as a share of what an endless way has."""
    scene = folder / "air.pov"
    scene.write_text(f"""#version 3.7;
global_settings {{ assumed_gamma 1 }}
#include "frond_far.inc"
fog {{ fog_type 2 distance {haze}*Frond_Unit fog_offset 0 fog_alt 8*Frond_Unit rgb 0.8 }}
Far_Air(<0, 1.6, 0>, <0.8, 0.8, 0.8>, {haze})
camera {{ location 1.6*y*Frond_Unit look_at <0, {height}, {metres}>*Frond_Unit angle 0.1 }}
plane {{ z, {metres}*Frond_Unit hollow texture {{ pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 }} }} texture {{ Far_Veil }} }}
""")
    picture = picture_of(scene, [], folder)
    return linear(mean(picture)) / 0.8


WATER = """#version 3.7;
#include "frond_water.inc"
#declare Water_Ridge = 0;
#declare Water_Backdrop = array[1]{<0.01, 0.2, 0.3, 0>};
#declare Water_Direct = <0.37, 0.19, 0.17>;
#declare Water_Backscatter = <0.28, 0.187, 0.174>;
global_settings { assumed_gamma 1 ambient_light rgb 1 }
"""
DIRECT, BACKSCATTER, HAZE = (0.37, 0.19, 0.17), (0.28, 0.187, 0.174), (0.01, 0.2, 0.3)


def through_water(folder, metres, lit=False):
    """Red, green and blue of a white patch so far away that shines by itself or is lit by a strobe beside the camera;
    0: the water without it."""
    scene = folder / "water.pov"
    finish = "ambient 0 diffuse 1" if lit else "ambient 0 diffuse 0 emission 1"
    patch = (f"disc {{ {metres}*z*Frond_Unit, z, 5*Frond_Unit pigment {{ rgb 1 }} finish {{ {finish} }} }}" if metres else "")
    strobe = f"#declare Water_Strobes = array[1]{{<0, 0, 0>}};\nWater_Strobe(z, 100, <1, 1, 1>*{metres**2 if lit else 0})\n"
    haze = "rgb <0, 0, 0>" if lit else "rgb <0.01, 0.2, 0.3>"
    scene.write_text(WATER + f'Water_Setting(<0, 0, 0>, {haze}, 5, y, rgb 0, 0, "")\n' + strobe + patch +
                     "\ncamera { location 0 look_at z angle 0.5 }\n")
    return [linear(c) for c in picture_of(scene, [], folder)[WIDTH * HEIGHT // 2 + WIDTH // 2]]


def mirror_in_water(folder, metres):
    """Red, green and blue of a mirror so far away that shows endless water."""
    scene = folder / "mirror.pov"
    scene.write_text(WATER + f"""Water_Setting(<0, 0, 0>, rgb <0.01, 0.2, 0.3>, 5, y, rgb 0, 0, "")
disc {{ {metres}*z*Frond_Unit, -z + 0.3*y, Frond_Unit pigment {{ rgb 0 }} finish {{ ambient 0 diffuse 0 reflection 1 }} }}
camera {{ location 0 look_at z angle 0.5 }}
""")
    return [linear(c) for c in picture_of(scene, [], folder)[WIDTH * HEIGHT // 2 + WIDTH // 2]]


def surface_over_water(folder, metres):
    """Red, green and blue of the surface so far above a camera that looks up, without the water's own light."""
    scene = folder / "surface.pov"
    scene.write_text(WATER.replace("<0.01, 0.2, 0.3, 0>", "<0, 0, 0, 0>") + f"#declare Water_Depth = {metres};\n" + """Water_Setting(<0, 0, 0>, rgb <0, 0, 0>, 5, y, rgb 0, 0, "")
Water_Surface(<0, 0, 0>, rgb <0.1, 0.1, 0.1>)
camera { location 0 look_at y sky z angle 0.1 }
""")
    return [linear(c) for c in picture_of(scene, [], folder)[WIDTH * HEIGHT // 2 + WIDTH // 2]]


def leaf_in_light(folder, texture, behind, turned=False):
    """Red, green and blue of a leaf of one colour with the sun before it or behind it, or of the other side of the leaf."""
    (folder / "leaf.ppm").write_bytes(b"P6 2 2 255 " + bytes([125, 150, 110] * 4))
    subprocess.run(["ffmpeg", "-loglevel", "error", "-y", "-i", folder / "leaf.ppm", folder / "leaf.png"], check=True)
    scene = folder / "leaf.pov"
    scene.write_text(f"""#version 3.7;
global_settings {{ assumed_gamma 1 }}
#include "frond_tree.inc"
#include "frond_copy.inc"
light_source {{ z*{9 if behind else -9}, rgb 1 parallel }}
camera {{ orthographic location -3*z look_at 0 right x up 0.75*y }}
#declare Whole = pigment {{ Copy_File("leaf.png", 0) }}
#declare Half = pigment {{ Copy_File("leaf.png", 0.5) }}
#local F = array[1] {{ Whole }}
#local H = array[1] {{ Half }}
mesh2 {{
  vertex_vectors {{ 4, <-2, -2, 0>, <2, -2, 0>, <2, 2, 0>, <-2, 2, 0> }}
  uv_vectors {{ 4, <0.1, 0.1>, <0.9, 0.1>, <0.9, 0.9>, <0.1, 0.9> }}
  face_indices {{ 2, <0, 1, 2>, <0, 2, 3> }}
  texture {{ {texture} }}
  rotate {180 if turned else 0}*y
}}
""")
    return [linear(c) for c in picture_of(scene, [], folder)[WIDTH * HEIGHT // 2]]


def main():
    good = True
    with tempfile.TemporaryDirectory() as where:
        folder = pathlib.Path(where)
        film = render("tests/presets/tiny_film.json", [1, 2, 4, 6], folder / "film")
        for frame, picture in film.items():
            good &= check(f"frame {frame} is not blank", deviation(picture) > 12, f"{deviation(picture):.1f}")
            good &= check(f"frame {frame} is neither dark nor burnt out", 40 < mean(picture) < 200, f"{mean(picture):.1f}")
        for a, b in [(1, 2), (2, 4), (4, 6)]:
            moved = difference(film[a], film[b])
            good &= check(f"frames {a} and {b} differ", 0.5 < moved < 60, f"{moved:.2f}")
        # The air takes exp(-distance / haze) of what is far off, whether the fog near the ground does it or not.
        for metres, height in [(300, 0), (300, 40), (2000, 20), (6000, 300), (12000, 900)]:
            light = air_before(folder, metres, height, 6000)
            lost = 1 - math.exp(-math.hypot(metres, height) / 6000)
            good &= check(f"air over {metres} m", abs(light - lost) < 0.012, f"{light:.3f}, {lost:.3f} expected")
        # Water takes of each colour its own share and adds a veil; of a strobe's light it takes on both ways.
        for metres in (1, 2, 4, 8):
            law = [math.exp(-c * metres) + veil * (1 - math.exp(-k * metres)) for c, k, veil in zip(DIRECT, BACKSCATTER, HAZE)]
            seen = through_water(folder, metres)
            good &= check(f"a white patch in water, {metres} m away", all(abs(a - b) < 0.02 * b + 0.002 for a, b in zip(seen, law)),
                          " ".join(f"{a:.3f} ({b:.3f})" for a, b in zip(seen, law)))
            law = [math.exp(-2 * c * metres) for c in DIRECT]
            seen = through_water(folder, metres, lit=True)
            good &= check("the same by strobe", all(abs(a - b) < 0.02 * b + 0.002 for a, b in zip(seen, law)),
                          " ".join(f"{a:.3f} ({b:.3f})" for a, b in zip(seen, law)))
        seen = through_water(folder, 0)
        good &= check("endless water shows its backdrop", all(abs(a - b) < 0.03 * b + 0.002 for a, b in zip(seen, HAZE)),
                      " ".join(f"{a:.3f}" for a in seen))
        seen = mirror_in_water(folder, 2)
        law = [veil * (math.exp(-2 * c) + 1 - math.exp(-2 * k)) for c, k, veil in zip(DIRECT, BACKSCATTER, HAZE)]
        good &= check("and what is glossy reflects it", all(abs(a - b) < 0.03 * b + 0.002 for a, b in zip(seen, law)),
                      " ".join(f"{a:.3f} ({b:.3f})" for a, b in zip(seen, law)))
        # So it does of the sky that stands in the surface, where one looks up.
        near, far = (surface_over_water(folder, metres) for metres in (4, 6))
        fades = [-math.log(b / a) / 2 for a, b in zip(near, far)]
        good &= check("the surface fades with depth", all(abs(a - b) < 0.04 * b for a, b in zip(fades, DIRECT)),
                      " ".join(f"{a:.3f}" for a in fades))
        # Light that comes through a leaf has lost blue and is greener; before the sun the leaf is as it was.
        for name, plain, lit in [("tree", 'Tree_Leaf("leaf.png",1) Plant_Luster(0.4,0)', 'Tree_Lit("leaf.png",1,0.4,1,0,0)'),
                                 ("copy", "Copy_Picture(F,<0,1,1>,0.4,0)", "Copy_Lit(F,H,<0,1,1>,0.4,0,1)")]:
            for behind, expected in [(False, (1, 1, 1)), (True, (0.95, 1.15, 0.3))]:
                light = [a / b for a, b in zip(*(leaf_in_light(folder, how, behind) for how in (lit, plain)))]
                good &= check(f"a {name}'s leaf {'against' if behind else 'before'} the sun",
                              all(abs(a / b - 1) < 0.04 for a, b in zip(light, expected)), " ".join(f"{a:.3f}" for a in light))
        # Both of its sides throw light back and let it through.
        sided = 'Tree_Lit("leaf.png",1,0.4,1,0,0) } interior_texture { Tree_Lit_Under("leaf.png",1,0.4,1,0)'
        for behind in (False, True):
            sides = [leaf_in_light(folder, sided, behind, turned) for turned in (False, True)]
            good &= check(f"both sides of a leaf {'against' if behind else 'before'} the sun",
                          all(abs(a / b - 1) < 0.02 for a, b in zip(*sides)) and min(sides[0]) > 0.01,
                          " ".join(f"{a:.3f} ({b:.3f})" for a, b in zip(*sides)))
        # The qualities bring what they cost: errors of the root of the mean square against 49 samples in each pixel.
        flags = {quality: re.search(r"^flags = (.*)$", frond_flags(folder / quality, quality), re.MULTILINE)[1].split()
                 for quality in ("draft", "good", "best")}
        reference = picture_of(folder / "film/frames/frame_0004.pov", ["+A0.0", "+AM1", "+R7", "-J"], folder)
        errors = {quality: distance(picture_of(folder / "film/frames/frame_0004.pov", how, folder), reference)
                  for quality, how in flags.items()}
        good &= check("draft is near enough", errors["draft"] < 9, f"{errors['draft']:.2f}")
        good &= check("good is nearer", errors["good"] < 0.75*errors["draft"], f"{errors['good']:.2f}")
        good &= check("best is nearest", errors["best"] < 0.75*errors["good"], f"{errors['best']:.2f}")
        # Soft light is what POV-Ray finds by its own radiosity, with three bounces.
        ours = render("tests/presets/tiny_light.json", [1], folder / "light")[1]
        own = folder / "own"
        own.mkdir()
        (own / "frond_light.inc").write_text(OWN_LIGHT)
        theirs = picture_of(folder / "light/frames/frame_0001.pov", ["+A0.3"], folder, own)
        shaded = [i for i, p in enumerate(theirs) if sum(p) < 3*60]
        bright = [mean([picture[i] for i in shaded]) for picture in (ours, theirs)]
        good &= check("light is POV-Ray's own", distance(ours, theirs) < 10, f"{distance(ours, theirs):.1f}")
        good &= check("so are shadows", abs(bright[0]/bright[1] - 1) < 0.25, f"{bright[0]:.1f} against {bright[1]:.1f}")
        # Copies of a trunk are as bright next to the camera as farther away, and all over.
        trunks = render("tests/presets/trunks.json", [1], folder / "trunks")[1]
        sides = [[linear(sum(trunks[row*WIDTH + column])/3) for row in range(12, 25) for column in columns]
                 for columns in (range(11, 20), range(47, 49))]
        near, away = (sum(side)/len(side) for side in sides)
        good &= check("a near trunk is as bright as another", abs(near/away - 1) < 0.2, f"{near:.3f} against {away:.3f}")
        good &= check("and all over", min(sides[0]) > 0.6*near, f"{min(sides[0]):.3f}")
        # A frame with a shutter is the mean, in light, of its exposures, and what moves leaves a trail.
        blurred = folder / "blurred"
        sets = ["/scene/camera/shutter=1", "/scene/camera/shutter_samples=3"]
        subprocess.run([frond, "generate", source / "tests/presets/tiny_film.json", "-o", blurred, "-q", "--frames", "4-4"] +
                       [w for s in sets for w in ("--set", s)], check=True)
        subprocess.run(["ninja", "-C", blurred, "frames/frame_0004.png"], check=True, capture_output=True,
                       env={**os.environ, "FROND_BIN": frond})
        parts = [picture_of(blurred / f"frames/frame_0004{end}.pov", ["+A0.15", "+AM1", "+R2", "-J"], folder)
                 for end in ("", "_s2", "_s3")]
        expected = [tuple(encoded(sum(linear(p[i][c]) for p in parts) / 3) for c in range(3)) for i in range(len(parts[0]))]
        apart = distance(png_of(blurred / "frames/frame_0004.png"), expected)
        trail = distance(parts[0], parts[2])
        good &= check("a blurred frame is the mean of its exposures", apart < 0.2 * trail, f"{apart:.2f}")
        good &= check("which differ", trail > 2, f"{trail:.1f}")
        # Where a film goes from one stretch of its way to the next, and copies to other levels, nothing pops.
        # Every pixel takes nine samples, or leaves thinner than it would flicker by themselves.
        walk = render("tests/images/walk.json", range(22, 28), folder / "walk", ("+A0.0", "+AM1", "+R3", "-J"))
        steps = {frame: distance(walk[frame], walk[frame + 1]) for frame in range(22, 27)}
        usual = max(step for frame, step in steps.items() if frame != 24)
        good &= check("nothing pops on the way", 0 < steps[24] < 1.2 * usual, f"{steps[24]:.1f}, else {usual:.1f}")
        # Water is blue: above the reef there is more blue than red, and it fades toward the light.
        sky = film[6][:WIDTH * 8]
        blue, red = (sum(p[c] for p in sky) / len(sky) for c in (2, 0))
        good &= check("the water is blue", blue > red + 30, f"{blue:.0f} against {red:.0f}")

        # The coral stands out: the still without it is another picture.
        still = render("tests/presets/tiny_still.json", [1], folder / "still")[1]
        black = sum(1 for p in still if max(p) < 6)
        good &= check("no black specks", black == 0, f"{black} pixels")
        red = [p for p in still if p[0] > p[2] + 40]
        good &= check("the coral stands out from the water and the sand", len(red) > 60, f"{len(red)} pixels")

        # Out of focus a frame is as much blurred by POV-Ray's lens as by the rays that resolving traces through its own.
        lenses = {}
        for stop, resolve in [(0.5, "--resolve"), (0.5, "--no-resolve"), (1, "--no-resolve")]:
            out = folder / f"lens_{stop}{resolve}"
            subprocess.run([frond, "render", source / "tests/presets/tiny_still.json", "-o", out, "--quality", "good", resolve,
                            "--set", f"/scene/camera/aperture={stop}", "--set", "/scene/camera/focus=[0, 0.3, 1.2]"],
                           check=True, capture_output=True)
            lenses[stop, resolve] = png_of(out / "still.png")
        same, half = (distance(lenses[0.5, "--resolve"], lenses[stop, "--no-resolve"]) for stop in (0.5, 1))
        good &= check("both lenses are as wide", same < 0.6 * half, f"{same:.1f}, half as wide {half:.1f}")

        # A rock as triangles and as POV-Ray's own isosurface are the same body, but for a share of a pixel round it.
        for field in ("gaussian", "soft", "cubic"):
            sets = [f"/organisms/0/field={field}"]
            mesh = render("tests/presets/rock.json", [1], folder / field, sets=sets)[1]
            native = render("tests/presets/rock.json", [1], folder / f"{field}_native",
                            sets=sets + ["/organisms/0/native=true"])[1]
            body = sum(1 for p in mesh if p[0] > p[2] + 25)
            apart = sum(1 for p, q in zip(mesh, native) if (p[0] > p[2] + 25) != (q[0] > q[2] + 25))
            good &= check(f"the {field} rock is there", 300 < body < WIDTH * HEIGHT / 2, f"{body} pixels")
            good &= check("its isosurface is the same body", apart < 0.03 * body, f"{apart} pixels apart")
    return 0 if good else 1


sys.exit(main())
