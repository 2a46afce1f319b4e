#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "appearance/appearance.h"
#include "bake/bake.h"
#include "export/export_scene.h"

namespace frond {

/// Where on the picture of a vessel places on it lie, v being 0 at the foot .. 1 at the lip .. 2 at the
/// bottom inside.
std::vector<Vec2> on_vessel(std::vector<Vec2> uv);

/// Whether the picture of a body is unrolled from it: one that is turned and says where on it places lie.
bool is_vessel(const Solid& solid);

/// What that picture is drawn from, for places on_vessel(). It is wider than those of other bodies, which are
/// so many pixels wide.
Swatch vessel_swatch(const Solid& vessel, const Material& material, int pixels);

/// The skin or the bark of branches in one of its colours; which must be patterned() and
/// have no coat.
Swatch skin_swatch(const BranchLook& look, std::size_t color, int pixels);
/// The roughness of what is smooth on it.
double skin_roughness(const BranchLook& look);

/// The pictures of a coat, so many pixels wide.
Result<BakedPictures> coat_pictures(const BarkCoat& coat, int wide);

/// Gives names that no two things share.
class Names {
 public:
  std::string unique(const std::string& name);

 private:
  std::map<std::string, int> times_;
};

/// Makes the materials of an exported scene, each once. Their pictures are noted and drawn at the end, side
/// by side: by POV-Ray from the macros of povinc/, but for those that the film itself shows as pictures.
class Palette {
 public:
  Palette(ExportScene& exported, const ExportOptions& options) : scene_(exported), options_(options) {}

  /// A material, and how many metres its picture is wide and high where it lies.
  struct Use {
    std::size_t material = 0;
    double wide = 1, high = 1;
    Vec3 young{1};  ///< how much more light a growing tip gives back, as a factor; see tint_at()

    /// The tint of skin that is so young, 0..1; the material is as light as the lightest.
    Vec3 tint_at(float age) const { return glm::mix(Vec3(1), young, age) / glm::max(young, Vec3(1)); }
  };

  /// The material of branches of one of the bark's colours; `name` is what the material is called. Where
  /// `ages`, tips differ.
  Use branches(const Look& look, double brightness, std::size_t color, const std::string& name,
               bool ages = false);
  /// The material of cubes with a side in metres.
  Use cubes(const BranchLook& look, double brightness, std::size_t color, double side,
            const std::string& name);
  /// Metres that the picture of branches of a colour is wide and high; of coats, 1 and 1.
  static std::pair<double, double> picture_size(const BranchLook& look, std::size_t color = 0);
  /// How a part of an organ lies on its picture: not at all, as a mesh of its own, or as a card that is cut
  /// out of it.
  enum class Lies { nowhere, mesh, card };
  /// The number of the material of a part of an organ, or of a blade, in one of its colours.
  std::size_t organ(const Look& look, const Prototype& organ, std::size_t part, std::size_t color, Lies lies,
                    const std::string& name);
  std::size_t blade(const BladeLook& look, std::size_t color, const std::string& name);
  /// The material of a body, on its own `uv` where it is a `vessel` or wears a picture of the look's.
  Use body(const Look& look, const Material& material, const Solid* vessel, const std::string& name);

  /// The number of a material that shows given pictures.
  std::size_t shown(ExportMaterial made, const std::string& name, BakedPictures pictures);

  /// Makes the pictures of all materials.
  Errors make_pictures();

 private:
  /// Makes the files of a material's pictures.
  using PictureMaker = std::function<Result<BakedPictures>()>;
  struct PendingPictures {
    std::string name;  // of the first material that shows it
    PictureMaker make;
    std::vector<std::size_t> materials;
  };
  /// The material of that key; a new one is `made`, and shows what `make` gives, once for each `picture`.
  Use keep(const std::string& key, ExportMaterial made, const std::string& name, const std::string& picture,
           const PictureMaker& make, double wide = 1, double high = 1);
  Use keep_swatch(Swatch swatch, ExportMaterial made, const std::string& name, double rough);
  /// Adds a picture of a material; no picture where there are no bytes.
  std::size_t add_picture(std::string name, std::string bytes);

  ExportScene& scene_;
  const ExportOptions& options_;
  std::map<std::string, Use> used_;
  std::map<std::string, std::size_t> drawn_by_;  // key of a picture -> index in pending_
  std::vector<PendingPictures> pending_;
  Names names_;
};

}  // namespace frond
