#include "preset/schema.h"

#include <gtest/gtest.h>

#include <algorithm>

#include <nlohmann/json.hpp>

#include "preset/judge.h"

namespace frond {
namespace {

TEST(Schema, AcceptsWhatHasNoFault) {
  SchemaJudge judge;
  EXPECT_TRUE(judge.accepts(reef::kGood)) << judge.reason();
  EXPECT_TRUE(judge.accepts(R"({"title": ""})"));
  EXPECT_TRUE(judge.accepts(R"({"title": "", "defaults": {"rules": []}, "organisms": [{"kind": "coral"}]})"));
}

TEST(Schema, AgreesWithTheReaderOnFaults) {
  SchemaJudge judge;
  for (const reef::WrongMember& wrong : reef::kWrongMembers) {
    EXPECT_EQ(judge.accepts(reef::preset_with(wrong.member)), !wrong.schema_sees_it) << wrong.member;
  }
  EXPECT_FALSE(judge.accepts("{}")) << "the title is required";
  EXPECT_FALSE(judge.accepts("[]"));
}

TEST(Schema, SaysWhatAPropertyIs) {
  nlohmann::json schema =
      nlohmann::json::parse(serialize_pretty(file_schema<reef::Preset>("Reef", "All of it")));
  EXPECT_EQ(schema["title"], "Reef");
  EXPECT_EQ(schema["$schema"], "http://json-schema.org/draft-07/schema#");
  EXPECT_EQ(schema["required"], nlohmann::json({"title"}));
  const nlohmann::json& amplitude = schema["properties"]["swell"]["properties"]["amplitude"];
  EXPECT_EQ(amplitude["description"], "How far a tip leans (degrees)");
  EXPECT_EQ(amplitude["default"], 22.5) << "degrees, without the noise of single precision";
  EXPECT_EQ(amplitude["maximum"], 90);
  const nlohmann::json& quality = schema["properties"]["film"]["properties"]["quality"];
  EXPECT_EQ(quality["description"], "How long to calculate. draft: quick; good: as it should be");
  EXPECT_EQ(quality["default"], "good");
  const nlohmann::json& coral = schema["properties"]["ground"]["allOf"][0];
  EXPECT_EQ(coral["if"]["properties"]["kind"]["const"], "coral");
  EXPECT_EQ(coral["then"]["properties"]["base"]["default"], "#ff8000");
  EXPECT_EQ(coral["then"]["properties"]["size"]["exclusiveMinimum"], 0);
  EXPECT_EQ(coral["then"]["additionalProperties"], false);
}

TEST(Schema, TheSameTextTwice) {
  EXPECT_EQ(serialize_pretty(file_schema<reef::Preset>("a", "b")),
            serialize_pretty(file_schema<reef::Preset>("a", "b")));
}

TEST(Schema, DefaultsMayBeOfAnyKind) {
  Value defaults = SchemaWriter::defaults_of(slot_type<reef::Organism>, reef::kKinds);
  EXPECT_FALSE(defaults.find("required"));
  EXPECT_TRUE(defaults.find("properties")->find("rules"));
  EXPECT_EQ(defaults.find("properties")->find("size")->find("anyOf")->items.size(), 2u)
      << "a number or a vector";
  std::vector<std::string> paths = paths_of(defaults);
  EXPECT_NE(std::ranges::find(paths, "wave/amplitude"), paths.end());
  EXPECT_EQ(std::ranges::find(paths, "kind"), paths.end());
}

}  // namespace
}  // namespace frond
