#include <algorithm>
#include <bit>
#include <cmath>

#include "core/curve.h"
#include "scene/entry_seeds.h"
#include "scene/sowing.h"

namespace frond {

namespace {

constexpr double kComing = 0.02;  // of a year, in which a copy comes up or shrivels
constexpr float kSmall = 0.02f;   // factor of the size below which it is not there

/// A part of the year, which may run past its end.
struct Presence {
  double up = 0, down = 1;

  /// Factor of the size at a time of the year.
  float size(double year) const {
    double since = year - up - std::floor(year - up), left = down - up - since;
    return static_cast<float>(smooth_step(0.0, kComing, since) * smooth_step(0.0, kComing, left));
  }
};

Presence presence_of(Vec2 present, Seed seed) {
  double length = present.y - present.x + (present.y < present.x ? 1 : 0);
  return {present.x + 0.4 * length * seed.child("up").unit(),
          present.x + length * (1 - 0.4 * seed.child("down").unit())};
}

/// An instant of the film.
struct Instant {
  double time = 0, year = 0;
};

std::vector<Instant> instants_of(const Film& film, const Animated<double>& year) {
  std::vector<Instant> instants;
  for (int frame = 1; frame <= film.frames; ++frame)
    instants.push_back({film.time(frame), year.at(film.time(frame))});
  double end = std::max(film.length(), instants.back().time + 1);
  instants.push_back({end, film.frames > 1 ? year.at(end) : instants.back().year});
  return instants;
}

/// When a copy is there: from one instant to the next, and as long as it stays as large.
std::vector<CopySpan> spans_of(const Presence& presence, const std::vector<Instant>& instants) {
  std::vector<CopySpan> spans;
  for (std::size_t k = 0; k + 1 < instants.size(); ++k) {
    float first = presence.size(instants[k].year), last = presence.size(instants[k + 1].year);
    if (std::max(first, last) <= kSmall) continue;
    Vec2 from(std::max(first, kSmall)), to(std::max(last, kSmall));
    if (first == 1 && last == 1 && !spans.empty() && spans.back().first == from && spans.back().last == to &&
        spans.back().end == instants[k].time)
      spans.back().end = instants[k + 1].time;
    else
      spans.push_back({instants[k].time, instants[k + 1].time, from, to, nullptr});
  }
  return spans;
}

/// What of a span is there in another one, too.
CopySpan within(const CopySpan& span, const CopySpan& other) {
  CopySpan both = span;
  both.begin = std::max(span.begin, other.begin), both.end = std::min(span.end, other.end);
  both.first = span.size(both.begin) * other.size(both.begin);
  both.last = span.size(both.end) * other.size(both.end);
  return both;
}

/// Copies draw their lots by their number, and from version 2 on by their place, which is theirs whoever else
/// finds no room.
Copies present(const Copies& all, Vec2 part, const std::vector<Instant>& instants, Seed seed, int version) {
  Copies now;
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::uint64_t own = version < 2 ? i : std::bit_cast<std::uint64_t>(Vec2(all.foot[i].x, all.foot[i].z));
    for (CopySpan& span : spans_of(presence_of(part, seed.child("present", own)), instants)) {
      if (!all.span.empty()) span = within(all.span[i], span);
      if (span.end > span.begin) now.add(all, i, std::move(span));
    }
  }
  return now;
}

}  // namespace

void set_copy_lifetimes(Scene& scene, const Preset& preset) {
  if (!scene.setup.year) return;
  std::vector<Instant> instants = instants_of(scene.film, *scene.setup.year);
  std::vector<Seed> seeds = entry_seeds(preset, "season");
  for (CopySet& set : scene.copy_sets)
    if (const auto& part = set.organism.sown->present)
      set.copies = present(set.copies, *part, instants, seeds[set.entry], preset.version);
}

}  // namespace frond
