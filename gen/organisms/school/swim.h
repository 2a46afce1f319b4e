#pragma once

#include <vector>

#include "core/seed.h"
#include "organisms/school/clearance.h"

namespace frond {

/// How a school swims.
struct SwimParams {
  double speed = 0.35;    ///< metres a second through the water
  double spacing = 0.16;  ///< metres that each keeps from the next
  double sight = 0.6;     ///< metres within which it reads others
  double separation = 1;  ///< strengths of the three rules and of what else turns it
  double alignment = 1;
  double cohesion = 1;
  double avoidance = 1;
  double wander = 0.4;
  double home = 0.8;              ///< metres, radius of the school's home
  double layer = 0.35;            ///< metres, half its height
  double roam = 0.8;              ///< metres that its middle moves from its home
  double clearance = 0.08;        ///< metres that each keeps from what stands there, beside its own body
  Vec3 current{0.85f, 0, 0.15f};  ///< in shares of that speed; they swim against it
};

/// A school to swim.
struct SwimTask {
  SwimParams params;
  int count = 60;
  double length = 0.08;  ///< metres, of a fish
  Vec3 home{0, 1, 0};
  double film = 0;  ///< seconds after which all is as at first; 0: a still picture
  Seed seed;
};

/// How a school swam: a structure of arrays, step by step. Of a film, fish i is after the last step where
/// fish next[i] was at first, so that the film can be repeated.
struct Trajectory {
  int count = 0, steps = 0;  ///< steps + 1 are held
  double step = 0;           ///< seconds
  bool repeats = false;
  std::vector<Vec3> position, velocity;  ///< [step * count + fish], metres, metres a second
  std::vector<Vec3> heading;             ///< through the water, of length 1
  std::vector<float> stroke;             ///< beats of the tail so far
  std::vector<float> size;               ///< factor
  std::vector<int> next;

  std::size_t bytes() const;  ///< of memory

  std::size_t at(int s, int fish) const {
    return static_cast<std::size_t>(s) * static_cast<std::size_t>(count) + static_cast<std::size_t>(fish);
  }
};

/// Lets a school swim: boids (Reynolds 1987) in fixed steps, kept clear of what stands. Of a film the end is
/// blended into the beginning.
Trajectory swim(const SwimTask& task, double beat, double size_variation, const Clearance& clear);

/// A fish at a time.
struct FishPose {
  Vec3 position{0}, heading{1, 0, 0};
  float stroke = 0;  ///< beats
  float turn = 0;    ///< radians a second to its left
  float size = 1;
};
FishPose fish_at(const Trajectory& trajectory, int fish, double time);

/// How alike fish head at a step: 0 at random .. 1 all alike, as a share.
double polarization(const Trajectory& trajectory, int step);

}  // namespace frond
