"""How well a farm is used, by its nodes and by the frames of a task: a simulation, with what was measured of Frond and of Slurm.

Usage: bench/farm_simulation.py [PLOT.svg]

Prints a table, and draws it. A film of 24,000 frames goes to up to 1,000 nodes of one slot. A slot that is free waits for the
queue, which starts so many tasks a second; a task takes the tool and what others have grown from the shared disk, generates, and
renders its frames; each picture goes to the shared disk, which serves one after the other. Nodes die, which the queue notices
late, and what their task had not finished begins anew. Efficiency is the time of POV-Ray alone over what all nodes spent
until the film was rendered.
"""

import heapq
import random
import sys

FRAMES = 24000
# Seconds that POV-Ray takes for a frame, on the mean; that frond takes where nothing is grown yet, and where models are there;
# for the text of a frame; bytes of the models. Within a film frames differ as those of the reef do, which begins light.
FILMS = {
    "reef, draft: 4 s a frame": (4.0, 0.3, 0.3, 0.1, 0.0),
    "reef, good: 35 s a frame": (35.0, 0.3, 0.3, 0.1, 0.0),
    "wood, good: 330 s a frame": (330.0, 27.0, 2.0, 0.5, 0.98e9),
}
SPREAD = (0.45, 1.25)  # of the first frame and of the last, as parts of the mean; and by chance
CHANCE = 0.12
START = 0.55  # seconds from a slot that falls free to its next task's first line (Slurm 22.05, two nodes)
STARTED = 50.0  # tasks that the queue starts a second, on all nodes together
TOOL, PICTURE, SHARED = 6.7e6, 0.4e6, 500e6  # bytes of the tool and of a picture; bytes a second of the disk
DEATHS, NOTICED = 1 / (30 * 86400), 150.0  # of a node a second; seconds until its task is begun again elsewhere

NODES = [1, 2, 5, 10, 20, 50, 100, 200, 500, 1000]
CHUNKS = [1, 2, 4, 8, 16, 32]


def simulate(film, nodes, chunk):
    """The efficiency of one film, one farm and one size of tasks."""
    mean, grow, again, write, models = film
    chance = random.Random(7)
    first, last = SPREAD
    middle = (first + last) / 2
    seconds = [
        mean * (first + (last - first) * frame / FRAMES) / middle * chance.lognormvariate(-CHANCE**2 / 2, CHANCE)
        for frame in range(FRAMES)
    ]
    tasks = [(0.0, frame, min(frame + chunk, FRAMES)) for frame in range(0, FRAMES, chunk)]
    heapq.heapify(tasks)
    slots = [0.0] * nodes
    queue = disk = end = 0.0
    grown = float("inf")  # when the first task has brought its models
    while tasks:
        ready, begin, until = heapq.heappop(tasks)
        queue = max(heapq.heappop(slots), ready, queue + 1 / STARTED)
        shared = queue > grown
        disk = max(disk, queue + START) + (TOOL + (models if shared else 0)) / SHARED
        now = disk + (again if shared else grow) + write * (until - begin)
        grown = min(grown, now)
        dies = queue + chance.expovariate(DEATHS)
        for frame in range(begin, until):
            now += seconds[frame] + PICTURE / SHARED
            if now > dies:
                heapq.heappush(tasks, (dies + NOTICED, frame, until))
                now = dies + NOTICED
                break
        heapq.heappush(slots, now)
        end = max(end, now)
    return sum(seconds) / (nodes * end)


def plot(tables):
    """A picture of the tables: efficiency above nodes, a panel a film, a line a chunk."""
    wide, high, left, top, gap = 250, 220, 50, 40, 30
    shades = ["#9db7d5", "#6f9bd1", "#3f7cc4", "#2a9d8f", "#e9a23b", "#d1495b"]
    width, height = left + len(tables) * (wide + gap) + 90, top + high + 60
    out = [
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" font-size="12">',
        f'<rect width="{width}" height="{height}" fill="#fff"/>',
    ]
    for panel, (film, rows) in enumerate(tables.items()):
        x0 = left + panel * (wide + gap)
        out.append(f'<text x="{x0}" y="{top - 14}" font-weight="bold">{film}</text>')
        for percent in range(0, 101, 25):
            y = top + high * (1 - percent / 100)
            out.append(f'<path d="M{x0} {y:.1f}h{wide}" stroke="#ddd"/>')
            if panel == 0:
                out.append(f'<text x="{x0 - 6}" y="{y + 4:.1f}" text-anchor="end">{percent} %</text>')
        for which, nodes in enumerate(NODES):
            x = x0 + wide * which / (len(NODES) - 1)
            if nodes in (1, 10, 100, 1000):
                out.append(f'<text x="{x:.1f}" y="{top + high + 18}" text-anchor="middle">{nodes}</text>')
        for chunk, values in rows.items():
            points = " ".join(
                f"{x0 + wide * i / (len(NODES) - 1):.1f},{top + high * (1 - value):.1f}" for i, value in enumerate(values)
            )
            shade = shades[CHUNKS.index(chunk)]
            out.append(f'<polyline points="{points}" fill="none" stroke="{shade}" stroke-width="2"/>')
        out.append(f'<text x="{x0 + wide / 2}" y="{top + high + 40}" text-anchor="middle">nodes</text>')
    for which, chunk in enumerate(CHUNKS):
        x, y = left + len(tables) * (wide + gap), top + 20 * which + 10
        out.append(f'<path d="M{x} {y}h16" stroke="{shades[which]}" stroke-width="3"/>')
        out.append(f'<text x="{x + 22}" y="{y + 4}">--chunk {chunk}</text>')
    return "\n".join(out + ["</svg>\n"])


def main():
    tables = {}
    for film, numbers in FILMS.items():
        print(f"\n{film}: nodes {' '.join(f'{n:>5}' for n in NODES)}")
        tables[film] = {}
        for chunk in CHUNKS:
            tables[film][chunk] = [simulate(numbers, nodes, chunk) for nodes in NODES]
            print(f"  --chunk {chunk:<3}      {' '.join(f'{value:5.0%}' for value in tables[film][chunk])}", flush=True)
    if len(sys.argv) > 1:
        with open(sys.argv[1], "w", encoding="utf-8") as file:
            file.write(plot(tables))


main()
