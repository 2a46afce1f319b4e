#include "jobs/escape.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

TEST(ShellQuoted, IsOneWordWhateverStandsInIt) {
  EXPECT_EQ(shell_quoted(""), "''");
  EXPECT_EQ(shell_quoted("$(rm -r x) `y` \"z\" *"), "'$(rm -r x) `y` \"z\" *'");
  EXPECT_EQ(shell_quoted("it's"), "'it'\\''s'");
}

TEST(NinjaPath, EscapesWhatEndsAPath) {
  EXPECT_EQ(ninja_path("a b:c$d"), "a$ b$:c$$d");
  EXPECT_EQ(ninja_path("two\nlines\r"), "two$ lines$ ");
}

TEST(NinjaValue, EscapesDollarsAndABlankInFront) {
  EXPECT_EQ(ninja_value("a b:c$d|e"), "a b:c$$d|e");
  EXPECT_EQ(ninja_value("  a"), "$  a");
  EXPECT_EQ(ninja_value("two\nlines\r"), "two lines ");
}

TEST(JsonQuoted, EscapesQuotesAndControls) {
  EXPECT_EQ(json_quoted("a\"b\\c"), "\"a\\\"b\\\\c\"");
  EXPECT_EQ(json_quoted("line\nbell\a"), "\"line\\nbell\\u0007\"");
  EXPECT_EQ(json_quoted("Féerie"), "\"Féerie\"");
  // Names of files may be none: the JSON is whole all the same.
  EXPECT_EQ(json_quoted("b\xe4um\xc3"), "\"b\\ufffdum\\ufffd\"");
}

}  // namespace
}  // namespace frond
