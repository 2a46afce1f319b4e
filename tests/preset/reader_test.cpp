#include "preset/reader.h"

#include <gtest/gtest.h>

#include <string>
#include <tuple>

#include "preset/faults.h"
#include "preset/reef.h"

namespace frond {
namespace {

using reef::Coral;
using reef::kGood;
using reef::Preset;
using reef::Rock;

Result<Preset> read(std::string_view text) {
  Result<Document> document = parse_json(text, "p.json");
  return document ? read_preset<Preset>(*document) : Result<Preset>(document.errors());
}

TEST(Reader, ReadsEveryKindOfProperty) {
  Result<Preset> read_good = read(kGood);
  ASSERT_TRUE(read_good) << read_good.errors()[0].text();
  const Preset& p = *read_good;
  EXPECT_EQ(p.title, "Reef");
  EXPECT_EQ(p.seed, 7u);
  EXPECT_EQ(p.film.frames, 24);
  EXPECT_EQ(p.film.size, (std::array{320, 200}));
  EXPECT_EQ(p.film.quality, reef::Quality::best);
  ASSERT_EQ(p.zoom.keys().size(), 2u);
  EXPECT_EQ(p.zoom.keys()[1].value, 3);
  EXPECT_DOUBLE_EQ(p.turn.at(0), -90);
  EXPECT_EQ(p.location.at(1), Vec3(4, 5, 6));
  EXPECT_EQ(p.focus, Vec2(0.5f, 0.25f));
  EXPECT_EQ(p.fog, (Color{1, 128 / 255.0f, 0}));
  EXPECT_EQ(p.custom, 0.25);
  EXPECT_EQ(p.tags, (std::vector<std::string>{"a", "é😀"}));
  ASSERT_TRUE(p.swell);
  EXPECT_EQ(p.swell->speed, 2);
  EXPECT_TRUE(p.swell->loop);
  EXPECT_EQ(std::get<Rock>(p.ground.params).blobs.size(), 1u);
  EXPECT_EQ(std::get<Rock>(p.stones.at(0).params).weights, (std::vector<double>{1, 2}));
}

TEST(Reader, OrganismsInherit) {
  Result<Preset> p = read(kGood);
  ASSERT_TRUE(p);
  ASSERT_EQ(p->organisms.size(), 3u);
  const auto& [one, two, rock] = std::tie(p->organisms[0], p->organisms[1], p->organisms[2]);
  EXPECT_EQ(one.count, 3);
  EXPECT_EQ(one.wave.speed, 4) << "its own wins";
  EXPECT_FLOAT_EQ(one.wave.amplitude, static_cast<float>(kPi / 4)) << "forced";
  EXPECT_EQ(std::get<Coral>(one.params).base, Coral{}.base) << "forced, but the scene has none";
  EXPECT_EQ(std::get<Coral>(one.params).rules.at(0).rule, "A -> B");
  EXPECT_EQ(std::get<Coral>(two.params).rules.at(1).limit, 2);
  EXPECT_EQ(std::get<Coral>(two.params).constants.at(0), std::pair(std::string("r"), std::string("0.9")));
  EXPECT_EQ(rock.count, 1);
  EXPECT_EQ(std::get<Rock>(rock.params).weights, (std::vector<double>{3})) << "a default only rocks have";
}

TEST(Reader, MissingPropertiesKeepTheirDefaults) {
  Result<Preset> p = read(R"({"title": ""})");
  ASSERT_TRUE(p);
  EXPECT_EQ(p->film.frames, 1);
  EXPECT_FALSE(p->focus);
  EXPECT_FALSE(p->swell);
}

TEST(Reader, SaysWhatIsWrongAndWhere) {
  for (const reef::WrongMember& wrong : reef::kWrongMembers) {
    Result<Preset> preset = read(reef::preset_with(wrong.member));
    ASSERT_FALSE(preset) << wrong.member;
    EXPECT_EQ(preset.errors().size(), 1u) << wrong.member;
    EXPECT_EQ(preset.errors()[0].text(), "p.json:2:" + std::string(wrong.message)) << wrong.member;
  }
}

TEST(Reader, AKeyMayHaveAnEaseAndHandles) {
  auto with = [](const std::string& keys) { return read(R"({"title": "a", )" + keys + "}"); };
  Result<Preset> p = with(R"("zoom": [[0, 1, "in"], [1, 2, {"ease": "none"}], [2, 3]],
    "location": [[0, [0, 0, 0], {"ease": "both", "out": [1, 0, 0]}], [1, [2, 0, 0], {"in": [0, 1, 0]}]])");
  ASSERT_TRUE(p) << p.errors()[0].text();
  EXPECT_EQ(p->zoom.keys()[0].ease, Ease::in);
  EXPECT_EQ(p->zoom.keys()[1].ease, Ease::none);
  EXPECT_FALSE(p->zoom.keys()[2].ease);
  EXPECT_EQ(p->location.keys()[0].ease, Ease::both);
  EXPECT_EQ(p->location.keys()[0].out, Vec3(1, 0, 0));
  EXPECT_EQ(p->location.keys()[1].in, Vec3(0, 1, 0));
  std::string all;
  for (const char* keys : {R"("zoom": [[0, 1, "inn"]])", R"("zoom": [[0, 1, {"out": [1, 2, 3]}]])",
                           R"("zoom": [[0, 1, "in", 3]])", R"("location": [[0, [0, 0, 0], {"in": 2}]])"}) {
    Result<Preset> wrong = with(keys);
    ASSERT_FALSE(wrong) << keys;
    for (const Error& error : wrong.errors()) all += error.text() + "\n";
  }
  EXPECT_EQ(
      all,
      "p.json:1:32: /zoom/0/2: found the text \"inn\"; expected one of none, in, out, both; did you mean "
      "\"in\"?\n"
      "p.json:1:33: /zoom/0/2/out: unknown property \"out\"; expected ease\n"
      "p.json:1:25: /zoom/0: found a list of 4; expected a keyframe [seconds, value] or [seconds, value, "
      "ease]\n"
      "p.json:1:51: /location/0/2/in: found 2; expected a list of 3 numbers\n");
}

TEST(Reader, CollectsAllFaults) {
  Result<Preset> preset = read(R"({
    "seed": -1,
    "film": {"frames": 0, "frmes": 1, "size": [1, 2]},
    "organisms": [{"kind": "rok"}, {"kind": "rock", "count": "many"}],
    "zoom": [[0, "a"], 5]
  })");
  ASSERT_FALSE(preset);
  std::string all;
  for (const Error& error : preset.errors()) all += error.where + "\n";
  EXPECT_EQ(all,
            "p.json:1:1: /\n"
            "p.json:2:13: /seed\n"
            "p.json:3:24: /film/frames\n"
            "p.json:3:27: /film/frmes\n"
            "p.json:3:48: /film/size/0\n"
            "p.json:3:51: /film/size/1\n"
            "p.json:4:28: /organisms/0/kind\n"
            "p.json:4:62: /organisms/1/count\n"
            "p.json:5:18: /zoom/0/1\n"
            "p.json:5:24: /zoom/1\n");
  EXPECT_EQ(preset.errors()[0].what, "no \"title\"; expected this property to be given");
}

TEST(Reader, OneFaultInTheDefaultsIsToldOnce) {
  Result<Preset> preset = read(R"({"title": "", "defaults": {"wave": {"speed": 99}},
    "organisms": [{"kind": "rock"}, {"kind": "rock"}, {"kind": "coral", "rules": []}]})");
  ASSERT_FALSE(preset);
  ASSERT_EQ(preset.errors().size(), 1u);
  EXPECT_EQ(preset.errors()[0].text(),
            "p.json:1:46: /defaults/wave/speed: found 99; expected a number from 0 to 10");
}

TEST(Reader, DefaultsMayNameWhatOnlyOtherKindsHave) {
  EXPECT_TRUE(
      read(R"({"title": "", "defaults": {"weights": [1], "rules": []}, "organisms": [{"kind": "coral"}]})"));
  EXPECT_FALSE(read(R"({"title": "", "organisms": [{"kind": "coral", "rules": [], "weights": [1]}]})"))
      << "but an organism may not";
}

TEST(Reader, WhatIsForcedOutMustBeRightToo) {
  EXPECT_FALSE(read(R"({"title": "", "force": ["count"], "organisms": [{"kind": "rock", "count": "x"}]})"));
  EXPECT_FALSE(read(R"({"title": "", "force": ["rules"], "organisms": [{"kind": "coral", "rules": []}]})"))
      << "nothing is left of a required property";
}

TEST(Reader, ARootThatIsNoObject) {
  for (std::string_view text : {"[]", "1", "null", "\"x\"", "true"}) {
    Result<Preset> preset = read(text);
    ASSERT_FALSE(preset);
    EXPECT_EQ(preset.errors().size(), 1u);
    EXPECT_TRUE(preset.errors()[0].text().starts_with("p.json:1:1: /: found ")) << preset.errors()[0].text();
  }
}

}  // namespace
}  // namespace frond
