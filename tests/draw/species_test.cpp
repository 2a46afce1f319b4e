#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/bounds.h"
#include "core/files.h"
#include "draw/sizes.h"
#include "preset/json.h"
#include "scene/copies.h"
#include "scene/copy_organs.h"
#include "scene/scene.h"
#include "scene/taxon.h"

// What is shipped as a species is as large as that species is.

namespace frond {
namespace {

namespace fs = std::filesystem;

/// Plants of a species, alone.
struct Alone {
  Preset preset;
  Scene scene;
};

Alone alone(const fs::path& file, int count) {
  Value one = make_object();
  one.set("species", make_text(file.string())).set("count", make_number(count));
  Value place = make_object();
  Value at = make_list();
  for (int i = 0; i < count; ++i) at.items.push_back(make_list({make_number(2 * i), make_number(0)}));
  one.set("place", place.set("at", at));
  Value scene = make_object();
  Value whole = make_object();
  whole.set("scene", scene.set("setting", make_text("studio"))).set("organisms", make_list({one}));
  Result<Preset> preset = read_preset(serialize(whole), "test.json", {"/film/frames=1"});
  if (!preset) throw std::runtime_error(preset.errors()[0].text());
  return {*preset, *build_scene(*preset)};
}

/// The longest side of the organs of that symbol, metres: that which a quarter exceed, since the young
/// ones are still small. Pieces of one flower, which stand in one place, count as their longest.
double length_of(const Alone& grown, const std::string& symbol) {
  std::vector<double> lengths;
  for (const Specimen& planted : grown.scene.specimens) {
    const Specimen specimen = **developed(planted, 0);
    std::vector<Vec3> sides;
    for (const Prototype& prototype : specimen.model.prototypes) {
      Bounds box;
      for (const OrganPart& part : prototype.parts)
        for (const Vec3& p : part.surface.position) box.extend(p);
      sides.push_back(box.empty() ? Vec3(0) : box.size());
    }
    const Organs& organs = specimen.model.organs;
    for (std::size_t i = 0; i < organs.size(); ++i) {
      std::size_t prototype = organs.prototype[i];
      if (specimen.model.prototypes[prototype].name != symbol) continue;
      Vec3 size = sides[prototype] * organs.scale[i];
      auto length = static_cast<double>(std::max({size.x, size.y, size.z}));
      bool piece = i > 0 && organs.id[i] == organs.id[i - 1] &&
                   organs.position[i] == organs.position[i - 1] &&
                   specimen.model.prototypes[organs.prototype[i - 1]].name == symbol;
      if (piece)
        lengths.back() = std::max(lengths.back(), length);
      else
        lengths.push_back(length);
    }
  }
  if (lengths.empty()) return 0;
  auto grown_up = lengths.begin() + static_cast<std::ptrdiff_t>(3 * lengths.size() / 4);
  std::ranges::nth_element(lengths, grown_up);
  return *grown_up;
}

/// A tenth more or less than what is usual is no fault: sources differ by more.
void expect_within(const Vec2& range, double size, const char* what) {
  EXPECT_GE(size, 0.9 * static_cast<double>(range.x)) << what;
  EXPECT_LE(size, 1.1 * static_cast<double>(range.y)) << what;
}

std::vector<fs::path> files() {
  std::vector<fs::path> all;
  for (const fs::path& file : files_below(FROND_ROOT "/presets"))
    if (Result<std::string> text = read_file(file);
        file.extension() == ".json" && text && text->find("\"taxon\"") != text->npos)
      all.push_back(file);
  return all;
}

class Species : public testing::TestWithParam<fs::path> {};

TEST_P(Species, IsOfItsSize) {
  Result<Preset> told = read_preset(*read_file(GetParam()), GetParam().string(), {});
  ASSERT_TRUE(told) << told.errors()[0].text();
  EXPECT_TRUE(told->notes.empty()) << told->notes[0].text();
  const Taxon& taxon = *told->taxon;
  // Single herbs may be without a flower by chance.
  Alone grown = alone(GetParam(), taxon.height && taxon.height->y < 1.6f ? 6 : 1);
  GrownSize size = sizes_of(grown.scene, grown.preset, 0)->front();
  if (taxon.height) expect_within(*taxon.height, size.height, "height");
  if (taxon.spread) expect_within(*taxon.spread, size.width, "spread");
  struct Part {
    const char* what;
    const std::optional<TaxonPart>& part;
  };
  for (const Part& one : {Part{"leaf", taxon.leaf}, Part{"flower", taxon.flower}, Part{"fruit", taxon.fruit},
                          Part{"body", taxon.body}})
    if (one.part && !one.part->organ.empty())
      expect_within(one.part->size, one.part->share * length_of(grown, one.part->organ), one.what);
}

/// What the organs of each prototype add up to, dew aside: square metres.
std::vector<double> measured_areas(const Model& model) {
  std::vector<double> all(model.prototypes.size());
  const Organs& organs = model.organs;
  for (std::size_t i = 0; i < organs.size(); ++i) {
    std::size_t which = organs.prototype[i];
    for (const OrganPart& part : model.prototypes[which].parts) {
      if (part.tissue == Tissue::dew) continue;
      Surface scaled = part.surface;
      for (Vec3& p : scaled.position) p *= organs.scale[i];
      all[which] += area(scaled);
    }
  }
  return all;
}

TEST_P(Species, KeepsTheAreaOfItsOrgansAsCopies) {
  Result<Preset> told = read_preset(*read_file(GetParam()), GetParam().string(), {});
  ASSERT_TRUE(told) << told.errors()[0].text();
  if (told->organisms[0].grower->traits().stage == GrowthStage::swimming)
    GTEST_SKIP() << "a school is not sown";
  Value one = make_object(), sown = make_object(), scene = make_object(), whole = make_object();
  sown.set("models", make_number(1)).set("where", make_object().set("radius", make_number(1)));
  one.set("species", make_text(GetParam().string())).set("sown", sown);
  scene.set("setting", make_text("forest"));
  whole.set("scene", scene).set("organisms", make_list({one}));
  Result<Preset> preset = read_preset(serialize(whole), "test.json", {"/film/frames=1"});
  ASSERT_TRUE(preset) << preset.errors()[0].text();
  const Organism& organism = preset->organisms[0];
  Result<Model> model = grow_copy(organism, 0);
  ASSERT_TRUE(model);
  const std::vector<double> areas = measured_areas(*model);
  // Woods have 3 to 8 m2 of leaves on each m2 of ground (Asner, Scurlock and Hicke 2003), so trees that stand
  // alone, round as they are, have no more than some twelve times their silhouette.
  const double leaves = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (organism.grower->perennial() != nullptr) {
    EXPECT_GE(hiding_share(*model, leaves), 10.0 / 12);
  }
  for (int level = 0; level < kLevelCount; ++level) {
    std::vector<double> found(areas.size());
    for (const CopyPart& part : copy_parts(organism.grower->appearance().look, *model, kLevels[level]))
      if (part.kind == CopyPart::Kind::organ) found[part.which] += area(part.surface);
    for (std::size_t p = 0; p < areas.size(); ++p) {
      if (areas[p] <= 0) continue;
      // What is round is drawn as a leaf of a quarter of its surface.
      EXPECT_GT(found[p] / areas[p], 0.2) << model->prototypes[p].name << " at level " << level;
      EXPECT_LT(found[p] / areas[p], 1.35) << model->prototypes[p].name << " at level " << level;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, Species, testing::ValuesIn(files()), [](const auto& file) {
  return file.param.parent_path().stem().string() + "_" + file.param.stem().string();
});

TEST(ShippedSpecies, AreFoundByAnyName) {
  std::vector<ShippedSpecies> all = shipped_species();
  ASSERT_FALSE(all.empty());
  for (const ShippedSpecies& one : all) {
    EXPECT_EQ(shipped_by_name(one.taxon.latin).value_or("none"), one.file);
    EXPECT_FALSE(one.taxon.source.empty()) << one.file;
    EXPECT_FALSE(one.taxon.names.empty()) << one.file;
  }
  EXPECT_EQ(shipped_by_name("English_Lavender"), shipped_by_name("lavender"));
  EXPECT_FALSE(shipped_by_name("no such plant"));
  EXPECT_FALSE(shipped_by_name(""));
}

}  // namespace
}  // namespace frond
