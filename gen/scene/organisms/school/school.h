#pragma once

#include "appearance/swimmer_look.h"
#include "organisms/school/swim.h"

namespace frond {

/// One kind of fish, or of another animal.
struct FishParams {
  SeaAnimal animal = SeaAnimal::fish;
  double length = 0.08;  ///< metres, the tail included
  double size_variation = 0.12;
  double variation = 0;  ///< of their colours
  double beat = 2.2;     ///< distance per beat of its tail, in lengths
  FishForm form;
  FishLook look;
};

struct SchoolParams {
  FishParams fish;
  SwimParams swim;
};

/// Number of precomputed positions of the tail and bends of the body of fish.
inline constexpr int kTailPhases = 8, kTailBends = 3;
/// Number of precomputed shapes of any animal: of those that do not bend, all are moments of their stroke.
inline constexpr int kShapes = kTailPhases * kTailBends;

/// The looks of single animals, one where they do not vary.
std::vector<FishLook> looks_of(const FishParams& fish);
int look_count(const FishParams& fish);

/// All its shapes: kTailPhases for each of kTailBends, or kShapes phases.
std::vector<Prototype> swimmer_prototypes(const FishParams& fish);

/// The fish of a school at a time, as the organs of a model.
Organs school_organs(const SchoolParams& params, const Trajectory& trajectory, double time);

}  // namespace frond
