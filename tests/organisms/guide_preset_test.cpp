#include <gtest/gtest.h>

#include "organisms/describe_grammar.h"
#include "preset/json.h"
#include "preset/reader.h"

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

TEST(GuidePreset, SkeletonsLeadByTheirMainWayFirst) {
  const char* text =
      "# a fork\r\n1 0 0 0 0 0.1 -1\r\n2 0 0 1 0 0.1 1\r\n3 0 1 2 0 0.02 2\r\n"
      "4 0 0 2 0 0.08 2\r\n5 0 0 3 0 0.05 4\r\n";
  Result<GuideLines> fork = read_guide_file({"fork.swc", text, nullptr});
  ASSERT_TRUE(fork);
  GuideText guide;
  guide.lines = *fork;
  using Line = std::array<std::uint32_t, 2>;
  EXPECT_EQ(guide.lines.line, (std::vector<Line>{{0, 1}, {1, 3}, {3, 4}, {1, 2}}));
  EXPECT_EQ(guide.lines.place[2], DVec3(1, 2, 0));
  guide.file.name = "fork.swc";
  Result<Guide> ready = guide_of(guide);
  ASSERT_TRUE(ready) << ready.errors()[0].text();
  ASSERT_EQ(ready->roots.size(), 1u);
  EXPECT_EQ(ready->points[0].at, DVec3(0));
  EXPECT_EQ(ready->leaves(), 2u);
  Result<GuideLines> wrong = read_guide_file({"fork.swc", "1 0 0 0 0 0.1 -1\n2 0 0 1 0 0.1 7\n", nullptr});
  ASSERT_EQ(wrong.errors().size(), 1u);
  EXPECT_EQ(wrong.errors()[0].text(),
            "fork.swc: is a skeleton that cannot be read; `frond derive` of it says why");
  // By its ending, where the text itself does not tell.
  EXPECT_EQ(read_guide_file({"short.swc", "1 0 0 0\n", nullptr}).errors().size(), 1u);
  // Lines of an OBJ stay what they were.
  Result<GuideLines> lines = read_guide_file({"lines.obj", "v 0 0 0\nv 0 1 0\nl 1 2\n", nullptr});
  ASSERT_TRUE(lines);
  EXPECT_EQ(lines->line, (std::vector<Line>{{0, 1}}));
}

}  // namespace
}  // namespace frond
