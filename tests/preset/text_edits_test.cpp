#include "preset/text_edits.h"

#include <gtest/gtest.h>

#include "preset/json.h"

namespace frond {
namespace {

constexpr std::string_view kText = R"({
  // What it is called.
  "title": "A {meadow}, [dry]",
  "scene": {
    "meadow": {"sun": [1, 2], "hills": 0.3, "plants": []},  // a hill
    "floor": {
      "relief": 0.5,  // m
      "far~/": [{"a": 1}, {"a": 2}]
      /* nothing else */
    }
  },
  "last": true
}
)";

/// The line of the text that holds a word, or "".
std::string line_with(const std::string& text, std::string_view word) {
  std::size_t at = text.find(word);
  if (at == text.npos) return "";
  std::size_t begin = text.rfind('\n', at) + 1;
  return text.substr(begin, text.find('\n', at) - begin);
}

TEST(TextEdits, TellsWhatIsWritten) {
  TextEdits edits{std::string(kText)};
  EXPECT_EQ(edits.written("/title"), "\"A {meadow}, [dry]\"");
  EXPECT_EQ(edits.written("/scene/meadow/sun"), "[1, 2]");
  EXPECT_EQ(edits.written("/scene/floor/far~0~1/1/a"), "2");
  EXPECT_EQ(edits.written("/last"), "true");
  for (const char* none : {"/none", "/scene/none/x", "/title/x", "/scene/meadow/sun/2", "/last/0"})
    EXPECT_FALSE(edits.written(none)) << none;
}

TEST(TextEdits, ChangesNamesAndValuesAlone) {
  TextEdits edits{std::string(kText)};
  edits.rename("/scene/meadow/hills", "val\"ley");
  edits.replace("/scene/floor/relief", "[3, 4]");
  EXPECT_EQ(line_with(edits.text(), "sun"),
            R"(    "meadow": {"sun": [1, 2], "val\"ley": 0.3, "plants": []},  // a hill)");
  EXPECT_EQ(line_with(edits.text(), "relief"), R"(      "relief": [3, 4],  // m)");
  TextEdits same{std::string(kText)};
  same.rename("/none", "x"), same.replace("/none", "1"), same.remove("/none"),
      same.insert_after("/none", "a", "1");
  EXPECT_EQ(same.text(), kText);
}

TEST(TextEdits, RemovesWithTheComma) {
  struct {
    std::string_view before, pointer, after;
  } const cases[] = {
      {R"({"a": 1, "b": 2, "c": 3})", "/a", R"({"b": 2, "c": 3})"},
      {R"({"a": 1, "b": 2, "c": 3})", "/b", R"({"a": 1, "c": 3})"},
      {R"({"a": 1, "b": 2, "c": 3})", "/c", R"({"a": 1, "b": 2})"},
      {R"({"a": 1})", "/a", "{}"},
      {R"([[1], [2], [3]])", "/1", "[[1], [3]]"},
      {"{\n  \"a\": 1,\n  \"b\": 2,\n  \"c\": 3\n}", "/b", "{\n  \"a\": 1,\n  \"c\": 3\n}"},
      {"{\n  \"a\": 1,\n  \"b\": 2\n}", "/b", "{\n  \"a\": 1\n}"},
      {"{\n  \"a\": 1, \"b\": 2,\n  \"c\": 3\n}", "/b", "{\n  \"a\": 1,\n  \"c\": 3\n}"},
      {"{\n  \"a\": 1,  // one\n  \"b\": 2\n}", "/b", "{\n  \"a\": 1  // one\n  \n}"},
      {"{\n  \"a\": 1,\n  \"b\": 2 // two\n}", "/b", "{\n  \"a\": 1 // two\n}"},
      {"{\"a\": 1 /* one */, \"b\": 2}", "/a", "{ /* one */\"b\": 2}"},
      {"\xef\xbb\xbf {\"a\": 1, \"b\": 2}", "/a", "\xef\xbb\xbf {\"b\": 2}"},
      {"{\r\n  \"a\": 1,\r\n  \"b\": 2\r\n}", "/a", "{\r\n  \"b\": 2\r\n}"},
  };
  for (const auto& c : cases) {
    TextEdits edits{std::string(c.before)};
    edits.remove(c.pointer);
    EXPECT_EQ(edits.text(), c.after);
    EXPECT_TRUE(parse_json(edits.text(), "f")) << edits.text();
  }
}

TEST(TextEdits, InsertsAsItsNeighbourStands) {
  struct {
    std::string_view before, pointer, name, after;
  } const cases[] = {
      {R"({"a": 1, "b": 2})", "/a", "n", R"({"a": 1, "n": [0], "b": 2})"},
      {R"({"a": 1})", "/a", "n", R"({"a": 1, "n": [0]})"},
      {R"([1, 2])", "/1", "", R"([1, 2, [0]])"},
      {"{\n  \"a\": 1,  // one\n  \"b\": 2  // two\n}", "/a", "n",
       "{\n  \"a\": 1,  // one\n  \"n\": [0],\n  \"b\": 2  // two\n}"},
      {"{\n  \"a\": 1,  // one\n  \"b\": 2  // two\n}", "/b", "n",
       "{\n  \"a\": 1,  // one\n  \"b\": 2,  // two\n  \"n\": [0]\n}"},
      {"{\n  \"a\": 1, \"b\": 2\n}", "/a", "n", "{\n  \"a\": 1,\n  \"n\": [0], \"b\": 2\n}"},
      {"{\n  \"a\": 1, /* on\n and on */\n  \"b\": 2\n}", "/a", "n",
       "{\n  \"a\": 1,\n  \"n\": [0], /* on\n and on */\n  \"b\": 2\n}"},
  };
  for (const auto& c : cases) {
    TextEdits edits{std::string(c.before)};
    edits.insert_after(c.pointer, c.name, "[0]");
    EXPECT_EQ(edits.text(), c.after);
    EXPECT_TRUE(parse_json(edits.text(), "f")) << edits.text();
  }
}

}  // namespace
}  // namespace frond
