#include <gtest/gtest.h>

#include "organisms/describe_grammar.h"
#include "preset/json.h"

namespace frond {
namespace {

Result<GrammarText> read(std::string_view text) {
  return read_preset<GrammarText>(*parse_json(text, "g.json"));
}

TEST(GuidePreset, PointsWithChildren) {
  Result<GrammarText> grammar = read(R"({"axiom": "F?", "guide": {"points": [
    [0, 0, 0],
    {"at": [0, 1, 0], "radius": 0.05, "angle": 20, "elasticity": 0.1, "tropism": [0, 1, 0],
     "children": [[1, 2, 0], [[-1, 2, 0], {"at": [-1, 3, 0], "children": [{"at": [-2, 4, 0]}]}]]},
    [0, 2, 0]], "tolerance": 0.2, "leniency": 0.4, "reach_ends": true},
    "start": {"position": [1, 2, 3], "heading": [0, 0, 1]}})");
  ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
  const GuideText& guide = grammar->guide;
  ASSERT_EQ(guide.points.size(), 7u);
  std::vector<std::int32_t> parents;
  for (const GuidePoint& point : guide.points) parents.push_back(point.parent);
  EXPECT_EQ(parents, (std::vector<std::int32_t>{-1, 0, 1, 1, 3, 4, 1}));
  EXPECT_EQ(guide.points[5].at, DVec3(-2, 4, 0));
  EXPECT_EQ(guide.points[1].radius, 0.05);
  EXPECT_EQ(guide.points[1].angle, 20);
  EXPECT_EQ(guide.points[1].tropism, DVec3(0, 1, 0));
  EXPECT_EQ(guide.tolerance, 0.2);
  EXPECT_TRUE(guide.reach_ends);
  EXPECT_EQ(grammar->start, DVec3(1, 2, 3));
  EXPECT_EQ(grammar->start_heading, DVec3(0, 0, 1));
}

TEST(GuidePreset, MistakesKnowTheirPlace) {
  Result<GrammarText> grammar = read(R"({"axiom": "F?", "guide": {"points": [
    [0, 0], {"at": [0, 1, 0], "radus": 2, "children": [[1, "a", 2], {"radius": 1}]}]}})");
  ASSERT_FALSE(grammar.ok());
  std::string all;
  for (const Error& error : grammar.errors()) all += error.text() + "\n";
  EXPECT_NE(all.find("/guide/points/0"), std::string::npos) << all;
  EXPECT_NE(all.find("/guide/points/1/radus"), std::string::npos) << all;
  EXPECT_NE(all.find("/guide/points/1/children/0"), std::string::npos) << all;
  EXPECT_NE(all.find("/guide/points/1/children/1"), std::string::npos) << all;
}

}  // namespace
}  // namespace frond
