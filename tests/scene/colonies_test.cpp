#include <gtest/gtest.h>

#include "closed.h"
#include "creeping/triangle_surface.h"
#include "scene/scene.h"

namespace frond {
namespace {

Scene reef_of(const std::string& organisms) {
  Result<Preset> preset =
      read_preset(R"({"seed": 5, "scene": {"setting": "underwater", "floor": {"stones": 0}},
      "organisms": [)" +
                      organisms + "]}",
                  "colonies", {});
  EXPECT_TRUE(preset.ok()) << (preset ? "" : preset.errors()[0].text());
  Result<Scene> scene = build_scene(*preset);
  EXPECT_TRUE(scene.ok()) << (scene ? "" : scene.errors()[0].text());
  return std::move(*scene);
}

const std::string kMassive =
    R"({"kind": "massive", "name": "dome", "relief": "plain", "across": 0.3, "height": 0.2,
    "edge": 0.004, "place": {"at": [[0, 0]], "rock": 0, "size_variation": 0, "lean": 0}})";
const std::string kColumnar =
    R"({"kind": "columnar", "name": "fingers", "accretion": {"across": 0.15, "up": 0.25,
    "edge": 0.012, "layers": 40, "hunger": 2, "lumps": 0.7, "lump_size": 0.04},
    "place": {"at": [[0.2, 0]], "rock": 0, "size_variation": 0, "lean": 0}})";
const std::string kBranching = R"({"kind": "coral", "name": "branches", "steps": 3, "height": 0.3,
    "place": {"at": [[0, 0.2]], "rock": 0, "size_variation": 0, "lean": 0}})";

Surface skin(const Scene& scene, std::string_view name) {
  for (const Specimen& s : scene.specimens)
    if (s.name == name) return skin_of(s.model);
  ADD_FAILURE() << name;
  return {};
}

TEST(Colonies, NoneGrowsIntoAnother) {
  Scene scene = reef_of(kMassive + "," + kColumnar + "," + kBranching);
  Surface dome = skin(scene, "dome"), fingers = skin(scene, "fingers");
  Result<TriangleSurface> dome_host = TriangleSurface::build(dome),
                          fingers_host = TriangleSurface::build(fingers);
  const TriangleSurface &in_dome = *dome_host, &in_fingers = *fingers_host;
  for (const Vec3& p : fingers.position) EXPECT_FALSE(in_dome.inside(DVec3(p)));
  for (const Vec3& p : dome.position) EXPECT_FALSE(in_fingers.inside(DVec3(p)));
  const Skeleton& branches = scene.specimens[2].model.skeleton;
  EXPECT_GT(branches.size(), 20u);
  for (std::size_t i = 20; i < branches.size(); ++i) {
    auto contact = in_dome.closest(DVec3(branches.position[i]));
    EXPECT_TRUE(!contact->inside && contact->distance > 0.9 * branches.radius[i]) << i;
  }
}

TEST(Colonies, GrowIntoTheSpaceOfANeighbourThatIsGone) {
  double beside = volume_of(skin(reef_of(kMassive + "," + kColumnar), "dome")),
         alone = volume_of(skin(reef_of(kMassive), "dome"));
  EXPECT_GT(alone, 1.1 * beside);
}

TEST(Colonies, StandOnBodiesAndNotInThem) {
  Scene scene = reef_of(R"({"kind": "rock", "name": "ledge", "size": 0.8, "place": {"at": [[0, 0]]}},
      {"kind": "massive", "name": "dome", "count": 4, "relief": "plain", "across": 0.16, "height": 0.1, "edge": 0.004,
       "place": {"on": ["ledge"], "radius": 1, "spacing": 0.08}})");
  ASSERT_EQ(scene.specimens.size(), 5u);
  Result<TriangleSurface> ledge = TriangleSurface::build(skin(scene, "ledge"));
  const TriangleSurface& rock = *ledge;
  int high = 0;
  for (std::size_t i = 1; i < 5; ++i) {
    Surface dome = skin_of(scene.specimens[i].model);
    std::size_t inside = 0;
    float top = -1;
    for (const Vec3& p : dome.position) {
      inside += rock.inside(DVec3(p));
      top = std::max(top, p.y);
    }
    EXPECT_LT(inside, dome.position.size() / 2);  // its foot is
    high += top > 0.15f;
  }
  EXPECT_GE(high, 2);
}

TEST(Colonies, ABodyThatIsMissingIsNamed) {
  Result<Preset> preset = read_preset(R"({"seed": 5, "scene": {"setting": "underwater"}, "organisms": [
      {"kind": "rock", "name": "ledge"}, {"kind": "massive", "name": "dome", "place": {"on": ["lege"]}}]})",
                                      "colonies", {});
  ASSERT_FALSE(preset.ok());
  EXPECT_NE(preset.errors()[0].text().find("/organisms/1/place/on/0: no organism \"lege\" to grow on"),
            std::string::npos)
      << preset.errors()[0].text();
}

TEST(Colonies, ASpeciesIsLaidUnderAnEntry) {
  Result<Preset> preset = read_preset(R"({"seed": 5, "scene": {"setting": "underwater"}, "organisms": [
      {"species": "presets/species/corals/brain.json", "count": 3, "across": 0.2}]})",
                                      "colonies", {});
  ASSERT_TRUE(preset.ok()) << preset.errors()[0].text();
  const Organism& brain = preset->organisms[0];
  EXPECT_EQ(brain.name, "brain");
  EXPECT_EQ(brain.count, 3);
  EXPECT_TRUE(brain.place.at.empty()) << "where it stands is no matter of the species";
  EXPECT_NEAR(brain.grower->spread()->across, 0.1, 1e-6) << "its own";
  EXPECT_NEAR(brain.grower->spread()->up, 0.21, 1e-6) << "that of the species";
}

}  // namespace
}  // namespace frond
