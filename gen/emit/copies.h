#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "emit/levels.h"
#include "emit/pov.h"

namespace frond {

inline constexpr double kModelUnit = 10;  ///< units a metre in which models are written

/// `Model_0123456789abcdef_2_7`, of the model, the level and the block: what the names of a file's parts
/// begin with.
std::string declared_name(const ModelFile& file);

/// The texts of files of one level of a model; `blocks` are its own.
std::vector<std::string> model_texts(const std::vector<ModelFile>& files, const SownStand& stand,
                                     const Model& model, const ModelBlocks& blocks);

/// Which parts the file declares, by its first line; none where it is not ours.
std::optional<std::vector<int>> model_parts(std::string_view text);

/// For a stretch of the film: the includes of the models and the tints of the stands, and all copies of
/// stands that stand still.
std::string still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                              std::size_t stretch);
/// The copies of stands that sway in the wind, in a frame at its time.
std::string swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, int frame,
                                double time);

}  // namespace frond
