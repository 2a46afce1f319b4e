#pragma once

#include "appearance/skin.h"
#include "core/curve.h"
#include "core/result.h"
#include "core/seed.h"
#include "grammar/grammar.h"
#include "model/skeleton.h"
#include "motion/motion.h"

namespace frond {

/// The rules that a coral grows by.
enum class CoralForm {
  branching,  ///< A -> !"[B]////[B]////B, B -> &FFFA
  tufted,     ///< A -> "[&FFFA]////[&FFFA]////[&FFFA]
  own         ///< the preset's own `grammar`
};

/// Thickness of branches: the distance to the farthest tip, as a share, through a curve, times the radius at
/// the base.
struct Thickness {
  double radius = 0.035;                                           ///< metres, at the base
  Curve curve{{{0, 0.36f}, {0.35f, 0.5f}, {0.8f, 0.8f}, {1, 1}}};  ///< 0 at the farthest tip .. 1 at the base
  double knob = 1.15;                                              ///< factor right at each tip
  double flare = 0.6;                                              ///< how much wider the foot is
};

/// Noise that bends the straight shape, 0 at the base.
struct Distortion {
  double strength = 0.04;  ///< metres at the tips
  double scale = 0.35;     ///< metres from bend to bend
};

/// A branching coral: an L-system, walked by a turtle, thickened and bent.
struct CoralParams {
  CoralForm form = CoralForm::branching;
  int steps = 6;                       ///< number of derivation steps
  double pitch = radians(25.0);        ///< of a new branch (&)
  double roll = radians(45.0);         ///< of one / symbol
  double angle_jitter = radians(9.0);  ///< random change of each turn, plus or minus
  double length_jitter = 0.25;         ///< random change of each internode, as a share of its length
  double internode = 0.05;             ///< metres; length of one F
  double length_scale = 1.0;           ///< factor of " for lengths
  double width_scale = 0.93;           ///< factor of ! for thickness
  double lift = 0.06;                  ///< upward bend per internode (elasticity of the tropism)
  double height = 0;                   ///< metres; the whole is scaled to this height; 0: not scaled
  int smoothing = 3;                   ///< nodes for each internode
  GrammarText grammar;                 ///< for CoralForm::own
  bool own_rules = false;              ///< whether the preset gives this coral its own grammar
  Thickness thickness;
  Distortion distortion;
  Skin skin;
  Wave wave;
  Food food;
  Growth growth;
};

/// The grammar for the parameters, ready to derive; errors are those of an own grammar.
Result<Grammar> coral_grammar(const CoralParams& params);

/// Grows one coral, upright, its foot at the origin. Every node has its distance, birth and radius.
/// `environment` answers the questions of its grammar.
Result<Skeleton> grow_coral(const CoralParams& params, Seed seed, const Environment& environment = {});

}  // namespace frond
