#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "draw/levels.h"
#include "emit/pov.h"

namespace frond {

inline constexpr double kModelUnit = 10;  ///< units a metre in which models are written

/// `Model_0123456789abcdef_2_7`, of the model, the level and the block: what the names of a file's parts
/// begin with.
std::string declared_name(const ModelFile& file);

void append_part_name(std::string& text, std::string_view model, std::size_t part);

/// Declares what a file holds of a model's parts, `all` of its level, under a name, and a macro of each one's
/// look. Gives which.
std::vector<int> append_parts(std::string& text, std::string_view name, const Look& look, const Model& model,
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

}  // namespace frond
