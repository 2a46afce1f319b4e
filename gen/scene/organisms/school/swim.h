#pragma once

#include <vector>

#include "core/seed.h"
#include "world/world.h"

namespace frond {

/// The distance to existing objects, at any point in a box. A grid of exact distances between its cells
/// (Felzenszwalb and Huttenlocher 2012), so a query is cheap.
class Clearance {
 public:
  /// An empty box with cells of that size.
  Clearance(Vec3 low, Vec3 high, float cell);

  /// Adds a ball; parts outside the box are ignored.
  void add(Vec3 middle, float radius);
  /// Adds a cone between two balls, or a mesh; parts outside the box are ignored.
  void add(Vec3 a, Vec3 b, float radius_a, float radius_b);
  void add(const Surface& surface);
  /// Adds everything below the ground.
  void add_ground(const World& world);
  /// Computes the distances; call it after all objects are added, before any query.
  void measure();

  /// Metres to the nearest object, at most about the size of the box; beyond the box as at its edge.
  float operator()(Vec3 at) const;
  /// The direction away from the nearest object, not normalized; 0 if there is none.
  Vec3 away(Vec3 at) const;

  Vec3 low() const { return low_; }
  Vec3 high() const { return low_ + cell_ * Vec3(size_[0], size_[1], size_[2]); }

 private:
  std::size_t index(int x, int y, int z) const {
    return (static_cast<std::size_t>(z) * static_cast<std::size_t>(size_[1]) + static_cast<std::size_t>(y)) *
               static_cast<std::size_t>(size_[0]) +
           static_cast<std::size_t>(x);
  }

  Vec3 low_;
  float cell_;
  int size_[3];
  std::vector<float> distance_;  // cells, squared until they are measured
};

/// The clearance of everything in a world, throughout the film, round a home.
Clearance clearance_of(const World& world, Vec3 low, Vec3 high, float cell);

/// How a school swims.
struct SwimParams {
  double speed = 0.35;    ///< metres a second through the water
  double turn = 5;        ///< radians a second at most
  double spacing = 0.16;  ///< metres that fish keep from each other
  double sight = 0.6;     ///< metres within which it reacts to others
  double separation = 1;  ///< weights of the three rules, and of the other influences
  double alignment = 1;
  double cohesion = 1;
  double avoidance = 1;
  double wander = 0.4;
  double home = 0.8;              ///< metres, radius of the school's home
  double layer = 0.35;            ///< metres, half its height
  double roam = 0.8;              ///< metres that its middle moves from its home
  double clearance = 0.08;        ///< metres that each keeps from objects, besides its own body
  Vec3 current{0.85f, 0, 0.15f};  ///< relative to that speed; they swim against it
};

/// A school to swim.
struct SwimTask {
  SwimParams params;
  int count = 60;
  double length = 0.08;   ///< metres, of a fish
  double idle = 0.8;      ///< beats a second of one that does not swim
  std::size_t looks = 1;  ///< kinds of colours: animal i has number i % looks, and so has who takes its place
  Vec3 home{0, 1, 0};
  double film = 0;  ///< seconds after which it repeats; 0: a still picture
  Seed seed;
};

/// The trajectories of a school: a structure of arrays, step by step. In a film, fish i ends where fish
/// next[i] began, so that the film can be repeated.
struct Trajectory {
  int count = 0, steps = 0;  ///< steps + 1 are stored
  double step = 0;           ///< seconds
  bool repeats = false;
  std::vector<Vec3> position, velocity;  ///< [step * count + fish], metres, metres a second
  std::vector<Vec3> heading;             ///< through the water, of length 1
  std::vector<float> stroke;             ///< number of tail beats so far
  std::vector<float> size;               ///< factor
  std::vector<int> next;

  std::size_t bytes() const;  ///< of memory

  std::size_t at(int s, int fish) const {
    return static_cast<std::size_t>(s) * static_cast<std::size_t>(count) + static_cast<std::size_t>(fish);
  }
};

/// Simulates a school: boids (Reynolds 1987) in fixed steps, avoiding objects. In a film the end is blended
/// into the beginning.
Trajectory swim(const SwimTask& task, double beat, double size_variation, const Clearance& clear);

/// A fish at a time.
struct FishPose {
  Vec3 position{0}, heading{1, 0, 0};
  float stroke = 0;  ///< beats
  float turn = 0;    ///< radians per second to its left
  float size = 1;
};
FishPose fish_at(const Trajectory& trajectory, int fish, double time);

}  // namespace frond
