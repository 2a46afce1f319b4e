#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "core/curve.h"
#include "core/ease.h"
#include "core/vec.h"
#include "model/skeleton.h"
#include "motion/sway.h"

namespace frond {

/// When and how an organism grows. The shape is final from the start; time only reveals it.
struct Growth {
  double start = 0;               ///< seconds
  double duration = 0;            ///< seconds; 0: fully grown from the start
  double stagger = 0;             ///< seconds: individuals start later by a random delay of at most this
  double ripen = 0.35;            ///< share of the growth after which a new node has its full thickness, > 0
  bool to_end = false;            ///< duration is what the film leaves, see read_preset()
  std::optional<Ease> ease = {};  ///< none: fast in youth, slow in age
  double rate = 0;                ///< cm a year by which it becomes longer; 0: `duration` holds
  double years_a_second = 0;      ///< of the film, for `rate` and for what grows over years

  /// Whether its duration follows from its length, see paced().
  bool by_rate() const { return rate > 0 && years_a_second > 0; }
};

/// The growth of what comes to be so long, metres, at its rate; one without a rate stays as it is.
inline Growth paced(Growth growth, double length) {
  if (!growth.by_rate()) return growth;
  // It is as long as it comes to be when the front is at 1, and ripens after that.
  const double years = 100 * length / growth.rate;
  growth.duration = (1 + growth.ripen) * years / growth.years_a_second;
  return growth;
}

/// Swaying in a current: a bend that grows toward the tips and travels through the water.
struct Wave {
  double amplitude = 0;        ///< radians at the tips
  double speed = 0.25;         ///< swings a second
  double phase = 0;            ///< radians
  double length = 3;           ///< metres from crest to crest along the current
  Vec3 direction{1, 0, 0.3f};  ///< of the current; its vertical part is ignored
  bool loop = true;            ///< whole swings over the film, so that it can be repeated
};

struct FoodPlace {
  Animated<Vec3> position{Vec3(0, 1, 0)};
};

/// A pull toward food: branches bend to it, lengthen toward it, or both.
struct Food {
  double strength = 0;  ///< about the largest bend of a whole branch, radians
  double stretch = 0;   ///< share of its length by which a tip beside the food lengthens, at most
  double reach = 0.25;  ///< metres; the pull fades nearer than this, so that tips do not spin round the food
  Animated<Vec3> position{Vec3(0, 1, 0)};
  std::vector<FoodPlace> others;  ///< further food; each part of a branch bends mostly to the nearest
  bool eaten = false;             ///< whether food that a tip has reached is eaten
  std::vector<double> reached;    ///< seconds at which a tip reaches position and the others; empty: never

  bool pulls() const { return strength != 0 || stretch != 0; }
  std::size_t places() const { return 1 + others.size(); }
  const Animated<Vec3>& place(std::size_t i) const { return i == 0 ? position : others[i - 1].position; }
  /// The share of it that is left, 0..1.
  float left(std::size_t i, double time) const;
};

inline constexpr double kMeal = 1.5;  ///< seconds that eating takes

/// Leaves that tremble on their stalks in gusts of wind.
struct Flutter {
  double amplitude = 0;        ///< radians, of a leaf with a stalk of 5 cm in a gust
  double speed = 1.6;          ///< swings a second, about; varies between leaves
  double gust = 2.5;           ///< metres from gust to gust
  Vec3 direction{1, 0, 0.3f};  ///< in which gusts travel; its vertical part is ignored
};

struct Motion {
  Growth growth;
  Wave wave;
  Food food;
  double film_length = 1;  ///< seconds; what `loop` refers to
  bool limbs = false;      ///< each limb swings about its own base, as trees do, and leaves flutter
  Flutter flutter = {};
  double unfold = 0;                      ///< share of the growth in which a leaf unfolds; 0: as for ripening
  std::optional<SwayWood> wood = {};      ///< of what the wind bends
  std::shared_ptr<const Sway> sway = {};  ///< how it gives way to the wind of the scene; none: it does not
  double exposure = 1;                    ///< the share of that wind that reaches it

  /// Whether it moves by a wave of its own or by the wind.
  bool sways() const { return wave.amplitude != 0 || sway; }
};

/// A skeleton at one time, node by node. Nodes not reached by growth yet are at the growing tip of their
/// branch and move with it, so that nothing appears suddenly.
struct Pose {
  std::vector<Vec3> position;
  std::vector<float> radius;
  /// Rotates the rest shape round a node to the posed shape: skin point x of the rest shape near node i is at
  /// position[i] + turn[i] * (x - rest.position[i]). Textures follow it.
  std::vector<Quat> turn;
  /// How many times as long the segment that ends at a node is as at rest, growth aside; empty: all are as
  /// long.
  std::vector<float> stretch = {};
  float flutter = 0;              ///< radians, amplitude of the organs' flutter
  float flutter_phase = 0;        ///< radians; each organ adds its own
  std::vector<float> gusts = {};  ///< of each limb of Motion::sway, the factor of its flutter
  float front = 0;                ///< nodes born before this have been reached; above 1 all of them
};

/// Limits a radius at one end of a branch segment so that neither end sphere contains the other: otherwise
/// there is no cone between them, and a sphere_sweep has artefacts. Metres.
float cone_radius(float radius, float other, float length);

/// The share of growth at a time: 0 before the start, 1 + ripen at the end, smooth in between.
double growth_front(const Growth& growth, double time);

/// Poses a skeleton; a pure function. The root stays in place. Segments keep their lengths, or where food
/// stretches them their volumes. `pose` is overwritten; reusing it saves allocations.
void pose_skeleton(const Skeleton& rest, const Motion& motion, double time, Pose& pose);

}  // namespace frond
