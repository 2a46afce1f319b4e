#!/usr/bin/env python3
"""The module for Python against the program, and by its own promises.

    tests/python/module_test.py PROGRAM PACKAGES [TEST...]
"""
import contextlib
import io
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import threading
import unittest

import numpy as np

PROGRAM = sys.argv[1]
sys.path.insert(0, sys.argv[2])
import frond  # noqa: E402

ROOT = pathlib.Path(__file__).resolve().parents[2]
TINY = ROOT / "tests/presets/tiny_film.json"


def said(*words):
    return subprocess.run([PROGRAM, *map(str, words)], check=True, capture_output=True, text=True).stdout


class Presets(unittest.TestCase):
    def test_are_read_changed_and_saved(self):
        preset = frond.read(TINY)
        changed = preset.changed({"/film/fps": 12, "/title": "other = \"x\""})
        self.assertEqual((changed.fps, changed.title, changed["/film/fps"]), (12, "other = \"x\"", 12))
        self.assertNotEqual(preset.fps, 12)
        with tempfile.TemporaryDirectory() as folder:
            changed.save(pathlib.Path(folder) / "saved.json")
            self.assertEqual(frond.read(pathlib.Path(folder) / "saved.json").document, changed.document)

    def test_faults_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            file = pathlib.Path(folder) / "wrong.json"
            file.write_text('{"film": {"fps": -1, "frame": 3},\n "organisms": [{"kind": "tre"}]}')
            faults = frond.check(file)
            ended = subprocess.run([PROGRAM, "check", file], capture_output=True, text=True)
            self.assertEqual(ended.returncode, 2)
            self.assertEqual([str(fault) for fault in faults], ended.stderr.splitlines())
            self.assertGreaterEqual(len(faults), 3)
            self.assertRegex(faults[0].where, "wrong.json:1:.*/film")
        self.assertEqual(frond.check(TINY), [])

    def test_of_every_file_are_right(self):
        for file in sorted((ROOT / "presets/garden").glob("*.json")):
            self.assertEqual(frond.check(file), [], file)

    def test_may_name_species_of_fronds_own(self):
        code = "import frond; print(frond.Preset({'organisms': [{'species': 'bush.json'}]}).grow().nodes)"
        bare = {name: value for name, value in os.environ.items() if name != "FROND_HOME"}
        with tempfile.TemporaryDirectory() as folder:
            grown = subprocess.run([sys.executable, "-c", code], env={**bare, "PYTHONPATH": os.path.abspath(sys.argv[2])}, cwd=folder,
                                   capture_output=True, text=True)
            self.assertEqual(grown.stderr, "")
            self.assertGreater(int(grown.stdout), 100)

    def test_schema_and_kinds(self):
        self.assertEqual(json.loads((ROOT / "docs/preset.schema.json").read_text()), frond.schema())
        self.assertIn("coral", frond.kinds())
        self.assertIn("underwater", frond.settings())


class Scenes(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.scene = frond.read(TINY).grow()

    def test_have_the_nodes_of_the_program(self):
        nodes = json.loads(said("info", TINY, "--json"))
        self.assertEqual(self.scene.nodes, sum(len(o.skeleton) for o in self.scene.organisms))
        with tempfile.TemporaryDirectory() as folder:
            ended = subprocess.run([PROGRAM, "generate", TINY, "-o", folder, "--frames", "1"], capture_output=True, text=True,
                                   check=True)
            self.assertIn(f"{self.scene.nodes} nodes", ended.stderr, nodes)

    def test_skeletons_keep_their_laws(self):
        skeleton = max((o.skeleton for o in self.scene.organisms), key=len)
        self.assertEqual(skeleton.position.shape, (len(skeleton), 3))
        self.assertEqual((skeleton.position.dtype, skeleton.parent.dtype), (np.float32, np.int32))
        self.assertTrue((skeleton.parent < np.arange(len(skeleton))).all())
        inner = skeleton.parent >= 0
        steps = np.linalg.norm(skeleton.position[inner] - skeleton.position[skeleton.parent[inner]], axis=1)
        longer = skeleton.distance[inner] - skeleton.distance[skeleton.parent[inner]]
        np.testing.assert_allclose(steps, longer, atol=1e-4)

    def test_arrays_are_views_that_keep_their_owner(self):
        skeleton = frond.read(TINY).grow().organisms[0].skeleton
        first, second = skeleton.position, skeleton.position
        self.assertTrue(np.shares_memory(first, second))
        self.assertFalse(first.flags.writeable or first.flags.owndata)
        copy = first.copy()
        del skeleton, second
        frond.read(TINY).grow()  # what was freed would be written over
        np.testing.assert_array_equal(first, copy)

    def test_poses_grow_and_keep_lengths(self):
        organism = max(self.scene.organisms, key=lambda o: len(o.skeleton))
        film = frond.read(TINY)
        start, end = organism.pose(0), organism.pose(self.scene.time(film.frames))
        self.assertLessEqual(start.front, end.front)
        skeleton = end.skeleton
        there = (skeleton.parent >= 0) & (skeleton.birth < end.front)
        def lengths(at): return np.linalg.norm(at[there] - at[skeleton.parent[there]], axis=1)
        if end.front >= 1:
            np.testing.assert_allclose(lengths(end.position), lengths(skeleton.position), rtol=1e-3, atol=1e-5)

    def test_exports_are_those_of_the_program(self):
        with tempfile.TemporaryDirectory() as folder:
            ours, theirs = pathlib.Path(folder) / "a" / "x.ply", pathlib.Path(folder) / "b" / "x.ply"
            ours.parent.mkdir(), theirs.parent.mkdir()
            self.scene.export(ours, texture=0)
            said("export", TINY, "-o", theirs, "--texture", "0", "-q")
            self.assertEqual(ours.read_bytes(), theirs.read_bytes())

    def test_meshes_are_closed_over_their_indices(self):
        for part in self.scene.meshes(detail=5000):
            self.assertEqual(part.mesh.position.shape, part.mesh.normal.shape)
            self.assertLess(int(part.mesh.triangle.max()), len(part.mesh.position))

    def test_progress_is_told_and_ends_it(self):
        told = []
        frond.read(TINY).grow(lambda *step: told.append(step))
        self.assertTrue(told and all(done <= steps for _, done, steps in told))

        def enough(phase, done, steps):
            raise KeyboardInterrupt
        with self.assertRaises(KeyboardInterrupt):
            frond.read(TINY).grow(enough)

    def test_other_threads_go_on(self):
        preset, went = frond.read(ROOT / "tests/presets/staghorn.json"), []
        growing = threading.Thread(target=lambda: went.append(preset.grow().nodes))
        growing.start()
        turns = 0
        while growing.is_alive():
            turns += 1
        self.assertTrue(went)
        self.assertGreater(turns, 100)

    def test_wrong_calls_are_told(self):
        with self.assertRaisesRegex(frond.FrondError, "expected 1-"):
            self.scene.meshes(frame=10_000)
        with self.assertRaises(frond.FrondError):
            self.scene.export("nothing.xyz")
        with self.assertRaises(KeyError):
            self.scene["nobody"]


class Grammars(unittest.TestCase):
    def test_models_of_cpfg_are_read_as_the_program_reads_them(self):
        file = ROOT / "presets/lsystems/maple.l"
        model = frond.Grammar.read(file)
        word = model.derive()
        self.assertEqual(str(word), said("derive", file).rstrip("\n"))
        self.assertEqual("".join(f"{name} {count}\n" for name, count in sorted(word.counts.items())),
                         said("derive", file, "--format", "counts"))
        with tempfile.TemporaryDirectory() as folder:
            svg = pathlib.Path(folder) / "maple.svg"
            said("turtle", file, "--steps", 3, "--svg", svg)
            self.assertEqual(model.picture(3), svg.read_text())
        figure = model.draw(2)
        measured = json.loads(said("turtle", file, "--steps", 2))
        self.assertGreaterEqual(len(figure.skeleton), measured["segments"])
        with self.assertRaises(frond.FrondError):
            frond.Grammar.read(ROOT / "presets/lsystems/none.l")

    def test_words_are_those_of_the_program(self):
        for file in sorted((ROOT / "presets/grammars").glob("*.json")):
            grammar = frond.Grammar.read(file)
            steps = min(grammar.steps, 4)
            word = grammar.derive(steps, seed=7)
            self.assertEqual(str(word) + "\n", said("derive", file, "--steps", steps, "--seed", 7), file)
            self.assertEqual(len(word), len(word.symbols))
            self.assertEqual(sum(word.counts.values()), len(word))

    def test_pictures_are_those_of_the_program(self):
        file = ROOT / "presets/grammars/dragon.json"
        with tempfile.TemporaryDirectory() as folder:
            svg = pathlib.Path(folder) / "dragon.svg"
            said("turtle", file, "--svg", svg)
            self.assertEqual(frond.Grammar.read(file).picture(), svg.read_text())

    def test_of_a_mapping_and_of_a_preset(self):
        algae = frond.Grammar({"axiom": "A", "rules": ["A -> AB", "B -> A"], "steps": 5})
        self.assertEqual([len(algae.derive(n)) for n in range(8)], [1, 2, 3, 5, 8, 13, 21, 34])
        plants = frond.read(ROOT / "presets/lsystems/bracketed-plant.json").grammars()
        self.assertTrue(plants)
        self.assertGreater(len(plants[-1].draw().skeleton), 10)
        with self.assertRaises(frond.FrondError):
            frond.Grammar({"axiom": "A", "rules": ["A -> ["]})


class Rendering(unittest.TestCase):
    def test_gives_a_picture_and_can_be_stopped(self):
        preset = frond.read(TINY).changed({"/film/size": [64, 36], "/film/frames": 3})
        with tempfile.TemporaryDirectory() as folder:
            told = []
            film = frond.render(preset, pathlib.Path(folder) / "out", quality="draft").wait(lambda *step: told.append(step))
            self.assertTrue(film.read_bytes())
            self.assertEqual(told[-1], (3, 3))
            with frond.render(preset, pathlib.Path(folder) / "other", size=(640, 360), quality="best") as run:
                next(iter(run))
            self.assertFalse((pathlib.Path(folder) / "other" / "film.mp4").exists())
            self.assertEqual(frond.render(preset, pathlib.Path(folder) / "out", quality="draft").wait(), film, "it is there already")
            with self.assertRaisesRegex(frond.FrondError, "missing.json"):
                frond.render(pathlib.Path(folder) / "missing.json", folder)
            with self.assertRaisesRegex(RuntimeError, "is a file"):
                frond.render(preset, TINY).wait()


class Docs(unittest.TestCase):
    def test_examples_run(self):
        text = (ROOT / "docs/python.md").read_text()
        text = text.replace('size=(640, 360), quality="good"', 'size=(32, 18), quality="draft"').replace('"/film/frames": 24', '"/film/frames": 1')
        with tempfile.TemporaryDirectory() as name, contextlib.chdir(name):
            pathlib.Path("presets").symlink_to(ROOT / "presets")
            pathlib.Path("mine.json").write_text('{"film":\n {"fps": -1}}')
            names, said_there = {}, io.StringIO()
            with contextlib.redirect_stdout(said_there):
                for block in re.findall(r"^```py\n(.*?)^```$", text, re.M | re.S):
                    exec(compile(block, "docs/python.md", "exec"), names)
            self.assertIn("/film/fps", said_there.getvalue())
            self.assertTrue(pathlib.Path("birch.glb").stat().st_size)
            self.assertEqual(str(names["word"]), said("derive", ROOT / "presets/grammars/algae.json", "--steps", 6).strip())


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
