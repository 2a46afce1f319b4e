#include "preset/keys.h"

#include <gtest/gtest.h>

#include "core/assets.h"
#include "preset/json.h"
#include "preset/reef.h"

namespace frond {

namespace reef {

void describe_rest(KeyWriter& v, Organism& o) {
  if (auto* coral = std::get_if<Coral>(&o.params)) v.add("coral", *coral);
  if (auto* rock = std::get_if<Rock>(&o.params)) v.add("rock", *rock);
}

}  // namespace reef

namespace {

struct Petal {
  Color color;
  double size = 1, swing = 0;
};

void describe(Properties& v, Petal& p) {
  v.aspect(Aspect::look);
  v.color("color", p.color, "");
  v.number("size", p.size, {}, "");
  v.number("swing", p.swing, {}, "");
  v.aspect(Aspect::shape, "size");
  v.aspect(Aspect::motion, "swing");
}

struct Flower {
  int height = 1;
  std::optional<Petal> sepal;
  std::vector<Petal> petals{{}, {}};
  FileName file;
};

void describe(Properties& v, Flower& f) {
  v.integer("height", f.height, {}, "");
  v.object("sepal", f.sepal, "");
  v.list("petals", f.petals, "");
  v.file(
      "file", f.file, [](const NamedFile&) { return Errors{}; }, "");
}

/// Which of the three keys a change touches.
template <class Change>
std::string touched(Change change) {
  Flower before, after;
  change(after);
  Keys a = keys_of(before), b = keys_of(after);
  std::string all;
  if (a.shape != b.shape) all += "shape ";
  if (a.look != b.look) all += "look ";
  if (a.motion != b.motion) all += "motion ";
  return all;
}

TEST(Keys, TellApartWhatAPropertyTells) {
  EXPECT_EQ(touched([](Flower&) {}), "");
  EXPECT_EQ(touched([](Flower& f) { f.height = 2; }), "shape ");
  EXPECT_EQ(touched([](Flower& f) { f.petals[1].color.red = 0.5f; }), "look ");
  EXPECT_EQ(touched([](Flower& f) { f.petals[1].size = 2; }), "shape ");
  EXPECT_EQ(touched([](Flower& f) { f.petals[0].swing = 2; }), "motion ");
  EXPECT_EQ(touched([](Flower& f) { f.sepal.emplace(); }), "shape look motion ");
  EXPECT_EQ(touched([](Flower& f) { f.petals.clear(); }), "shape look motion ");
  EXPECT_EQ(touched([](Flower& f) { f.petals[0].size = -0.0 + 1; }), "");
}

TEST(Keys, FilesCountByWhatTheyHold) {
  EXPECT_EQ(touched([](Flower& f) { f.file.name = "a.obj"; }), "shape ");
  Flower first, second;
  first.file = {"a.obj", "12"}, second.file = {"b.obj", "12"};
  EXPECT_EQ(keys_of(first), keys_of(second));
  second.file.content = "13";
  EXPECT_NE(keys_of(first), keys_of(second));
}

TEST(Keys, OfAllThatIsRead) {
  auto keys = [](std::string_view text) {
    return keys_of(*read_preset<reef::Preset>(*parse_json(text, "a")));
  };
  std::string plain(reef::kGood);
  EXPECT_EQ(keys(plain), keys(plain));
  for (auto [from, to] : {std::pair{"\"seed\": 7", "\"seed\": 8"},
                          {"[2.5, 3]", "[2.5, 4]"},
                          {"[320, 200]", "[320, 201]"},
                          {"\"best\"", "\"draft\""},
                          {"\"left\"", "0.5"},
                          {"\"q\": \"1-r\"", "\"q\": \"2-r\""},
                          {"[1, 1.5, 2]", "[1, 1.5, 1.9]"},
                          {"\"limit\": 2", "\"limit\": 3"}}) {
    std::string other = plain;
    std::size_t at = other.find(from);
    ASSERT_NE(at, other.npos) << from;
    other.replace(at, std::string_view(from).size(), to);
    EXPECT_NE(keys(other), keys(plain)) << from;
  }
  std::string same = plain;
  same.replace(same.find("\"left\""), 6, "2.5e-1");
  EXPECT_EQ(keys(same), keys(plain));
}

}  // namespace
}  // namespace frond
