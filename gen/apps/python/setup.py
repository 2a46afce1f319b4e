"""Builds the wheel: CMake builds the shared module and the program, whose files go with them.

    pip wheel --no-deps --no-build-isolation -w out gen/apps/python
"""
import pathlib
import shutil
import subprocess

from setuptools import Distribution, setup
from setuptools.command.build_py import build_py

ROOT = pathlib.Path(__file__).resolve().parents[3]
SCRATCH = ROOT / "build" / "wheel"


class WithProgram(build_py):
    """The package with what CMake builds of it."""

    def run(self):
        subprocess.run(["cmake", "--preset", "release"], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", "--preset", "release", "--target", "frond", "frond_python"], cwd=ROOT, check=True)
        package = pathlib.Path(self.build_lib) / "frond"
        shutil.rmtree(package, ignore_errors=True)
        shutil.copytree(ROOT / "build" / "python" / "frond", package, ignore=shutil.ignore_patterns("__pycache__"))
        for folder in ("templates", "povinc", "presets", "scripts"):
            shutil.copytree(ROOT / folder, package / "home" / folder)
        (package / "bin").mkdir()
        shutil.copy2(ROOT / "build" / "frond", package / "bin")


class Binary(Distribution):
    """A wheel of this machine's kind, not of all."""

    def has_ext_modules(self):
        return True


SCRATCH.mkdir(parents=True, exist_ok=True)
setup(cmdclass={"build_py": WithProgram}, distclass=Binary,
      options={"build": {"build_base": str(SCRATCH)}, "egg_info": {"egg_base": str(SCRATCH)}})
