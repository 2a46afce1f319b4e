#pragma once

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

#include "draw/surfels.h"
#include "light/light.h"
#include "scene/copies.h"

// Which copy of a model is drawn how fine.

namespace frond {

/// A file that declares one model of a copy set, or a block of it, at one level of detail: its parts as
/// mesh2, or as unions of those of its blocks, and a macro that gives each its texture for a tint. Its name
/// says what is in it, so that one that is there is right.
struct ModelFile {
  std::size_t copy_set = 0;
  int model = 0, level = 0;
  int block = kWhole;
  int blocks = 0;    ///< whose files, of the same level, it is put together from; 0: its meshes are its own
  std::string name;  ///< without its folder
  std::vector<int> parts;  ///< that it declares, once that is known

  static constexpr int kWhole = -1;
};
/// What such a file is called.
std::string model_file_name(const Organism& organism, int model, int level, int block = ModelFile::kWhole,
                            bool bare = false);

/// A copy, or a block of it, and its level.
struct Drawn {
  std::uint32_t copy = 0;
  std::int16_t block = ModelFile::kWhole;
  std::int16_t level = 0;
};

/// What frames have to know of a model, at one level, whose copies change their look over a film.
struct WornModel {
  Condition condition;
  Model model;  ///< its prototypes, with the colours of failing health, and its materials, without meshes
  std::vector<CopyPart> parts;
};

/// What is drawn of copies in each stretch of a film, some frames long. Each copy keeps its levels over
/// several stretches, and from one stretch to the next few copies change theirs, by about the size of a
/// pixel, so that nothing pops.
struct CopyPlan {
  int stretch = 1;                                     ///< frames
  std::vector<std::vector<std::vector<Drawn>>> drawn;  ///< of each stretch, of each copy set
  std::vector<ModelFile> files;        ///< that are needed: by copy set, model, level and block
  std::vector<std::string> summaries;  ///< names of the files that tell the same of models
  Surfels surfels;                     ///< of all models that stand
  /// Models that the film sees grow or change their leaves, by copy set and number: what is there of them is
  /// written in each frame. Of those that change their leaves it holds nothing else.
  std::map<std::pair<std::size_t, int>, std::shared_ptr<const Model>> growing;

  /// Models whose look the film sees change, by copy set, number and level.
  std::map<std::tuple<std::size_t, int, int>, std::shared_ptr<const WornModel>> worn;

  std::size_t stretch_of(int frame) const {
    return std::min(static_cast<std::size_t>((frame - 1) / stretch), drawn.size() - 1);
  }
  const ModelFile& file(std::size_t copy_set, int model, const Drawn& one) const;
};

/// What is drawn of the copies of one model in each stretch, and the files that are needed for that.
struct ModelPlan {
  std::vector<std::vector<Drawn>> drawn;  ///< of each stretch
  std::vector<ModelFile> files;
};

/// How many times as coarse as a pixel copies may be drawn.
inline double coarseness(Quality quality) { return quality == Quality::draft ? 1.5 : 1; }

ModelBlocks blocks_of(const std::vector<Surfel>& surfels);

/// What the cameras of a film see.
class Views {
 public:
  explicit Views(const Scene& scene);

  /// By how near each block of each copy comes to the camera, and whether it, or its shadow in the sun, is in
  /// view.
  ModelPlan plan(std::size_t copy_set, int model, const std::vector<Surfel>& surfels) const;
  /// A plan for no model yet. Models are added in their order.
  CopyPlan empty_plan() const;
  static void add(CopyPlan& plan, std::size_t copy_set, const ModelPlan& model);

 private:
  std::vector<Drawn> drawn(std::size_t last, const CopySet& set, int model, const ModelBlocks& blocks) const;
  std::vector<int> levels_of(const std::vector<Eye>& eyes, const ModelBlocks& blocks, Vec3 foot, Quat turn,
                             float scale) const;
  bool shades(const std::vector<Eye>& eyes, Vec3 from, float radius) const;

  const Scene& scene_;
  std::vector<std::vector<Eye>> eyes_;  // of the frames that levels hold for, by the last stretch of these
  std::vector<std::pair<double, double>> times_;  // of these frames, from and to, seconds
  std::vector<Vec3> suns_;                        // directions that light comes from in the film
  int stretch_ = 1;
  std::size_t stretches_ = 1, groups_ = 1;
  double coarse_ = 1;
};

}  // namespace frond
