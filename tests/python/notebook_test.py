#!/usr/bin/env python3
"""Checks the form of a notebook and runs its cells.

    tests/python/notebook_test.py NOTEBOOK PACKAGES
"""
import pathlib
import sys

import matplotlib

matplotlib.use("Agg")
import nbformat  # noqa: E402

file = pathlib.Path(sys.argv[1]).resolve()
sys.path.insert(0, sys.argv[2])
notebook = nbformat.read(file, as_version=4)
nbformat.validate(notebook)
names = {}
for cell in notebook.cells:
    if cell.cell_type == "code":
        assert not cell.outputs, "a notebook is committed without what it gave"
        exec(compile(cell.source, f"{file.name}:{cell.id}", "exec"), names)
if len(sys.argv) > 3:
    matplotlib.pyplot.savefig(sys.argv[3], dpi=100)
