"""Films: starts the program `frond render`, which generates frames and has POV-Ray draw them."""

import os
import pathlib
import re
import subprocess
from types import TracebackType
from typing import Callable, Iterator, List, Optional, Tuple, Type, Union

from .home import home, program
from .presets import Path, Preset

_OF = re.compile(r"^frame (\d+) of (\d+)")


class Render:
    """A render that runs. Iterating waits and gives what it says, line by line; leaving a `with` block stops it.

    Frames that are finished stay: the same call goes on with the others.
    """

    def __init__(self, words: List[str], out: pathlib.Path) -> None:
        self.out = out
        """The folder it writes to."""
        self.lines: List[str] = []
        """What it has said so far."""
        files = home()
        environment = {**os.environ, **({"FROND_HOME": str(files)} if files else {})}
        self._process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE,
                                         env=environment, text=True, encoding="utf-8", errors="replace")

    def __iter__(self) -> Iterator[str]:
        assert self._process.stderr
        for line in self._process.stderr:
            self.lines.append(line.rstrip("\n"))
            yield self.lines[-1]

    def wait(self, progress: Optional[Callable[[int, int], None]] = None) -> pathlib.Path:
        """Waits for its end and returns the film, or the picture of a still; RuntimeError where there is none.

        `progress(done, all)` is called with numbers of frames.
        """
        try:
            for line in self:
                found = _OF.match(line)
                if progress and found:
                    progress(int(found[1]), int(found[2]))
        except BaseException:
            self.stop()
            raise
        self._process.communicate()
        if self._process.returncode != 0:
            raise RuntimeError("\n".join(self.lines) or f"frond render ended with {self._process.returncode}")
        still = self.out / "still.png"
        return still if still.exists() else next(self.out.glob("film.*"))

    def stop(self) -> None:
        """Ends it, with the frames that POV-Ray is at, as an interrupt from the keyboard does."""
        if self._process.poll() is None:
            self._process.terminate()
        self._process.communicate()

    def __enter__(self) -> "Render":
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.stop()


def render(preset: Union[Preset, Path], out: Path, *, frames: Optional[Tuple[int, int]] = None,
           size: Optional[Tuple[int, int]] = None, quality: Optional[str] = None, format: str = "mp4",
           jobs: int = 0) -> Render:
    """Starts to render a preset into a folder: `frond.render(preset, "out/reef").wait()`.

    `frames` are the first and the last, `size` width and height in pixels, `quality` is draft, good or best; `jobs` is how
    many processors render, 0 all.
    """
    folder = pathlib.Path(out)
    words = [str(program()), "render", *(preset.words(folder) if isinstance(preset, Preset) else [os.fspath(preset)])]
    words += [f"--out={folder}", f"--format={format}"]
    if jobs:
        words.append(f"--jobs={jobs}")
    if frames:
        words.append(f"--frames={frames[0]}-{frames[1]}")
    if size:
        words.append(f"--size={size[0]}x{size[1]}")
    if quality:
        words.append(f"--quality={quality}")
    return Render(words, folder)
