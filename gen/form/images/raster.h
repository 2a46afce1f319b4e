#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

namespace frond {

/// A picture of 8 bits per channel, rows from the top down; sRGB if it is a colour picture.
struct Raster {
  int width = 0, height = 0;
  int channels = 3;  ///< 1 grey, 3 colour, 4 colour and opacity
  std::vector<std::uint8_t> data;

  Raster() = default;
  Raster(int wide, int high, int of) : width(wide), height(high), channels(of) {
    data.resize(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high) *
                static_cast<std::size_t>(of));
  }
  std::size_t index(int x, int y, int c = 0) const {
    auto whole = [](int number) { return static_cast<std::size_t>(number); };
    return (whole(y) * whole(width) + whole(x)) * whole(channels) + whole(c);
  }
  std::uint8_t at(int x, int y, int c = 0) const { return data[index(x, y, c)]; }
};

/// A colour picture of 16 bits per channel; brightness is linear.
struct LinearRaster {
  int width = 0, height = 0;
  int channels = 3;  ///< 4: with opacity, by which the colours are multiplied
  std::vector<std::uint16_t> data;
};

/// A value per pixel; rows from the top down.
template <class T>
struct PixelGrid {
  int width = 0, height = 0;
  std::vector<T> data;

  PixelGrid() = default;
  PixelGrid(int wide, int high) : width(wide), height(high) {
    data.resize(static_cast<std::size_t>(wide) * static_cast<std::size_t>(high));
  }
  T& at(int x, int y) { return data[index(x, y)]; }
  T at(int x, int y) const { return data[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  /// Wraps round at the edges.
  T wrapped(int x, int y) const { return at((x % width + width) % width, (y % height + height) % height); }
};

/// The grid with its rows as columns.
template <class T>
PixelGrid<T> transposed(const PixelGrid<T>& grid) {
  PixelGrid<T> turned(grid.height, grid.width);
  for (int y = 0; y < grid.height; ++y)
    for (int x = 0; x < grid.width; ++x) turned.at(y, x) = grid.at(x, y);
  return turned;
}

/// Numbers mostly from 0 to 1.
using Grid = PixelGrid<float>;

/// A number as a byte: 0 to 1 becomes 0 to 255, clamped.
std::uint8_t to_byte(double value);

/// The bytes of a PNG file. Equal pictures give equal bytes.
Result<std::string> png_text(const Raster& raster);

/// Width and height of a PNG file, as its head says.
Result<std::array<int, 2>> png_size(std::string_view bytes);

/// Reads a PNG file of any kind as grey, colour or colour with opacity; at most 16384 pixels
/// a side and 100 million in all, as it is held whole.
Result<Raster> read_png(std::string_view bytes);
/// Reads a PNG file of any kind as linear light; at most 32768 pixels a side and 16384 times 16384 in all.
/// `opacity`: with the opacity of the file, where it has one; else its colours are laid over black.
Result<LinearRaster> read_linear_png(std::string_view bytes, bool opacity = false);

}  // namespace frond
