// Branches to which edits give another bark, in exports.

#include <gtest/gtest.h>

#include "core/linear.h"
#include "export/export_scene.h"
#include "exported.h"

namespace frond {
namespace {

/// The mesh of the branches of a plant, with its materials.
ExportScene exported(const std::string& organism, const std::string& edits) {
  const std::string text =
      R"({"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{"name": "one",
  "place": {"at": [[0, 0]], "size_variation": 0, "lean": 0, "turn_variation": 0}, )" +
      organism + (edits.empty() ? "" : R"(, "edits": [)" + edits + "]") + "}]}";
  ExportOptions options{.texture = 0};
  options.bake.home = FROND_ROOT;
  Result<ExportScene> made = export_scene(scene_of_text(text), 0, options);
  EXPECT_TRUE(made) << made.errors()[0].text();
  return std::move(*made);
}

TEST(OtherBark, IsAMaterialOfAllThatIsBeyondThePlace) {
  const std::string cross =
      R"("kind": "plant", "height": 0, "grammar": {"axiom": "FF[+(90)FFFF][-(90)FFFF]FF", "length": 0.3},
         "bark": {"young_length": 0, "variation": 0, "kind": "stem"})";
  const std::string coated =
      R"("kind": "weber_penn", "tree": {"scale": 4, "levels": 2, "leaves": 0, "branches": {"branches": 12}},
         "bark": {"variation": 0}, "coat": {"pixels": 16})";
  for (const std::string& plant : {cross, cross + R"(, "body": {"build": "fused", "voxel": 0.02})", coated}) {
    const ExportScene plain = exported(plant, ""),
                      painted =
                          exported(plant, R"({"at": "2", "bark": {"kind": "metal", "color": [1, 0, 0]}})");
    auto parts = [](const ExportScene& scene) {
      std::vector<const ExportPart*> all;
      for (const ExportMesh& mesh : scene.meshes)
        if (mesh.name.find("branches") != std::string::npos)
          for (const ExportPart& part : mesh.parts)
            if (!part.surface.triangle.empty()) all.push_back(&part);
      return all;
    };
    ASSERT_EQ(parts(plain).size(), 1u) << plant;
    ASSERT_EQ(parts(painted).size(), 2u) << plant;
    const ExportMaterial &own = painted.materials[parts(painted)[0]->material],
                         &other = painted.materials[parts(painted)[1]->material];
    EXPECT_EQ(own.color, plain.materials[parts(plain)[0]->material].color);
    EXPECT_FALSE(own.metal);
    EXPECT_TRUE(other.metal);
    EXPECT_EQ(other.color, (Color{1, 0, 0}));
    EXPECT_EQ(parts(plain)[0]->surface.triangle.size(),
              parts(painted)[0]->surface.triangle.size() + parts(painted)[1]->surface.triangle.size());
  }
}

}  // namespace
}  // namespace frond
