#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <utility>

#include "appearance/describe.h"
#include "appearance/picture_bounds.h"
#include "geometry/mesh_file.h"
#include "images/describe_mask.h"
#include "organisms/describe_grammar.h"
#include "organisms/ivy/ivy.h"
#include "organisms/kinds.h"
#include "preset/describe_spline.h"

namespace frond {

inline constexpr Choice<Lure> kLures[] = {
    {"along", Lure::along, "a direction, everywhere the same"},
    {"light", Lure::light, "the light, where the surface lies in shade of its own"},
    {"point", Lure::point, "a place"},
    {"round", Lure::round, "round what they grow on and upward, as twining plants do"}};

inline constexpr Choice<IvyDetail> kIvyDetails[] = {
    {"fitting", IvyDetail::fitting, "single leaves, or sprigs where there would be more than 25000"},
    {"leaves", IvyDetail::leaves, "each leaf by itself, on its own petiole"},
    {"sprigs", IvyDetail::sprigs, "several leaves at once, for ivy far away"}};

/// The curves of a file: what follows on each other is one.
Errors load_curves(const NamedFile& file, std::vector<std::vector<DVec3>>& curves) {
  Result<GuideLines> lines = read_guide_file(file);
  if (!lines) return lines.errors();
  std::uint32_t last = 0;
  for (auto [from, to] : lines->line) {
    if (curves.empty() || from != last) curves.push_back({lines->place[from]});
    curves.back().push_back(lines->place[to]);
    last = to;
  }
  return {};
}

void describe(Properties& v, CrawlGuide& g) {
  v.list(
      "points", g.points,
      "Points of one curve, in metres in the world, on the host or near it: places, or objects with handles");
  v.boolean("curve", g.curve, "Whether the curve is smooth at points without handles, too");
  v.file(
      "file", g.file, [&](const NamedFile& file) { return load_curves(file, g.filed); },
      "A Wavefront OBJ file with lines (`l`), each row of them one curve, or a skeleton as SWC, each branch "
      "one, in place of points");
  v.number("width", g.width, metres(0.005, 100), "Distance from the curve within which strands keep");
  v.number("pull", g.pull, kShare,
           "How strongly strands are led along the curve; those that leave its width end there");
}

/// Where strands end: nothing of it is written where there is no limit.
void describe_limits(Properties& v, Crawl& c) {
  const Crawl open;
  auto limit = [](const auto& own, const auto& none) {
    return own == none ? std::nullopt : std::optional(own);
  };
  auto longest = limit(c.max_length, open.max_length);
  v.number("max_length", longest, metres(0.001, 1e6),
           "Length of one strand at most; without it there is no limit");
  if (longest) c.max_length = *longest;
  auto low = limit(c.low, open.low), high = limit(c.high, open.high);
  v.vector("low", low, metres(-1e6, 1e6), "Low corner x, y, z of a box that strands do not leave");
  v.vector("high", high, metres(-1e6, 1e6), "High corner x, y, z of the box that strands do not leave");
  if (low) c.low = *low;
  if (high) c.high = *high;
}

void describe(Properties& v, CrawlMask& m) {
  v.file(
      "file", m.picture.file, [&](const NamedFile& file) { return load_mask(file, m.picture); },
      "A picture (PNG, JPEG or WebP), laid on by the texture coordinates of a mesh (`vt`) or over the face "
      "of a wall unless along is given; its brightness counts. Without it, the grey of a mesh's vertex "
      "colours (`v x y z r g b`)");
  describe_projection(v, m.picture);
  v.list("scales", m.scales, Count{0, 3},
         "What it scales, from nothing in black to all in white: bias, spacing, leaves");
  v.number("stops", m.stops, kShare,
           "Strands neither begin nor go where the grey is below this; 0 stops none");
}

void describe(Properties& v, Crawl& c) {
  v.number("speed", c.speed, metres(0.0005, 1), "Length of one step of a strand");
  v.angle("wander", c.wander, {.min = 0, .max = 120}, "Angle by which each step turns at random, either way");
  v.animated(
      "bias", c.bias, kShare,
      "How much of the way to the lure each step turns; times of keyframes are shares of the growth, 0 to 1");
  v.choice("lure", c.lure, kLures, "What strands turn toward");
  v.animated(
      "toward", c.toward, {.min = -1000, .max = 1000},
      "The direction that strands turn toward with the lure along; the place, in metres, with the lure "
      "point; times of keyframes are shares of the growth, 0 to 1");
  v.angle("pitch", c.pitch, {.min = -85, .max = 85},
          "How steeply strands wind up; above 0 in a right-handed helix, as beans do, below in a left-handed "
          "one, as hops do. Needs \"lure\": \"round\"");
  v.list("guides", c.guides, Count{0, 100},
         "Curves that strands follow: those that come within the width of one keep within it to its end. "
         "Without place.at strands begin where curves do");
  v.object("mask", c.mask, "A grey on the host that scales what ivy does there");
  v.boolean("trace", c.trace,
            "Whether strands stay where they creep; if not, bodies creep there, as walkers says, and leave "
            "nothing");
  v.number("branch_every", c.branch_every, metres(0.001, 1000),
           "Distance along a strand from one branch to the next");
  v.number("branch_jitter", c.branch_jitter, kShare, "Random change of that distance, as a share of it");
  v.angle("branch_angle", c.branch_angle, {.min = 5, .max = 150}, "Angle between a branch and its strand");
  v.integer("branch_depth", c.branch_depth, {.min = 0, .max = 16},
            "How many times over branches branch again; 0 leaves single strands");
  v.number("radius", c.radius, metres(0.0001, 1), "Radius of a grown strand that carries nothing but itself");
  v.number("ripening", c.ripening, {.min = 0.0001, .max = 1},
           "Share of the final radius that each step adds");
  v.number("pipe", c.pipe, {.min = 0, .max = 5},
           "Exponent of the stem's thickness: one that carries k strands is k^(1/pipe) times as thick; 0 "
           "leaves all alike");
  v.number("thickest", c.thickest, {.min = 1, .max = 100},
           "Radius of an old stem at most, as a multiple of a strand's");
  v.integer("max_age", c.max_age, {.min = 1, .max = 100000}, "Number of steps of the whole growth");
  describe_limits(v, c);
  v.number("spacing", c.spacing, metres(0, 10), "Distance that strands keep from each other");
  v.integer("patience", c.patience, {.min = 1, .max = 1000},
            "Number of steps without room after which a strand stops");
  v.number("let_go", c.let_go, kShare, "Chance that a strand loses its hold at an edge or overhang");
  v.number("hang_most", c.hang_most, metres(0, 50), "Length to which a strand hangs at most");
  v.number("stiffness", c.stiffness, metres(0.001, 10),
           "Length over which a strand stands out freely before it bends down");
}

void describe(Properties& v, IvyLeaves& l) {
  v.number("size", l.size, metres(0.001, 2), "Length of a grown leaf's blade");
  v.number("size_variation", l.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.number("spacing", l.spacing, metres(0.002, 10), "Distance along a strand from leaf to leaf");
  v.number("bare", l.bare, metres(0, 100), "Length above the root that bears no leaves");
  v.number("overlap", l.overlap, {.min = 0, .max = 20},
           "Share of a leaf that others may cover; a leaf that finds no such place does not grow");
  v.direction("light", l.light, "Direction toward the light that leaves turn to");
  v.number("turn", l.turn, kShare, "How leaves are turned: 0 flat on the surface, 1 square to the light");
  v.number("adult", l.adult, kShare, "Share of heart-shaped leaves on the oldest shoots");
  v.number("young_length", l.young_length, metres(0, 10),
           "Length below a tip over which leaves are small and fresh");
  v.choice("detail", l.detail, kIvyDetails, "How leaves are drawn");
  v.list("colors", l.colors, Count{1, 16}, "Colours of grown leaves");
  v.color("young", l.young, "Colour of leaves near the tips");
  v.color("bud", l.bud, "Colour of the buds that leaves unfold from");
  v.color("veins", l.veins, "Colour of the veins");
  v.number("unfold", l.unfold, {.min = 0.001, .max = 1}, "Share of the growth in which a leaf unfolds");
  v.object(
      "picture", l.picture,
      "The leaf of another climber, in place of the shapes and the colours of ivy; size, with the stalk, "
      "and its variation are those above");
  v.aspect(Aspect::look, "colors", "young", "bud", "veins");
  v.aspect(Aspect::motion, "unfold");
}

void describe(Properties& v, Tendrils& t) {
  v.integer("every", t.every, {.min = 1, .max = 1000}, "Number of leaves from one tendril to the next");
  v.number("reach", t.reach, metres(0.005, 5), "How far from its node a tendril finds something to hold");
  v.number("turns", t.turns, {.min = 0.2, .max = 20}, "Number of turns round a thin support");
  v.number("coils", t.coils, {.min = 0, .max = 30},
           "Number of turns of a free part to either hand, once it has coiled");
  v.number("coil", t.coil, metres(0, 0.5), "Radius of these turns");
  v.number("behind", t.behind, metres(0, 10), "Length below a tip that has no tendrils yet");
  v.number("radius", t.radius, metres(0.00005, 0.1), "Radius of a tendril at its foot");
  v.boolean("pads", t.pads, "Whether tendrils hold on to walls, by short branches with adhesive pads");
  v.integer("branches", t.branches, {.min = 1, .max = 12}, "Number of these branches");
  v.number("pad", t.pad, metres(0.0001, 0.1), "Radius of a pad");
  v.number("waste", t.waste, kShare, "Share of the tendrils that hold nothing which are kept");
  v.color("color", t.color, "Colour of tendrils");
  v.aspect(Aspect::look, "color");
}

void describe(Properties& v, Walkers& w) {
  v.aspect(Aspect::look);
  v.file(
      "file", w.file, [&](const NamedFile& file) { return load_unit_mesh(file, w.mesh); },
      "A mesh (OBJ, PLY, STL, GLB) of the body, named as seen from the preset's folder: y is up, it walks "
      "toward z; without it a beetle walks");
  v.number("size", w.size, metres(0.0005, 10), "Length of the body");
  v.number("size_variation", w.size_variation, {.min = 0, .max = 0.9},
           "Random change of the size, as a share of it");
  v.list("colors", w.colors, Count{1, 16}, "Colours of the body, one for each");
  v.color("second", w.second, "Colour of a beetle's head, legs and feelers");
  v.number("gloss", w.gloss, kShare, "How much it shines");
}

void describe(Properties& v, Flutter& f) {
  v.aspect(Aspect::motion);
  v.angle("amplitude", f.amplitude, {.min = 0, .max = 60},
          "Angle by which a gust moves a leaf on a petiole of 5 cm");
  v.number("speed", f.speed, {.min = 0, .max = 20, .unit = "1/s"},
           "Number of swings in a second; single leaves differ");
  v.number("gust", f.gust, metres(0.05, 1000), "Distance from one gust to the next");
  v.direction("direction", f.direction, Across::xz, "Direction in which gusts travel; only x and z count");
}

void describe(Properties& v, Breeze& b) {
  v.aspect(Aspect::motion);
  v.angle("amplitude", b.amplitude, {.min = 0, .max = 60},
          "Angle by which the free end of a hanging strand swings, where speed is 0");
  v.number("speed", b.speed, {.min = 0, .max = 30, .unit = "m/s"},
           "Mean speed of a wind with gusts in which hanging strands are simulated as chains with weight and "
           "stiffness; 0 lets them swing by amplitude");
  v.number("gust", b.gust, metres(0.2, 1000),
           "Distance from one gust of that wind to the next; gusts travel at its speed");
  v.direction("direction", b.direction, Across::xz, "Direction of the wind; only x and z count");
}

void describe(Properties& v, IvyParams& i) {
  v.list("on", i.on,
         "Names of the organisms that it grows on, as their `name` says; without any it grows on all bodies "
         "there are");
  v.vector("facing", i.facing, {.min = -1000, .max = 1000},
           "Roots without a place of their own stand where the host looks this way; [0, 0, 0] is anywhere");
  v.number("above", i.above, metres(0, 100),
           "Height above the host's lowest point up to which roots without a place of their own stand");
  v.object("crawl", i.crawl, "How strands creep");
  v.object("leaves", i.leaves, "The leaves");
  v.object("tendrils", i.tendrils, "Tendrils opposite to leaves; none without it");
  v.object("bark", i.bark, "Surface of the strands; its colours run from old wood to shoots");
  v.object("walkers", i.walkers, "What creeps where crawl leaves no trace");
  v.object("flutter", i.flutter, "How leaves tremble in the wind");
  v.object("breeze", i.breeze, "How hanging strands swing in the wind");
  v.object("growth", i.growth, "When it grows in the film");
}

namespace {

class IvyGrower final : public Described<IvyParams, BedGrower> {
 public:
  static constexpr std::string_view kLeading[] = {"on",           "crawl/max_age",      "crawl/wander",
                                                  "crawl/bias",   "crawl/branch_every", "crawl/branch_angle",
                                                  "crawl/radius", "crawl/low",          "crawl/high",
                                                  "leaves/size",  "leaves/spacing",     "leaves/colors"};

  GrowerTraits traits() const override {
    return {.stage = GrowthStage::creeping,
            .branches = params.crawl.trace,
            .rebuilt = params.crawl.trace ? Rebuilt::never : Rebuilt::in_films,
            .hosts = &params.on};
  }
  Review review() const override {
    Errors errors = faults();
    return {errors.empty() ? check_pictures({}, params.leaves.picture, "/leaves/picture/pixels") : errors};
  }
  /// How far ivy comes shows only on its host: here it always finds room.
  Result<SizeEstimate> estimate_size(Seed) const override {
    const Crawl& crawl = params.crawl;
    double length = std::min(crawl.max_age * crawl.speed, crawl.max_length);
    constexpr double kMaskPixel = 4;  // bytes that are held, of what paints its host
    double painted = 0;
    if (crawl.mask && !crawl.mask->picture.empty())
      painted = 2 * kMaskPixel * static_cast<double>(crawl.mask->picture.grey->size());
    double steps = length / crawl.speed, branches = crawl.branch_depth > 0 ? length / crawl.branch_every : 0;
    constexpr double kShapeTriangles = 9000;  // of all shapes of leaves, or of a beetle's
    constexpr double kLeafTriangles = 12;     // of the forms of a picture, for each point of half its rim
    constexpr double kStepBytes = 80;         // of a path
    if (!crawl.trace)
      return SizeEstimate{
          .organs = 1, .parts = 1, .shapes = kShapeTriangles, .held = painted + kStepBytes * steps};
    SizeEstimate ivy;
    ivy.nodes = std::min(steps * (1 + 1.5 * branches), static_cast<double>(crawl.most_nodes));
    ivy.organs = ivy.parts = 0.5 * ivy.nodes * crawl.speed / std::max(params.leaves.spacing, 1e-3);
    if (const auto& t = params.tendrils)
      ivy.nodes += ivy.organs / t->every * (30 * t->coils + 16 * t->turns + (t->pads ? 8 * t->branches : 0));
    ivy.shapes = kShapeTriangles;
    if (const auto& leaf = params.leaves.picture)
      ivy.shapes = kLeafTriangles * leaf->detail * (leaf->sprig ? 2 * leaf->sprigs.pairs + 1 : 1);
    ivy.riding = true;
    ivy.nodes_a_second = 1.5e4;
    ivy.held = painted;
    return ivy;
  }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.branches = {.bark = params.bark};
    if (params.tendrils) appearance.look.branches.bark->colors.push_back(params.tendrils->color);
    if (params.leaves.picture) appearance.look.organs.push_back(*params.leaves.picture);
    appearance.motion = {params.growth, {}, {}, 1, false, params.flutter, params.leaves.unfold};
    appearance.variation = params.bark.variation;
    return appearance;
  }
  Result<Specimen> grow_bed(const Bed& bed, const World& world) const override {
    const Organism& organism = *bed.organism;
    auto ground = [&](double x, double z) { return (*world.ground())(x, z); };
    IvyRoots roots;
    for (Vec2 at : organism.place.at)
      roots.emplace_back(at.x, ground(at.x, at.y) + organism.place.raise, at.y);
    auto host = world.host(params.on, "what the ivy grows on");
    if (!host) return Error{"/on", host.errors().front().what};
    if (Errors errors = mask_faults(**host); !errors.empty()) return errors;
    Result<Ivy> ivy = grow_ivy(params, **host, roots, organism.count, ground, bed.seed.child("grow"));
    if (!ivy) return ivy.errors();
    Specimen specimen{{organism.name, bed.entry}, std::move(ivy->model)};
    Appearance worn = appearance();
    specimen.look = worn.look;
    specimen.brightness = 1 + worn.variation * bed.seed.child("brightness").range(-1, 1);
    specimen.motion = worn.motion;
    specimen.motion.growth = paced(worn.motion.growth, length_of(specimen.model));
    specimen.motion.film_length = world.film_length();
    if (!params.crawl.trace) {
      set_walk(specimen, std::move(ivy->strands), world, bed.seed.child("grow").child("walkers"));
      return specimen;
    }
    Hanging& hanging = specimen.life.hanging.emplace(Hanging{std::move(ivy->strands), params.breeze});
    hanging.breeze.film_length = world.film_length();
    if (params.breeze.speed > 0) {
      Breeze wind = hanging.breeze;
      if (!world.filmed()) wind.film_length = 0;
      hanging.paths =
          std::make_shared<const SwingPaths>(swing_paths(hanging.strands, wind, params.crawl.stiffness));
    }
    return specimen;
  }
  Result<Model> grow_copy(const Organism&, Seed) const override {
    return Error{"", "ivy grows on other bodies"};
  }

 private:
  Errors faults() const {
    const Crawl& crawl = params.crawl;
    for (int axis = 0; axis < 3; ++axis)
      if (crawl.low[axis] > crawl.high[axis])
        return {error_at(fmt::format("/crawl/high/{}", axis),
                         "found {:g}, below the {:g} of low; expected a box that holds something",
                         crawl.high[axis], crawl.low[axis])};
    for (std::size_t i = 0; i < crawl.guides.size(); ++i)
      if (crawl.guides[i].curves().empty() && crawl.guides[i].file.empty())
        return {{fmt::format("/crawl/guides/{}", i), "expected at least two points, or a file of lines"}};
    if (params.tendrils && !crawl.trace)
      return {{"/tendrils", "have no strands to grow on; expected crawl without \"trace\": false"}};
    if (crawl.mask && crawl.mask->picture.along && crawl.mask->picture.file.empty())
      return {{"/crawl/mask/along", "has no picture to project; expected a file beside it"}};
    if (crawl.mask)
      for (std::size_t i = 0; i < crawl.mask->scales.size(); ++i)
        if (std::ranges::find(kMaskScales, crawl.mask->scales[i]) == std::end(kMaskScales))
          return {error_at(fmt::format("/crawl/mask/scales/{}", i), "found \"{}\"; expected one of {}",
                           crawl.mask->scales[i], fmt::join(kMaskScales, ", "))};
    auto none = [](const auto& key) { return glm::length(key.value) < 1e-3f; };
    auto biased = [](const auto& key) { return key.value > 0; };
    if (crawl.lure == Lure::point || crawl.lure == Lure::round ||
        std::ranges::none_of(crawl.bias.keys(), biased) || std::ranges::none_of(crawl.toward.keys(), none))
      return {};
    return {{"/crawl/toward", "found a vector of length 0; expected the direction that strands turn to"}};
  }

  Errors mask_faults(const TriangleSurface& host) const {
    const std::optional<CrawlMask>& mask = params.crawl.mask;
    bool pictured = mask && !mask->picture.file.empty();
    if (!mask || (pictured ? mask->picture.along || host.has_texture() : host.has_grey())) return {};
    if (!pictured)
      return {{"/crawl/mask",
               "what the ivy grows on has no vertex colours; expected a mesh whose OBJ file has "
               "them at all vertices (`v x y z r g b`), or a file here"}};
    return {{"/crawl/mask/file",
             "what the ivy grows on has no texture coordinates; expected a wall, a mesh whose OBJ file has "
             "them (`vt`), or along and area"}};
  }

  /// Has walkers move along their paths in a film, as long as its growth or, without one, all the time.
  void set_walk(Specimen& specimen, Strands&& paths, const World& world, Seed seed) const {
    Growth growth = std::exchange(specimen.motion.growth, {});
    if (growth.duration <= 0) growth.duration = world.film_length();
    if (!world.filmed()) return;
    specimen.life.held = 80 * paths.size();
    specimen.life.develop =
        [walkers = params.walkers, growth, seed,
         shapes = std::make_shared<const std::vector<Prototype>>(specimen.model.prototypes),
         paths = std::make_shared<const Strands>(std::move(paths))](double time) -> Result<Model> {
      Model model;
      model.prototypes = *shapes;
      double share = std::clamp((time - growth.start) / growth.duration, 0.0, 1.0);
      model.organs = walkers_at(walkers, *paths, share, seed);
      return model;
    };
  }
};

}  // namespace

Kind<Organism> ivy_kind() { return make_grower<IvyGrower>("ivy", "Ivy that creeps over other bodies"); }

}  // namespace frond
