#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include "bake/bake.h"
#include "core/result.h"

// The studio
// ==========
// A page in the browser in which a preset is shaped with sliders before a live view. This module serves it:
// docs/studio.md tells what it asks and what it gets. The page holds the text of the preset; each question
// brings it along, so that the server knows nothing but what it may forget: scenes, models, pictures.
//
// It listens on the loopback address alone. Host and Origin are checked, every question carries a token that
// only the printed address holds, and no file is read or written but in the preset's folder, that of
// --assets, and Frond's own presets (read only).

namespace frond {

/// Where nothing else is asked for, so that a browser finds again what it kept of a page from there.
inline constexpr int kUsualPort = 8417;

struct StudioOptions {
  std::filesystem::path home;                   ///< the folder of templates/, povinc/, presets/ and scripts/
  std::optional<std::filesystem::path> preset;  ///< to open; none: the page begins with the gallery
  int port = 0;                                 ///< 0: kUsualPort, or where that is taken any that is free
  std::size_t memory = std::size_t{1} << 30;    ///< bytes that what is kept may come to, all of it together
  std::optional<std::filesystem::path> assets;  ///< one more folder to read from
  BakeOptions bake = {};                        ///< how pictures of materials are drawn
  std::function<void(const std::string& address)> ready;  ///< called when the page can be opened
};

/// Serves the page until the process is asked to end (SIGINT, SIGTERM). An error where it cannot begin.
Errors serve_studio(const StudioOptions& options);

}  // namespace frond
