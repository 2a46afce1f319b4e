#include "preset/tokens.h"

#include <gtest/gtest.h>

#include <cmath>

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

TEST(ReadQuoted, EndsBehindTheClosingQuote) {
  std::string read, text = R"(["a\u00e9\ud83d\ude00\/", 1])";
  std::size_t at = 1;
  EXPECT_FALSE(read_quoted(text, at, read));
  EXPECT_EQ(read, "aé😀/");
  EXPECT_EQ(text.substr(at), ", 1]");
}

TEST(ReadQuoted, FaultsStandWhereTheirCauseIs) {
  struct {
    std::string_view text;
    std::size_t offset;
    std::string_view what;  // how it begins
  } const cases[] = {
      {R"("a)", 0, "a text without end"},           {R"("\)", 1, "an unknown escape"},
      {R"("a\u12)", 2, "an unknown escape"},        {R"("\u12g4")", 1, "an unknown escape"},
      {R"("\u+123")", 1, "an unknown escape"},      {R"("\ud83d\x")", 1, "half a surrogate pair"},
      {R"("\ud83d\u12")", 7, "an unknown escape"},  {R"("\ud83d\ud83d")", 1, "half a surrogate pair"},
      {R"("a\ude00")", 2, "half a surrogate pair"}, {"\"ab\tc\"", 3, "a line break or control character"},
  };
  for (const auto& c : cases) {
    std::size_t at = 0;
    std::string read;
    std::optional<TokenFault> fault = read_quoted(c.text, at, read);
    ASSERT_TRUE(fault) << c.text;
    EXPECT_EQ(fault->offset, c.offset) << c.text;
    EXPECT_TRUE(fault->what.starts_with(c.what)) << c.text << ": " << fault->what;
  }
}

TEST(ReadNumber, BeyondDoublePrecisionIsTooLargeOrZero) {
  auto read = [](std::string_view text) {
    std::size_t at = 0;
    NumberToken token;
    std::optional<TokenFault> fault = read_number(text, at, token);
    EXPECT_EQ(at, text.size()) << text;
    return fault ? static_cast<double>(INFINITY) : token.number;
  };
  std::string zeros(400, '0');
  EXPECT_EQ(read("1.7976931348623157e308"), 1.7976931348623157e308);
  EXPECT_EQ(read("5e-324"), 5e-324);
  const std::vector<std::string> large{
      "1e309", "-2e308", "1E+99999999999999999999", "1" + zeros, "1" + zeros + "e-9", "0." + zeros + "1e800"};
  for (const std::string& number : large) EXPECT_EQ(read(number), INFINITY) << number;
  const std::vector<std::string> small{"1e-999",   "-1e-99999999999999999999", "0." + zeros + "1", "0e999",
                                       "0.0e-999", "1" + zeros + "e-900"};
  for (const std::string& number : small) EXPECT_EQ(read(number), 0) << number;
}

TEST(ReadNumber, AnIntegerIsNeverMinusZero) {
  std::size_t at = 0;
  NumberToken token;
  EXPECT_FALSE(read_number("-0", at, token));
  EXPECT_TRUE(token.integer);
  EXPECT_FALSE(std::signbit(token.number));
}

TEST(FoundAt, NamesWhatStandsThere) {
  EXPECT_EQ(found_at("é1", 0), "'é'");
  EXPECT_EQ(found_at("\x01", 0), "a control character");
  EXPECT_EQ(found_at("a", 1), "the end of the text");
}

}  // namespace
}  // namespace frond
