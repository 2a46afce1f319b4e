#pragma once

#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include "core/result.h"

/// Pictures for pages, by ffmpeg: the same pictures give the same bytes.
namespace frond {

struct JpegJob {
  std::vector<std::filesystem::path> pictures;  ///< several make a sheet, on white, row by row
  std::array<int, 2> size{};                    ///< of each, where there are several
  int columns = 1;
  std::string ffmpeg = "ffmpeg";  ///< the program
};

/// Makes a JPEG; it is seen whole or not at all, and left alone where it is the same already. `scratch` is a
/// file to write meanwhile.
Errors write_jpeg(const JpegJob& job, const std::filesystem::path& scratch,
                  const std::filesystem::path& file);

/// Where ffmpeg lays the pictures of a sheet, from left to right and then down, with a gap between them.
std::string sheet_layout(std::size_t pictures, int columns, std::array<int, 2> size);

}  // namespace frond
