#include "pruning/edits.h"

#include <gtest/gtest.h>

#include "scene/copies.h"
#include "scene/scene.h"
#include "scene/specimen_cache.h"
#include "scene/wrong_presets.h"

// Edits by hand of plants of several kinds, as presets spell them.
namespace frond {
namespace {

const char* kTree =
    R"("kind": "tree", "years": 9, "habit": {"clear_trunk": 0}, "weather": {"wind": 0}, "leaves": {"size": 0.1})";
const char* kKinds[] = {
    R"("kind": "coral", "steps": 3)",
    R"("kind": "fan")",
    R"("kind": "weber_penn", "tree": {"branches": {"branches": 12}})",
    R"("kind": "colonized", "colonize": {"attractors": 150})",
    R"("kind": "plant", "grammar": {"axiom": "A", "steps": 5, "rules": ["A -> F[+A]F[-A]FA"]}, "height": 1)",
    kTree};

std::string text_of(std::string_view kind, std::string_view edits, std::string_view more = "") {
  return std::string(R"({"film": {"frames": 1}, "scene": {"setting": "studio"}, "organisms": [{)") +
         std::string(kind) + R"(, "place": {"at": [[0, 0]], "rock": 0}, "edits": [)" + std::string(edits) +
         "]" + std::string(more) + "}]}";
}

Scene grown(const std::string& text, SpecimenCache* cache = nullptr) {
  Result<Preset> preset = read_preset(text, "edits.json", {});
  if (!preset) {
    ADD_FAILURE() << preset.errors().front().text() << "\n" << text;
    return {};
  }
  return std::move(*build_scene(*preset, {[](auto, auto) {}, [] {}}, cache));
}

const Specimen& plant_of(const Scene& scene) {
  for (const Specimen& s : scene.specimens)
    if (s.entry == 0) return s;
  ADD_FAILURE() << "no plant";
  return scene.specimens.front();
}

TEST(SceneEdits, EachNodeHasAnAddress) {
  for (const char* kind : kKinds) {
    Scene scene = grown(text_of(kind, ""));
    const Model& m = plant_of(scene).model;
    std::vector<AxisNode> axes = axis_nodes(m);
    Branching plant{m.skeleton.parent, axes};
    std::vector<std::int32_t> starts = axis_starts(plant);
    ASSERT_GT(m.skeleton.size(), 20u) << kind;
    const std::size_t step = 1 + m.skeleton.size() / 500;
    for (std::size_t i = 0; i < m.skeleton.size(); i += step) {
      if (axes[i].number < 0 || axes[starts[i]].number < 0) continue;  // roots and stubs
      std::string name = text(*address_of(plant, {static_cast<std::int32_t>(i), 1}));
      Result<BranchPlace> found = find_place(plant, starts, *parse_address(name));
      ASSERT_TRUE(found) << kind << " " << name;
      EXPECT_EQ(starts[found->node], starts[i]) << kind << " " << name;
      std::int32_t p = m.skeleton.parent[found->node];
      Vec3 at = p < 0 ? m.skeleton.position[found->node]
                      : glm::mix(m.skeleton.position[p], m.skeleton.position[found->node], found->within);
      EXPECT_LT(glm::distance(at, m.skeleton.position[i]), 1e-3f) << kind << " " << name;
    }
  }
}

/// The address of the thickest branch that leaves the stem.
std::string thickest_branch(const Model& m) {
  std::vector<AxisNode> axes = axis_nodes(m);
  Branching plant{m.skeleton.parent, axes};
  std::vector<std::int32_t> starts = axis_starts(plant);
  std::int32_t best = -1;
  for (std::size_t i = 1; i < m.skeleton.size(); ++i)
    if (axes[i].number > 0 && m.skeleton.parent[i] >= 0 && starts[m.skeleton.parent[i]] == starts[0] &&
        (best < 0 || m.skeleton.radius[i] > m.skeleton.radius[best]))
      best = static_cast<std::int32_t>(i);
  return best < 0 ? "" : text(*address_of(plant, {best, 0}));
}

TEST(SceneEdits, AreDoneToEachKind) {
  for (const char* kind : kKinds) {
    Scene plain = grown(text_of(kind, ""));
    const Model& before = plant_of(plain).model;
    std::string branch = thickest_branch(before);
    ASSERT_NE(branch, "") << kind;
    auto edited = [&](const std::string& edit) {
      return grown(text_of(kind, R"({"at": ")" + branch + edit + "}"));
    };
    Scene cut = edited(R"(:0.3", "cut": true)"), bent = edited(R"(:0.8", "bend": [0, -0.05, 0.05])"),
          strong = edited(R"(", "strength": 1.4)");
    EXPECT_LT(plant_of(cut).model.skeleton.size(), before.skeleton.size()) << kind;
    EXPECT_EQ(plant_of(bent).model.skeleton.size(), before.skeleton.size()) << kind;
    EXPECT_NE(plant_of(bent).model.skeleton.position, before.skeleton.position) << kind;
    EXPECT_EQ(plant_of(strong).model.skeleton.size(), before.skeleton.size()) << kind;
    EXPECT_NE(plant_of(strong).model.skeleton.radius, before.skeleton.radius) << kind;
    for (const Scene* scene : {&cut, &bent, &strong}) EXPECT_EQ(scene->find_fault(), "") << kind;
    Scene none = edited(R"(:0.8", "bend": [0, 0, 0])");
    EXPECT_EQ(plant_of(none).model.skeleton.position, before.skeleton.position) << kind;
    EXPECT_EQ(plant_of(none).model.organs.position, before.organs.position) << kind;
  }
}

TEST(SceneEdits, GrowNothingAnew) {
  SpecimenCache cache;
  std::string edit = R"({"at": "2:0.5", "cut": true})";
  Scene first = grown(text_of(kTree, ""), &cache);
  Scene cut = grown(text_of(kTree, edit), &cache), plain = grown(text_of(kTree, edit));
  EXPECT_EQ(plant_of(cut).model.skeleton.position, plant_of(plain).model.skeleton.position);
  EXPECT_EQ(plant_of(cut).model.organs.position, plant_of(plain).model.organs.position);
  Scene again = grown(text_of(kTree, edit), &cache);
  EXPECT_TRUE(again.grown.empty());
}

TEST(SceneEdits, HoldAtAllTimesOfAFilm) {
  auto film = [](std::string_view edits) {
    std::string text = text_of(kTree, edits, R"(, "growth": {"duration": 4})");
    text.replace(text.find(R"("frames": 1)"), 11, R"("frames": 50, "fps": 10)");
    return grown(text);
  };
  Scene plain = film("");
  std::string branch = thickest_branch(plant_of(plain).model);
  Scene bent = film(R"({"at": ")" + branch + R"(:0.7", "bend": [0, 0.1, 0.2]})");
  Scene cut = film(R"({"at": ")" + branch + R"(", "cut": true})");
  std::size_t fewer = 0;
  for (double time : {1.0, 2.0, 3.0, 3.5, 4.5}) {
    auto a = developed(plant_of(plain), time), b = developed(plant_of(bent), time),
         c = developed(plant_of(cut), time);
    ASSERT_TRUE(a && b && c);
    ASSERT_EQ((*a)->model.skeleton.size(), (*b)->model.skeleton.size());
    fewer += (*c)->model.skeleton.size() < (*a)->model.skeleton.size();
    EXPECT_EQ((*b)->model.find_fault(), "");
    EXPECT_EQ((*c)->model.find_fault(), "");
  }
  EXPECT_GE(fewer, 3u);
}

TEST(SceneEdits, ABareBranchHasNoLeavesAtAnyTimeOfAFilm) {
  auto film = [](std::string_view edits) {
    std::string text = text_of(kTree, edits, R"(, "growth": {"duration": 4})");
    text.replace(text.find(R"("frames": 1)"), 11, R"("frames": 50, "fps": 10)");
    return grown(text);
  };
  Scene plain = film("");
  const std::string branch = thickest_branch(plant_of(plain).model);
  Scene bare = film(R"({"at": ")" + branch + R"(", "bare": true})");
  Scene all = film(R"({"at": "", "bare": true})");
  for (double time : {1.0, 2.0, 3.0, 3.5, 4.5}) {
    auto a = developed(plant_of(plain), time), b = developed(plant_of(bare), time),
         c = developed(plant_of(all), time);
    ASSERT_TRUE(a && b && c);
    EXPECT_EQ((*a)->model.skeleton.position, (*b)->model.skeleton.position) << time;
    EXPECT_EQ((*c)->model.organs.size(), 0u) << time;
    if (time < 3.2) continue;
    EXPECT_LT((*b)->model.organs.size(), (*a)->model.organs.size()) << time;
    EXPECT_GT((*b)->model.organs.size(), 0u) << time;
  }
}

TEST(SceneEdits, ABranchHasItsOwnBarkAtAllTimesOfAFilm) {
  auto film = [](std::string_view edits) {
    std::string text = text_of(kTree, edits, R"(, "bark": {"colors": [[0.3, 0.2, 0.1], [0.4, 0.3, 0.2]]},
        "growth": {"duration": 4})");
    text.replace(text.find(R"("frames": 1)"), 11, R"("frames": 50, "fps": 10)");
    return grown(text);
  };
  Scene plain = film("");
  EXPECT_TRUE(plant_of(plain).look.branches.others.empty());
  const std::string branch = thickest_branch(plant_of(plain).model);
  Scene painted = film(R"({"at": ")" + branch + R"(", "bark": {"kind": "ink", "color": [1, 0, 0]}},
      {"at": ")" + branch +
                       R"(:0.5", "bend": [0, 0.1, 0]})");
  const BranchLook& look = plant_of(painted).look.branches;
  ASSERT_EQ(look.others.size(), 1u);
  EXPECT_EQ(look.colors(), 3u);
  EXPECT_EQ(look.plain(2, 1), (Color{1, 0, 0}));
  EXPECT_EQ(look.young(2, 1, Built::branches), (Color{1, 0, 0})) << "young shoots are painted, too";
  std::size_t shown = 0;
  for (double time : {1.0, 2.0, 3.0, 3.5, 4.5}) {
    auto a = developed(plant_of(plain), time), b = developed(plant_of(painted), time);
    ASSERT_TRUE(a && b);
    const Model &before = (*a)->model, &m = (*b)->model;
    ASSERT_EQ(m.skeleton.size(), before.skeleton.size()) << time;
    EXPECT_EQ(m.skeleton.radius, before.skeleton.radius) << time;
    EXPECT_EQ(m.organs.size(), before.organs.size()) << time;
    EXPECT_TRUE(before.color.empty());
    // What hangs on it wears the same, and nothing else does.
    std::vector<AxisNode> axes = axis_nodes(m);
    Branching plant{m.skeleton.parent, axes};
    Result<BranchPlace> foot = find_place(plant, axis_starts(plant), *parse_address(branch));
    for (std::size_t i = 0; i < m.skeleton.size(); ++i) {
      bool beyond = false;
      for (auto k = static_cast<std::int32_t>(i); foot && k >= 0 && !beyond; k = m.skeleton.parent[k])
        beyond = k == foot->node;
      EXPECT_EQ(look.other(look.color_at(m, static_cast<std::int32_t>(i))), beyond ? 1u : 0u)
          << time << " " << i;
      shown += beyond;
    }
  }
  EXPECT_GT(shown, 20u);
}

TEST(SceneEdits, CopiesHaveBranchesOfAnotherBark) {
  for (std::string_view edits : {"", R"({"at": "2", "bark": {"color": "#aaaaaa"}})"}) {
    std::string text = text_of(kKinds[2], edits, R"(, "sown": {"models": 1})");
    text.replace(text.find(R"("studio")"), 8, R"("meadow")");
    Result<Preset> preset = read_preset(text, "edits.json", {});
    ASSERT_TRUE(preset) << preset.errors().front().text();
    const Organism& organism = preset->organisms[0];
    Result<Model> model = grow_copy(organism, 0);
    ASSERT_TRUE(model);
    std::size_t woods = 0;
    for (const CopyPart& part : copy_parts(copy_appearance(organism).look, *model, {}))
      woods += part.kind == CopyPart::Kind::wood;
    EXPECT_EQ(woods, edits.empty() ? 1u : 2u);
  }
}

TEST(SceneEdits, TellWhatTheyDoNotFind) {
  Scene scene = grown(text_of(kKinds[4], R"({"at": "1", "cut": true}, {"at": "99", "cut": true})"));
  ASSERT_FALSE(scene.notes.empty());
  const std::string& note = scene.notes.front();
  EXPECT_NE(note.find("/organisms/0/edits/1/at: finds no branch: the stem has "), note.npos) << note;
  EXPECT_TRUE(note.starts_with("edits.json:1:")) << note;
}

const WrongPreset kWrongEdits[] = {
    {"Addresses that are none",
     R"({"organisms": [{"kind": "coral", "edits": [{"at": "3//1", "cut": true}, {"at": 3, "cut": true}, {"cut": true}]}]})",
     {},
     {R"x(1:51: /organisms/0/edits/0/at: found the text "3//1"; expected numbers of branches with slashes and a share of the length from 0 to 1, as "3/1:0.4")x",
      R"(1:80: /organisms/0/edits/1/at: found 3; expected a text)",
      R"(1:97: /organisms/0/edits/2: no "at"; expected this property to be given)"}},
    {"Edits out of range",
     R"({"organisms": [{"kind": "coral", "edits": [{"at": "3", "strength": 9}, {"at": "3", "cut": false}]}]})",
     {},
     {R"(1:68: /organisms/0/edits/0/strength: found 9; expected a number from 0.2 to 3)",
      R"(1:91: /organisms/0/edits/1/cut: found false; expected true, or a year of its life from 1 to 500)"}},
    {"Edits of nothing, and of too much",
     R"({"organisms": [{"kind": "coral", "edits": [{"at": "3"}, {"at": "3", "cut": true, "strength": 2},
 {"at": "3", "bend": [0, 1, 0]}, {"at": "3", "cut": 24}]}]})",
     {},
     {R"(1:44: /organisms/0/edits/0: has 0 of cut, bend, strength, bare and bark; expected one of them)",
      R"(1:57: /organisms/0/edits/1: has 2 of cut, bend, strength, bare and bark; expected one of them)",
      R"(2:9: /organisms/0/edits/2/at: is where the limb is held; expected a place farther along it to pull at, as "3:0.8")",
      R"(2:53: /organisms/0/edits/3/cut: names a year; expected true, or the kind tree, which grows over years)"}},
    {"Another bark of what has none",
     R"({"organisms": [{"kind": "coral", "edits": [{"at": "3", "bark": {"color": "red"}}]}]})",
     {},
     {R"(1:64: /organisms/0/edits/0/bark: is of plants; expected an edit of a kind whose branches have bark)"}},
    {"Edits of what has no branches",
     R"({"organisms": [{"kind": "rock", "edits": [{"at": "3", "cut": true}]}]})",
     {},
     {R"(1:42: /organisms/0/edits: are of branches; expected a kind that has them and does not creep)"}},
};

TEST(SceneEdits, WrongOnesAreTold) { expect_messages(kWrongEdits); }

}  // namespace
}  // namespace frond
