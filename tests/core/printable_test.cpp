#include "core/printable.h"

#include <gtest/gtest.h>

#include "core/utf8.h"

namespace frond {
namespace {

TEST(Printable, LeavesNothingThatSteersATerminal) {
  EXPECT_EQ(printable("fine, größer: 木"), "fine, größer: 木");
  EXPECT_EQ(printable("\x1b[31mred\x1b[0m"), "\\x1b[31mred\\x1b[0m");
  EXPECT_EQ(printable(std::string_view("a\0b", 3)), "a\\x00b");
  EXPECT_EQ(printable("line\nline\r\ttab\x7f"), "line\\x0aline\\x0d\\x09tab\\x7f");
  EXPECT_EQ(printable("\u0085\u009b"), "\\u0085\\u009b") << "the other control characters";
  EXPECT_EQ(printable("\u202egnp.exe\u2069"), "\\u202egnp.exe\\u2069") << "backwards";
  EXPECT_EQ(printable("a\xff\xc3z\xe6\x9c"), "a\\xff\\xc3z\\xe6\\x9c") << "no UTF-8";
}

TEST(Printable, CutsTheMiddleOfWhatIsLong) {
  std::string text = "found " + std::string(100000, 'x') + "; expected less";
  std::string shown = printable(text, 100);
  EXPECT_LE(shown.size(), 100u);
  EXPECT_TRUE(shown.starts_with("found x"));
  EXPECT_TRUE(shown.ends_with("; expected less"));
  EXPECT_LE(printable(std::string(100000, '\x1b'), 100).size(), 100u) << "escapes count";
  for (std::size_t most = 16; most < 40; ++most) {
    std::string letters;
    for (int i = 0; i < 40; ++i) letters += "木";
    std::string left = printable(letters, most);
    EXPECT_FALSE(invalid_utf8(left)) << most;
    EXPECT_GE(left.size() + 4, most) << "no more goes than the letters that are cut, two bytes on each side";
  }
}

TEST(Printable, ErrorsKeepLineColumnAndPointer) {
  Error error{"/a/" + std::string(9000, 'f') + ".json:12:34: /organisms/" + std::string(9000, 'p') + "/wave",
              std::string(9000, 'w')};
  std::string shown = printable(error);
  EXPECT_LT(shown.size(), 2500u);
  EXPECT_TRUE(shown.starts_with("/a/fff"));
  EXPECT_NE(shown.find(".json:12:34: /organisms/ppp"), shown.npos) << shown;
  EXPECT_NE(shown.find("ppp/wave: www"), shown.npos) << shown;
  EXPECT_EQ(printable(Error{"", "what"}), "what");
  EXPECT_EQ(printable(Error{"p.json:1:2: /", "what"}), "p.json:1:2: /: what");
}

TEST(Printable, LongNamesBecomeNamesThatFilesMayBearAndStayApart) {
  std::string name(400, 'a');
  std::string plain = plain_name(name + "b", "organism"), other = plain_name(name + "c", "organism");
  EXPECT_EQ(plain.size(), kLongestName);
  EXPECT_TRUE(plain.starts_with("aaaa"));
  EXPECT_NE(plain, other);
  EXPECT_EQ(plain_name(std::string(kLongestName, 'a'), "organism"), std::string(kLongestName, 'a'));
}

}  // namespace
}  // namespace frond
