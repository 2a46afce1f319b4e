#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"
#include "emit/frame.h"
#include "export/macros.h"

// A scene as an include file for somebody else's POV-Ray scene: it stands alone, its macros, shapes and
// materials in one text, with nothing beside it but the pictures that its textures name.

namespace frond {

/// How finely an include's shapes are drawn: 0 as in our pictures, the others as one mesh a material.
inline constexpr int kIncludeDetails = 3;

/// One scene, grown and ready to be written.
struct IncludeVariant {
  Scene scene;                      ///< of no setting but the studio, of which nothing is written
  std::vector<CopyPlan> plans;      ///< of what is sown: one a detail, with the same files
  std::vector<std::string> models;  ///< what those files declare, without their includes
};

/// What an include is called and made of.
struct IncludeText {
  std::string name;           ///< `Frond_Oak`
  std::string file;           ///< its own, `oak.inc`
  std::string title, source;  ///< for the comment above
  MacroFiles macros;          ///< those of povinc
  std::vector<int> frames;    ///< of the film, one or more; what stands still is as in the last
};

/// `my-oak.inc` as a name of POV-Ray's: Frond_My_Oak.
std::string include_name(std::string_view file);

/// Readies a scene: takes its surroundings away, and plans the copies of what is sown, all of them, by how
/// large they are and not by how near to a camera. The files of the plans are still to be grown.
IncludeVariant include_variant(Scene scene);

/// The whole text, a pure function of its arguments. An error where a variant has nothing to show.
Result<std::string> include_text(const IncludeText& text, const std::vector<IncludeVariant>& variants);

}  // namespace frond
