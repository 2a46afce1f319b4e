#include <gtest/gtest.h>

#include <regex>
#include <span>

#include "scene/preset.h"

// Whole presets that are wrong, each with all that is said of it.
namespace frond {
namespace {

struct WrongPreset {
  const char* name;
  std::string text;
  std::vector<std::string> sets;
  std::vector<std::string> messages;  ///< those about the file without "reef.json:"
};

// The text itself.
const WrongPreset kWrongTexts[] = {
    {"An empty file", "", {}, {"1:1: /: the end of the text; expected a value"}},
    {"A truncated file",
     R"({
  "title": "Reef",
  "film": {"frames": 1,)",
     {},
     {"3:24: /film: the end of the text; expected a name in double quotes"}},
    {"A text without end",
     R"({"title": "Reef}
)",
     {},
     {R"(1:17: /title: a line break or control character inside a text; expected an escape such as \n)"}},
    {"A trailing comma",
     R"({
  "title": "Reef",
})",
     {},
     {"2:18: /: a comma before the closing '}'; expected no comma behind the last member"}},
    {"A trailing comma in a list",
     R"({"film": {"size": [64, 48,]}})",
     {},
     {"1:26: /film/size: a comma before the closing ']'; expected no comma behind the last element"}},
    {"A missing comma",
     R"({"title": "Reef"
 "seed": 1})",
     {},
     {R"(2:2: /: '"'; expected ',' or '}')"}},
    {"A name without quotes", "{seed: 1}", {}, {"1:2: /: 's'; expected a name in double quotes"}},
    {"Names that stand twice",
     R"({"seed": 1,
 "film": {"fps": 24, "fps": 25},
 "seed": 2})",
     {},
     {R"(2:22: /film/fps: the name "fps" a second time; expected it once)",
      R"(3:2: /seed: the name "seed" a second time; expected it once)"}},
    {"Two presets in a file",
     R"({"seed": 1}
{"seed": 2})",
     {},
     {"2:1: /: '{'; expected the end of the text"}},
    {"Not utf8",
     "{\"title\": \"R\xe9"
     "cif\"}",
     {},
     {"1:13: /: bytes that are not UTF-8; expected UTF-8"}},
    {"Not an object", R"(["coral"])", {}, {"1:1: /: found a list of 1; expected an object"}},
};

// Names that nobody knows, at every level.
const WrongPreset kWrongNames[] = {
    {"An unknown key",
     R"({"titel": "Reef",
 "flim": {}})",
     {},
     {R"(1:2: /titel: unknown property "titel"; expected one of title, base, seed, film, scene, defaults, force, organisms; did you mean "title"?)",
      R"(2:2: /flim: unknown property "flim"; expected one of title, base, seed, film, scene, defaults, force, organisms; did you mean "film"?)"}},
    {"An unknown key of film",
     R"({"film": {"frame": 1, "Quality": "best"}})",
     {},
     {R"(1:11: /film/frame: unknown property "frame"; expected one of frames, fps, size, quality; did you mean "frames"?)",
      R"(1:23: /film/Quality: unknown property "Quality"; expected one of frames, fps, size, quality; did you mean "quality"?)"}},
    {"An unknown key of the scene",
     R"({"scene": {"camrea": {}, "water": {"colour": "#ffffff"}, "floor": {"stone": 1}}})",
     {},
     {R"(1:12: /scene/camrea: unknown property "camrea"; expected one of setting, camera, water, studio, meadow, garden, forest, floor; did you mean "camera"?)",
      R"(1:36: /scene/water/colour: unknown property "colour"; expected one of near, deep, visibility, sun, caustics, shafts, particles)",
      R"(1:68: /scene/floor/stone: unknown property "stone"; expected one of relief, scale, stones, stone_size, extent; did you mean "stones"?)"}},
    {"An unknown key of the camera",
     R"({"scene": {"camera": {"lookat": [0, 0, 0]}}})",
     {},
     {R"(1:23: /scene/camera/lookat: unknown property "lookat"; expected one of location, look_at, angle, follow; did you mean "look_at"?)"}},
    {"An unknown key of a coral",
     R"({"organisms": [{"kind": "coral", "hieght": 1}]})",
     {},
     {R"(1:34: /organisms/0/hieght: unknown property "hieght"; expected one of N known names; did you mean "height"?)"}},
    {"An unknown key within a coral",
     R"({"organisms": [{"kind": "coral", "wave": {"ampltude": 1}, "skin": {"tint": {"colour": 1}},
  "place": {"position": [0, 0]}}]})",
     {},
     {R"(1:43: /organisms/0/wave/ampltude: unknown property "ampltude"; expected one of amplitude, speed, phase, length, direction, loop; did you mean "amplitude"?)",
      R"(1:77: /organisms/0/skin/tint/colour: unknown property "colour"; expected one of base, secondary, hue, saturation, value, variation, young, young_length)",
      R"(2:13: /organisms/0/place/position: unknown property "position"; expected one of at, center, inner, radius, spacing, size_variation, turn, turn_variation, lean, raise, rock)"}},
    {"An unknown key of a grammar",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"axoim": "F", "rules": [{"rule": "F -> FF", "limits": 1}]}}]})",
     {},
     {R"(3:16: /organisms/0/grammar/axoim: unknown property "axoim"; expected one of N known names; did you mean "axiom"?)",
      R"(3:60: /organisms/0/grammar/rules/0/limits: unknown property "limits"; expected one of rule, limit; did you mean "limit"?)"}},
    {"An unknown key of the defaults",
     R"({"defaults": {"wav": {}}, "organisms": []})",
     {},
     {R"(1:15: /defaults/wav: unknown property "wav"; expected one of N known names; did you mean "wave"?)"}},
    {"An unknown name to force",
     R"({"force": ["wav", "wave/sped"], "organisms": []})",
     {},
     {R"(1:12: /force/0: unknown property "wav"; expected one of N known names; did you mean "wave"?)",
      R"(1:19: /force/1: unknown property "sped"; expected one of amplitude, speed, phase, length, direction, loop; did you mean "speed"?)"}},
    {"A force that is no list",
     R"({"force": "wave"})",
     {},
     {R"(1:11: /force: found the text "wave"; expected a list)"}},
    {"A misspelt kind",
     R"({"organisms": [{"kind": "corla"}]})",
     {},
     {R"(1:25: /organisms/0/kind: found the text "corla"; expected one of N known names; did you mean "coral"?)"}},
    {"No kind",
     R"({"organisms": [{"name": "Staghorn"}]})",
     {},
     {R"(1:16: /organisms/0: no "kind"; expected one of the kinds)"}},
    {"A misspelt choice",
     R"({"film": {"quality": "god"},
 "scene": {"setting": "sky"},
 "organisms": [{"kind": "coral", "form": "branch", "skin": {"kind": "stone"}}]})",
     {},
     {R"(1:22: /film/quality: found the text "god"; expected one of draft, good, best; did you mean "good"?)",
      R"(2:23: /scene/setting: found the text "sky"; expected one of underwater, studio, meadow, garden, forest)",
      R"(3:42: /organisms/0/form: found the text "branch"; expected one of branching, tufted, own)",
      R"(3:69: /organisms/0/skin/kind: found the text "stone"; expected one of stony, fan, soft; did you mean "stony"?)"}},
};

// Values of the wrong type or out of range.
const WrongPreset kWrongValues[] = {
    {"Wrong types",
     R"({"title": 1,
 "seed": "1",
 "film": [1],
 "scene": {"water": {"particles": true}},
 "organisms": {"kind": "coral"}})",
     {},
     {"1:11: /title: found 1; expected a text",
      R"(2:10: /seed: found the text "1"; expected a whole number from 0 to 9000000000000000)",
      "3:10: /film: found a list of 1; expected an object",
      "4:35: /scene/water/particles: found true; expected a whole number from 0 to 1000",
      "5:15: /organisms: found an object; expected a list"}},
    {"Out of range",
     R"({"film": {"frames": 0, "fps": -24},
 "scene": {"camera": {"angle": 170}, "water": {"visibility": 0}},
 "organisms": [{"kind": "coral", "steps": 13, "pitch": 270, "thickness": {"radius": 0}}]})",
     {},
     {"1:21: /film/frames: found 0; expected a whole number from 1 to 100000",
      "1:31: /film/fps: found -24; expected a number from 0.1 to 1000",
      "2:32: /scene/camera/angle: found 170; expected a number from 1 to 160 degrees",
      "2:62: /scene/water/visibility: found 0; expected a number from 0.5 to 1000 m",
      "3:43: /organisms/0/steps: found 13; expected a whole number from 1 to 12",
      "3:56: /organisms/0/pitch: found 270; expected a number from -180 to 180 degrees",
      "3:85: /organisms/0/thickness/radius: found 0; expected a number above 0 up to 5 m"}},
    {"Not whole",
     R"({"seed": 0.5, "film": {"frames": 1.5}})",
     {},
     {"1:10: /seed: found 0.5; expected a whole number from 0 to 9000000000000000",
      "1:34: /film/frames: found 1.5; expected a whole number from 1 to 100000"}},
    {"A negative count",
     R"({"organisms": [{"kind": "coral", "count": -1}]})",
     {},
     {"1:43: /organisms/0/count: found -1; expected a whole number from 0 to 1000000"}},
    {"Bad sizes",
     R"({"film": {"size": [64]}})",
     {},
     {"1:19: /film/size: found a list of 1; expected [width, height]"}},
    {"A size out of range",
     R"({"film": {"size": [8, 20000]}})",
     {},
     {"1:20: /film/size/0: found 8; expected a whole number from 16 to 16384 pixels",
      "1:23: /film/size/1: found 20000; expected a whole number from 16 to 16384 pixels"}},
    {"Bad colors",
     R"({"scene": {"water": {"near": "blue", "deep": [0, 0.5, 2]}},
 "defaults": {"skin": {"tint": {"base": "#12345"}}}})",
     {},
     {R"(1:30: /scene/water/near: found the text "blue"; expected a color, as "#rrggbb" or [red, green, blue] from 0 to 1)",
      "1:55: /scene/water/deep/2: found 2; expected a number from 0 to 1",
      R"(2:41: /defaults/skin/tint/base: found the text "#12345"; expected a color, as "#rrggbb" or [red, green, blue] from 0 to 1)"}},
    {"Bad vectors",
     R"({"scene": {"camera": {"location": [0, 1], "look_at": "reef"}},
 "organisms": [{"kind": "coral", "place": {"at": [[0, 0], [1]]}}]})",
     {},
     {"1:35: /scene/camera/location: found a list of 2; expected a list of 3 numbers from -1000 to 1000 m",
      R"(1:54: /scene/camera/look_at: found the text "reef"; expected a list of 3 numbers from -1000 to 1000 m, or keyframes [[seconds, value], ...])",
      "2:59: /organisms/0/place/at/1: found a list of 1; expected a list of 2 numbers"}},
    {"Keyframes in disorder",
     R"({"scene": {"camera": {"location": [[1, [0, 1, 2]], [0, [0, 1, 3]]],
  "angle": [[0, 45], [0, 50], [1, 500]]}}})",
     {},
     {"1:53: /scene/camera/location/1/0: found 0; expected a time greater than 1 before it",
      "2:23: /scene/camera/angle/1/0: found 0; expected a time greater than 0 before it",
      "2:35: /scene/camera/angle/2/1: found 500; expected a number from 1 to 160 degrees"}},
    {"Bad keyframes",
     R"({"scene": {"camera": {"location": [[0, [0, 1]], [1]], "angle": []}}})",
     {},
     {"1:40: /scene/camera/location/0/1: found a list of 2; expected a list of 3 numbers from -1000 to 1000 "
      "m",
      "1:49: /scene/camera/location/1: found a list of 1; expected a keyframe [seconds, value]",
      "1:64: /scene/camera/angle: found an empty list; expected a number from 1 to 160 degrees, or keyframes "
      "[[seconds, value], ...]"}},
    {"Bad curves",
     R"({"organisms": [{"kind": "coral", "thickness": {"curve": [[0, 1]]}},
  {"kind": "coral", "thickness": {"curve": [[0, 1], [0.5, 1], [0.5, 2]]}},
  {"kind": "coral", "thickness": {"curve": "thin"}}]})",
     {},
     {"1:57: /organisms/0/thickness/curve: found a list of 1; expected a curve: two or more points [[x, y], "
      "...]",
      "2:64: /organisms/1/thickness/curve/2/0: found 0.5; expected an x greater than 0.5 before it",
      R"(3:44: /organisms/2/thickness/curve: found the text "thin"; expected a curve: two or more points [[x, y], ...])"}},
    {"A fault of the defaults once",
     R"({"defaults": {"wave": {"speed": -1}}, "organisms": [{"kind": "coral"}, {"kind": "coral"}]})",
     {},
     {"1:33: /defaults/wave/speed: found -1; expected a number from 0 to 20 1/s"}},
};

// Own grammars: found when all else is right.
const WrongPreset kWrongGrammars[] = {
    {"An empty grammar",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": ""}]})",
     {},
     {R"(3:15: /organisms/0/grammar: found the text ""; expected an object)"}},
    {"An empty rule",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": [""]}}]})",
     {},
     {"3:26: /organisms/0/grammar/rules/0: column 1: no arrow; a rule is `predecessor -> successor`; in ``"}},
    {"A rule without arrow",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": ["F -> FF",
     "F = F"]}}]})",
     {},
     {"4:6: /organisms/0/grammar/rules/1: column 6: no arrow; a rule is `predecessor -> successor`; in `F = "
      "F`"}},
    {"An unbalanced bracket",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"axiom": "F]", "rules": [
     "F -> F[+F",
     {"rule": "A -> F]"}]}}]})",
     {},
     {"3:25: /organisms/0/grammar/axiom: column 2: this `]` closes no `[`; remove it or open the branch; in "
      "`F]`",
      "4:6: /organisms/0/grammar/rules/0: column 7: this `[` is not closed; add a `]`; in `F -> F[+F`",
      "5:6: /organisms/0/grammar/rules/1: column 7: this `]` closes no `[`; remove it or open the branch; in "
      "`A -> F]`"}},
    {"An unknown function",
     R"~({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": [
     "F(x) -> F(sine(x))"]}}]})~",
     {},
     {"4:6: /organisms/0/grammar/rules/0: column 11: there is no function `sine`; did you mean `sin`?; in "
      "`F(x) -> F(sine(x))`"}},
    {"An unknown variable",
     R"~({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": ["F(x) -> F(y)"], "constants": {"a": "b + 1", "2c": 1}}}]})~",
     {},
     {"3:26: /organisms/0/grammar/rules/0: column 11: `y` is not a parameter of the rule, nor a constant; "
      "known are x; in `F(x) -> F(y)`",
      "3:56: /organisms/0/grammar/constants: `2c` is not a name; use letters, digits and _",
      "3:62: /organisms/0/grammar/constants/a: column 1: `b` is not a parameter of the rule, nor a constant; "
      "declare it in `constants`; in `b + 1`"}},
    {"A rule that is never used",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": ["F -> FF",
     "F -> F[+F]F"]}}]})",
     {},
     {"4:6: /organisms/0/grammar/rules/1: `F -> F[+F]F` can never be used: `F -> FF` (reef.json:3:26: "
      "/organisms/0/grammar/rules/0) comes first and always matches; put it before, give both a weight, or "
      "remove it"}},
    {"Bad rules of every list",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"rules": [{"rule": "F -> FF", "limit": 0}],
     "decomposition": ["A < B -> C"],
     "interpretation": ["C"]}}]})",
     {},
     {"3:26: /organisms/0/grammar/rules/0: column 1: the limit is 0; it must be 1 or more, or left out; in "
      "`F -> FF`",
      "4:24: /organisms/0/grammar/decomposition/0: column 1: a decomposition rule has no context; remove `<` "
      "and `>`; in `A < B -> C`",
      "5:25: /organisms/0/grammar/interpretation/0: column 2: no arrow; a rule is `predecessor -> "
      "successor`; in `C`"}},
    {"Grammar numbers out of range",
     R"({"organisms": [
  {"kind": "coral", "form": "own",
   "grammar": {"width": 0,
     "symbols": ["a b"],
     "ignore": "+", "consider": "F"}}]})",
     {},
     {"3:25: /organisms/0/grammar/width: `width` is 0; it must be more than 0",
      "4:17: /organisms/0/grammar/symbols: `a b` cannot be a symbol: no blanks, commas or brackets",
      "5:33: /organisms/0/grammar/consider: give either `ignore` or `consider`, not both"}},
    {"A grammar of the defaults once",
     R"({"defaults": {"form": "own",
  "grammar": {"axiom": "F["}},
 "organisms": [{"kind": "coral"}, {"kind": "coral"}]})",
     {},
     {"2:24: /organisms/0/grammar/axiom: column 2: this `[` is not closed; add a `]`; in `F[`"}},
    {"Rules that no coral grows by, and a coral without its own",
     R"({"organisms": [
  {"kind": "coral", "grammar": {"rules": ["F -> FF"]}},
  {"kind": "coral", "form": "own"}]})",
     {},
     {R"(2:32: /organisms/0/grammar: found rules, but the coral grows by those of its form; expected "form": "own")",
      R"(3:29: /organisms/1/form: found "own" and no rules; expected a "grammar")"}},
    {"Words past their limits",
     R"({"organisms": [
  {"kind": "coral", "form": "own", "grammar": {"rules": ["F -> FF"], "steps": 60}},
  {"kind": "plant", "grammar": {"rules": ["F -> FF"], "steps": 5, "limits": {"modules": 20}}}]})",
     {},
     {"2:47: /organisms/0/grammar: step 28 would have 2.684e+08 modules or segments, past the limit of "
      "200000000 "
      "modules and 4294967296 bytes; the last step would have 1.153e+18 (1.15e+18 bytes): use at most 27 "
      "steps, or "
      "raise `limits`",
      "3:32: /organisms/1/grammar: step 5 would have 32 modules or segments, past the limit of 20 modules "
      "and "
      "4294967296 bytes; the last step would have 32 (32 bytes): use at most 4 steps, or raise `limits`"}},
    {"A decomposition without end",
     R"({"organisms": [{"kind": "plant", "grammar": {
  "decomposition": ["F -> FX"]}}]})",
     {},
     {"2:21: /organisms/0/grammar/decomposition/0: `F -> FX` never ends: what it makes is taken apart into "
      "`F` again; "
      "give it a condition, or put it among `rules`"}},
};

// Overrides of the command line.
const WrongPreset kWrongOverrides[] = {
    {"Bad overrides",
     R"({"organisms": [{"kind": "coral"}]})",
     {"film/fps=25", "/film/fps", "/film~fps=25", "/organisms/1/steps=3", "/organisms/0/kind/x=1"},
     {"--set film/fps: found a pointer without '/' in front; expected /film/fps",
      "--set /film/fps: found no '='; expected POINTER=VALUE, as in /film/fps=24",
      "--set /film~fps: found a single '~'; expected ~0 for '~' and ~1 for '/'",
      R"(--set /organisms/1/steps: found "1" as the index of a list of 1 at /organisms; expected the index 0, or - to add to it)",
      R"(--set /organisms/0/kind/x: found the text "coral" at /organisms/0/kind, which has nothing inside; expected an object or a list)"}},
    {"Overrides of unknown names",
     "{}",
     {"/film/fsp=25", "/scene/camera/angle=wide"},
     {R"(--set /film/fsp: /film/fsp: unknown property "fsp"; expected one of frames, fps, size, quality; did you mean "fps"?)",
      R"(--set /scene/camera/angle: /scene/camera/angle: found the text "wide"; expected a number from 1 to 160 degrees, or keyframes [[seconds, value], ...])"}},
    {"An override of a rule",
     R"({"organisms": [{"kind": "coral", "form": "own", "grammar": {"rules": ["F -> FF"]}}]})",
     {"/organisms/0/grammar/rules/0=F -> F["},
     {"--set /organisms/0/grammar/rules/0: /organisms/0/grammar/rules/0: column 7: this `[` is not closed; "
      "add a `]`; in `F -> F[`"}},
    {"Faults of file and override",
     R"({"seed": -1})",
     {"/film/frames=0"},
     {"1:10: /seed: found -1; expected a whole number from 0 to 9000000000000000",
      "--set /film/frames: /film/frames: found 0; expected a whole number from 1 to 100000"}},
};

void expect_messages(std::span<const WrongPreset> presets) {
  for (const WrongPreset& wrong : presets) {
    Result<Preset> preset = read_preset(wrong.text, "reef.json", wrong.sets);
    ASSERT_FALSE(preset.ok()) << wrong.name;
    std::vector<std::string> messages;
    for (const Error& error : preset.errors()) {
      std::string message = error.text();
      EXPECT_EQ(message.find('\n'), message.npos) << message;
      if (message.starts_with("reef.json:")) message.erase(0, message.find(':') + 1);
      // How many there are changes with each new property.
      message = std::regex_replace(message, std::regex("[0-9]+ known names"), "N known names");
      messages.push_back(
          std::regex_replace(message, std::regex("one of coral, plant[a-z_, ]*"), "one of the kinds"));
    }
    EXPECT_EQ(messages, wrong.messages) << wrong.name << "\n" << wrong.text;
  }
}

TEST(WrongPresets, Text) { expect_messages(kWrongTexts); }
TEST(WrongPresets, Names) { expect_messages(kWrongNames); }
TEST(WrongPresets, Values) { expect_messages(kWrongValues); }
TEST(WrongPresets, Grammars) { expect_messages(kWrongGrammars); }
TEST(WrongPresets, Overrides) { expect_messages(kWrongOverrides); }

}  // namespace
}  // namespace frond
