#pragma once

#include <string>
#include <vector>

#include "cpfg/cpfg.h"
#include "cpfg/curves.h"
#include "cpfg/preprocess.h"

namespace frond::cpfg {

/// Reads the files of a model: those in its folder and below it.
class ModelFolder {
 public:
  explicit ModelFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  Result<std::string> read(const std::string& name);
  const std::filesystem::path& path() const { return folder_; }

  /// What was read: the files, and all that they hold.
  const std::vector<std::filesystem::path>& files() const { return files_; }
  const std::string& content() const { return content_; }

 private:
  std::filesystem::path folder_;
  std::vector<std::filesystem::path> files_;
  std::string content_;
};

std::vector<std::string> words_in(std::string_view text);
/// The number that a word begins with, in any locale; 0 where it begins with none. The second one is whole.
double leading_number(std::string_view word);
int leading_whole(std::string_view word);

/// The files that belong to a grammar: those that the folder's `specifications` names, else those of the same
/// name, else the only one of its kind.
Result<CpfgFiles> files_of(const std::filesystem::path& grammar);

/// Lines `key: value` of a view or an animation. Lines without a colon go on the one before where a tab
/// begins them, else they are passed over.
Result<std::vector<CpfgViewLine>> read_view(ModelFolder& folder, const std::filesystem::path& file);

/// The functions and curves that a view names, numbered from 1 in its order.
struct ViewCurves {
  std::vector<FunctionTable> functions;
  std::vector<Predefined> names;  ///< of functions in sets, with their numbers
  std::vector<CurveTable> curves;
};
Result<ViewCurves> read_curves(ModelFolder& folder, const std::vector<CpfgViewLine>& view);

}  // namespace frond::cpfg
