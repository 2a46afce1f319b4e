"""Holds trees for laser scans against each other, read by nothing of ours: python3 leaves.py FILE.obj ...

Of all files the area of the leaves and the share of vertical rays that reach the ground are those of the last
within a tenth; materials have the same names in all, those of the .mtl, where each has a colour and none a
picture."""
import collections
import random
import sys

REACH, RAYS, CELL = 2.0, 6000, 0.1


def read(name):
    v, triangles, now = [], [], ""
    for line in open(name):
        w = line.split()
        if w[:1] == ["v"]:
            v.append(tuple(map(float, w[1:4])))
        if w[:1] == ["usemtl"]:
            now = w[1]
        if w[:1] == ["f"]:
            triangles.append((now, [v[int(c.split("/")[0]) - 1] for c in w[1:4]]))
    return triangles


def check_materials(obj, used):
    colored, named = set(), ""
    for line in open(obj[:-4] + ".mtl"):
        w = line.split()
        if w[:1] == ["newmtl"]:
            named = w[1]
        if w[:1] == ["Kd"]:
            colored.add(named)
        assert not w or not w[0].startswith("map_"), "a leaf that only a picture makes a leaf"
    assert used <= colored, (used, colored)


def measure(triangles):
    area, longest, cells = 0, 0, collections.defaultdict(list)
    for material, (a, b, c) in triangles:
        if "branches" not in material:
            u, w = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
            cross = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
            area += 0.5 * sum(x * x for x in cross) ** 0.5
            longest = max(longest, sum(x * x for x in u) ** 0.5)
        x, z = [p[0] for p in (a, b, c)], [p[2] for p in (a, b, c)]
        for i in range(int(min(x) // CELL), int(max(x) // CELL) + 1):
            for k in range(int(min(z) // CELL), int(max(z) // CELL) + 1):
                cells[i, k].append((a, b, c))
    random.seed(2)
    free = 0
    for _ in range(RAYS):
        x, z = random.uniform(-REACH, REACH), random.uniform(-REACH, REACH)
        for t in cells.get((int(x // CELL), int(z // CELL)), []):
            d = [(p[0] - x) * (q[2] - z) - (p[2] - z) * (q[0] - x) for p, q in zip(t, (t[1], t[2], t[0]))]
            if min(d) >= 0 or max(d) <= 0:
                break
        else:
            free += 1
    return area, free / RAYS, longest


names, measured = [], []
for obj in sys.argv[1:]:
    triangles = read(obj)
    names.append({material for material, _ in triangles})
    check_materials(obj, names[-1])
    measured.append(measure(triangles))
    print("%s: %d triangles, leaves %.2f m2, gaps %.3f, longest edge %.3f m" % (obj, len(triangles), *measured[-1]))
assert all(n == names[-1] for n in names), names
assert any("branches" in n for n in names[0]) and any("branches" not in n for n in names[0]), names[0]
for area, gaps, longest in measured:
    assert abs(area / measured[-1][0] - 1) < 0.1, (area, measured[-1])
    assert abs(gaps / measured[-1][1] - 1) < 0.1, (gaps, measured[-1])
    assert longest >= measured[-1][2], "the last is the finest"
# Its leaves are 0.3 of a sprig of 0.22 m, and vary.
assert 0.05 < measured[-1][2] < 0.09, measured[-1]
