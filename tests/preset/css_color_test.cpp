#include "preset/css_color.h"

#include <gtest/gtest.h>

#include "preset/json.h"
#include "preset/palettes.h"
#include "preset/schema_parts.h"

namespace frond {
namespace {

/// As #rrggbb, rounded; "none" where it is no colour.
std::string shown(std::string_view text) {
  std::optional<Color> color = css_color(text);
  return color ? color_default(*color).text : "none";
}

TEST(CssColor, ReadsEachNotation) {
  struct {
    std::string_view text, color;
  } const cases[] = {
      {"goldenrod", "#daa520"},
      {"RebeccaPurple", "#663399"},
      {"grey", "#808080"},
      {"#d92", "#dd9922"},
      {"#D98a4e", "#d98a4e"},
      {"rgb(221, 153, 34)", "#dd9922"},
      {"rgb(221 153 34)", "#dd9922"},
      {"rgb(100%, 0%,20%)", "#ff0033"},
      {"hsl(120, 100%, 25%)", "#008000"},
      {"hsl(-240deg 100% 25%)", "#008000"},
      {"HSL(38, 73%, 50%)", "#dd9822"},
      {"hsl(0, 0%, 100%)", "#ffffff"},
  };
  for (const auto& c : cases) EXPECT_EQ(shown(c.text), c.color) << c.text;
}

TEST(CssColor, RefusesWhatIsNone) {
  for (std::string_view text :
       {"", "#", "#12345", "#12345678", "#ff80zz", "transparent", "currentcolor", "bleu", "rgb(256, 0, 0)",
        "rgb(1, 2)", "rgb(1, 2, 3, 0.5)", "rgb(1 2 3 / 50%)", "rgb(10%, 2, 3)", "rgba(1, 2, 3, 1)",
        "hsl(120, 50, 50)", "hsl(120, 50%, 101%)", "rgb(1,,2)", "rgb(nan, 0, 0)"})
    EXPECT_EQ(shown(text), "none") << text;
  EXPECT_EQ(nearest_css_name("goldenrood"), "goldenrod");
  EXPECT_EQ(nearest_css_name("transparent"), "");
}

TEST(Palettes, StandInPlace) {
  Document document =
      *parse_json(R"({"title": "palette:autumn", "palettes": {"autumn": ["red", "#0f0"], "one": ["blue"]},
"organisms": [{"colors": ["palette:autumn", "white", "palette:autumn/1"], "second": "palette:autumn/0", "bud": "palette:one"}]})",
                  "f");
  EXPECT_TRUE(use_palettes(document.root).empty());
  EXPECT_EQ(serialize(*document.root.find("organisms")),
            R"([{"colors":["red","#0f0","white","#0f0"],"second":"red","bud":"blue"}])");
  EXPECT_EQ(document.root.find("title")->text, "palette:autumn");
}

TEST(Palettes, NamesWhatIsMissing) {
  Document document = *parse_json(R"({"palettes": {"autumn": ["red", "#0f0"]},
"defaults": {"a": "palette:autum",
"b": ["palette:autumn/2"],
"c": "palette:autumn"}})",
                                  "f");
  std::string found;
  for (const Error& error : use_palettes(document.root)) found += error.text() + "\n";
  EXPECT_EQ(found, R"(f:2:19: /defaults/a: no palette "autum"; expected autumn; did you mean "autumn"?
f:3:7: /defaults/b/0: found the color "2" of a palette; expected a number from 0 to 1
f:4:6: /defaults/c: found a palette of 2 colors; expected one of them, as "palette:autumn/0"
)");
}

}  // namespace
}  // namespace frond
