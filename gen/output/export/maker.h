#pragma once

#include <cmath>
#include <map>
#include <span>

#include "draw/solids.h"
#include "export/foliage.h"
#include "export/materials.h"

namespace frond {

/// A level of detail that is drawn as pictures which cross, when the materials of what they show have theirs.
struct CrossedLevel {
  std::vector<std::size_t> meshes;  ///< what they show; they become a level of the first
  std::size_t level = 1;
  int boughs = 0;  ///< into how many the leaves of the first are parted; 0: one set of the whole
};

/// The width of a bough's picture.
int bough_pixels(const ExportOptions& options);

/// Puts an exported scene together.
struct Maker {
  ExportScene& exported;
  const ExportOptions& options;
  Palette palette{exported, options};
  Names group_names{}, mesh_names{};
  int level = 0;                               ///< level of detail of what is added next
  std::map<std::string, std::size_t> begun{};  ///< the meshes of this organism, by what was asked for
  std::vector<CrossedLevel> crossed{};
  double spare = 0;  ///< triangles that wood and bodies may have above their share

  /// Begins an organism, which what is added next belongs to.
  void begin(const std::string& name, Vec3 foot, bool sown = false) {
    exported.groups.push_back({group_names.unique(name), foot, sown});
    begun.clear();
  }
  /// Share of the first level's triangles that what is added next may have.
  double share() const { return std::pow(kCoarser, level); }
  const std::string& name() const { return exported.groups.back().name; }
  Vec3 foot() const { return exported.groups.back().foot; }

  /// Whether this level is one set of pictures of the whole plant: the last of three or more, of what has
  /// leaves and where there are pictures. Notes it.
  bool whole_is_crossed();

  /// Adds a mesh without a placement; nothing where its parts are empty. At a coarser level it is added to
  /// the mesh of that name, its wood and bodies in no more triangles than their share, and nothing is to be
  /// placed. Leaves that take far more than their share, or would be drawn as much larger ones without
  /// pictures, become pictures of boughs.
  std::optional<std::size_t> mesh(const std::string& part, std::vector<ExportPart> parts);
  void place(std::size_t mesh, Vec3 at, Quat turn, Vec3 scale) {
    exported.placements.push_back({mesh, at, turn, scale, exported.groups.size() - 1});
  }
  /// Adds a mesh whose corners are where they stand in the world.
  void add_in_place(const std::string& part, std::vector<ExportPart> parts);

  /// The bodies of an organism; `keys`: see body_parts().
  void add_bodies(const Look& look, std::span<const DrawnBody> bodies, std::span<const Solids> keys);
};

ExportTint tint_of(Vec3 light);
/// The factor on a coral's skin of a linear colour for what is left of its light; see starved_color().
Vec3 starved(float light, Vec3 color);

/// How many triangles parts have.
double triangles_of(const std::vector<ExportPart>& parts);

/// Foliage by the names of its prototypes, one part a material.
std::map<std::string, std::vector<ExportPart>> by_name(Maker& maker, const Look& look, const Model& model,
                                                       std::vector<LeafPart> parts);

}  // namespace frond
