#include "render/scene_head.h"

#include <algorithm>
#include <charconv>

namespace frond {

namespace {

/// Takes a word off the front of a text; false where something else stands there.
bool take(std::string_view& text, std::string_view word) {
  if (!text.starts_with(word)) return false;
  text.remove_prefix(word.size());
  return true;
}

template <class Number>
bool take_number(std::string_view& text, Number& number) {
  auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc{}) return false;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return true;
}

/// Of "... +RFlight_0123.rca ..." the name of the file.
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

}  // namespace

SceneHead read_scene_head(std::string_view scene) {
  std::string_view line = scene.substr(0, scene.find('\n'));
  SceneHead head;
  head.light = light_of(line);
  constexpr std::string_view kFine = " +FN16";
  std::size_t at = line.find(kFine);
  if (at == line.npos) return head;
  std::string_view rest = line.substr(at + kFine.size());
  SceneHead fine = head;
  fine.fine = true;
  if (take(rest, "; exposure 1 of ") && !take_number(rest, fine.exposures)) return head;
  if (rest == "; then frond resolve") {
    fine.raw = true;
    return fine;
  }
  // A later exposure names no tone: it is no picture by itself.
  if (take(rest, "; then frond develop --highlights ") && take_number(rest, fine.tone.highlights) &&
      take(rest, " --contrast ") && take_number(rest, fine.tone.contrast) && rest.empty())
    return fine;
  return head;
}

}  // namespace frond
