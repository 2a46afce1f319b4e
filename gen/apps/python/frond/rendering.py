"""Films: the library generates frames, POV-Ray draws them and ffmpeg makes the film."""

import json
import os
import pathlib
from types import TracebackType
from typing import Callable, Iterator, List, Optional, Tuple, Type, Union

from . import _frond
from .home import program
from .presets import Path, Preset


class Render:
    """A render that runs. Iterating waits and gives what it says, line by line; leaving a `with` block stops it.

    Frames that are finished stay: the same call goes on with the others.
    """

    def __init__(self, run: _frond.Render, out: pathlib.Path) -> None:
        self.out = out
        """The folder it writes to."""
        self.lines: List[str] = []
        """What it has said so far."""
        self._run = run

    def _said(self) -> Iterator[Tuple[str, int, int]]:
        while said := self._run.next():
            self.lines.append(said[0])
            yield said

    def __iter__(self) -> Iterator[str]:
        for line, _, _ in self._said():
            yield line

    def wait(self, progress: Optional[Callable[[int, int], None]] = None) -> pathlib.Path:
        """Waits for its end and returns the film, or the picture of a still; RuntimeError where there is none.

        `progress(done, all)` is called with numbers of frames.
        """
        try:
            for _, done, all_frames in self._said():
                if progress and all_frames:
                    progress(done, all_frames)
        except BaseException:
            self.stop()
            raise
        if not self._run.files:
            raise RuntimeError("\n".join([*self.lines, self._run.fault]))
        return pathlib.Path(self._run.files[0])

    def stop(self) -> None:
        """Ends it, with the frames that POV-Ray is at, as an interrupt from the keyboard does."""
        self._run.stop()

    def __enter__(self) -> "Render":
        return self

    def __exit__(self, kind: Optional[Type[BaseException]], error: Optional[BaseException],
                 trace: Optional[TracebackType]) -> None:
        self.stop()


def render(preset: Union[Preset, Path], out: Path, *, frames: Optional[Tuple[int, int]] = None,
           size: Optional[Tuple[int, int]] = None, quality: Optional[str] = None, format: str = "",
           jobs: int = 0) -> Render:
    """Starts to render a preset into a folder: `frond.render(preset, "out/reef").wait()`.

    `frames` are the first and the last, `size` width and height in pixels, `quality` is draft, good or best; `format` is
    mp4, webm, gif, webp or mov, or what suits; `jobs` is how many processors render, 0 all. FrondError where the preset is wrong.
    """
    source = preset.source() if isinstance(preset, Preset) else (None, os.fspath(preset), {}, None)
    text, file, values, assets = source
    sets = [(pointer, json.dumps(value)) for pointer, value in values.items()]
    if size:
        sets.append(("/film/size", json.dumps(list(size))))
    if quality:
        sets.append(("/film/quality", json.dumps(quality)))
    run = _frond.render(text, file, sets, assets, os.fspath(out), list(frames) if frames else None, format, jobs, program())
    return Render(run, pathlib.Path(out))
