#include "preset/merge.h"

#include <gtest/gtest.h>

#include "preset/json.h"

namespace frond {
namespace {

Value value(std::string_view text) {
  Result<Document> document = parse_json(text, "f");
  EXPECT_TRUE(document) << text;
  return document ? document->root : Value{};
}

std::string merged(std::string_view defaults, std::string_view own,
                   const std::vector<std::string>& force = {}) {
  return serialize(merge(value(defaults), value(own), force));
}

TEST(Merge, OwnWins) {
  EXPECT_EQ(merged(R"({"a": 1, "b": 2})", R"({"b": 3, "c": 4})"), R"({"a":1,"b":3,"c":4})");
  EXPECT_EQ(merged(R"({"o": {"a": 1, "b": {"x": 1}}})", R"({"o": {"b": {"y": 2}}})"),
            R"({"o":{"a":1,"b":{"x":1,"y":2}}})");
  EXPECT_EQ(merged(R"({"l": [1, 2, 3]})", R"({"l": [4]})"), R"({"l":[4]})") << "lists are replaced";
  EXPECT_EQ(merged(R"({"o": {"a": 1}})", R"({"o": 2})"), R"({"o":2})");
  EXPECT_EQ(merged(R"({"o": 2})", R"({"o": {"a": 1}})"), R"({"o":{"a":1}})");
  EXPECT_EQ(merged(R"({"a": 1})", R"({"a": null})"), R"({"a":null})");
}

TEST(Merge, ForcedPropertiesCountAsInTheDefaults) {
  constexpr std::string_view kDefaults = R"({"wave": {"speed": 1, "amplitude": 2}, "size": 3})";
  constexpr std::string_view kOwn = R"({"wave": {"speed": 7, "loop": true}, "size": 8, "color": 9})";
  EXPECT_EQ(merged(kDefaults, kOwn, {"size"}),
            R"({"wave":{"speed":7,"amplitude":2,"loop":true},"size":3,"color":9})");
  EXPECT_EQ(merged(kDefaults, kOwn, {"wave"}), R"({"wave":{"speed":1,"amplitude":2},"size":8,"color":9})")
      << "the whole of it";
  EXPECT_EQ(merged(kDefaults, kOwn, {"wave/speed"}),
            R"({"wave":{"speed":1,"amplitude":2,"loop":true},"size":8,"color":9})");
  EXPECT_EQ(merged(kDefaults, kOwn, {"wave/loop", "color"}), R"({"wave":{"speed":7,"amplitude":2},"size":8})")
      << "the scene has none: the built-in default counts";
  EXPECT_EQ(merged(kDefaults, R"({"wave": 5})", {"wave/speed"}), R"({"wave":5,"size":3})")
      << "left for the reader to refuse";
  EXPECT_EQ(merged("{}", kOwn, {"wave", "size", "color", "other/x"}), "{}");
}

TEST(Merge, Laws) {
  const std::string_view texts[] = {"{}", R"({"a": 1})", R"({"a": {"b": 2}, "c": [1]})",
                                    R"({"c": {"d": null}, "a": 3})", R"({"a": {"b": {"x": 1}, "y": 2}})"};
  const std::vector<std::string> force = {"a", "c/d"};
  for (std::string_view a : texts) {
    EXPECT_EQ(merged(a, "{}"), merged("{}", a));
    EXPECT_EQ(merged(a, a), merged(a, "{}"));
    EXPECT_EQ(merged(a, "{}", force), merged(a, "{}")) << "force takes nothing from the defaults";
    for (std::string_view b : texts) {
      std::string once = merged(a, b);
      EXPECT_EQ(merged(a, once), once);
      std::string forced = merged(a, b, force);
      EXPECT_EQ(merged(a, forced, force), forced);
      Value scene = value(a);
      Value result = value(forced);
      const Value* wanted = scene.find("a");
      const Value* got = result.find("a");
      ASSERT_EQ(wanted == nullptr, got == nullptr);
      if (wanted) {
        EXPECT_EQ(serialize(*wanted), serialize(*got));
      }
      for (std::string_view c : texts) {
        EXPECT_EQ(value(merged(merged(a, b), c)).find("c") == nullptr,
                  value(merged(a, merged(b, c))).find("c") == nullptr);
      }
    }
  }
}

TEST(Merge, ValuesKeepTheirPlaces) {
  Value result = merge(value("{\"a\": 1,\n \"b\": {\"x\": 2}}"), value("{\"b\":\n\n {\"y\": 3}}"), {});
  EXPECT_EQ(result.find("a")->origin.text(), "f:1:7");
  EXPECT_TRUE(result.find("a")->inherited);
  EXPECT_EQ(result.find("b")->origin.text(), "f:3:2");
  EXPECT_FALSE(result.find("b")->inherited);
  EXPECT_EQ(result.find("b")->find("x")->origin.text(), "f:2:13");
  EXPECT_TRUE(result.find("b")->find("x")->inherited);
  EXPECT_EQ(result.find("b")->find("y")->origin.text(), "f:3:8");
}

}  // namespace
}  // namespace frond
