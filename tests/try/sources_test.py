"""The sources that docs/try/CMakeLists.txt lists are enough: what they include has its source among them.

  sources_test.py ROOT

Only a linker knows all that is missing, and that takes emscripten; most of it is a header whose source was forgotten.
"""
import pathlib
import re
import sys

# Included for what their headers define alone, or defined by docs/try/engine for a browser.
LEFT_OUT = set("""appearance/appearance core/mask core/parallel creeping/crawl creeping/swing creeping/triangle_surface
geometry/girth geometry/obj geometry/polygon geometry/polygon_mesh geometry/tubes images/bark images/raster images/read_picture
images/tiling_noise land/ground land/scatter land/sow motion/fall motion/motion motion/sway motion/wind organisms/colony
organisms/grower organisms/kinds organisms/tree/topple world/obstacles world/specimen world/territory world/world""".split())

root = pathlib.Path(sys.argv[1])
text = (root / "docs/try/CMakeLists.txt").read_text(encoding="utf-8")
patterns = [f"gen/*/{name}.cpp" for name in re.search(r"foreach\(file (.*?)\)\n  file\(GLOB", text, re.DOTALL)[1].split()]
patterns += re.search(r"file\(GLOB sources .*?engine/\*\.cpp (.*?)\)", text, re.DOTALL)[1].replace("${root}/", "").split()
sources = {file for pattern in patterns for file in root.glob(pattern)}
assert len(sources) > 100, f"only {len(sources)} sources are found"
files, users = [*sources, *root.glob("docs/try/engine/*.cpp")], {}
for file in files:
    for header in re.findall(r'^#include "(\S+)\.h"', file.read_text(encoding="utf-8"), re.MULTILINE):
        if header not in users:
            users[header] = file.name
            files += root.glob(f"gen/*/{header}.h")
missing = {header for header in users if not sources.issuperset(root.glob(f"gen/*/{header}.cpp"))}
for header in sorted(missing - LEFT_OUT):
    print(f"docs/try/CMakeLists.txt lacks {header}.cpp, whose header {users[header]} includes")
for header in sorted(LEFT_OUT - missing):
    print(f"{header} is not missing")
sys.exit(missing != LEFT_OUT)
