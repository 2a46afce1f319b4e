#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "draw/surfels.h"

namespace frond {

/// What later runs have to know of a sown model so that they need not grow it again.
struct ModelSummary {
  std::vector<Surfel> surfels;
  /// Which parts its file of a level and block declares; none where there is no such file.
  std::map<std::pair<int, int>, std::vector<int>> parts;

  /// Of each surfel.
  std::vector<int> halvings() const;
};

/// The text of a file and what it says; nothing where that is no such text or not all of it. Its words are
/// parted by blanks or line ends:
///
///     surfels N    N times x y z area wide red green blue bulk
///     finer N    N times which surfel, its halvings, M and M times a surfel and its facing
///     files N     N times level block M and M numbers of parts
///     end
///
/// Numbers have the decimals that surfels have, so that what is read is what was written.
std::string summary_text(const ModelSummary& summary);
std::optional<ModelSummary> read_summary(std::string_view text);

}  // namespace frond
