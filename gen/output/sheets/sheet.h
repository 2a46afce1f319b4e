#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/result.h"

/// Stills of one preset over values of it, labelled and side by side.
namespace frond {

/// A value of a preset, and what it takes from picture to picture.
struct Sweep {
  std::string pointer;
  std::vector<std::string> values;
};

/// So many values, evenly from one to the other.
Sweep sweep_of(std::string pointer, double from, double to, int count);

/// Reads POINTER=FROM:TO:COUNT, of at most 99; none where the text is not that.
std::optional<Sweep> read_sweep(const std::string& text);

/// A picture of a sheet.
struct SheetCell {
  std::vector<std::string> sets;  ///< POINTER=VALUE
  std::string text;               ///< what stands below it
  std::filesystem::path folder;   ///< of its film
};

/// The pictures of one sweep or two, row by row; of two, the values of the first go from left to right. Their
/// folders, in that of `pictures`, are named by what is set, so that another sheet finds them.
std::vector<SheetCell> cells_of(const std::vector<Sweep>& sweeps, const std::filesystem::path& pictures);

/// How many stand side by side: of one sweep about as many as one below the other.
int columns_of(const std::vector<Sweep>& sweeps);

/// Labels a frame of the films, which is rendered in all of them, and puts the pictures side by side.
Errors make_sheet(const std::vector<SheetCell>& cells, int frame, int columns,
                  const std::filesystem::path& sheet);

}  // namespace frond
