"""Where the files of Frond are that are no code: templates, macros and presets, and the program."""

import os
import pathlib
import shutil

PACKAGE = pathlib.Path(__file__).resolve().parent


def home() -> "pathlib.Path | None":
    """$FROND_HOME; what was installed with the package; or the sources that it was built in."""
    given = os.environ.get("FROND_HOME")
    for folder in [pathlib.Path(given)] if given else [PACKAGE / "home", PACKAGE.parents[2]]:
        if (folder / "templates" / "frame.pov").exists():
            return folder
    return None


def program() -> pathlib.Path:
    """The program `frond`: $FROND_PROGRAM, what came with the package or was built beside it, or that of PATH."""
    given = os.environ.get("FROND_PROGRAM")
    for file in [pathlib.Path(given)] if given else [PACKAGE / "bin" / "frond", PACKAGE.parents[1] / "frond"]:
        if os.access(file, os.X_OK):
            return file
    found = shutil.which("frond")
    if not found:
        raise FileNotFoundError("the program frond was not found; set FROND_PROGRAM to it")
    return pathlib.Path(found)


def cache() -> pathlib.Path:
    """Where what may be made again is kept."""
    return pathlib.Path(os.environ.get("XDG_CACHE_HOME") or pathlib.Path.home() / ".cache") / "frond"
