"""Holds the levels of detail of a GLB against each other, read by nothing of ours: python3 levels.py FILE.

The boxes of all levels are that of the first within 3 %, the area of the leaves within a fifth, no edge of a
leaf is more than 2.5 times that of the first, and the trunk is nowhere thinner than half; MSFT_lod names nodes
that are there."""
import json
import struct
import sys

data = open(sys.argv[1], "rb").read()
n = struct.unpack_from("<I", data, 12)[0]
g, blob = json.loads(data[20 : 20 + n]), data[28 + n :]


def read(i):
    a = g["accessors"][i]
    view = g["bufferViews"][a["bufferView"]]
    k = {"SCALAR": 1, "VEC2": 2, "VEC3": 3, "VEC4": 4}[a["type"]]
    code, size = {5126: ("f", 4), 5125: ("I", 4), 5123: ("H", 2), 5121: ("B", 1)}[a["componentType"]]
    step = view.get("byteStride", k * size)
    start = view.get("byteOffset", 0) + a.get("byteOffset", 0)
    return [struct.unpack_from("<%d%s" % (k, code), blob, start + j * step) for j in range(a["count"])]


def area(a, b, c):
    u, w = [b[i] - a[i] for i in range(3)], [c[i] - a[i] for i in range(3)]
    cross = (u[1] * w[2] - u[2] * w[1], u[2] * w[0] - u[0] * w[2], u[0] * w[1] - u[1] * w[0])
    return 0.5 * sum(x * x for x in cross) ** 0.5


class Level:
    def __init__(self, node):
        self.places, self.leaves, self.edge, foot = [], 0, 0, []
        for m in self.meshes(node):
            for primitive in g["meshes"][m]["primitives"]:
                p, t = read(primitive["attributes"]["POSITION"]), [i[0] for i in read(primitive["indices"])]
                self.places += p
                if "branches" in g["materials"][primitive["material"]]["name"]:
                    foot += [x[0] for x in p if x[1] < 0.3]
                    continue
                for x in zip(t[::3], t[1::3], t[2::3]):
                    self.leaves += area(*(p[i] for i in x))
                    self.edge = max(self.edge, *(sum((p[x[i]][j] - p[x[i - 1]][j]) ** 2 for j in range(3)) ** 0.5 for i in range(3)))
        self.box = [(min(c), max(c)) for c in zip(*self.places)]
        self.foot = max(foot) - min(foot) if foot else 0

    def meshes(self, node):
        found = [g["nodes"][node]["mesh"]] if "mesh" in g["nodes"][node] else []
        for child in g["nodes"][node].get("children", []):
            found += self.meshes(child)
        return found


chains = [
    [i] + node["extensions"]["MSFT_lod"]["ids"]
    for i, node in enumerate(g["nodes"])
    if "MSFT_lod" in node.get("extensions", {})
]
assert chains, "no node has levels"
for chain in chains:
    assert all(0 <= i < len(g["nodes"]) for i in chain), "a level that is not there"
    first, *others = [Level(i) for i in chain]
    assert others, "one level alone"
    longest = max(high - low for low, high in first.box)
    for number, level in enumerate(others, 1):
        apart = max(abs(a - b) for x, y in zip(first.box, level.box) for a, b in zip(x, y)) / longest
        print("level %d: box %.3f, leaves %.3f, edge %.2f, foot %.2f" % (number, apart,
              level.leaves / first.leaves, level.edge / first.edge, level.foot / first.foot))
        assert apart < 0.03, (number, "box", apart)
        assert abs(level.leaves / first.leaves - 1) < 0.2, (number, "leaves", level.leaves / first.leaves)
        assert level.edge < 2.5 * first.edge, (number, "edge", level.edge / first.edge)
        assert level.foot > 0.5 * first.foot, (number, "trunk", level.foot / first.foot)
