#pragma once

#include <optional>
#include <string>
#include <vector>

#include "crown/colonize.h"
#include "crown/weber_penn.h"
#include "organisms/bark_coat.h"
#include "organisms/leaf_look.h"
#include "organisms/plant.h"
#include "organisms/season.h"

namespace frond {

/// What trees of both kinds below wear and how they move.
struct TreeDress {
  Bark bark;                     ///< of branches drawn as sweeps
  std::optional<BarkCoat> coat;  ///< where given, branches are meshes with this picture
  LeafLook leaves;
  std::optional<Seasons> season;
  Wave wave;
  Growth growth;
};

/// A tree by the parameters of Weber and Penn.
struct WeberPennParams {
  WeberPenn tree;
  std::string species;  ///< an Arbaro file whose values stand for `tree`, as seen from the preset's folder
  TreeDress dress;
};

enum class EnvelopeKind { ball, cone, cylinder, mesh, outline };

/// The room that a colonized tree fills.
struct EnvelopeParams {
  EnvelopeKind kind = EnvelopeKind::ball;
  double base = 1.2;   ///< metres above the ground
  double height = 4;   ///< metres
  double width = 3.6;  ///< metres
  double depth = 0;    ///< metres from front to back; 0: as wide, and an outline is turned about its middle
  double top = 0;      ///< of a cone: width at its top as a share of that at its foot
  std::string file;    ///< of a mesh an OBJ, of an outline an SVG or a PNG, as seen from the preset's folder
  std::string path;    ///< of an outline: SVG path data in place of a file
  Surface mesh;        ///< what the file holds
  std::optional<Silhouette> outline;  ///< the same
};

/// A tree that grows into the free space of an envelope.
struct ColonizedParams {
  EnvelopeParams envelope;
  Colonization growth_into;
  Girth thickness{GirthFrom::pipe, 0.13, 2.4, Curve(), 0.0025, 0.5};
  int smoothing = 2;
  double leaf_reach = 0.55;          ///< metres from tips that bear leaves; 0: bare
  double leaf_spacing = 0.035;       ///< metres from leaf to leaf
  double leaf_down = radians(55.0);  ///< between branch and leaf
  TreeDress dress;
};

Result<Model> grow_weber_penn_tree(const WeberPennParams& params, Seed seed);
Result<Model> grow_colonized_tree(const ColonizedParams& params, Seed seed);

/// The room itself; what it lacks is an error.
Result<Envelope> envelope_of(const EnvelopeParams& params);

/// What is missing before it can be grown.
Errors check_colonized(const ColonizedParams& params);

/// All pictures that a tree's frames need.
std::vector<Drawing> dress_drawings(const TreeDress& dress, bool leafy);

}  // namespace frond
