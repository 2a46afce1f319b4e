#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emit/crumbs.h"
#include "emit/pov.h"
#include "scene/copies.h"

namespace frond {

/// A file that declares one model of a stand at one level of detail: its parts as mesh2, and a macro that
/// gives each its texture for a tint. Its name says what is in it, so that one that is there is right.
struct ModelFile {
  std::size_t stand = 0;
  int model = 0, level = 0;
  std::string name;  ///< without its folder
  int parts = 0;     ///< that it declares; see model_parts()
};

/// Which copies are drawn how: the same in all frames of a film, so that nothing pops.
struct CopyPlan {
  static constexpr std::uint8_t kUnseen = 255;
  std::vector<std::vector<std::uint8_t>> level;  ///< of each copy of each stand
  std::vector<ModelFile> files;                  ///< all that are needed: by stand, model and level
  std::vector<std::string> crumb_files;          ///< names of what they are read from
  Crumbs crumbs;                                 ///< of all models that stand, once they are written
};

/// By how near each copy comes to the camera in the film, and whether it is ever in view.
CopyPlan plan_copies(const Scene& scene);

/// The text of a model's file.
std::string model_text(const ModelFile& file, const SownStand& stand, const Model& model);

/// How many parts the file declares, by its first line; none where it is not ours.
std::optional<int> model_parts(std::string_view text);

/// The includes of the models and the tints of the stands, and all copies of stands that stand still.
std::string still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan);
/// The copies of stands that sway in the wind, at a time.
std::string swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, double time);

}  // namespace frond
