#!/usr/bin/env python3
"""A new kind is a folder and a row, a new setting a pair of files and a row, a new material a row and a macro, a new
format of export a file and a row, a new symbol of the turtle a row and what it does, a new light a row: in a copy of
the tree all are added so, built, and are then in the schema, in `frond list`, and understood by check, info, generate,
export and the manual.

    tests/toy_test.py ROOT
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile

KIND = r'''
#include "organisms/kinds.h"
#include "rocks/stone.h"

namespace frond {

struct ToyParams {
  double size = 0.4;  ///< metres
};

void describe(Properties& v, ToyParams& p) {
  v.number("size", p.size, {.min = 0.01, .max = 10, .unit = "m"}, "How large the toy is");
}

namespace {

class Toy final : public Described<ToyParams, BodyBuilder> {
 public:
  Review review() const override { return {}; }
  Result<SizeEstimate> estimate_size(Seed) const override { return SizeEstimate{}; }
  Result<Model> grow_alone(Seed seed) const override {
    Model model;
    std::uint16_t stone = model.solids.add_shape({stone_surface({seed}, 2), {.matter = Matter::candy}});
    model.solids.place(stone, Vec3(0), Quat(1, 0, 0, 0), Vec3(static_cast<float>(params.size)));
    return model;
  }
};

}  // namespace

Kind<Organism> toy_kind() { return make_grower<Toy>("toy", "Something to play with"); }

}  // namespace frond
'''

SETTING = r'''
#include "settings/settings.h"

namespace frond {

struct Toyshop {
  double shelf = 0.5;  ///< metres
};

void describe(Properties& v, Toyshop& t) {
  v.number("shelf", t.shelf, {.min = 0, .max = 2, .unit = "m"}, "How high things stand");
}

namespace {

class Shelf final : public Grounds {
 public:
  explicit Shelf(double height) : height_(static_cast<float>(height)) {}
  void strew(TakenSpots&) override {}
  float seat(Vec2, double, Seed) override { return height_; }
  Land land(std::vector<Spot>) const override { return {}; }
  std::vector<Specimen> furnishings() const override { return {}; }
  std::vector<std::string> remarks(const std::function<std::vector<Occupied>()>&, const Camera&,
                                   double) const override {
    return {};
  }

 private:
  float height_;
};

}  // namespace

SettingRow toyshop_setting() {
  return setting_row<Toyshop>(
      "toyshop", "a shelf of toys", "toyshop", "The shelf, for toyshop", {"/toyshop"},
      [](const Stage&) { return Extent{}; }, [](const Stage&, const Film&) { return Errors{}; },
      [](const Stage&, const Film&) { return GroundSizeEstimate{}; },
      [](const Stage& stage, const Film&, double, Seed) -> std::unique_ptr<Grounds> {
        return std::make_unique<Shelf>(stage.block<Toyshop>().shelf);
      },
      [](const Stage&) { return Daylight{}; });
}

}  // namespace frond
'''

SETTING_TEXT = r'''
#include "emit/setting.h"

namespace frond {

SettingText toyshop_text() {
  return {{"studio"},
          [](const Scene&, double) -> std::string { return "// a shelf of toys"; },
          [](const PovSpace&, const Scene&) { return std::string(); }};
}

}  // namespace frond
'''

MACRO = r'''
#ifndef (Frond_Candy_Inc)
#declare Frond_Candy_Inc = version;
#version 3.7;
#include "frond_light.inc"
#macro Candy_Stripes(Color, Second, Scale, Relief, Moss, Gloss)
  pigment { gradient x color_map { [0.5 rgb <0.9, 0.05, 0.05>] [0.5 rgb <0.05, 0.05, 0.9>] } scale Scale*Frond_Unit }
  finish { ambient Frond_Ambient diffuse 0.8 }
#end
#version Frond_Candy_Inc;
#end
'''

FORMAT = r'''
#include "export/formats.h"

namespace frond {

Result<bool> write_count(const ExportScene& exported, const ExportOptions&, const std::filesystem::path& path) {
  return write_file(path, std::to_string(exported.meshes.size()) + " meshes\n");
}

}  // namespace frond
'''.replace('#include "export/formats.h"', '#include "core/files.h"\n#include "export/formats.h"')

TEMPLATE = {
    "film": {"frames": 1, "size": [64, 48], "quality": "draft"},
    "scene": {"setting": "toyshop"},
    "organisms": [{"kind": "toy", "name": "toy", "size": 0.5, "place": {"at": [[0, 0]]}}],
}

# What leaps two metres up between two steps of 20 cm.
LEAPING = {
    "film": {"frames": 1},
    "scene": {"setting": "studio"},
    "organisms": [{"kind": "plant", "name": "leaper", "grammar": {"axiom": "F(0.2)@J(2)F(0.2)"},
                   "place": {"at": [[0, 0]], "size_variation": 0, "lean": 0}}],
}

PRESET = {
    "film": {"frames": 1},
    "scene": {"setting": "toyshop", "toyshop": {"shelf": 0.25}},
    "organisms": [{"kind": "toy", "name": "bear", "size": 0.5, "place": {"at": [[0, 0]]}}],
}


def add_row(path, macro, name):
    """One row more, at the end of the list of a macro."""
    text = path.read_text()
    lines = text.split("\n")
    start = next(i for i, line in enumerate(lines) if line.startswith(f"#define {macro}(row)"))
    end = next(i for i in range(start, len(lines)) if not lines[i].endswith("\\"))
    lines[end:end + 1] = [lines[end] + " \\", f"  row({name})"]
    path.write_text("\n".join(lines))


def put_before(path, mark, text):
    """Adds text before the first place of a mark."""
    whole = path.read_text()
    assert mark in whole, f"{path}: {mark}"
    path.write_text(whole.replace(mark, text + mark, 1))


def main():
    root = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as scratch:
        tree = pathlib.Path(scratch) / "frond"
        for part in ("CMakeLists.txt", "CMakePresets.json", "gen", "templates", "povinc", "scripts"):
            source, target = root / part, tree / part
            tree.mkdir(exist_ok=True)
            if source.is_dir():
                shutil.copytree(source, target, ignore=shutil.ignore_patterns("node_modules", "dist"))
            else:
                shutil.copy2(source, target)
        (tree / "docs/kinds").mkdir(parents=True)
        shutil.copy2(root / "docs/kinds/strips.json", tree / "docs/kinds")
        (tree / "gen/scene/organisms/toy").mkdir()
        (tree / "gen/scene/organisms/toy/kind.cpp").write_text(KIND.lstrip())
        add_row(tree / "gen/scene/organisms/kinds.h", "FROND_KINDS", "toy")
        (tree / "gen/scene/settings/toyshop.cpp").write_text(SETTING.lstrip())
        (tree / "gen/output/emit/setting_toyshop.cpp").write_text(SETTING_TEXT.lstrip())
        add_row(tree / "gen/scene/settings/settings.h", "FROND_SETTINGS", "toyshop")
        put_before(tree / "gen/form/model/matter.h", "};\n\n/// What a material is,", "  candy,\n")
        put_before(tree / "gen/form/model/matter.h", "};\n\nconstexpr const MatterRow& row_of",
                   ', {Matter::candy, "candy", "Candy_Stripes", 2}')
        (tree / "povinc/frond_candy.inc").write_text(MACRO.lstrip())
        (tree / "gen/output/export/count.cpp").write_text(FORMAT.lstrip())
        put_before(tree / "gen/output/export/formats.h", "// The texts of the formats",
                   "Result<bool> write_count(const ExportScene&, const ExportOptions&, const std::filesystem::path&);\n")
        put_before(tree / "gen/output/export/formats.cpp", '    {".obj",',
                   '{".count", "how many meshes there are", [](const ExportSize&) { return 10.0; }, kAny, write_count},\n')
        put_before(tree / "gen/growth/grammar/symbols.h", "turn_back, roll_back,", "leap, ")
        put_before(tree / "gen/growth/grammar/symbols.cpp", '    {"F",', '    {"@J", Act::leap, Act::leap, "leap up: @J(metres)"},\n')
        put_before(tree / "gen/growth/grammar/turtle.h", "      case Act::roll_back:",
                   "      case Act::leap:\n        now_.position.y += given ? parameters[0] : 1;\n        return;\n")
        put_before(tree / "gen/scene/settings/studio.cpp", "          {Vec3(0, 3,", "          {Vec3(3, 1, 0), Vec3(0, 0, 0.375f)},\n")
        (tree / "templates/new/toy.json").write_text(json.dumps(TEMPLATE))
        # What was compiled in the tree itself need not be compiled again.
        env = {**os.environ, "XDG_CACHE_HOME": str(tree / "cache"), "CCACHE_BASEDIR": str(tree), "CCACHE_NOHASHDIR": "1"}

        def run(*command, **options):
            done = subprocess.run(command, cwd=tree, env=env, capture_output=True, text=True, **options)
            if done.returncode != 0:
                sys.exit(f"{' '.join(map(str, command))}\n{done.stdout[-4000:]}\n{done.stderr[-4000:]}")
            return done.stdout

        # What it says counts here, not how fast: without optimisation it is built in half the time.
        run("cmake", "--preset", "release", "-DFROND_TESTS=OFF", "-DCMAKE_BUILD_TYPE=None", "-DCMAKE_CXX_FLAGS=-O0")
        run("cmake", "--build", "build", "--target", "frond")
        frond = tree / "build/frond"
        listed = json.loads(run(frond, "list", "--json"))
        assert {"toy", "toyshop", "@J"} <= {row["name"] for row in listed}, "not listed"
        schema = run(frond, "schema")
        for words in ("Something to play with", "How large the toy is", "How high things stand"):
            assert words in schema, f"not in the schema: {words}"
        preset = tree / "toy.json"
        preset.write_text(json.dumps(PRESET))
        run(frond, "check", preset)
        run(frond, "info", preset)
        run(frond, "generate", preset, "-o", tree / "out", "--quiet")
        text = (tree / "out/frames/frame_0001.pov").read_text()
        assert "// a shelf of toys" in text and "mesh2" in text, "the frame has no toy"
        assert '#include "frond_candy.inc"' in text and "Candy_Stripes(" in text, "the toy is not of candy"
        run(frond, "export", preset, "-o", tree / "toy.obj")
        heights = [float(line.split()[2]) for line in (tree / "toy.obj").read_text().splitlines()
                   if line.startswith("v ")]
        assert heights and min(heights) > -0.2 and max(heights) > 0.3, "the toy does not stand on its shelf"
        run(frond, "export", preset, "-o", tree / "toy.count")
        assert (tree / "toy.count").read_text() == "1 meshes\n", "the format is not written"
        pictures = [path.stat().st_size for path in tree.glob("toy_*_color.png")]
        assert len(pictures) == 1, "the export shows no candy"
        preset.write_text(json.dumps(LEAPING))
        run(frond, "generate", preset, "-o", tree / "leap", "--quiet")
        text = (tree / "leap/frames/frame_0001.pov").read_text()
        assert text.count("\nStudio_Lamp(") == 5 and "rgb <0,0,0.375>" in text, "the lamp does not shine"
        run(frond, "export", preset, "-o", tree / "leap.obj")
        highest = max(float(line.split()[2]) for line in (tree / "leap.obj").read_text().splitlines()
                      if line.startswith("v "))
        assert 2.3 < highest < 2.5, f"what leaps is {highest} m high"
        run(frond, "new", "mine", "--from", "toy")
        run(frond, "check", tree / "mine.json")
        run(sys.executable, tree / "scripts/manual.py")
        for page, words in (("kinds/toy.md", "How large the toy is"), ("settings/toyshop.md", "How high things stand")):
            assert words in (tree / "docs" / page).read_text(), f"not in docs/{page}: {words}"
        wrong = dict(PRESET, organisms=[{"kind": "toy", "size": 100}])
        preset.write_text(json.dumps(wrong))
        done = subprocess.run([frond, "check", preset], capture_output=True, text=True)
        assert done.returncode == 2 and "/organisms/0/size" in done.stderr, done.stderr
    print("a kind, a setting, a material, a format, a symbol and a light were added, each by what CONTRIBUTING.md says")


if __name__ == "__main__":
    main()
