#include "preset/syntax.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(SkipBlanks, PassesBlanksAndComments) {
  struct {
    std::string_view text;
    std::size_t token;
  } const cases[] = {
      {"", 0},           {"x", 0},         {" \t\r\nx", 4}, {"// a\nx", 5},
      {"// a\rx", 5},    {"// a", 4},      {"/**/x", 4},    {"/* a */x", 7},
      {"/***/x", 5},     {"/* // */x", 8}, {"// /*\nx", 6}, {"/*//*/ /**/", 11},
      {" /* a", 1},      {"/*/ x", 0},     {" / x", 1},     {"//a\n//b\n\n", 9},
      {"/*\n\n*/,x", 6},
  };
  for (const auto& c : cases) EXPECT_EQ(skip_blanks(c.text, 0), c.token) << c.text;
  EXPECT_EQ(skip_blanks("ab  c", 2), 4u);
  EXPECT_EQ(skip_blanks("ab", 2), 2u);
}

TEST(FindFault, SaysWhatMustFollow) {
  struct {
    std::string_view text;
    Expected expected;
    std::size_t offset;
    bool inside;
    std::string_view what;
  } const cases[] = {
      {" x", Expected::value, 1, true, "'x'; expected a value"},
      {" x", Expected::first_name, 1, false, "'x'; expected a name in double quotes"},
      {" x", Expected::colon, 1, false, "'x'; expected ':' behind the name"},
      {" : x", Expected::colon, 3, true, "'x'; expected a value"},
      {" x", Expected::comma_or_bracket, 1, false, "'x'; expected ',' or ']'"},
      {"\n\n\"x", Expected::comma_or_brace, 0, false, "no comma behind the value; expected ',' or '}'"},
      {" // x\n1", Expected::comma_or_bracket, 0, false, "no comma behind the value; expected ',' or ']'"},
      {" , x", Expected::comma_or_bracket, 3, true, "'x'; expected a value"},
      {" x", Expected::comma_or_brace, 1, false, "'x'; expected ',' or '}'"},
      {" , x", Expected::comma_or_brace, 3, false, "'x'; expected a name in double quotes"},
      {" , }", Expected::comma_or_brace, 1, false,
       "a comma before the closing '}'; expected no comma behind the last member"},
      {" x", Expected::end, 1, false, "'x'; expected the end of the text"},
      {"\x01", Expected::end, 0, false, "a control character; expected the end of the text"},
      {"", Expected::value, 0, true, "the end of the text; expected a value"},
      {"/*", Expected::end, 0, false, "a comment without end; expected */"},
  };
  for (const auto& c : cases) {
    SyntaxFault fault = find_fault(c.text, 0, c.expected, c.text.size(), "a sentence of no token");
    EXPECT_EQ(fault.what, c.what) << c.text;
    EXPECT_EQ(fault.offset, c.offset) << c.text;
    EXPECT_EQ(fault.inside, c.inside) << c.text;
  }
}

TEST(FindFault, StaysInsideTheTextWhateverThePosition) {
  for (std::string_view reason : {"missing closing quote", "control character", "after backslash",
                                  "hex digits", "surrogate", "invalid number", "number overflow"}) {
    for (std::size_t position = 0; position < 12; ++position) {
      SyntaxFault fault = find_fault("[ \"\\x\"", 1, Expected::value, position, reason);
      EXPECT_GE(fault.offset, 2u) << reason << position;
      EXPECT_LT(fault.offset, 6u) << reason << position;
    }
  }
}

}  // namespace
}  // namespace frond
