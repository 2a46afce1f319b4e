#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/result.h"
#include "scene/scene.h"

namespace frond {

/// The blocks of space that a model is cut into, so that its near parts can be fine and the others coarse. A
/// model no more than a few metres wide is one block.
class ModelBlocks {
 public:
  ModelBlocks() = default;
  /// The blocks of a model; `bits` are places all over it, in metres.
  explicit ModelBlocks(std::span<const Vec3> bits);

  int count() const { return static_cast<int>(cells_.size()); }
  Vec3 middle(int block) const {
    return low_ + (Vec3(cells_[static_cast<std::size_t>(block)]) + 0.5f) * side_;
  }
  float radius() const {
    return 0.87f * side_ + 0.3f;
  }                       ///< of a ball round each that holds all of it, metres
  int of(Vec3 at) const;  ///< the block that holds a place, or the nearest one
  /// Metres from a place to the box that holds all of a block; 0 within.
  float distance(int block, Vec3 at) const {
    return glm::length(glm::max(glm::abs(at - middle(block)) - (0.5f * side_ + 0.3f), Vec3(0)));
  }

 private:
  Vec3 low_{0};
  float side_ = 1;
  std::vector<glm::ivec3> cells_;  // in order
};

/// Tint `number`, of kTints: they are spread evenly over the range of a copy set, so that all of it occurs.
ColorShift tint_shift(const CopyTint& tint, int number);

/// A part of a model that has one look.
struct CopyPart {
  enum class Kind { wood, organ, blade, solid };
  Kind kind = Kind::wood;
  std::size_t which = 0;  ///< an organ's prototype, a solid's shape, which of the other barks; 0: its own
  std::size_t part = 0;   ///< of the prototype
  /// `uv` of leaves: (k + u, v), where k is a whole number of each leaf's own, k modulo the number of colours
  /// the index of its colour, and (u, v) its place on the leaf; of wood as of tube_surface(), but of a coral
  /// u is how young its skin is, 0..1.
  Surface surface;
  std::vector<int> block;  ///< of each triangle
};

/// What copies of a sown organism wear, with the barks that edits give to branches of them.
Appearance copy_appearance(const Organism& organism);

/// Grows model `which` of a sown organism, its foot at the origin. A tree with `crowd` grows up among six
/// neighbours. Its leaves are in the season that the film begins in, or in full leaf. What it is made of
/// depends on the organism and its `seeds` alone, not on the scene's seed.
Result<Model> grow_copy(const Organism& organism, int which, bool full_leaf = false);

/// The year of a sown organism whose leaves change over a film; nothing where they stay as they are.
std::optional<Seasons> copy_seasons(const Organism& organism, const Film& film);

/// The organs at a time of model `which`, which is in full leaf.
Organs copy_organs(const Organism& organism, int which, const Model& full, const Seasons& seasons,
                   double time);

/// How the copies of model `which` of a sown organism grow over a film, all of them together, see paced();
/// nothing where they stand as they are.
std::optional<Growth> copy_growth(const Organism& organism, const Film& film, int which);

/// What changes the look of model `which` of a sown organism over a film: nothing where it stays as it is.
std::optional<Condition> copy_condition(const Organism& organism, int which);

/// A model with what growth has reached of it at a time; nothing before it begins.
std::optional<Model> grown_by(const Model& model, const Motion& motion, double time);

/// What stands for model `which` of a sown organism in names: it differs where the model or its look does. In
/// `bare` files are no leaves.
std::string copy_id(const Organism& organism, int which, bool bare = false);

/// How a model is drawn.
struct CopyDetail {
  double grain = 0.002;  ///< metres that a pixel covers where it stands: what would be finer is left out
  double leaves = 4e5;   ///< triangles of leaves at most, about: more become fewer and larger ones
  bool plain = false;    ///< leaves are single triangles, too small to have any `uv` but of pictures
  bool solid = false;    ///< they are bodies, as fruit is, rather than leaves
  double cover = 1;      ///< share of the area of all leaves that those which are left have at least
};

inline constexpr int kLevelCount = 6;
/// How a model is drawn at each level, from the nearest on; each is used from where a pixel covers its grain.
inline constexpr CopyDetail kLevels[kLevelCount] = {{0.0005, 6e5},  {0.002, 6e5},      {0.008, 3e5},
                                                    {0.025, 1.4e5}, {0.08, 5e4, true}, {0.25, 1.5e4, true}};
/// The coarsest level with a grain no larger than asked for.
int level_for(double grain);

/// A model as meshes. What is left of its leaves has the area of all of them. With blocks it is known of
/// which each triangle is; an organ is not cut. With `now`, organs of the model at some time, these are
/// drawn: those which stand for others are the same at all times.
std::vector<CopyPart> copy_parts(const Look& look, const Model& model, const CopyDetail& detail,
                                 const ModelBlocks* blocks = nullptr, const Organs* now = nullptr);

/// What of a part is in a block.
Surface in_block(const CopyPart& part, int block);

}  // namespace frond
