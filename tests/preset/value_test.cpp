#include "preset/value.h"

#include <gtest/gtest.h>

#include <array>

#include "preset/json.h"

namespace frond {
namespace {

TEST(Value, MembersKeepTheirOrder) {
  Value object = make_object().set("b", make_number(1)).set("a", make_number(2)).set("b", make_boolean(true));
  EXPECT_EQ(serialize(object), R"({"b":true,"a":2})");
  object.remove("b");
  object.remove("none");
  EXPECT_EQ(serialize(object), R"({"a":2})");
  EXPECT_EQ(object.find("b"), nullptr);
  EXPECT_EQ(make_number(1).find("a"), nullptr);
}

TEST(Value, PointersAreEscaped) {
  EXPECT_EQ(pointer_step("", "a"), "/a");
  EXPECT_EQ(pointer_step("/a", "b/c~d"), "/a/b~1c~0d");
  EXPECT_EQ(pointer_step("", ""), "/");
}

TEST(Value, PlacesAreFoundByPointer) {
  Value root = parse_json("{\"a\": [1,\n 2],\n \"b/c\": {\"d\": 3}}", "f")->root;
  EXPECT_EQ(origin_at(root, "").text(), "f:1:1");
  EXPECT_EQ(origin_at(root, "/a/1").text(), "f:2:2");
  EXPECT_EQ(origin_at(root, "/b~1c/d").text(), "f:3:15");
  EXPECT_EQ(origin_at(root, "/a/7/x").text(), "f:1:7") << "the list that has no such element";
}

TEST(Value, MessagesNameWhatWasFound) {
  EXPECT_EQ(found_text(Value{}), "null");
  EXPECT_EQ(found_text(make_number(-0.5)), "-0.5");
  EXPECT_EQ(found_text(make_text("a\"b\n")), R"(the text "a\"b\n")");
  EXPECT_EQ(found_text(make_list()), "an empty list");
  EXPECT_EQ(found_text(make_list({Value{}, Value{}})), "a list of 2");
  EXPECT_EQ(found_text(make_text(std::string(50, 'x'))), "the text \"" + std::string(40, 'x') + "...\"");
  std::string accents;
  for (int i = 0; i < 30; ++i) accents += "é";
  EXPECT_EQ(found_text(make_text("x" + accents)).substr(0, 11), "the text \"x");
  EXPECT_TRUE(parse_json(found_text(make_text("x" + accents)).substr(9), "f")) << "cut between characters";
}

TEST(Value, MessagesOfferNames) {
  std::vector<std::string> many;
  for (int i = 0; i < 30; ++i) many.push_back("property" + std::to_string(i));
  std::vector<std::string_view> names(many.begin(), many.end());
  EXPECT_TRUE(expected_names("", names).starts_with("; expected one of property0, property1, property2, "));
  EXPECT_TRUE(expected_names("", names).ends_with(", property23 and 6 more")) << "bounded";
  std::string said = expected_names("propperty7", names);
  EXPECT_TRUE(said.starts_with("; expected one of property7, property0, property1")) << said;
  EXPECT_TRUE(said.ends_with(" and 6 more; did you mean \"property7\"?")) << said;
  names.resize(19);
  EXPECT_TRUE(expected_names("property7s", names).starts_with("; expected one of property7, property0,"));
  EXPECT_EQ(expected_names("property7s", names).find("more"), std::string::npos) << "all are listed";
  EXPECT_LT(expected_names(std::string(1000000, 'x'), names).size(), 1000u);
  names.resize(2);
  EXPECT_EQ(expected_names("x", names), "; expected one of property0, property1");
  names.resize(1);
  EXPECT_EQ(expected_names("x", names), "; expected property0");
  EXPECT_EQ(expected_names("x", {}), "; expected no further name");
}

}  // namespace
}  // namespace frond
