
#include <algorithm>
#include <cmath>
#include <memory>

#include "organisms/kinds.h"
#include "organisms/school/school.h"

namespace frond {

namespace {

constexpr Choice<SeaAnimal> kSwimmers[] = {
    {"fish", SeaAnimal::fish, "a fish of the given form"},
    {"turtle", SeaAnimal::turtle, "a sea turtle: back, scutes of flank, seams of mark, belly"},
    {"manta", SeaAnimal::manta, "a manta: back, shoulders of mark, belly with spots of edge"},
    {"jellyfish", SeaAnimal::jellyfish,
     "a jellyfish: top of back, rim of flank, arms of belly, tentacles of tail; with the pattern `lines` "
     "stripes "
     "of mark, with `spots` four horseshoes"}};

}  // namespace

void describe(Properties& v, FishParams& f) {
  v.choice("animal", f.animal, kSwimmers, "What swims, and which colours of its look count");
  v.number("length", f.length, metres(0.005, 20),
           "Length from nose to tail; of a manta from wingtip to wingtip, of a jellyfish across its bell");
  v.number("size_variation", f.size_variation, {.min = 0, .max = 0.6},
           "Random change of the length, as a share of it");
  v.number("variation", f.variation, {.min = 0, .max = 0.8},
           "Random change of the colours, as a share of them");
  v.number("beat", f.beat, {.min = 0.1, .max = 20},
           "Lengths of its own that it comes on with one beat of its tail, its wings or its bell");
  v.object("form", f.form, "The shape of a fish; shares of its length. Needs \"animal\": \"fish\"");
  v.object("look", f.look, "The colours of a fish");
}

void describe(Properties& v, SwimParams& s) {
  v.number("speed", s.speed, {.min = 0.01, .max = 20, .unit = "m/s"}, "Speed through the water");
  v.number("turn", s.turn, {.min = 0.05, .max = 20, .unit = "rad/s"},
           "How fast they turn at most, at that speed");
  v.number("spacing", s.spacing, metres(0.005, 50), "Distance that fish like to keep from each other");
  v.number("sight", s.sight, metres(0.01, 100), "Distance within which a fish reads others");
  v.number("separation", s.separation, {.min = 0, .max = 10}, "How strongly fish keep apart");
  v.number("alignment", s.alignment, {.min = 0, .max = 10},
           "How strongly they take the direction of those round them");
  v.number("cohesion", s.cohesion, {.min = 0, .max = 10}, "How strongly they keep together");
  v.number("avoidance", s.avoidance, {.min = 0, .max = 10},
           "How strongly they turn away from what stands in their way");
  v.number("wander", s.wander, {.min = 0, .max = 10}, "How strongly each drifts by itself");
  v.number("home", s.home, metres(0.02, 100), "Radius of the school, about");
  v.number("layer", s.layer, metres(0.02, 100), "Half the height of the school, about");
  v.number("roam", s.roam, metres(0, 100),
           "Distance that the school goes from its place and back in the film; shorter where the film is");
  v.number("clearance", s.clearance, metres(-0.5, 10),
           "Distance that fish keep from corals, rocks and ground at least, beside half their length; below "
           "0 they "
           "swim in between, as clownfish do");
  v.vector(
      "current", s.current, {.min = -10, .max = 10},
      "Current that they swim against, as a share of their speed; near 1 they hover, at 0 they go round");
}

void describe(Properties& v, SchoolParams& s) {
  v.object("fish", s.fish, "The fish");
  v.object("swim", s.swim, "How they swim");
}

namespace {

constexpr double kMostCells = 4e6;  // of the grid that says where corals are
constexpr double kMostFish = 5000;

Errors too_many_fish(std::span<const Organism* const> all, double /*relief*/) {
  for (const Organism* one : all)
    if (one->count > kMostFish)
      return {error_at("/count", "found {} fish; expected {} at most", one->count, kMostFish)};
  return {};
}

class School final : public Described<SchoolParams, BedGrower> {
 public:
  static constexpr std::string_view kLeading[] = {
      "fish/animal",   "fish/length",    "fish/form",   "swim/speed", "swim/spacing",
      "swim/cohesion", "swim/alignment", "swim/wander", "swim/layer", "swim/roam"};

  GrowerTraits traits() const override {
    return {.stage = GrowthStage::swimming, .rebuilt = Rebuilt::in_films, .faults_together = too_many_fish};
  }
  Review review() const override {
    if (params.swim.sight < params.swim.spacing)
      return {{{"/swim/sight",
                "is below swim.spacing; expected at least that, so that fish see who is too near"}}};
    if (params.fish.animal == SeaAnimal::fish && params.fish.form.dorsal_to <= params.fish.form.dorsal_from)
      return {{{"/fish/form/dorsal_to", "is not behind fish.form.dorsal_from; expected more than that"}}};
    return {};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    constexpr double kTriangles[] = {1700, 6000, 3200, 9800};  // of the animals, about
    double triangles = kTriangles[static_cast<std::size_t>(params.fish.animal)];
    return SizeEstimate{.organs = 1, .parts = 1, .shapes = kShapes * triangles};
  }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.branches = {.bark = Bark{}};  // none is seen: fish are organs
    for (const FishLook& look : looks_of(params.fish))
      appearance.look.pictures.push_back(swimmer_drawing(params.fish.animal, params.fish.form, look));
    if (params.fish.animal == SeaAnimal::fish)
      appearance.look.pictures.push_back(fish_relief(params.fish.form, params.fish.look));
    return appearance;
  }
  Result<Specimen> grow_bed(const Bed& bed, const World& world) const override {
    const Place& place = bed.organism->place;
    Vec2 at = place.at.empty() ? place.center : place.at.front();
    SwimTask task;
    task.params = params.swim;
    task.count = std::max(bed.organism->count, 0);
    task.length = params.fish.length;
    task.looks = static_cast<std::size_t>(look_count(params.fish));
    if (params.fish.animal != SeaAnimal::fish) task.idle = 0;
    task.home = Vec3(at.x, world.height(at) + place.raise, at.y);
    task.film = world.filmed() ? world.film_length() : 0;
    task.seed = bed.seed.child("swim");
    auto trajectory = std::make_shared<const Trajectory>(
        frond::swim(task, params.fish.beat, params.fish.size_variation, clearance_round(task.home, world)));
    Specimen specimen{{bed.organism->name, bed.entry}, {}};
    Appearance worn = appearance();
    specimen.look = worn.look;
    specimen.motion = worn.motion;
    specimen.motion.film_length = world.film_length();
    specimen.model.prototypes = swimmer_prototypes(params.fish);
    specimen.model.organs = school_organs(params, *trajectory, 0);
    auto shapes = std::make_shared<const std::vector<Prototype>>(specimen.model.prototypes);
    specimen.life.held = trajectory->bytes();
    if (trajectory->repeats)
      specimen.life.develop = [own = params, trajectory, shapes](double time) -> Result<Model> {
        Model model;
        model.prototypes = *shapes;
        model.organs = school_organs(own, *trajectory, time);
        return model;
      };
    return specimen;
  }
  Result<Model> grow_copy(const Organism&, Seed) const override {
    return Error{"", "a school swims; it cannot be sown"};
  }

 private:
  /// The box that its fish may reach, and the grid in it.
  Clearance clearance_round(Vec3 home, const World& world) const {
    const SwimParams& swim = params.swim;
    constexpr double kBeyondHome = 1.4, kBeyondLayer = 1.6, kRoamUp = 0.2;  // of home, layer and roam
    constexpr double kSpare = 0.8;                                          // metres
    constexpr double kCell = 0.4, kFinest = 0.03, kCoarsest = 0.5;          // of a fish's length; metres
    double wide = kBeyondHome * swim.home + swim.roam + kSpare,
           high = kBeyondLayer * swim.layer + kRoamUp * swim.roam + kSpare;
    Vec3 reach(wide, high, wide);
    double cell = std::clamp(kCell * params.fish.length, kFinest, kCoarsest);
    cell = std::max(cell, std::cbrt(8 * wide * wide * high / kMostCells));
    return clearance_of(world, home - reach, home + reach, static_cast<float>(cell));
  }
};

}  // namespace

Kind<Organism> school_kind() {
  return make_grower<School>(
      "school", "Fish, turtles, mantas or jellyfish that keep together and clear of what stands there");
}

}  // namespace frond
