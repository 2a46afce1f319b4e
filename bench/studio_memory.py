#!/usr/bin/env python3
"""What memory the studio's server takes in the course of a session.

Usage: bench/studio_memory.py FROND PRESET MINUTES [OPTION...]

Starts `frond studio PRESET OPTION...` and asks what its page asks while somebody works: a slider is dragged, the film is played,
other seeds are tried, and again, each request after the answer to the last. An hour of work is reckoned as 30 drags of 12 steps,
30 times the film of 48 moments and 30 seeds. Prints how much memory the process takes after each turn.
"""

import http.client
import json
import os
import re
import subprocess
import sys

STEPS, MOMENTS = 12, 48  # of a drag; of the film when it is played


class Studio:
    def __init__(self, frond, preset, options):
        self.process = subprocess.Popen([frond, "studio", preset, *options], stdout=subprocess.PIPE, text=True)
        self.port, self.token = re.search(r":(\d+)/#token=(\w+)", self.process.stdout.readline()).groups()
        self.line = http.client.HTTPConnection("127.0.0.1", int(self.port), timeout=3600)
        self.number, self.have = 0, []

    def ask(self, method, path, body=None):
        headers = {"X-Frond-Token": self.token, "Content-Type": "application/json"}
        self.line.request(method, path, json.dumps(body) if body is not None else None, headers)
        answer = self.line.getresponse()
        return answer.status, answer.read()

    def scene(self, text, file, time):
        """Asks as the page does, which keeps the parts that it was sent last."""
        self.number += 1
        question = {"doc": {"text": text, "file": file}, "time": time, "have": self.have, "solo": None, "hide": [], "ask": None}
        status, answer = self.ask("POST", f"/api/scene?session=bench&seq={self.number}", question)
        if status != 200:
            raise SystemExit(f"{status}: {answer[:400]}")
        length = int.from_bytes(answer[4:8], "little")
        header = json.loads(answer[8 : 8 + length])
        self.have = [part["id"] for part in header["parts"]]
        return header

    def memory(self):
        """MB now, and at most so far."""
        with open(f"/proc/{self.process.pid}/status", encoding="utf-8") as file:
            status = file.read()
        return [int(re.search(name + r":\s+(\d+) kB", status)[1]) // 1024 for name in ("VmRSS", "VmHWM")]

    def seconds(self):
        """Of processor, so far."""
        with open(f"/proc/{self.process.pid}/stat", encoding="utf-8") as file:
            fields = file.read().rsplit(")", 1)[1].split()
        return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def sliders(text):
    """Places of numbers that a slider may move."""
    return [m.span(2) for m in re.finditer(r'"(height|size|length)": (\d+\.\d+)', text)]


def main():
    frond, preset, minutes, *options = sys.argv[1:]
    studio = Studio(frond, preset, options)
    start = json.loads(studio.ask("GET", "/api/start")[1])["preset"]
    text, file = start["text"], start["file"]
    header = studio.scene(text, file, 0)
    end = header["film"]["seconds"]
    places = sliders(text)

    def tell(what):
        now, most = studio.memory()
        kept = json.loads(studio.ask("GET", "/api/ping")[1]).get("kept", 0) >> 20
        print(f"{what:<24}{now:>7} MB now{most:>7} MB at most{kept:>7} MB kept{studio.seconds():>8.0f} s of processor", flush=True)

    tell("opened")
    for turn in range(max(1, round(float(minutes) / 2))):
        if places:
            begin, stop = places[turn % len(places)]
            for step in range(STEPS):
                value = float(text[begin:stop]) * (0.8 + 0.4 * step / STEPS + 0.001 * turn)
                studio.scene(f"{text[:begin]}{value:.4g}{text[stop:]}", file, 0)
        tell(f"{2 * turn + 1} min: a slider")
        for moment in range(MOMENTS):
            studio.scene(text, file, end * moment / MOMENTS)
        tell(f"{2 * turn + 1} min: the film")
        studio.scene(re.sub(r'"seed": \d+', f'"seed": {1000 + turn}', text, count=1), file, end / 2)
        tell(f"{2 * turn + 2} min: a seed")
    studio.process.terminate()
    studio.process.wait()


main()
