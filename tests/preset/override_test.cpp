#include "preset/override.h"

#include <gtest/gtest.h>

#include "preset/reef.h"

namespace frond {
namespace {

constexpr std::string_view kBase = R"({"film": {"fps": 24}, "list": [1, 2], "a/b": {"~": 0}, "none": []})";

/// The document after the assignment, or what is wrong with it.
std::string set(std::string_view assignment) {
  Document document = *parse_json(kBase, "f");
  std::string before = serialize(document.root);
  Errors errors = apply_set(document, assignment);
  if (errors.empty()) return serialize(document.root);
  EXPECT_EQ(serialize(document.root), before) << "left alone";
  return errors[0].text();
}

TEST(Override, SetsValues) {
  struct {
    std::string_view assignment, result;
  } const cases[] = {
      {"/film/fps=25", R"({"film":{"fps":25},"list":[1,2],"a/b":{"~":0},"none":[]})"},
      {"/film/quality=best", R"({"film":{"fps":24,"quality":"best"},"list":[1,2],"a/b":{"~":0},"none":[]})"},
      {"/film/quality=\"25\"", R"({"film":{"fps":24,"quality":"25"},"list":[1,2],"a/b":{"~":0},"none":[]})"},
      {"/film/title=", R"({"film":{"fps":24,"title":""},"list":[1,2],"a/b":{"~":0},"none":[]})"},
      {"/film/title=a=b", R"({"film":{"fps":24,"title":"a=b"},"list":[1,2],"a/b":{"~":0},"none":[]})"},
      {"/film=[true, {\"a\": null}]", R"({"film":[true,{"a":null}],"list":[1,2],"a/b":{"~":0},"none":[]})"},
      {"/list/1=9", R"({"film":{"fps":24},"list":[1,9],"a/b":{"~":0},"none":[]})"},
      {"/list/-=9", R"({"film":{"fps":24},"list":[1,2,9],"a/b":{"~":0},"none":[]})"},
      {"/list/-/x/y=9", R"({"film":{"fps":24},"list":[1,2,{"x":{"y":9}}],"a/b":{"~":0},"none":[]})"},
      {"/none/-=9", R"({"film":{"fps":24},"list":[1,2],"a/b":{"~":0},"none":[9]})"},
      {"/a~1b/~0=9", R"({"film":{"fps":24},"list":[1,2],"a/b":{"~":9},"none":[]})"},
      {"/x/y=9", R"({"film":{"fps":24},"list":[1,2],"a/b":{"~":0},"none":[],"x":{"y":9}})"},
      {"/x/-=9", R"({"film":{"fps":24},"list":[1,2],"a/b":{"~":0},"none":[],"x":[9]})"},
  };
  for (const auto& c : cases) EXPECT_EQ(set(c.assignment), c.result) << c.assignment;
}

TEST(Override, SaysWhatIsWrong) {
  struct {
    std::string_view assignment, message;
  } const cases[] = {
      {"/film", "--set /film: found no '='; expected POINTER=VALUE, as in /film/fps=24"},
      {"film/fps=24", "--set film/fps: found a pointer without '/' in front; expected /film/fps"},
      {"=24", "--set : found a pointer without '/' in front; expected /"},
      {"/a~b=1", "--set /a~b: found a single '~'; expected ~0 for '~' and ~1 for '/'"},
      {"/a~=1", "--set /a~: found a single '~'; expected ~0 for '~' and ~1 for '/'"},
      {"/list/2=1",
       "--set /list/2: found \"2\" as the index of a list of 2 at /list; expected an index from 0 to 1, or - "
       "to add to it"},
      {"/list/01=1",
       "--set /list/01: found \"01\" as the index of a list of 2 at /list; expected an index from 0 to 1, or "
       "- to add to it"},
      {"/list/x=1",
       "--set /list/x: found \"x\" as the index of a list of 2 at /list; expected an index from 0 to 1, or - "
       "to add to it"},
      {"/none/0=1",
       "--set /none/0: found \"0\" as the index of a list of 0 at /none; expected - to add to it"},
      {"/film/fps/x=1",
       "--set /film/fps/x: found 24 at /film/fps, which has nothing inside; expected an object or a list"},
      {"/film/\xff=1", "--set /film/\xff: bytes that are not UTF-8; expected UTF-8"},
  };
  for (const auto& c : cases) EXPECT_EQ(set(c.assignment), c.message) << c.assignment;
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "/a";
  EXPECT_NE(set(deep + "=1").find("found 100000 steps; expected at most 100"), std::string::npos);
}

TEST(Override, FaultsNameTheOverride) {
  Document document = *parse_json(R"({"title": ""})", "f");
  ASSERT_TRUE(apply_set(document, "/film/fraems=3").empty());
  ASSERT_TRUE(apply_set(document, "/swell={\"speed\": -1, \"loop\": 3}").empty());
  Result<reef::Preset> preset = read_preset<reef::Preset>(document);
  ASSERT_FALSE(preset);
  ASSERT_EQ(preset.errors().size(), 3u);
  EXPECT_EQ(preset.errors()[0].text(),
            "--set /film/fraems: unknown property \"fraems\"; expected one of frames, size, quality; "
            "did you mean \"frames\"?");
  EXPECT_EQ(preset.errors()[1].text(),
            "--set /swell: /swell/speed: found -1; expected a number from 0 to 10");
  EXPECT_EQ(preset.errors()[2].text(), "--set /swell: /swell/loop: found 3; expected true or false");
}

}  // namespace
}  // namespace frond
