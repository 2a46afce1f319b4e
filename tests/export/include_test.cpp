#include "export/include.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

constexpr std::string_view kReed = R"({
  "film": {"frames": 5, "fps": 2}, "scene": {"setting": "studio"},
  "organisms": [{"kind": "plant", "name": "reed", "height": 2, "place": {"at": [[1, 3]], "size_variation": 0, "lean": 0},
    "growth": {"duration": 2}, "grammar": {"axiom": "FFFF", "steps": 0}}]})";

IncludeText text_of(std::vector<int> frames) {
  return {"Frond_Reed", "reed.inc", "A reed", "reed.json", {}, std::move(frames)};
}

std::vector<IncludeVariant> variants(int count) {
  std::vector<IncludeVariant> list;
  for (int i = 0; i < count; ++i) {
    Result<Preset> preset = read_preset(kReed, "reed.json", {"/seed=" + std::to_string(i)});
    list.push_back(include_variant(*build_scene(*preset)));
  }
  return list;
}

std::size_t count_of(const std::string& text, const std::string& what) {
  std::size_t count = 0;
  for (std::size_t at = text.find(what); at != text.npos; at = text.find(what, at + 1)) ++count;
  return count;
}

TEST(Include, NamesAreThosePovRayTakes) {
  EXPECT_EQ(include_name("oak"), "Frond_Oak");
  EXPECT_EQ(include_name("my-old oak2"), "Frond_My_Old_Oak2");
  EXPECT_EQ(include_name("bush-1.25"), "Frond_Bush_1_25");
}

TEST(Include, HoldsAShapeForEachSeedAndDetail) {
  Result<std::string> text = include_text(text_of({5}), variants(2));
  ASSERT_TRUE(text.ok()) << text.errors()[0].text();
  EXPECT_EQ(count_of(*text, "#macro Frond_Reed_Make_"), 6u);
  EXPECT_EQ(count_of(*text, "#macro Frond_Reed_At("), 0u);
  constexpr std::string_view kHeight = "#declare Frond_Reed_Height = ";
  std::size_t at = text->find(kHeight);
  ASSERT_NE(at, std::string::npos);
  EXPECT_NEAR(std::stod(text->substr(at + kHeight.size())), 2, 0.1);
  EXPECT_EQ(text->find("#include \"frond"), std::string::npos);
  // The box in POV-Ray's axes: z is mirrored.
  EXPECT_NE(text->find("#declare Frond_Reed_High = <1.0"), std::string::npos);
}

TEST(Include, HoldsThePosesOfFramesForDetailZeroAlone) {
  Result<std::string> text = include_text(text_of({3, 4, 5}), variants(1));
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(count_of(*text, "#macro Frond_Reed_Make_0_0_"), 3u);
  EXPECT_EQ(count_of(*text, "#macro Frond_Reed_Make_"), 5u);
  EXPECT_NE(text->find("int((Time - 1)*2 + 0.5)"), std::string::npos);
}

TEST(Include, AUnionIsOfTwoObjectsOrMore) {
  Result<std::string> text = include_text(text_of({5}), variants(1));
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(count_of(*text, "_Shapes[0][0][0] = object{"), 1u) << "of one plant, which is one sweep";
  EXPECT_EQ(count_of(*text, "_Shapes[0][1][0] = object{"), 1u);
  EXPECT_EQ(count_of(*text, " = union{"), 0u);
}

TEST(Include, ABodyThatGrowsIsSomething) {
  Result<Preset> preset = read_preset(R"({"film": {"frames": 3, "fps": 2}, "scene": {"setting": "studio"},
      "organisms": [{"species": "presets/species/corals/brain.json", "place": {"at": [[0, 0]]},
        "growth": {"duration": 1}}]})",
                                      "brain.json", {});
  ASSERT_TRUE(preset);
  Result<std::string> text = include_text(text_of({2}), {include_variant(*build_scene(*preset))});
  EXPECT_TRUE(text.ok()) << text.errors()[0].text();
}

TEST(Include, LoopsBeginAnewAndTimesOutsideHold) {
  Result<std::string> text = include_text(text_of({3, 4, 5}), variants(1));
  ASSERT_TRUE(text.ok());
  EXPECT_NE(text->find("max(0, min(2, int((Time - 1)*2 + 0.5)))"), std::string::npos);
  EXPECT_NE(text->find("#macro Frond_Reed_Loop(Seed, Time)"), std::string::npos);
  EXPECT_NE(text->find("floor((Time - 1)*2 + 0.5 + 1e-6);"), std::string::npos);
  EXPECT_NE(text->find("Frond_Frame - 3*floor(Frond_Frame/3))"), std::string::npos);
  EXPECT_NE(text->find("// Frond_Reed_Loop(Seed, Time)"), std::string::npos) << "told in the head";
}

TEST(Include, MayBeMirroredInAllAxesForItKeepsATransformation) {
  Result<std::string> text = include_text(text_of({5}), variants(1));
  ASSERT_TRUE(text.ok());
  EXPECT_EQ(count_of(*text, "matrix<1,0,0,0,1,0,0,0,1,0,0,0> scale 1/"), 3u) << "each detail";
}

TEST(Include, OfNothingIsRefused) {
  Result<std::string> text = include_text(text_of({1}), variants(1));
  ASSERT_FALSE(text.ok());
  EXPECT_EQ(text.errors()[0].what, "nothing has grown yet at frame 1; expected another --frame");
}

}  // namespace
}  // namespace frond
