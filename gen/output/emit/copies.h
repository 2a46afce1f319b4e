#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "draw/levels.h"
#include "emit/pov.h"

// What is sown: models, each in files of its own, and their copies.

namespace frond {

inline constexpr double kModelUnit = 10;  ///< units a metre in which models are written

/// `Model_0123456789abcdef_2_7`, of the model, the level and the block: what the names of a file's parts
/// begin with.
std::string declared_name(const ModelFile& file);

/// That of a part: the file's with its number.
std::string part_name(std::string_view file, std::size_t part);

/// Declares what a file holds of a model's parts, `all` of its level, under a name, and a macro of each one's
/// look. Gives which.
std::vector<int> append_parts(std::string& text, std::string_view name, const Look& look, const Model& model,
                              const std::vector<CopyPart>& all, const ModelFile& file);

/// Declares the macros of the looks of those parts alone, under another name.
void append_looks(std::string& text, std::string_view name, const Look& look, const Model& model,
                  const std::vector<CopyPart>& all, const ModelFile& file);

/// What a model's file says.
struct ModelText {
  std::vector<int> parts;                  ///< that it declares
  std::vector<std::string_view> includes;  ///< names of the povinc files that it needs, as `copy`
  std::string title, body;                 ///< a comment of one line; the declarations

  std::string file_text() const;
};

/// The texts of files of one level of a model; `blocks` are its own.
std::vector<ModelText> model_texts(const std::vector<ModelFile>& files, const CopySet& set,
                                   const Model& model, const ModelBlocks& blocks);

/// The `#include` lines of the models that a stretch of the film shows; with a time, of those whose copies
/// come and go, and without one of the others.
std::string model_includes_text(const Scene& scene, const CopyPlan& plan, std::size_t stretch,
                                std::optional<double> time = {});
/// The looks of copies in a stretch that change over the film, as they are at a time: a tint for each of a
/// copy set, and a macro for each part of a model.
std::string worn_copies_text(const Scene& scene, const CopyPlan& plan, std::size_t stretch, double time);
/// For a stretch of the film: the tints of all copies and those copies that stand still.
ObjectText still_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan,
                             std::size_t stretch);
/// The copies that sway in the wind, in a frame at its time.
ObjectText swaying_copies_text(const PovSpace& space, const Scene& scene, const CopyPlan& plan, int frame,
                               double time);

}  // namespace frond
