#include "preset/reader.h"

#include <gtest/gtest.h>

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
  EXPECT_DOUBLE_EQ(p.turn.at(0), -kPi / 2);
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

}  // namespace
}  // namespace frond
