#pragma once

#include <map>
#include <string>

#include "export/export_scene.h"
#include "export/tile.h"

namespace frond {

/// Gives names that no two things share.
class Names {
 public:
  std::string unique(const std::string& name);

 private:
  std::map<std::string, int> times_;
};

/// Makes the materials of a cast with their pictures, each once.
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

  /// Of branches of one of the bark's colours; `name` is what the material is called. Where `ages`, tips
  /// differ.
  Use branches(const Look& look, double brightness, std::size_t color, const std::string& name,
               bool ages = false);
  Use cubes(const Look& look, double brightness, std::size_t color, const std::string& name);
  /// Metres that the picture of branches is wide and high; of coats, 1 and 1.
  static std::pair<double, double> picture_size(const Look& look);
  /// How a part of an organ lies on its picture: not at all, as a mesh of its own, or as a card that is cut
  /// out of it.
  enum class Lies { nowhere, mesh, card };
  /// Of a part of an organ in one of its colours.
  std::size_t organ(const Look& look, const Prototype& organ, std::size_t part, std::size_t color, Lies lies,
                    const std::string& name);
  std::size_t blade(const BladeLook& look, std::size_t color, const std::string& name);
  /// Of a body, on its own `uv` where that is a vessel's or it wears a picture of the look's.
  Use body(const Look& look, const Material& material, bool vessel, const std::string& name);

 private:
  /// The material of that key; a new one is `made` with pictures that `draw` makes.
  template <class Draw>
  Use keep(const std::string& key, ExportMaterial made, const std::string& name, const Draw& draw);
  void add_pictures(ExportMaterial& material, const std::string& key, const std::string& name,
                    const std::function<Pictures()>& draw);
  /// The picture of that name, of those that the look wears.
  void add_drawn(ExportMaterial& material, const Look& look, const std::string& picture);

  ExportScene& scene_;
  const ExportOptions& options_;
  std::map<std::string, Use> used_;
  std::map<std::string, std::array<std::size_t, 3>> drawn_;
  Names names_;
};

}  // namespace frond
