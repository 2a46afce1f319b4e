#include "preset/json.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

namespace frond {
namespace {

std::string message(std::string_view text) {
  Result<Document> document = parse_json(text, "f");
  return document ? "good: " + serialize(document->root) : document.errors()[0].text();
}

TEST(Json, SaysWhatIsWrong) {
  struct {
    std::string_view text, message;
  } const cases[] = {
      {"", "f:1:1: /: the end of the text; expected a value"},
      {" // only\n", "f:2:1: /: the end of the text; expected a value"},
      {"[1,]", "f:1:3: /: a comma before the closing ']'; expected no comma behind the last element"},
      {"{\"a\": 1, // so\n}",
       "f:1:8: /: a comma before the closing '}'; expected no comma behind the last member"},
      {"[1 2]", "f:1:3: /: no comma behind the value; expected ',' or ']'"},
      {"[1", "f:1:3: /: the end of the text; expected ',' or ']'"},
      {"[,1]", "f:1:2: /0: ','; expected a value"},
      {"{a: 1}", "f:1:2: /: 'a'; expected a name in double quotes"},
      {"{\"a\" 1}", "f:1:6: /: '1'; expected ':' behind the name"},
      {"{\"a\": {\"b\": tru}}", "f:1:13: /a/b: 't'; expected a value"},
      {"{\"a\": 1,\n \"a\": 2}", "f:2:2: /a: the name \"a\" a second time; expected it once"},
      {"1 2", "f:1:3: /: '2'; expected the end of the text"},
      {"[1] /* open", "f:1:5: /: a comment without end; expected */"},
      {"/", "f:1:1: /: '/'; expected a value"},
      {"\"a", "f:1:1: /: a text without end; expected a closing '\"'"},
      {"[\"a\nb\"]",
       "f:1:4: /0: a line break or control character inside a text; expected an escape such as \\n"},
      {"\"\\x\"", "f:1:2: /: an unknown escape; expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX"},
      {"\"\\u12g4\"",
       "f:1:2: /: an unknown escape; expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX"},
      {"\"\\ud800\"",
       "f:1:2: /: half a surrogate pair; expected \\uD800 to \\uDBFF and then \\uDC00 to \\uDFFF"},
      {"01", "f:1:2: /: '1'; expected the end of the text"},
      {"[-]", "f:1:2: /0: an unfinished number; expected a digit behind its '-', '.' or 'e'"},
      {"[1.]", "f:1:2: /0: an unfinished number; expected a digit behind its '-', '.' or 'e'"},
      {"[2, 1e+]", "f:1:5: /1: an unfinished number; expected a digit behind its '-', '.' or 'e'"},
      {"[.5]", "f:1:2: /0: '.'; expected a value"},
      {"[1e999]", "f:1:2: /0: the number 1e999; expected one below 1.8e308"},
      {"[NaN]", "f:1:2: /0: 'N'; expected a value"},
      {"[\"\xff\"]", "f:1:3: /: bytes that are not UTF-8; expected UTF-8"},
      {"[\"\xed\xa0\x80\"]", "f:1:3: /: bytes that are not UTF-8; expected UTF-8"},
      {"[\"a\\\"\", \"surrogate \\q\"]",
       "f:1:20: /1: an unknown escape; expected one of \\\" \\\\ \\/ \\b \\f \\n \\r \\t \\uXXXX"},
      {"{\"a\": 1, \"b\tc\": 2}",
       "f:1:12: /: a line break or control character inside a text; expected an escape such as \\n"},
      {"[1 \"a", "f:1:3: /: no comma behind the value; expected ',' or ']'"},
      {"[1, /* , */ // ]\n", "f:2:1: /1: the end of the text; expected a value"},
      {"[1, /* , */]", "f:1:3: /: a comma before the closing ']'; expected no comma behind the last element"},
      {"{\"a\" /* : */ 1}", "f:1:14: /: '1'; expected ':' behind the name"},
      {"{\"a\": 0 /* open}", "f:1:9: /: a comment without end; expected */"},
      {"[0, 1e400, 2]", "f:1:5: /1: the number 1e400; expected one below 1.8e308"},
      {"{}]", "f:1:3: /: ']'; expected the end of the text"},
      {"\"é\" é", "f:1:5: /: 'é'; expected the end of the text"},
      {"Ａ", "f:1:1: /: 'Ａ'; expected a value"},
      {{"{} \0 {", 6}, "f:1:4: /: a zero byte; expected a text"},
      {"// \xff\n{}", "f:1:4: /: bytes that are not UTF-8; expected UTF-8"},
      {"{\"a/b~c\": x}", "f:1:11: /a~1b~0c: 'x'; expected a value"},
  };
  for (const auto& c : cases) EXPECT_EQ(message(c.text), c.message) << c.text;
}

TEST(Json, EveryNameThatStandsTwiceIsTold) {
  Result<Document> document = parse_json(R"({"a": 1, "a": 2, "b": {"c": 1, "c": 1}})", "f");
  ASSERT_FALSE(document);
  EXPECT_EQ(document.errors().size(), 2u);
}

TEST(Json, PlacesCountCharactersFromOne) {
  Result<Document> document =
      parse_json("\xef\xbb\xbf{\r\n\t\"é😀\": /* ü */ [1, //\r\n  -2.5e3],\n\"b\":null}", "f");
  ASSERT_TRUE(document);
  const Value& root = document->root;
  EXPECT_EQ(root.origin.text(), "f:1:1");
  EXPECT_EQ(root.members[0].origin.text(), "f:2:2");
  EXPECT_EQ(root.members[0].value.origin.text(), "f:2:16");
  EXPECT_EQ(root.members[0].value.items[0].origin.text(), "f:2:17");
  EXPECT_EQ(root.members[0].value.items[1].origin.text(), "f:3:3");
  EXPECT_EQ(root.members[1].origin.text(), "f:4:1");
  EXPECT_EQ(root.members[1].value.origin.text(), "f:4:5");
}

TEST(Json, PlacesDoNotTakeCommentsForTokens) {
  Result<Document> document = parse_json(
      "/* { */ [ // [\"a\",\r\n 10/**/,-0/*,*/,\t/* // */0 , \"/*\",true,{\"//\"/*:*/:/**//**/ "
      "{\"a\":1.5e3}}]//",
      "f");
  ASSERT_TRUE(document);
  const Value& list = document->root;
  std::vector<std::string> places{list.origin.text()};
  for (const Value& item : list.items) places.push_back(item.origin.text());
  EXPECT_EQ(places,
            (std::vector<std::string>{"f:1:9", "f:2:2", "f:2:9", "f:2:26", "f:2:30", "f:2:35", "f:2:40"}));
  const Member& inner = list.items[5].members[0];
  EXPECT_EQ(inner.origin.text(), "f:2:41");
  EXPECT_EQ(inner.value.origin.text(), "f:2:60");
  EXPECT_EQ(inner.value.members[0].value.origin.text(), "f:2:65");
}

TEST(Json, ReadsValues) {
  EXPECT_EQ(message(R"( [true, false, null, "a\"\\\/\b\f\n\r\t\u0041\u00e9\u20ac\ud83d\ude00", {}, []] )"),
            "good: [true,false,null,\"a\\\"\\\\/\\u0008\\u000c\\n\\r\\tAé€😀\",{},[]]");
  EXPECT_EQ(message("[0, -0, 1.0, 0.1, 100000, 1e21, 1E-7, 123456789012, 5e-324, 1e-999, "
                    "0.000000000000000000001e-400]"),
            "good: [0,0,1,0.1,100000,1e+21,1e-07,123456789012,5e-324,0,0]");
}

TEST(Json, KnowsWholeNumbers) {
  Result<Document> document = parse_json("[1, 1.0, 1e2, -3, -0, 18446744073709551616]", "f");
  ASSERT_TRUE(document);
  std::vector<bool> integer;
  for (const Value& item : document->root.items) integer.push_back(item.integer);
  EXPECT_EQ(integer, (std::vector<bool>{true, false, false, true, true, true}));
}

TEST(Json, DepthHasALimit) {
  EXPECT_EQ(message(std::string(100000, '[')).substr(0, 8), "f:1:101:");
  std::string deep;
  for (int i = 0; i < 100000; ++i) deep += "{\"a\":";
  EXPECT_NE(message(deep).find("expected at most 100"), std::string::npos);
  EXPECT_EQ(message(std::string(100, '[') + std::string(100, ']')),
            "good: " + std::string(100, '[') + std::string(100, ']'));
}

TEST(Json, LongLinesAreRead) {
  std::string text = "[0";
  for (int i = 0; i < 200000; ++i) text += ",1";
  Result<Document> document = parse_json(text + "]", "f");
  ASSERT_TRUE(document);
  EXPECT_EQ(document->root.items.back().origin.column, 400002);
}

TEST(Json, AgreesWithALibrary) {
  for (std::string_view text : {"[1,2.5,-3e-2,\"x\\u0000y\"]", "{\"b\":1,\"a\":[{},[]]}", "-0.0",
                                "\"\\ud83d\\ude00\"", "[1e-5,1e15,1e16,0.3]"}) {
    Result<Document> document = parse_json(text, "f");
    ASSERT_TRUE(document) << text;
    EXPECT_EQ(nlohmann::ordered_json::parse(serialize(document->root)), nlohmann::ordered_json::parse(text))
        << text;
  }
}

TEST(Serialize, ReadsBackAsTheSame) {
  for (double x :
       {0.1, 1 / 3.0, 1e300, 5e-324, 123456.789, -1e-5, 9007199254740991.0, 1e15, 999999999999999.0}) {
    Result<Document> document = parse_json(serialize(make_number(x)), "f");
    ASSERT_TRUE(document);
    EXPECT_EQ(document->root.number, x);
  }
}

TEST(Serialize, PrettyFitsTheWidth) {
  Value list = make_list();
  for (int i = 0; i < 30; ++i) list.items.push_back(make_number(i));
  Value object = make_object().set("numbers", list).set("short", make_object().set("a", make_text("b")));
  std::string text = serialize_pretty(object, 40);
  EXPECT_EQ(text,
            "{\n  \"numbers\": [\n"
            "    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,\n    11, 12, 13, 14, 15, 16, 17, 18, 19,\n"
            "    20, 21, 22, 23, 24, 25, 26, 27, 28,\n    29\n  ],\n"
            "  \"short\": {\"a\": \"b\"}\n}\n");
  EXPECT_EQ(serialize(parse_json(text, "f")->root), serialize(object));
}

}  // namespace
}  // namespace frond
