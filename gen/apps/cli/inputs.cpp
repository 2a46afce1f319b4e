#include "cli/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cli/streams.h"
#include "core/files.h"
#include "core/home.h"
#include "core/read_as.h"
#include "core/text.h"
#include "grammar/kind.h"
#include "jobs/escape.h"
#include "preset/json.h"
#include "preset/range_text.h"
#include "resolve/resolve.h"
#include "scene/describe.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// What sets the size of a film to so many times what it is.
Result<std::string> scaled_size(const Film& film, double scale) {
  constexpr double kMost = 16;
  constexpr long kLargest = 16384;
  if (!(scale >= 1 && scale <= kMost))
    return error_at("--scale", "{} is no such factor; expected a number from 1 to {}", scale, kMost);
  long width = std::lround(film.size[0] * scale), height = std::lround(film.size[1] * scale);
  if (std::max(width, height) > kLargest)
    return error_at("--scale", "pictures of {}x{} would be {}x{} pixels; expected {} at most", film.size[0],
                    film.size[1], width, height, kLargest);
  return fmt::format("/film/size=[{},{}]", width, height);
}

constexpr double kUsualDpi = 300;
constexpr Range kDpi{.min = 1, .max = 10000};

/// Consumes a number above 0 at the front of a text; 0 where there is none.
double consume_length(std::string_view& text) {
  double number = consume_as<double>(text).value_or(0);
  return number > 0 ? number : 0;
}

bool consume_sign(std::string_view& text, std::string_view sign) {
  if (!text.starts_with(sign)) return false;
  text.remove_prefix(sign.size());
  return true;
}

/// Inches of a unit; 0 where it is none.
double inches(std::string_view unit) {
  return unit == "cm" ? 1 / 2.54 : unit == "mm" ? 1 / 25.4 : unit == "in" ? 1 : 0;
}

/// Consumes a number of pixels, or per cent of `whole`, at the front of a text; negative where there is none.
int consume_pixels(std::string_view& text, int whole) {
  double number = consume_as<double>(text).value_or(-1);
  if (!(number >= 0 && number <= 1e6)) return -1;
  if (consume_sign(text, "%")) number *= whole / 100.0;
  return static_cast<int>(std::lround(number));
}

Result<PixelRect> asked_crop(const std::string& asked, const std::array<int, 2>& size) {
  PixelRect crop;
  std::string_view rest = asked;
  bool good = (crop.x = consume_pixels(rest, size[0])) >= 0 && consume_sign(rest, ",") &&
              (crop.y = consume_pixels(rest, size[1])) >= 0 && consume_sign(rest, ",") &&
              (crop.width = consume_pixels(rest, size[0])) >= 0 && consume_sign(rest, "x") &&
              (crop.height = consume_pixels(rest, size[1])) >= 0 && rest.empty();
  if (!good)
    return error_at("--crop",
                    "\"{}\" is no part of a picture; expected X,Y,WIDTHxHEIGHT in pixels or per cent, as in "
                    "10,20,300x200 or 25%,25%,50%x50%",
                    asked);
  if (crop.width < 1 || crop.height < 1 || crop.x + crop.width > size[0] || crop.y + crop.height > size[1])
    return error_at("--crop", "{},{},{}x{} pixels do not lie within the picture; expected a part of {}x{}",
                    crop.x, crop.y, crop.width, crop.height, size[0], size[1]);
  return crop;
}

/// The size in pixels that `--print` and `--dpi` ask for, as what sets it; one side keeps the film's aspect.
Result<std::string> printed_size(const PresetArguments& arguments, const Film& film) {
  if (arguments.size || arguments.scale)
    return error_at("--print", "says the size, as {} does; expected one of the two",
                    arguments.size ? "--size" : "--scale");
  std::string_view rest = *arguments.print;
  double first = consume_length(rest), second = consume_sign(rest, "x") ? consume_length(rest) : -1,
         unit = inches(rest);
  if (first == 0 || second == 0 || unit == 0)
    return error_at("--print", "\"{}\" is no size on paper; expected one as 20cm, 20x15cm, 150mm or 8in",
                    *arguments.print);
  double dots = arguments.dpi.value_or(kUsualDpi) * unit;
  bool wide = film.size[0] >= film.size[1];
  double shape = film.aspect(), width = first, height = second;
  if (second < 0) width = wide ? first : first / shape, height = wide ? first * shape : first;
  width = std::round(width * dots), height = std::round(height * dots);
  if (!kSides.holds(width) || !kSides.holds(height))
    return error_at("--print", "found {}, {:g}x{:g} pixels; expected sides{}", *arguments.print, width,
                    height, range_text(kSides));
  return fmt::format("/film/size=[{:.0f},{:.0f}]", width, height);
}

/// Sets what the options say of how pictures are written; `film` has its size.
Errors set_pictures(const PresetArguments& arguments, Film& film) {
  if (arguments.dpi && !kDpi.holds(*arguments.dpi))
    return {error_at("--dpi", "found {:g}; expected a number{}", *arguments.dpi, range_text(kDpi))};
  if (arguments.print || arguments.dpi) film.dpi = arguments.dpi.value_or(kUsualDpi);
  film.depth = arguments.depth.value_or(film.depth);
  if (!arguments.crop) return {};
  Result<PixelRect> crop = asked_crop(*arguments.crop, film.size);
  if (!crop) return crop.errors();
  film.crop = *crop;
  return {};
}

/// Whether a text is the JSON of a grammar; one that does not even hold the word is not parsed.
bool is_grammar_text(const std::string& text) {
  if (text.find("axiom") == text.npos) return false;
  Result<Document> document = parse_json(text, "");
  return document && document->root.find("axiom") && !document->root.find("organisms");
}

/// The value of `--fps` or `--seconds`, as what sets it; of seconds the number of frames, at a film's rate.
Result<std::string> asked_pace(const char* option, double asked, const char* pointer, double frames) {
  if (!(asked > 0) || !std::isfinite(asked))
    return error_at(option, "found {}; expected a number above 0", asked);
  if (!(frames <= 1e6))
    return error_at(option, "{} would be {:.0f} frames; expected 1000000 at most", asked, frames);
  return fmt::format("{}={}", pointer, frames);
}

/// The folder of `--assets`; empty: any file is read.
Result<std::optional<fs::path>> assets_folder(const std::optional<std::string>& named) {
  if (!named) return std::optional<fs::path>{};
  if (!is_folder(*named))
    return error_at("--assets", "\"{}\" is no folder; expected one that may be read", *named);
  return std::optional<fs::path>(*named);
}

/// The size that `--size` asks for, as what sets it.
Result<std::string> asked_size(const std::string& asked) {
  std::string_view rest = asked;
  int width = consume_whole(rest);
  bool cross = consume_sign(rest, "x");
  int height = consume_whole(rest);
  if (!cross || width == 0 || height == 0 || !rest.empty())
    return error_at("--size", "\"{}\" is no size; expected WIDTHxHEIGHT, as in 640x360", asked);
  if (!kSides.holds(width) || !kSides.holds(height))
    return error_at("--size", "found {}; expected sides{}", asked, range_text(kSides));
  return fmt::format("/film/size=[{},{}]", width, height);
}

Result<std::string> asked_quality(const std::string& asked) {
  std::vector<std::string_view> names;
  for (const auto& row : kQualities) names.push_back(row.name);
  if (std::ranges::find(names, asked) != names.end()) return "/film/quality=" + asked;
  return Error{"--quality", "found " + found_text(make_text(asked)) + expected_names(asked, names)};
}

}  // namespace

Result<fs::path> home() {
  fs::path path = home_folder();
  if (path_exists(path / "templates" / "frame.pov")) return path;
  return Error{path.string(), "holds no templates/frame.pov; set FROND_HOME to the folder of Frond"};
}

std::string render_command() {
  Result<fs::path> root = home();
  std::error_code error;
  if (!root || !fs::exists(*root / "scripts" / "render.sh", error)) return {};
  bool here = fs::equivalent(*root, fs::current_path(error), error);
  return here ? "scripts/render.sh" : (fs::absolute(*root, error) / "scripts" / "render.sh").string();
}

std::string nearest_presets(const std::string& path) {
  Result<fs::path> root = home();
  if (!root) return {};
  std::vector<fs::path> files;
  for (const fs::path& file : files_below(*root / "presets"))
    if (file.extension() == ".json") files.push_back(file);
  std::vector<std::string> stems;
  for (const fs::path& file : files) stems.push_back(file.stem().string());
  std::string near(nearest_name(fs::path(path).stem().string(), stems)), found;
  for (std::size_t i = 0; i < files.size(); ++i)
    if (stems[i] == near && !is_grammar(files[i].string()))
      found += fmt::format("{}\"{}\"", found.empty() ? "" : " or ", fs::proximate(files[i]).string());
  return found.empty() ? "" : fmt::format("; did you mean {}?", found);
}

void refuse_missing(const PresetArguments& preset) {
  if (!is_file(preset.path))
    fail_run({{"", preset.path + ": no such preset" + nearest_presets(preset.path)}}, kWrongInput);
}

fs::path out_folder(const std::string& asked, const PresetArguments& preset, std::string_view ending) {
  return asked.empty() ? fs::path("out") / out_file("", preset, ending) : fs::path(asked);
}

std::string out_file(const std::string& asked, const PresetArguments& preset, std::string_view ending) {
  return asked.empty() ? fs::path(preset.path).stem().string().append(ending) : asked;
}

Result<Assets> assets_of(const std::string& path, const std::optional<std::string>& named) {
  Result<std::optional<fs::path>> only = assets_folder(named);
  if (!only) return only.errors();
  return Assets(path, *only);
}

Result<Upgrade> upgraded(const std::string& path, const std::optional<std::string>& assets) {
  Result<std::string> text = read_file(path);
  if (!text) return text.errors();
  Result<Assets> files = assets_of(path, assets);
  if (!files) return files.errors();
  return upgrade_preset(*text, path, [&](const std::string& name) { return files->read(name).ok(); });
}

Error old_form(const std::string& path) {
  return error_at(path, "is of an earlier version; `frond check --upgrade {}` carries it over",
                  shell_quoted(path));
}

Result<Preset> load_preset(const PresetArguments& arguments) {
  now_doing("reading the preset");
  Result<std::string> text = read_file(arguments.path);
  if (!text) {
    Error error = text.errors().front();
    if (!path_exists(arguments.path)) error.what += nearest_presets(arguments.path);
    return error;
  }
  Result<std::optional<fs::path>> only = assets_folder(arguments.assets);
  if (!only) return only.errors();
  std::vector<std::string> sets = arguments.sets;
  if (arguments.transparent) sets.emplace_back("/film/background=transparent");
  for (const auto& [asked, read] :
       {std::pair(arguments.size, &asked_size), std::pair(arguments.quality, &asked_quality)}) {
    Result<std::string> set = asked ? read(*asked) : std::string();
    if (!set) return set.errors();
    if (asked) sets.push_back(*set);
  }
  if (arguments.fps) {
    Result<std::string> set = asked_pace("--fps", *arguments.fps, "/film/fps", *arguments.fps);
    if (!set) return set.errors();
    sets.push_back(*set);
  }
  Result<Preset> preset = read_preset(*text, arguments.path, sets, *only);
  if (!preset && is_grammar_text(*text))
    return error_at(arguments.path,
                    "is a grammar, no preset; `frond turtle {0} --svg` draws it, `frond derive {0}` derives "
                    "it, and the kind plant grows by it",
                    arguments.path);
  if (preset && arguments.seconds) {
    double frames = std::max(1.0, std::round(*arguments.seconds * preset->film.fps));
    Result<std::string> set = asked_pace("--seconds", *arguments.seconds, "/film/frames", frames);
    if (!set) return set.errors();
    sets.push_back(*set);
    preset = read_preset(*text, arguments.path, sets, *only);
  }
  if (preset && (arguments.scale || arguments.print)) {
    Result<std::string> size =
        arguments.print ? printed_size(arguments, preset->film) : scaled_size(preset->film, *arguments.scale);
    if (!size) return size.errors();
    sets.push_back(*size);
    preset = read_preset(*text, arguments.path, sets, *only);
  }
  if (!preset) {
    Errors errors = preset.errors();
    Result<Upgrade> today = upgraded(arguments.path, arguments.assets);
    if (today && !today->changes.empty()) errors.push_back(old_form(arguments.path));
    return errors;
  }
  if (Errors errors = set_pictures(arguments, preset->film); !errors.empty()) return errors;
  return preset;
}

bool is_grammar(const std::string& path) {
  Result<std::string> text = read_file(path);
  if (!text ? !path.ends_with(".json") : grammar_kind(path, *text) != GrammarKind::preset) return true;
  return text && is_grammar_text(*text);
}

}  // namespace frond
