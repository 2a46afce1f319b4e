#include "grammar/symbols.h"

#include <gtest/gtest.h>

#include <set>

namespace frond {
namespace {

TEST(Symbols, EachRowIsNamedOnceAndExplained) {
  std::set<std::string_view> names;
  for (const TurtleSymbol& symbol : turtle_symbols()) {
    EXPECT_TRUE(names.insert(symbol.name).second) << symbol.name;
    EXPECT_FALSE(symbol.doc.empty()) << symbol.name;
    EXPECT_TRUE(symbol.abop != Act::none || symbol.houdini != Act::none || symbol.lparser != Act::none)
        << symbol.name;
  }
  for (const char* name :
       {"F", "f", "G", "g", "+", "-", "&",  "^", "\\", "/", "|", "$",  "!",  "\"", ";", ",",
        "[", "]", "{", "}", ".", "~", "@O", "%", "'",  "_", "#", "?P", "?H", "?U", "?"})
    EXPECT_TRUE(names.contains(name)) << name;
}

TEST(Symbols, DialectsDiffer) {
  EXPECT_EQ(act_of("+", Dialect::abop), Act::yaw_left);
  EXPECT_EQ(act_of("+", Dialect::houdini), Act::yaw_right);
  EXPECT_EQ(act_of("<", Dialect::lparser), Act::roll_left);
  EXPECT_EQ(act_of("A", Dialect::abop), Act::none);
}

TEST(Symbols, TheLongestNameCounts) {
  EXPECT_EQ(long_symbol_at("@GcF", Dialect::abop), "@Gc");
  EXPECT_EQ(long_symbol_at("?P(1)", Dialect::abop), "?P");
  EXPECT_EQ(long_symbol_at("?PF", Dialect::abop), "");
  EXPECT_EQ(long_symbol_at("FF", Dialect::abop), "");
}

}  // namespace
}  // namespace frond
