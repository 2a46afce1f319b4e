#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/parallel.h"
#include "dress/describe.h"
#include "organisms/ivy/ivy.h"
#include "organisms/kinds.h"

namespace frond {

inline constexpr Choice<Lure> kLures[] = {
    {"along", Lure::along, "a direction, everywhere the same"},
    {"light", Lure::light, "the light, where the surface lies in shade of its own"},
    {"point", Lure::point, "a place"}};

inline constexpr Choice<IvyDetail> kIvyDetails[] = {
    {"fitting", IvyDetail::fitting, "single leaves, or sprigs where there would be more than 25000"},
    {"leaves", IvyDetail::leaves, "each leaf by itself, on its own petiole"},
    {"sprigs", IvyDetail::sprigs, "several leaves at once, for ivy far away"}};

template <class Visitor>
void describe(Visitor& v, Crawl& c) {
  v.number("speed", c.speed, {.min = 0.0005, .max = 1, .unit = "m"}, "One step of a strand");
  v.angle("wander", c.wander, {.min = 0, .max = 120}, "How far each step turns at random, either way");
  v.number("bias", c.bias, {.min = 0, .max = 1}, "How much of the way to the lure each step turns");
  v.choice("lure", c.lure, kLures, "What strands turn toward");
  v.vector("toward", c.toward, {.min = -1000, .max = 1000}, "A direction, or for point a place in metres");
  v.number("branch_every", c.branch_every, {.min = 0.001, .max = 1000, .unit = "m"},
           "Along a strand from branch to branch");
  v.number("branch_jitter", c.branch_jitter, {.min = 0, .max = 1}, "Random change of that, as a share");
  v.angle("branch_angle", c.branch_angle, {.min = 5, .max = 150}, "Between a branch and its strand");
  v.integer("branch_depth", c.branch_depth, {.min = 0, .max = 16}, "Branches of branches; 0: none");
  v.number("radius", c.radius, {.min = 0.0001, .max = 1, .unit = "m"},
           "Of a grown strand that carries itself");
  v.number("ripening", c.ripening, {.min = 0.0001, .max = 1}, "Share of that a step adds");
  v.number("pipe", c.pipe, {.min = 0, .max = 5},
           "k strands above make a stem k^(1/pipe) times as thick; 0: they do not");
  v.number("thickest", c.thickest, {.min = 1, .max = 100}, "Radii that an old stem has at most");
  v.integer("max_age", c.max_age, {.min = 1, .max = 100000}, "Steps of the whole growth");
  std::optional<double> longest;
  v.number("max_length", longest, {.min = 0.001, .max = 1e6, .unit = "m"}, "Of one strand; not given: any");
  if (longest) c.max_length = *longest;
  std::optional<Vec3> low, high;
  v.vector("low", low, {.min = -1e6, .max = 1e6, .unit = "m"}, "Strands stop at this corner's walls");
  v.vector("high", high, {.min = -1e6, .max = 1e6, .unit = "m"}, "And at this one's");
  if (low) c.low = *low;
  if (high) c.high = *high;
  v.number("spacing", c.spacing, {.min = 0, .max = 10, .unit = "m"}, "That strands keep apart");
  v.integer("patience", c.patience, {.min = 1, .max = 1000}, "Steps without room until a strand stops");
  v.number("let_go", c.let_go, {.min = 0, .max = 1}, "Chance to lose hold at an edge or overhang");
  v.number("hang_most", c.hang_most, {.min = 0, .max = 50, .unit = "m"}, "How long strands hang at most");
  v.number("stiffness", c.stiffness, {.min = 0.001, .max = 10, .unit = "m"},
           "That a strand stands out freely before it bends down");
}

template <class Visitor>
void describe(Visitor& v, IvyLeaves& l) {
  v.number("size", l.size, {.min = 0.001, .max = 2, .unit = "m"}, "Length of a grown blade");
  v.number("size_variation", l.size_variation, {.min = 0, .max = 0.9}, "Random change of it, as a share");
  v.number("spacing", l.spacing, {.min = 0.002, .max = 10, .unit = "m"}, "Along a strand from leaf to leaf");
  v.number("bare", l.bare, {.min = 0, .max = 100, .unit = "m"}, "Above the root, without leaves");
  v.number("overlap", l.overlap, {.min = 0, .max = 20},
           "Share of a leaf that others may cover; what finds no such place does not grow");
  v.direction("light", l.light, "Toward the light");
  v.number("turn", l.turn, {.min = 0, .max = 1}, "0: flat on the surface, 1: square to the light");
  v.number("adult", l.adult, {.min = 0, .max = 1}, "Share of heart-shaped leaves on the oldest shoots");
  v.number("young_length", l.young_length, {.min = 0, .max = 10, .unit = "m"},
           "Below a tip in which leaves are small and fresh");
  v.choice("detail", l.detail, kIvyDetails, "How leaves are drawn");
  v.list("colors", l.colors, Count{1, 16}, "Of grown leaves");
  v.color("young", l.young, "Of leaves near the tips");
  v.color("bud", l.bud, "That leaves unfold from");
  v.color("veins", l.veins, "Of the veins");
  v.number("unfold", l.unfold, {.min = 0.001, .max = 1}, "Share of the growth in which a leaf unfolds");
}

template <class Visitor>
void describe(Visitor& v, Flutter& f) {
  v.angle("amplitude", f.amplitude, {.min = 0, .max = 60}, "Of a leaf on a petiole of 5 cm in a gust");
  v.number("speed", f.speed, {.min = 0, .max = 20, .unit = "1/s"}, "Swings a second; single leaves differ");
  v.number("gust", f.gust, {.min = 0.05, .max = 1000, .unit = "m"}, "From gust to gust");
  v.direction("direction", f.direction, Across::xz, "In which gusts travel; only x and z count");
}

template <class Visitor>
void describe(Visitor& v, Breeze& b) {
  v.angle("amplitude", b.amplitude, {.min = 0, .max = 60}, "How far the free end of a hanging strand swings");
  v.direction("direction", b.direction, Across::xz, "Of the wind; only x and z count");
}

template <class Visitor>
void describe(Visitor& v, IvyParams& i) {
  v.list("on", i.on, "Names of the organisms that it grows on; none: all bodies there are");
  v.vector("facing", i.facing, {.min = -1000, .max = 1000},
           "Roots without a place stand where the host looks this way; 0: anywhere");
  v.number("above", i.above, {.min = 0, .max = 100, .unit = "m"},
           "Of those roots, over the host's lowest point");
  v.object("crawl", i.crawl, "How strands creep");
  v.object("leaves", i.leaves, "Leaves");
  v.object("bark", i.bark, "Of the strands; its colours run from old wood to shoots");
  v.object("flutter", i.flutter, "How leaves tremble");
  v.object("breeze", i.breeze, "How hanging strands swing");
  v.object("growth", i.growth, "When it grows");
}

namespace {

class IvyGrower final : public Described<IvyParams, Grower> {
 public:
  GrowthStage stage() const override { return GrowthStage::creeping; }
  bool stands_on_rock() const override { return false; }
  Errors check() const override {
    const Crawl& crawl = params.crawl;
    if (crawl.lure == Lure::point || crawl.bias <= 0 || glm::length(crawl.toward) >= 1e-3f) return {};
    return {{"/crawl/toward", "found a vector of length 0; expected the direction that strands turn to"}};
  }
  Errors doubts() const override { return {}; }
  Errors check_together(std::span<const Organism* const>, double) const override { return {}; }
  /// How far ivy comes shows only on its host: here it always finds room.
  Result<Foresight> foresee(Seed) const override {
    const Crawl& crawl = params.crawl;
    double length = std::min(crawl.max_age * crawl.speed, crawl.max_length);
    double steps = length / crawl.speed, branches = crawl.branch_depth > 0 ? length / crawl.branch_every : 0;
    Foresight ivy;
    ivy.nodes = std::min(steps * (1 + 1.5 * branches), static_cast<double>(crawl.most_nodes));
    ivy.organs = ivy.parts = 0.5 * ivy.nodes * crawl.speed / std::max(params.leaves.spacing, 1e-3);
    ivy.shapes = 9000;
    ivy.riding = true;
    ivy.nodes_a_second = kTreeNodesASecond;
    return ivy;
  }
  double tallest() const override { return 0; }
  Dress dress() const override {
    Dress dress;
    dress.look.bark = params.bark;
    dress.motion = {params.growth, {}, {}, 1, false, params.flutter, params.leaves.unfold};
    dress.variation = params.bark.variation;
    return dress;
  }
  bool develops(bool) const override { return false; }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  const std::vector<std::string>* hosts() const override { return &params.on; }

  std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                     const Step& step) const override {
    std::vector<std::optional<Result<Specimen>>> grown(beds.size());
    parallel_for(beds.size(), [&](std::size_t i) {
      grown[i] = grower_of<IvyGrower>(*beds[i].organism).grow_bed(beds[i], world);
      step();
    });
    std::vector<Result<Specimen>> list;
    for (auto& one : grown) list.push_back(std::move(*one));
    return list;
  }
  Result<Model> grow_copy(const Organism&, Seed) const override {
    return Error{"", "ivy grows on other bodies"};
  }
  float copy_depth(const Model&) const override { return 0; }

 private:
  Result<Specimen> grow_bed(const Bed& bed, const World& world) const {
    const Organism& organism = *bed.organism;
    auto named = [&](Errors errors) {
      for (Error& error : errors)
        error.where = organism.name.empty() ? fmt::format("organism {}", bed.entry) : organism.name;
      return errors;
    };
    auto ground = [&](double x, double z) { return (*world.ground())(x, z); };
    IvyRoots roots;
    for (Vec2 at : organism.place.at)
      roots.emplace_back(at.x, ground(at.x, at.y) + organism.place.raise, at.y);
    auto host = world.host(params.on, "what the ivy grows on");
    if (!host) return named(host.errors());
    Result<Ivy> ivy = grow_ivy(params, **host, roots, organism.count, ground, bed.seed.child("grow"));
    if (!ivy) return named(ivy.errors());
    Specimen specimen{{organism.name, bed.entry}, std::move(ivy->model)};
    Dress worn = dress();
    specimen.look = worn.look;
    specimen.brightness = 1 + worn.variation * bed.seed.child("brightness").range(-1, 1);
    specimen.motion = worn.motion;
    specimen.motion.film_length = world.film_length();
    specimen.life.hanging = Hanging{std::move(ivy->strands), params.breeze};
    specimen.life.hanging->breeze.film_length = world.film_length();
    return specimen;
  }
};

}  // namespace

Kind<Organism> ivy_kind() { return make_grower<IvyGrower>("ivy", "Ivy that creeps over other bodies"); }

}  // namespace frond
