#pragma once

#include "studio/documents.h"

namespace frond {

/// Exports a preset as it is at a time, seconds, by `frond export`: `type` is an extension of its formats, as
/// ".glb". The file and what it names come to lie in `out/exports` below the folder of presets, or below the
/// temporary folder where nothing can be written there; its path. An error says what `frond export` says.
Result<std::filesystem::path> export_doc(const Documents& documents, const std::filesystem::path& home,
                                         const Doc& doc, double time, const std::string& type);

}  // namespace frond
