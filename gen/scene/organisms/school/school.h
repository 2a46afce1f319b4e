#pragma once

#include "appearance/fish_look.h"
#include "organisms/school/swim.h"

namespace frond {

/// One kind of fish.
struct FishParams {
  double length = 0.08;  ///< metres, the tail included
  double size_variation = 0.12;
  double beat = 2.2;  ///< distance per beat of its tail, in lengths
  FishForm form;
  FishLook look;
};

struct SchoolParams {
  FishParams fish;
  SwimParams swim;
};

/// Number of precomputed positions of the tail and bends of the body.
inline constexpr int kTailPhases = 8, kTailBends = 3;

/// All its shapes: kTailPhases for each of kTailBends.
std::vector<Prototype> fish_prototypes(const FishParams& fish);

/// The fish of a school at a time, as the organs of a model.
Organs school_organs(const SchoolParams& params, const Trajectory& trajectory, double time);

}  // namespace frond
