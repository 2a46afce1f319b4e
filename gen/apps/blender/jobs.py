# SPDX-License-Identifier: GPL-3.0-or-later
"""Growing in the background: one `frond export` at a time, which a timer of Blender's looks after.

`ask` has a root grown after a pause, so that a slider that is drawn grows once; `tick` is the timer. No threads.
"""
import contextlib
import os
import subprocess
import tempfile
import time

import bpy

from . import presets, scene, state

PAUSE = 0.6  # seconds from the last change
TICK = 0.2

_due = {}  # time by name of the root
_running = {}  # Job by name of the root


class Job:
    """One run of the program, with a folder for its file and its messages."""

    def __init__(self, program, root):
        p = root.frond
        self.folder = tempfile.TemporaryDirectory(prefix="frond_")
        self.file = os.path.join(self.folder.name, "grown.glb")
        words = presets.export_words(program, p.preset, self.file, state.changes(root), only=p.only, frame=p.frame, film=p.film,
                                     detail=p.detail, texture=p.texture, instances=p.instances)
        self.said = open(os.path.join(self.folder.name, "said.txt"), "w+", encoding="utf-8")
        self.started = time.monotonic()
        self.process = subprocess.Popen(words, stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=self.said,
                                        env=presets.environment(program), creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0))

    def seconds(self):
        return int(time.monotonic() - self.started)

    def message(self):
        self.said.seek(0)
        return self.said.read().replace(f"{self.file}: ", "").strip() or f"frond ended with {self.process.returncode}"

    def close(self):
        if self.process.poll() is None:
            self.process.terminate()
            self.process.wait()
        self.said.close()
        self.folder.cleanup()


def start(root):
    """Begins to grow a root as it is now; a job of its own that runs is ended."""
    stop(root.name)
    program = state.program()
    if not program:
        raise FileNotFoundError("The program frond was not found")
    _running[root.name] = Job(program, root)
    return _running[root.name]


def grow_now(root):
    """Grows a root and waits for it; gives the job, which is to be closed. Raises ValueError with what the program said."""
    job = start(root)
    del _running[root.name]
    if job.process.wait() != 0:
        message = job.message()
        job.close()
        raise ValueError(message)
    return job


def ask(root, pause=PAUSE):
    """Has a root grown after a pause, which begins again with each call."""
    if root.frond.preset:
        _due[root.name] = time.monotonic() + pause
        if not bpy.app.timers.is_registered(tick):
            bpy.app.timers.register(tick, persistent=True)


def stop(name):
    """Ends the job of a root, if there is one, and forgets that it was asked for."""
    _due.pop(name, None)
    job = _running.pop(name, None)
    if job:
        job.close()


def cancel(root):
    """Ends the growing of a root; one below which nothing has grown yet goes."""
    stop(root.name)
    if not root.children:
        scene.remove(root)


@bpy.app.handlers.persistent
def stop_all(*_):
    """Ends all jobs, as another file is opened."""
    for name in [*_due, *_running]:
        stop(name)
    if bpy.app.timers.is_registered(tick):
        bpy.app.timers.unregister(tick)


def progress(root):
    """What is being done for a root, "" where nothing is."""
    if root.name in _running:
        return f"Growing, {_running[root.name].seconds()} s"
    return "Waits to grow" if root.name in _due else ""


def busy():
    return bool(_due or _running)


def tick():
    """Starts what is due, takes in what has grown; gives when it wants to be called again, None for never."""
    for name, job in list(_running.items()):
        if name in _due and time.monotonic() >= _due[name]:
            job.close()
            del _running[name]
        elif job.process.poll() is not None and bpy.context.mode == "OBJECT":
            del _running[name]
            finish(name, job)
    for name, at in list(_due.items()):
        if not _running and time.monotonic() >= at:
            del _due[name]
            begin(name)
    for window in bpy.context.window_manager.windows:
        for area in window.screen.areas:
            if area.type == "VIEW_3D":
                area.tag_redraw()
    return TICK if busy() else None


def begin(name):
    root = bpy.data.objects.get(name)
    if root:
        try:
            start(root)
        except (OSError, ValueError) as error:
            fail(root, str(error))


def finish(name, job):
    root = bpy.data.objects.get(name)
    try:
        if root and job.process.returncode == 0:
            windows = bpy.context.window_manager.windows
            with bpy.context.temp_override(window=windows[0]) if windows else contextlib.nullcontext():  # timers may have none
                bpy.ops.frond.put("EXEC_DEFAULT", True, root=name, file=job.file)  # with a step of undo
        elif root:
            fail(root, job.message())
    except RuntimeError as error:
        fail(bpy.data.objects[name], str(error))
    finally:
        job.close()


def fail(root, message):
    """Shows what went wrong. What stands stays; a root below which nothing has grown yet goes."""
    root.frond.fault = message
    if not root.children:
        bpy.context.window_manager.frond.message = message
        scene.remove(root)
