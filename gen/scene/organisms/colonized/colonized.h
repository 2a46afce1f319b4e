#pragma once

#include <optional>
#include <string>

#include "appearance/appearance.h"
#include "core/assets.h"
#include "crown/colonize.h"
#include "geometry/girth.h"
#include "organisms/tree_parts.h"

namespace frond {

enum class EnvelopeKind { ball, cone, cylinder, mesh, outline };

/// The volume that a colonized tree fills.
struct EnvelopeParams {
  EnvelopeKind kind = EnvelopeKind::ball;
  double base = 1.2;   ///< metres above the ground
  double height = 4;   ///< metres
  double width = 3.6;  ///< metres
  double depth = 0;    ///< metres from front to back; 0: as the width, outlines are turned about their middle
  double top = 0;      ///< of a cone: width at its top relative to its foot
  FileName file;       ///< OBJ for a mesh, SVG or PNG for an outline, relative to the preset's folder
  std::string path;    ///< of an outline: SVG path data in place of a file
  Surface mesh;        ///< content of the file, if a mesh
  std::optional<Silhouette> outline;  ///< content of the file, if an outline
};

/// A tree that grows into the free space of an envelope.
struct ColonizedParams {
  EnvelopeParams envelope;
  Colonization growth_into;
  TreeGuide guide;  ///< of its first limbs
  Girth thickness{GirthFrom::pipe, 0.13, 2.4, Curve(), 0.0025, 0.5};
  int smoothing = 2;
  BranchesAlong along;               ///< how branches are shaped once they have grown
  double leaf_reach = 0.55;          ///< metres from a tip within which leaves grow; 0: no leaves
  double leaf_spacing = 0.035;       ///< metres from leaf to leaf
  double leaf_down = radians(55.0);  ///< between branch and leaf
  TreeAppearance appearance;
};

/// One tree, its foot at the origin, round what is in its way.
Result<Model> grow_colonized_tree(const ColonizedParams& params, Seed seed, const Detour& detour = {});

/// What is missing before it can be grown.
Errors check_colonized(const ColonizedParams& params);

/// Loads the mesh or silhouette from an envelope's file.
Errors load_envelope(const NamedFile& file, EnvelopeParams& envelope);

}  // namespace frond
