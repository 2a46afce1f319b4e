#pragma once

#include <complex>
#include <memory>
#include <vector>

#include "model/model.h"
#include "motion/wind.h"

// How trees sway in the wind, by the stiffness and the mass of their wood and the drag of their leaves.
//
// The stem is a cantilever that carries its crown, and so is each limb on what bears it. It bends as its own
// wood does under the drag along it, M / (E I) a metre, and gravity rights what hangs. Its motion is that of
// damped oscillators in their first mode, the stem's in its second as well (James, Haritos and Ades 2006):
// each wave of the gusts moves it by an amplitude and a phase that are known in closed form, so any moment
// is computed by itself. Frequencies follow from the shape by Rayleigh's quotient, and for the stem by
// Stodola's iteration.

namespace frond {

struct Pose;

/// Wood and leaves, as the wind has to do with them.
struct SwayWood {
  double density = 900;    ///< kg/m3, green
  double stiffness = 8e9;  ///< Pa, of green wood
  double leaf_mass = 0.5;  ///< kg a square metre of leaves, with what lies on them
};

/// A damped oscillator.
struct Mode {
  double rate = 0;     ///< radians a second
  double damping = 1;  ///< share of the critical damping

  double frequency() const { return rate / (2 * kPi); }  ///< swings a second
};

/// The answer of an oscillator to a swing of that rate: its amplitude and phase, 1 where it follows.
std::complex<double> transfer(const Mode& mode, double rate);

/// A stem or limb: nodes of one order that hang together.
struct SwayLimb {
  std::int32_t first = 0;  ///< its lowest node
  Mode mode;               ///< its first one
  std::int32_t gusts = 0;  ///< the row of `response` that it follows
};

/// How a model gives way to a wind. A pure function of both; one entry for each node where nothing else is
/// said.
struct Sway {
  std::shared_ptr<const WindField> wind;
  SwayWood wood;
  std::vector<float> give;         ///< radians a pascal by which a segment turns against the one below it
  std::vector<float> second;       ///< as `give`, in the second mode; of the stem's nodes, else 0
  std::vector<std::int32_t> limb;  ///< index into limbs
  std::vector<SwayLimb> limbs;     ///< the stem is the first
  Mode stem_second;                ///< the stem's second mode
  /// For each row of limbs (SwayLimb::gusts), the amplitude and phase of the answer to each gust of the wind
  /// at time 0; then a last row for what the stem's second mode adds to the first.
  std::vector<std::complex<float>> response;

  /// The stem's first mode.
  const Mode& stem() const { return limbs.front().mode; }
};

/// Limbs of an order above this follow the gusts as the limb that bears them does.
inline constexpr int kSwayOrders = 3;

/// Square metres of leaves on each node of a model.
std::vector<float> leaf_areas(const Model& model);

Sway sway_of(const Model& model, const SwayWood& wood, std::shared_ptr<const WindField> wind);

/// The load on each limb at a time, Pa: the pressure of the mean wind and how the limb answers to the gusts.
class WindLoads {
 public:
  /// `exposure`: the share of the wind that reaches the tree.
  WindLoads(const Skeleton& rest, const Sway& sway, double time, double exposure);

  /// The rotation of node `i`, given those of all nodes before it. No segment is turned past the wind.
  Quat turn(std::size_t i, const std::vector<Quat>& turns) const;

  /// Sets how leaves flutter.
  void set_flutter(Pose& pose) const;

 private:
  const Skeleton& rest_;
  const Sway& sway_;
  double mean_, time_, exposure_;
  std::vector<float> swing_;  ///< of each row
  float pressure_ = 0, power_ = 2;
};

}  // namespace frond
