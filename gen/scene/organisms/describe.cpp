#include "organisms/describe.h"

#include "appearance/describe.h"
#include "images/describe_mask.h"
#include "preset/keys.h"
#include "preset/reader.h"

namespace frond {

namespace {

constexpr Choice<Layer> kLayers[] = {{"canopy", Layer::canopy, "trees"},
                                     {"shrubs", Layer::shrubs, "bushes and young trees"},
                                     {"herbs", Layer::herbs, "ferns, grass, stones"}};

constexpr Choice<Build> kBuilds[] = {
    {"sweeps", Build::sweeps, "each branch by itself"},
    {"fused", Build::fused, "branches grown into one body, rounded at the forks"},
    {"rough", Build::rough, "one body whose skin has the steps of a coarse grid"},
    {"voxels", Build::voxels, "built of cubes"}};

bool read_address(Reader& reader, const Value& value, Address& address) {
  std::optional<std::string> given = reader.text_at(value);
  if (!given) return false;
  Result<Address> parsed = parse_address(*given);
  if (parsed) return address = *parsed, true;
  return reader.fault(value, kAddressForm), false;
}

/// `true` for always, or a year.
bool read_cut(Reader& reader, const Value& value, double& year) {
  constexpr double kMostYears = 500;
  if (value.is(Value::Type::boolean) && value.boolean) return year = 0, true;
  if (value.is(Value::Type::number) && value.number >= 1 && value.number <= kMostYears)
    return year = value.number, true;
  return reader.fault(value, "true, or a year of its life from 1 to 500"), false;
}

}  // namespace

void describe(Properties& v, Warmth& w) {
  v.number("lowest", w.lowest, {.min = -20, .max = 40, .unit = "degrees Celsius"},
           "Mean temperature of the growing season at the lowest of the land; it falls by 0.6 each 100 m");
  v.number("full", w.full, {.min = -20, .max = 40, .unit = "degrees Celsius"},
           "Temperature down to which copies reach their full size and number");
  v.number("least", w.least, {.min = -20, .max = 40, .unit = "degrees Celsius", .sense = "6.4 the tree line"},
           "Temperature below which no copy comes up");
  v.number("dwarf", w.dwarf, {.min = 0.01, .max = 1}, "Factor of the size of copies at that temperature");
}

void describe(Properties& v, CropRows& r) {
  v.number("spacing", r.spacing, {.min = 0.01, .max = 1000, .unit = "m"},
           "Distance from one row to the next");
  v.angle("turn", r.turn, {.min = -180, .max = 180},
          "Turn of the rows about the vertical; at 0 they run along z");
  v.number("wander", r.wander, metres(0, 100),
           "Distance that plants stand beside the middle of their row, at most");
  v.number("gaps", r.gaps, kShare, "Share of the rows where nothing came up");
  v.number("gap", r.gap, {.min = 0.01, .max = 1000, .unit = "m"}, "Length of a gap");
}

void describe(Properties& v, SowRules& s) {
  v.choice("layer", s.layer, kLayers,
           "Layer of the wood that copies belong to; crowns of one layer keep apart, those of different "
           "layers may overlap");
  v.number("radius", s.radius, {.min = 0, .max = 100, .above_min = true, .unit = "m"},
           "Radius of a crown, within which no other of the same layer comes up");
  v.number("stem", s.stem, metres(0, 50), "Radius round a stem that plants of other layers keep free");
  v.vector("altitude", s.altitude, metres(-1e5, 1e5),
           "Lowest and highest altitude at which copies come up, above the lowest point of the land");
  v.object("warmth", s.warmth,
           "How copies become smaller and fewer with altitude, as trees toward the tree line; not given: "
           "they do not");
  v.angle("slope", s.slope, {.min = 0, .max = 180},
          "Steepest slope on which copies come up; on a body (`place.on`) more than 90 is under overhangs");
  v.number("patch", s.patch, metres(0, 10000),
           "Distance from one clump to the next; 0 spreads copies evenly");
  v.number("cover", s.cover, kShare, "Share of the land that clumps cover. Needs a patch above 0");
  v.object("rows", s.rows,
           "Straight rows that copies stand in, as crops do; not given: all over the land. Bodies have none");
  v.vector("shade", s.shade, kShare, "Least and greatest share of the sky that crowns above may hide");
  v.number("clear", s.clear, metres(-100, 1000),
           "Distance that copies keep from the edge of a path; negative lets them stand on it");
  v.vector("center", s.center, metres(-1e4, 1e4),
           "The middle of the area that is sown, x and z. Needs a reach above 0");
  v.number("reach", s.reach, metres(0, 1e4), "Radius of the area that is sown; 0 is all of the land");
  v.object("map", s.map,
           "A picture that scales the density of copies over the land; a bare file name will do");
}

void describe(Properties& v, CopyTint& t) {
  v.angle("hue", t.hue, {.min = 0, .max = 180}, "Angle by which the hue of copies differs, either way");
  v.number("saturation", t.saturation, kShare, "Share by which the saturation of copies differs, either way");
  v.number("value", t.value, kShare, "Share by which the brightness of copies differs, either way");
}

void describe(Properties& v, Sowing& s) {
  v.integer("models", s.models, {.min = 1, .max = 64},
            "Number of different models that are grown and copied, each from a seed of its own");
  v.list("seeds", s.seeds, "Seeds of the models; a model without one takes its number");
  v.number("crowd", s.crowd, metres(0, 100),
           "Distance to the neighbours among which model trees grow up; 0 grows them in the open");
  v.object("where", s.where, "Rules that say where copies come up");
  v.object("tint", s.tint, "How the colours of copies differ");
  v.number("upright", s.upright, kShare,
           "How upright copies stand on a slope: 1 plumb, 0 at right angles to the ground");
  v.vector(
      "present", s.present, kShare,
      "First and last time of the year, 0 to 1, at which copies are above the ground, as mushrooms are in "
      "autumn; it may run past the end of the year. Without /scene/year they always are");
}

void describe(Properties& v, Stance& s) {
  v.angle("turn", s.turn, {.min = -360, .max = 360}, "Turn about the vertical, besides that of all");
  v.number("size", s.size, {.min = 0.01, .max = 100}, "Factor of its size, besides the random change");
}

void describe(Properties& v, Place& p) {
  v.list("at", p.at,
         "Places [x, z] of the first ones, within 30 m of the middle or anywhere on the land of a forest; "
         "the others are scattered");
  v.list("each", p.each,
         "How those at the places of `at` stand, one by one; trees that grow by light only move");
  v.text("in", p.in,
         "Name of rooms of the plan, or \"gate\", \"corners\" or \"doors\": `count` stand in each of them, "
         "the first at the places of `at`, which then count from its middle, z out of the room, and the "
         "others scattered");
  v.text("along", p.along,
         "Name of rooms of the plan along whose edges they stand, or \"walls\" for the line round it: walls "
         "as long as each edge, all else twice `spacing` apart");
  v.vector("center", p.center, metres(-28, 28),
           "Middle of the ring in which the others are scattered, x and z");
  v.number("inner", p.inner, metres(0, 28), "Inner radius of the ring");
  v.number("radius", p.radius, metres(0, 28), "Outer radius of the ring");
  v.number("spacing", p.spacing, metres(0, 100),
           "Distance that others keep from each of them, sown ones included");
  v.number("size_variation", p.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.angle("turn", p.turn, {.min = -360, .max = 360}, "Turn about the vertical");
  v.angle("turn_variation", p.turn_variation, {.min = 0, .max = 180},
          "Random change of the turn, either way");
  v.angle("lean", p.lean, {.min = 0, .max = 90}, "Angle by which each leans at most, at random");
  v.number("raise", p.raise, metres(-100, 1000), "Height of the foot above the ground");
  v.number("rock", p.rock, metres(0, 100),
           "Width of the rock under each, for corals and plants under water; 0 lays none");
  v.list("on", p.on,
         "Names of the bodies that colonies (corals, sponges) stand on, scattered over all of them that does "
         "not face downward, or that copies of anything `sown` come up on; not given: the ground");
  v.number("upright", p.upright, kShare,
           "How upright they stand on a slope of such a body: 1 plumb, 0 at right angles to it");
}

void describe(Properties& v, Style& s) {
  v.shorthand("build");
  v.choice("build", s.build, kBuilds, "What branches are drawn as");
  v.number(
      "voxel", s.voxel, metres(0, 100),
      "Size of a voxel of a fused or rough body, or of a cube; 0 takes it from the size of the organism. "
      "Needs build other than sweeps");
  v.number("blend", s.blend, {.min = 0, .max = 3},
           "How far branches flow into each other at forks, as a share of the thinner one's radius. Needs "
           "\"build\": \"fused\" or \"rough\"");
  v.number("adaptivity", s.adaptivity, kShare,
           "How unequal the triangles of a fused body may be: 0 all alike, 1 few where the body is flat. "
           "Needs \"build\": \"fused\"");
  v.number("roughness", s.roughness, kShare,
           "How much of the grid the skin of a rough body shows: 0 is the plain mesh of its volume, 1 has "
           "steps as high as a voxel. Needs \"build\": \"rough\"");
  v.number(
      "limit", s.limit, {.min = 1e6, .max = 1e15, .unit = "bytes"},
      "Memory that one volume may take; one that would need more is refused. Needs build other than sweeps");
}

void describe_rest(KeyWriter& v, Address& address) {
  std::string name = text(address);
  v.add("", name);
}

void describe(Properties& v, Edit& e) {
  v.custom(
      "at", e.at, read_address, R"({"type": "string"})",
      "The place: numbers of branches, counted from the foot, and a share of the length, as in \"3/1:0.4\": "
      "four tenths along the first branch of the third one of the stem; \":0.7\" is on the stem itself");
  v.required("at");
  v.integer("plant", e.plant, {.min = 0, .max = 1000000},
            "The one of the entry's plants that is meant, counted from 0; without it all are");
  v.custom(
      "cut", e.cut, read_cut,
      R"({"anyOf": [{"const": true}, {"type": "number", "minimum": 1, "maximum": 500}]})",
      "Saws off what is beyond the place; a number is the year of its life at whose end that happens, for "
      "the kind tree, which answers by new shoots");
  v.vector("bend", e.bend, metres(-100, 100),
           "Way by which the place is pulled, as by a wire, in the plant's own upright frame");
  v.number("strength", e.strength, {.min = 0.2, .max = 3},
           "Factor of the length and thickness of all that is beyond the place");
  v.boolean("bare", e.bare, "Takes leaves, flowers and fruit off all that is beyond the place");
  v.object("bark", e.bark,
           "Another bark of all that is beyond the place, for plants; what it does not say is as on the rest "
           "of the plant");
}

void describe(Properties& v, Cut& c) {
  v.text("entry", c.entry, "Name of the organisms of which some are felled; without it all trees count");
  v.number("share", c.share, kShare, "Share of those that still stand, chosen by the seed");
}

void describe(Properties& v, Prune& p) {
  v.text("entry", p.entry, "Name of the organisms that are pruned; without it all trees are");
  v.number("below", p.below, metres(0, 100), "Height above the foot under which stems lose their limbs");
}

void describe(Properties& v, Event& e) {
  v.number("year", e.year, {.min = 0, .max = 10000, .unit = "years"},
           "When it happens, counted from when the oldest trees began to grow, or in the years of the stand "
           "or the reef");
  v.required("year");
  v.number(
      "storm", e.storm, {.min = 0, .max = 1, .sense = "0.5 breaks limbs, 1 flattens woods"},
      "Strength of a storm, from the strongest gust of an ordinary year to one of 50 m/s; on a reef from "
      "the strongest waves of an ordinary year to water of 6 m/s");
  v.number("heat", e.heat, {.min = 0, .max = 50, .unit = "degree heating weeks"},
           "Heat wave that bleaches a reef; below 3 nothing dies, at 8 most branching corals do");
  v.object("cut", e.cut, "Trees that are felled");
  v.object("prune", e.prune, "Limbs that are taken off");
}

void describe(Properties& v, Organism& o) {
  v.text("species", o.species,
         "Another preset, named as seen from this one's folder: the kind of its first organism and all that "
         "it says of how that grows and looks stand wherever this one has nothing of its own");
  v.text("name", o.name, "Your name for it, by which messages and ivy's `on` call it");
  if (v.purpose() != Purpose::keys)
    v.text("group", o.group,
           "A name under which the studio lists it with others; it grows and looks the same");
  v.integer("count", o.count, {.min = 0, .max = 1000000},
            "How many there are, those at given places included");
  v.object("place", o.place, "Where they stand");
  v.list("edits", o.edits, Count{0, 10000},
         "Edits of branches by hand: cuts, bends, limbs that grow stronger, are bare or wear another bark");
  v.object("sown", o.sown, "Makes copies of a few models and sows them over the land, `count` of them");
  v.object("body", o.style, "What their branches are drawn as");
  v.object("health", o.courses.health,
           "How they fare over the film: a value or keyframes. For what lives; without it they are healthy");
  v.object("tint", o.courses.tint, "How all their colours change over the film; without it they stay");
}

void describe_rest(KeyWriter& v, Organism& o) {
  Keys keys = o.grower->keys();
  v.add("kind", keys);
}

}  // namespace frond
