#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "draw/branches.h"
#include "draw/organs.h"
#include "draw/solids.h"
#include "draw/twigs.h"

// What is drawn of an organism at one time. POV-Ray's text, exports, the studio's view, the quick look and
// the samples for the soft light are made from this list.

namespace frond {

/// What a surface looks like to whoever does not call the macros of povinc/.
struct PlainLook {
  Color color;                    ///< sRGB
  double gloss = 0.2;             ///< 0 matt .. 1 polished
  bool both_sides = false;        ///< of a thin sheet
  double light_through = 0;       ///< share of the light that comes through a thin sheet
  double opacity = 1;             ///< 0 invisible .. 1
  std::string_view picture = {};  ///< a PNG file in place of the colour; empty: none
};
/// The look of part `part` of an organ in one of its colours, of blades in a colour, and of a body.
PlainLook plain_look(const Prototype& organ, std::size_t part, std::size_t color);
PlainLook plain_look(const BladeLook& blades, std::size_t color);
PlainLook plain_look(const Material& body);

/// All that is drawn of one organism. Refers to what it is made from and to its own pose, so it stays where
/// it is.
struct DrawList {
  /// What is drawn of a specimen, which must be developed() to that time; seconds. `solids` are drawn in
  /// place of its own.
  DrawList(const Specimen& specimen, double time) : DrawList(specimen, time, specimen.model.solids) {}
  /// With a plan, twigs are copies of a palette.
  DrawList(const Specimen& specimen, double time, const Solids& solids, const TwigPlan* plan = nullptr);
  /// What is drawn of a model at rest, fully grown.
  DrawList(const Traits& own, const Model& at_rest);
  DrawList(const DrawList&) = delete;
  DrawList& operator=(const DrawList&) = delete;

  const Traits& traits;
  const Model& model;
  Pose pose;
  std::optional<DrawnTwigs> twigs;        ///< which are no part of what follows
  std::optional<Pose> limbs;              ///< where there are twigs, the pose of the other branches
  std::optional<DrawnBranches> branches;  ///< none where they are not to be seen
  DrawnOrgans organs;
  std::vector<DrawnBlades> blades;
  std::vector<DrawnBody> bodies;  ///< those that stand still, then those that grow

 private:
  DrawList(const Traits& own, const Model& grown, Pose posed, double time, const Solids& solids,
           const TwigPlan* plan);
};

}  // namespace frond
