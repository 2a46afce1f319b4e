#pragma once

#include "organisms/season.h"
#include "preset/reader.h"

// The properties of seasons as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr std::string_view kSeasonTimes = "winter is 0, spring 0.25, summer 0.5, autumn 0.8";

template <class Visitor>
void describe(Visitor& v, Blossom& b) {
  v.number("share", b.share, {.min = 0, .max = 1}, "Of the leaves' places that bear flowers");
  v.integer("cluster", b.cluster, {.min = 1, .max = 40}, "Flowers at one place");
  v.number("size", b.size, {.min = 0.0005, .max = 2, .unit = "m"}, "Across a flower");
  v.integer("petals", b.petals, {.min = 1, .max = 60}, "Of a flower");
  v.color("color", b.color, "Of the petals");
  v.color("heart", b.heart, "Of the heart");
  v.number("at", b.at, {.min = 0, .max = 1, .unit = "years"}, "Time of the year at which they open");
  v.number("lasts", b.lasts, {.min = 0, .max = 0.6, .unit = "years"}, "Until the petals fall");
}

template <class Visitor>
void describe(Visitor& v, Seasons& s) {
  v.shorthand("at");
  v.animated("at", s.at, {.min = -1000, .max = 1000, .unit = "years", .sense = kSeasonTimes},
             "0 new year, 0.25 spring, 0.5 midsummer, 0.8 autumn, 1.5 the next summer");
  v.number("opening", s.opening, {.min = 0, .max = 1, .unit = "years"},
           "Time of the year at which leaves unfold");
  v.number("turning", s.turning, {.min = 0, .max = 1, .unit = "years"}, "When they begin to turn");
  v.number("fall", s.fall, {.min = 0, .max = 1, .unit = "years"}, "When they fall");
  v.number("spread", s.spread, {.min = 0, .max = 0.3, .unit = "years"}, "From the first leaf to the last");
  v.number("drift", s.drift, {.min = 0.0001, .max = 0.2, .unit = "years"}, "How long a leaf is in the air");
  v.number("litter", s.litter, {.min = 0, .max = 1}, "Share of the fallen leaves that lie until spring");
  v.boolean("evergreen", s.evergreen, "Leaves stay as they are");
  v.color("young", s.young, "Of leaves that unfold");
  v.list("autumn", s.autumn, Count{1, 16}, "Colours that a leaf goes through, some to the last, some not");
  v.object("blossom", s.blossom, "Flowers where leaves stand; none where it is not given");
}

}  // namespace frond
