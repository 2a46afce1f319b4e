#include "images/whole.h"

#include <zlib.h>

#include "geometry/byte_reader.h"

namespace frond {

std::uint32_t big_endian_at(std::string_view bytes, std::size_t at) {
  return ByteReader(bytes.substr(at), true).read<std::uint32_t>().value_or(0);
}

std::optional<std::array<int, 2>> whole_png(std::string_view bytes) {
  constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
  constexpr std::size_t kAround = 12;  // length, name and sum of a chunk
  if (!bytes.starts_with(kSignature)) return std::nullopt;
  bytes.remove_prefix(kSignature.size());
  std::optional<std::array<int, 2>> size;
  while (bytes.size() >= kAround) {
    std::size_t length = big_endian_at(bytes, 0);
    if (length > bytes.size() - kAround) return std::nullopt;
    std::string_view named = bytes.substr(4, 4 + length), name = named.substr(0, 4);
    auto sum = crc32(0, reinterpret_cast<const Bytef*>(named.data()), static_cast<uInt>(named.size()));
    if (sum != big_endian_at(bytes, 8 + length)) return std::nullopt;
    if (!size && (name != "IHDR" || length < 8)) return std::nullopt;
    if (!size) size = {static_cast<int>(big_endian_at(bytes, 8)), static_cast<int>(big_endian_at(bytes, 12))};
    bytes.remove_prefix(kAround + length);
    if (name == "IEND") return bytes.empty() ? size : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace frond
