#include "images/picture_turn.h"

#include <cstdint>

#include "geometry/byte_reader.h"

namespace frond {

namespace {

/// A number of a TIFF header and what follows it, in the order of bytes that it says; 0 beyond its end.
template <class T>
T number_at(std::string_view tiff, std::size_t at) {
  ByteReader reader(tiff, !tiff.starts_with("II"));
  return reader.skip(at) ? reader.read<T>().value_or(0) : T{0};
}

constexpr std::uint32_t kOrientation = 0x0112;
constexpr std::string_view kExif("Exif\0\0", 6);  // before the TIFF header, in WebP at will

/// The orientation that EXIF data hold, 1..8; 1 where they hold none, or another number.
int orientation_of(std::string_view tiff) {
  constexpr std::size_t kEntry = 12;  // bytes
  std::size_t first = number_at<std::uint32_t>(tiff, 4), count = number_at<std::uint16_t>(tiff, first);
  for (std::size_t i = 0; i < count && first + 2 + kEntry * (i + 1) <= tiff.size(); ++i)
    if (std::size_t entry = first + 2 + kEntry * i; number_at<std::uint16_t>(tiff, entry) == kOrientation) {
      int turn = number_at<std::uint16_t>(tiff, entry + 8);
      return turn >= 1 && turn <= 8 ? turn : 1;
    }
  return 1;
}

}  // namespace

int jpeg_turn(std::string_view bytes) {
  // Segments of a marker and a length, up to where the picture begins.
  for (std::size_t at = 2; at + 4 <= bytes.size() && bytes[at] == '\xff';) {
    auto byte = [&](std::size_t i) { return static_cast<std::size_t>(static_cast<unsigned char>(bytes[i])); };
    std::size_t marker = byte(at + 1), length = byte(at + 2) << 8 | byte(at + 3);
    if (marker == 0xda || length < 2) break;
    std::string_view data = bytes.substr(at + 4, length - 2);
    if (marker == 0xe1 && data.starts_with(kExif)) return orientation_of(data.substr(kExif.size()));
    at += 2 + length;
  }
  return 1;
}

int webp_turn(std::string_view bytes) {
  constexpr std::size_t kHead = 8;  // bytes: the name of a chunk and its length
  for (std::size_t at = 12; at + kHead <= bytes.size();) {
    std::size_t length = ByteReader(bytes.substr(at + 4)).read<std::uint32_t>().value_or(0);
    if (bytes.substr(at, 4) == "EXIF") {
      std::string_view data = bytes.substr(at + kHead, length);
      return orientation_of(data.starts_with(kExif) ? data.substr(kExif.size()) : data);
    }
    at += kHead + length + length % 2;
  }
  return 1;
}

Raster turned(const Raster& from, int turn) {
  if (turn <= 1) return from;
  bool lies = turn > 4;  // columns are rows
  Raster to(lies ? from.height : from.width, lies ? from.width : from.height, from.channels);
  bool right = turn == 2 || turn == 3 || turn == 7 || turn == 8;  // x runs from the right
  bool below = turn == 3 || turn == 4 || turn == 6 || turn == 7;  // y runs from below
  for (int y = 0; y < to.height; ++y)
    for (int x = 0; x < to.width; ++x) {
      int i = lies ? y : x, k = lies ? x : y;
      if (right) i = from.width - 1 - i;
      if (below) k = from.height - 1 - k;
      for (int c = 0; c < from.channels; ++c) to.data[to.index(x, y, c)] = from.at(i, k, c);
    }
  return to;
}

}  // namespace frond
