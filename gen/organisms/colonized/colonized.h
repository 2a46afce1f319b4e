#pragma once

#include <optional>
#include <string>

#include "core/assets.h"
#include "crown/colonize.h"
#include "dress/dress.h"
#include "geometry/girth.h"

namespace frond {

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

Result<Model> grow_colonized_tree(const ColonizedParams& params, Seed seed);

/// The room itself; what it lacks is an error.
Result<Envelope> envelope_of(const EnvelopeParams& params);

/// What is missing before it can be grown.
Errors check_colonized(const ColonizedParams& params);

/// Takes the mesh or the silhouette that an envelope's file holds.
Errors load_envelope(const NamedFile& file, EnvelopeParams& envelope);

}  // namespace frond
