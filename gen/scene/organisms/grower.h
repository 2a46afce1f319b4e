#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <typeinfo>
#include <vector>

#include "appearance/appearance.h"
#include "core/events.h"
#include "core/result.h"
#include "core/seed.h"
#include "grammar/forecast.h"
#include "model/model.h"
#include "preset/keys.h"
#include "world/world.h"

// Kinds of organisms
// ==================
// A kind is a folder below gen/scene/organisms and a row in organisms/kinds.h. In the folder its parameters
// are described (preset/describe.h) and a Grower answers everything that other modules ask. What all kinds
// must answer does not compile where it is missing; what only some have, they override. No code outside the
// folder knows the parameters.
//
//     class Toy final : public Described<ToyParams, LoneGrower> {
//      public:
//       GrowerTraits traits() const override { return {.branches = true, .tallest = params.size}; }
//       Result<Model> grow_alone(Seed seed) const override;
//       ...
//     };
//     Kind<Organism> toy_kind() { return make_grower<Toy>("toy", "A toy"); }

namespace frond {

struct Organism;

/// Kinds grow in this order; those of one stage see the results of earlier stages, but not each other.
enum class GrowthStage {
  free,          ///< bodies, and organisms that need only a place
  round_bodies,  ///< organisms that bend round bodies
  in_space,      ///< organisms that compete for space, beside and on bodies
  in_light,      ///< organisms that compete for light and are shaded by bodies
  creeping,      ///< organisms that find their own place on bodies
  swimming       ///< animals that move among everything else
};

/// A straight line on the ground along which something is built, from end to end.
struct PlaceLine {
  Vec2 at{0};         ///< its middle
  double turn = 0;    ///< radians; 0 is along x
  double length = 0;  ///< metres
};

/// A place for one organism.
struct Planting {
  Seed seed;
  Vec3 foot{0};                  ///< on the ground or on its rock, including the preset's `raise`
  Vec3 normal{0, 1, 0};          ///< of the surface below it, if that is a body
  std::size_t claim = SIZE_MAX;  ///< index of its claim in the world's territories, if it has one

  double turn = 0;                        ///< radians about the vertical, besides that of the preset
  double size = 1;                        ///< factor, besides that by chance
  std::span<const PlaceLine> lines = {};  ///< that it is built along; empty: it stands by itself
};

/// How far an organism would spread from its foot without neighbours, metres.
struct Spread {
  float across = 0.2f, up = 0.2f;
};

/// An entry of a preset that is about to grow.
struct Bed {
  const Organism* organism = nullptr;
  std::size_t entry = 0;
  Seed seed;
  std::vector<Planting> plantings;  ///< empty if it finds its own place
};

/// Predicted size of one organism, within about a factor of two.
struct SizeEstimate {
  Forecast word = {};  ///< of its grammar
  double nodes = 0;    ///< of its skeleton
  std::optional<double> chains =
      {};  ///< chains per node of the skeleton, if known; short chains need more text
  double organs = 0;
  double parts = 0;             ///< number of placements of all parts of its organs
  double corners = 0;           ///< of the turtle's outlines
  double shapes = 0;            ///< triangles of its organs' shapes, once per entry
  double triangles = 0;         ///< of a body
  double area = 0;              ///< m2 of a living skin, which is written no finer than visible; 0: none
  double blocks = 0;            ///< number of placements that a body consists of
  bool riding = false;          ///< whether its textures are attached to it even without motion
  double nodes_a_second = 5e5;  ///< nodes grown per second
  double seconds = 0;           ///< processor time to grow one, besides that of its nodes, organs and word
  double held = 0;              ///< bytes in use while one grows; half of it remains in use
};

/// Nodes per second of organisms that search for space, for SizeEstimate.
inline constexpr double kTreeNodesASecond = 5e4;

/// Called after each grown organism, from several threads.
using Step = std::function<void()>;

/// For which pictures a shape is built anew, rather than revealed as it has grown once.
enum class Rebuilt { never, in_films, always };

/// What is known of a grower by its parameters at once.
struct GrowerTraits {
  GrowthStage stage = GrowthStage::free;
  bool stands_on_rock = true;  ///< whether a rock may be placed under it; not for what is of stone
  bool colony = false;         ///< whether it is a coral or a sponge
  bool branches = false;       ///< whether it has any; an organism's `body` says how to draw them
  Rebuilt rebuilt = Rebuilt::never;
  double tallest = 0;      ///< metres, an upper estimate of the height of one; 0: unknown
  float sunk = 1;          ///< how deep one stands in the ground, in radii of its foot,
  float sunk_most = 0.1f;  ///< and as a share of its length at most; 0: however long it is
  /// The names of the organisms that it creeps over, kept by the grower; nullptr if it does not creep.
  const std::vector<std::string>* hosts = nullptr;
  /// What is wrong with all of its kind in a scene whose land rises by `relief` metres, taken together;
  /// pointers are below the first of them. nullptr: nothing can be.
  Errors (*faults_together)(std::span<const Organism* const> all, double relief) = nullptr;

  bool creeps() const { return hosts != nullptr; }
  /// Whether it lives, so that its health tells.
  bool lives() const { return colony || branches || creeps(); }
  bool swims() const { return stage == GrowthStage::swimming; }
  /// Whether it may stand on bodies, as `place.on` says: what competes for space may.
  bool stands_on_bodies() const { return stage == GrowthStage::in_space; }
  /// Whether all of its kind grow in one light.
  bool shares_light() const { return stage == GrowthStage::in_light; }
  /// Whether it finds its own place: all of an entry then grow as one.
  bool finds_own_place() const { return stage >= GrowthStage::creeping; }
  /// Whether its shape is rebuilt for each picture, of a film or of a still.
  bool develops(bool filmed) const { return rebuilt >= (filmed ? Rebuilt::in_films : Rebuilt::always); }
};

/// What shows only after reading everything; each `where` is a JSON pointer below the organism.
struct Review {
  Errors faults = {};
  Errors warnings = {};  ///< valid, but probably not intended; they count only where there are no faults
};

/// A storm in a film.
struct StormTime {
  double time = 0, lasts = 1;  ///< seconds: its height, and from there to where it is a third as strong
  double gust = 0;             ///< metres a second, the strongest
};

class Perennial;

/// The parameters of an organism and the functions of its kind. Pure functions.
class Grower {
 public:
  virtual ~Grower() = default;

  /// What stands for the kind with these parameters, in names and caches.
  virtual Keys keys() const = 0;
  virtual GrowerTraits traits() const = 0;
  /// Faults and warnings of one by itself; of all together see GrowerTraits::faults_together.
  virtual Review review() const = 0;
  /// Predicted size; a derivation beyond its limits is an error with the figure and the step.
  virtual Result<SizeEstimate> estimate_size(Seed seed) const = 0;
  /// What it wears and how it moves.
  virtual Appearance appearance() const = 0;
  /// Grows all plantings of all beds, in their order. All beds are of this kind, the first belongs to this
  /// grower.
  virtual std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                             const Step& step) const = 0;
  /// Grows one model for copies, upright, its foot at the origin, with an age and size of its own; an error
  /// where none of the kind can be sown.
  virtual Result<Model> grow_copy(const Organism& organism, Seed seed) const = 0;

  // What only some have:

  /// Its grammar, ready to derive.
  virtual std::optional<Result<Grammar>> grammar() const { return std::nullopt; }
  /// Its claim in the space that colonies compete for; none: it does not compete.
  virtual std::optional<Spread> spread() const { return std::nullopt; }
  /// What it can tell of its years, if it lives through years; nullptr otherwise.
  virtual const Perennial* perennial() const { return nullptr; }
  /// A coarser version that grows in about `share`, 0..1, of the time, for previews while it is edited; none
  /// if not needed.
  virtual std::shared_ptr<const Grower> coarse(double /*share*/) const { return nullptr; }
  /// A version of that length in metres, of what is built along lines; none of all else.
  virtual std::shared_ptr<const Grower> as_long_as(double /*length*/) const { return nullptr; }
};

/// What lives through years, so that it can be cut in one of them and grows on, see Edit::cut.
class Perennial {
 public:
  /// When and how strongly the storm of an event blows in a film; none where its years are not filmed.
  virtual std::optional<StormTime> storm_of(const Event& event) const = 0;
  /// A version of that age in years, which died before the last `dead` of them and has no limbs on the first
  /// `clear` metres of its stem; none if there is no such version.
  virtual std::shared_ptr<const Grower> at_age(double years, double dead, double clear) const = 0;
  /// Metres, how tall one of its copies is at the end of each of its years.
  virtual std::vector<float> heights(const Organism& organism, Seed seed) const = 0;

 protected:
  ~Perennial() = default;
};

/// An organism that does not depend on what grows beside it.
class LoneGrower : public Grower {
 public:
  /// Grows one, upright, its foot at the origin.
  virtual Result<Model> grow_alone(Seed seed) const = 0;
  /// Grows one at its place; the shape differs from that of grow_alone() only if the kind takes its
  /// surroundings into account.
  virtual Result<Model> grow_standing(const World&, const Planting&, const Placement&, Seed seed) const {
    return grow_alone(seed);
  }
  /// Grows one, upright, its foot at the origin, round the bodies of a detour; for the stage round_bodies.
  virtual Result<Model> grow_round(const Detour&, Seed seed) const { return grow_alone(seed); }
  /// The shape at a time of a film, fully revealed, see Life; empty: growth is only revealed.
  virtual std::function<Result<Model>(double)> develop(const Motion& /*motion*/, Seed) const { return {}; }

  std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                     const Step& step) const override;
  Result<Model> grow_copy(const Organism&, Seed seed) const override { return grow_alone(seed); }
};

/// An organism that finds its own place; all of an entry grow as one.
class BedGrower : public Grower {
 public:
  virtual Result<Specimen> grow_bed(const Bed& bed, const World& world) const = 0;
  std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                     const Step& step) const final;
};

/// The parameters of a kind; those that know their type find them by grower_of<Holding<Params>>().
template <class Params>
struct Holding {
  Params params;
};

/// A kind with the described parameters `Params`; functions that it does not define come from `Base`.
template <class Params, class Base>
class Described : public Base, public Holding<Params> {
 public:
  Keys keys() const final { return keys_of(std::string(typeid(Params).name()), this->params); }
};

/// A copy of a grower with changed parameters; none if these are invalid.
template <class Mine, class Change>
std::shared_ptr<const Grower> changed(const Mine& grower, Change change) {
  auto other = std::make_shared<Mine>(grower);
  change(other->params);
  return other->review().faults.empty() ? other : nullptr;
}

/// A copy of a grower whose triangles have edges so much longer that about `share` of them are left, at least
/// 1/16.
template <class Mine>
std::shared_ptr<const Grower> longer_edges(const Mine& grower, double share,
                                           double& (*edge)(decltype(grower.params)&)) {
  return changed(grower, [&](auto& params) { edge(params) /= std::sqrt(std::clamp(share, 1. / 16, 1.)); });
}

/// A copy of a grower with fewer derivation steps, and at most `share` of the nodes if possible. `word_size`
/// estimates a plant with some parameters by its grammar's word alone.
template <class Mine, class Params>
std::shared_ptr<const Grower> fewer_steps(const Mine& grower, double share, int& (*steps)(Params&),
                                          Result<SizeEstimate> (*word_size)(const Params&, Seed)) {
  return changed(grower, [&](Params& params) {
    auto nodes = [&] {
      Result<SizeEstimate> size = word_size(params, Seed{1});
      return size ? size->nodes : 0;
    };
    double most = share * nodes();
    params.smoothing = 1;
    for (int& left = steps(params); left > 1 && nodes() > most;) --left;
  });
}

/// Built objects: they have no branches, no motion, and no look except their materials.
class BodyBuilder : public LoneGrower {
 public:
  GrowerTraits traits() const override { return {}; }
  Appearance appearance() const override { return {}; }
};

/// The largest distance of one of them from the middle, metres.
double reach_of(const Organism& organism);

/// Sets the appearance of a specimen at its place, including individual variation.
void apply_appearance(Specimen& specimen, const Appearance& appearance, const World& world, Seed seed);

/// How deep a model of a grower stands in the ground, metres.
float depth_of(const Grower& grower, const Model& model);

/// The lean that `place` sets for a planting, and its size factor.
Quat lean_of(const Organism& organism, Seed planting);
float size_of(const Organism& organism, const Planting& planting);

}  // namespace frond
