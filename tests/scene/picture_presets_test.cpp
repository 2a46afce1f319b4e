#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "core/files.h"
#include "preset/json.h"
#include "scene/preset.h"

namespace frond {
namespace {

const std::string kPresets = std::string(FROND_ROOT) + "/presets/";

Preset wholly_read(const std::string& path) {
  Result<Preset> preset = read_preset(*read_file(path), path, {});
  EXPECT_TRUE(preset.ok()) << path << (preset ? "" : preset.errors()[0].text());
  return *preset;
}

TEST(PicturePresets, NoPlantOfTheWoodStandsBeforeAnOpenSky) {
  int plants = 0;
  for (const auto& file : std::filesystem::directory_iterator(kPresets + "forest")) {
    Preset preset = wholly_read(file.path().string());
    if (preset.stand) continue;  // its trees are no organisms
    std::set<Layer> behind;
    for (const Organism& organism : preset.organisms)
      if (organism.sown && organism.count >= 50) behind.insert(organism.sown->where.layer);
    EXPECT_TRUE(behind.contains(Layer::canopy)) << file.path() << " has no trees";
    EXPECT_TRUE(behind.contains(Layer::shrubs)) << file.path() << " has nothing between the trunks";
    ++plants;
  }
  EXPECT_GE(plants, 12);
}

TEST(PicturePresets, TheHillsideHasTheLarchesThatItAsksForAndNotThoseOfTheSpecies) {
  auto first_larch = [](const std::string& name) {
    return serialize(wholly_read(kPresets + name).written->find("organisms")->items[0]);
  };
  auto says = [](const std::string& text, const char* what) { return text.find(what) != std::string::npos; };
  std::string here = first_larch("photographs/hillside.json"), species = first_larch("trees/larch.json");
  EXPECT_TRUE(says(species, "\"leaf_scale\":0.22")) << species;
  EXPECT_TRUE(says(here, "\"leaf_scale\":0.11")) << here;
  EXPECT_TRUE(says(here, "\"branches\":120")) << "all else is the species'";
}

}  // namespace
}  // namespace frond
