#include "pipeline/frame_range.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "core/text.h"
#include "resolve/resolve.h"

namespace frond {

bool is_resolved(const Film& film, const std::optional<bool>& asked) {
  return asked.value_or((film.quality == Quality::good || film.air) && !film.sampled());
}

Errors refuse_resolving(const Film& film, const std::optional<bool>& asked) {
  if (!asked.value_or(false) || !film.sampled()) return {};
  return {error_at("--resolve", "frames are not resolved {}; expected --no-resolve, or neither",
                   film.crop ? "in parts" : "with a transparent background")};
}

Result<FrameRange> read_frames(const std::string& text, int count) {
  std::string_view rest = text;
  FrameRange range{};
  range.first = range.last = consume_whole(rest);
  if (!rest.empty() && rest.front() == '-') {
    rest.remove_prefix(1);
    range.last = consume_whole(rest);
  }
  bool written = rest.empty() && range.first >= 1 && range.last >= range.first;
  if (written && range.last <= count) return range;
  std::string there = count == 1
                          ? "this preset is a still, which has frame 1 alone; expected 1, or a film, as "
                            "by --seconds 4"
                          : fmt::format("the film has frames 1-{}", count);
  if (written) return error_at("--frames", "found {}, but {}", text, there);
  return error_at("--frames", "\"{}\" is no range of frames; expected A-B, as in 1-{}, or one number; {}",
                  text, std::max(count, 2), there);
}

Result<FrameRange> read_frames(const std::optional<std::string>& text, int count, FrameRange usual) {
  return text ? read_frames(*text, count) : usual;
}

Result<int> read_frame(int asked, int count) {
  if (asked > count) return error_at("--frame", "{} is no frame of this film; expected 1-{}", asked, count);
  return asked == 0 ? count : asked;
}

FrameRange drawn_frames(const Film& film, FrameRange wanted) {
  int around = film.raw ? ResolveOptions{}.window : 0;
  return {std::max(wanted.first - around, 1), std::min(wanted.last + around, film.frames)};
}

}  // namespace frond
