#pragma once

#include "scene/scene.h"
#include "studio/scenes.h"

namespace frond {

/// How a scene is exported: `{"type", "time", "detail", "levels", "wind"}`.
struct ExportOrder {
  std::string type = ".glb";  ///< an extension of the formats
  double time = 0;            ///< seconds
  double detail = 2.5e5;      ///< triangles of one organism, about
  int levels = 1;             ///< of detail, 1..6; of a .glb that does not move
  bool wind = false;          ///< of a .glb: how it sways and grows over the film, as an animation
};

/// The order that the page asks for; what is out of range is brought into it.
ExportOrder export_order(const Json& question);

/// About how large what is written will be, before anything is: `{"triangles": […, one a level], "vertices",
/// "bytes", "sown"}`; `sown`: plants that are sown, whose triangles are not in it.
Json export_size(const Scene& scene, const ExportOrder& order);
/// The answer with the size of the export of a preset, which is grown where that has not been done yet.
Answer export_size(const Documents& documents, Scenes& scenes, const Doc& doc, const ExportOrder& order);

/// Exports a preset by `frond export`. The file and what it names come to lie in `out/exports` below the
/// folder of presets, or below the temporary folder where nothing can be written there; its path. An error
/// says what `frond export` says.
Result<std::filesystem::path> export_doc(const Documents& documents, const std::filesystem::path& home,
                                         const Doc& doc, const ExportOrder& order);

}  // namespace frond
