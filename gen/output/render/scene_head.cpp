#include "render/scene_head.h"

#include <algorithm>
#include <fstream>

#include "core/read_as.h"

namespace frond {

namespace {

/// Consumes a word at the front of a text; false where something else stands there.
bool consume(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

template <class Number>
bool consume_number(std::string_view& text, Number& number) {
  std::optional<Number> taken = consume_as<Number>(text);
  number = taken.value_or(number);
  return taken.has_value();
}

/// The name of the file of soft light in a line: "light_0123.rca" of "... +RFlight_0123.rca ..."; empty where
/// there is none.
std::string light_of(std::string_view line) {
  constexpr std::string_view kFlag = "+RF", kEnd = ".rca";
  for (std::size_t at = 0; (at = line.find(kFlag, at)) != line.npos; ++at) {
    std::string_view rest = line.substr(at + kFlag.size());
    std::size_t stem = rest.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_");
    if (stem != rest.npos && stem > 0 && rest.substr(stem).starts_with(kEnd))
      return std::string(rest.substr(0, stem)) + std::string(kEnd);
  }
  return {};
}

/// Reads the flags and the numbers of a crop from a line as "+SC1 +EC64 +SR33 +ER96 (of which 10,40,50x30)";
/// other lines change nothing.
void read_crop(std::string_view line, SceneHead& head) {
  constexpr std::string_view kWhich = " (of which ";
  std::size_t flags = line.find(" +SC"), at = line.find(kWhich);
  if (flags == line.npos || at == line.npos || at < flags) return;
  std::array<int, 4> crop{};
  std::string_view rest = line.substr(at + kWhich.size());
  constexpr std::string_view kBetween[] = {",", ",", "x", ")"};
  for (std::size_t i = 0; i < crop.size(); ++i)
    if (!consume_number(rest, crop[i]) || !consume(rest, kBetween[i])) return;
  head.crop = crop;
  std::string_view words = line.substr(flags, at - flags);
  while (!words.empty()) {
    words.remove_prefix(1);
    std::size_t end = std::min(words.find(' '), words.size());
    head.part.emplace_back(words.substr(0, end));
    words.remove_prefix(end);
  }
}

}  // namespace

SceneHead read_scene_head(std::string_view scene) {
  std::string_view line = scene.substr(0, scene.find('\n'));
  SceneHead head;
  head.light = light_of(line);
  head.alpha = line.find(" +UA") != line.npos;
  read_crop(line, head);
  constexpr std::string_view kFine = " +FN16";
  std::size_t at = line.find(kFine);
  if (at == line.npos) return head;
  std::string_view rest = line.substr(at + kFine.size());
  SceneHead fine = head;
  fine.fine = true;
  if (consume(rest, "; exposure 1 of ") && !consume_number(rest, fine.exposures)) return head;
  if ((rest.empty() && fine.exposures == 1) || rest == "; then frond resolve" ||
      rest.starts_with("; then frond resolve, with air: ")) {
    fine.raw = true;
    return fine;
  }
  // A later exposure names no tone: it is no picture by itself.
  if (consume(rest, "; then frond develop --highlights ") && consume_number(rest, fine.tone.highlights) &&
      consume(rest, " --contrast ") && consume_number(rest, fine.tone.contrast)) {
    auto read = [&](std::string_view option, double& number) {
      return !consume(rest, option) || consume_number(rest, number);
    };
    bool whole = read(" --saturation ", fine.tone.saturation) && read(" --warmth ", fine.tone.warmth) &&
                 read(" --vignette ", fine.tone.vignette);
    if (consume(rest, " --depth 16")) fine.depth = 16;
    if (whole && rest.empty()) return fine;
  }
  return head;
}

SceneHead scene_head_of(const std::filesystem::path& scene) {
  std::string first(1000, '\0');
  std::ifstream text(scene, std::ios::binary);
  text.read(first.data(), static_cast<std::streamsize>(first.size()));
  first.resize(static_cast<std::size_t>(text.gcount()));
  return read_scene_head(first);
}

}  // namespace frond
