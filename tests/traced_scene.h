#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <filesystem>
#include <string>
#include <vector>

#include "appearance/leaf_look.h"
#include "core/files.h"
#include "images/raster.h"
#include "render/process.h"

namespace frond {

/// A scene as POV-Ray draws it, its colours linear; `flags`: further ones; `files`: what it reads besides.
inline LinearRaster traced_scene(const std::string& scene, std::array<int, 2> size,
                                 const std::vector<std::string>& flags = {},
                                 const std::vector<Picture>& files = {}) {
  namespace fs = std::filesystem;
  static std::atomic<int> times = 0;
  fs::path folder = fs::temp_directory_path() / fmt::format("frond_test_{}_{}", getpid(), times++);
  EXPECT_TRUE(write_file(folder / "own.pov", scene));
  for (const Picture& file : files) EXPECT_TRUE(write_file(folder / file.name, file.bytes));
  OutputCapture said;
  Command command;
  command.folder = folder;
  command.out = command.err = said.descriptor();
  command.words = {"povray",
                   "+Iown.pov",
                   "+Oown.png",
                   "+FN16",
                   "File_Gamma=1.0",
                   "-D",
                   "-A",
                   fmt::format("+W{}", size[0]),
                   fmt::format("+H{}", size[1]),
                   "+L" + fs::absolute(FROND_ROOT "/povinc").string()};
  command.words.insert(command.words.end(), flags.begin(), flags.end());
  Result<int> status = run(command);
  EXPECT_TRUE(status && *status == 0) << said.text();
  Result<LinearRaster> raster = read_linear_png(*read_file(folder / "own.png"));
  fs::remove_all(folder);
  return *raster;
}

}  // namespace frond
