#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

#include "scene/scene.h"

namespace frond {
namespace {

Scene built(const std::string& name) {
  std::string path = FROND_ROOT "/presets/garden/" + name + ".json";
  std::ifstream file(path);
  std::stringstream text;
  text << file.rdbuf();
  Result<Preset> preset = read_preset(text.str(), path, {"/scene/meadow/extent=0.1"});
  EXPECT_TRUE(preset.ok()) << (preset ? "" : preset.errors()[0].text());
  Result<Scene> scene = build_scene(*preset);
  EXPECT_TRUE(scene.ok()) << (scene ? "" : scene.errors()[0].text());
  EXPECT_TRUE(scene->notes.empty()) << scene->notes[0];
  return *scene;
}

const Specimen& named(const Scene& scene, const std::string& name) {
  for (const Specimen& b : scene.specimens)
    if (b.name == name) return b;
  ADD_FAILURE() << "no " << name;
  return scene.specimens.front();
}

std::set<Matter> matters(const Scene& scene) {
  std::set<Matter> all;
  for (const Specimen& b : scene.specimens)
    for (const Solid& solid : b.model.solids.shapes) all.insert(solid.material.matter);
  return all;
}

TEST(GardenPresets, TheBridgeIsOfTimberAndSpansIt) {
  Scene scene = built("bridge");
  EXPECT_TRUE(matters(scene).contains(Matter::timber));
  Surface all = merged(named(scene, "bridge").model.solids);
  float left = 99, right = -99, top = -99;
  for (const Vec3& p : all.position)
    left = std::min(left, p.x), right = std::max(right, p.x), top = std::max(top, p.y);
  EXPECT_GT(right - left, 5);
  EXPECT_GT(top, 1.5f);
}

TEST(GardenPresets, TheStoneBridgeIsOfAshlarInMortar) {
  std::set<Matter> all = matters(built("stone_bridge"));
  EXPECT_TRUE(all.contains(Matter::ashlar));
  EXPECT_TRUE(all.contains(Matter::bed));
}

TEST(GardenPresets, VasesAreOfEachMaterialAndOneHoldsAPlant) {
  Scene scene = built("vases");
  std::set<Matter> all = matters(scene);
  for (Matter matter : {Matter::ceramic, Matter::terracotta, Matter::glass, Matter::soil})
    EXPECT_TRUE(all.contains(matter)) << static_cast<int>(matter);
  const Specimen& pot = named(scene, "pot");
  const Specimen& plant = named(scene, "houseleek");
  float earth = 0;
  for (const Vec3& p : pot.model.solids.shapes[1].surface.position) earth = std::max(earth, p.y);
  EXPECT_NEAR(plant.model.skeleton.position[0].y, earth, 0.015) << "it hangs over the earth, or is buried";
  EXPECT_GT(plant.model.organs.size(), 20u);
  std::size_t bands = 0, lathes = 0;
  for (const Specimen& b : scene.specimens)
    for (const Solid& solid : b.model.solids.shapes)
      bands += solid.material.bands.size(), lathes += !solid.turned.empty();
  EXPECT_GE(bands, 5u);
  EXPECT_GE(lathes, 1u);
}

}  // namespace
}  // namespace frond
