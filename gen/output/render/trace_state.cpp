#include "render/trace_state.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <fstream>
#include <functional>
#include <string>
#include <string_view>

#include "core/files.h"
#include "images/whole.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kHead = 512;   // bytes in front of the messages
constexpr std::uintmax_t kAround = 20;  // bytes of a message that its length does not count
constexpr std::string_view kFile = "POV-Ray Render State File", kMessage = "POVRAYMS";
constexpr std::string_view kCoarse = "PxSe";  // of a message that holds coarse pixels
// Part of a message that holds the first block: the whole number PiId, 4 bytes long, is 0.
constexpr std::string_view kFirstBlock("PiIdINT4\0\0\0\4\0\0\0\0PiSi", 20);

bool is_notes(std::ifstream& in) {
  std::array<char, kFile.size()> name{};
  return in.read(name.data(), name.size()) && std::string_view(name.data(), name.size()) == kFile;
}

/// Hands each whole message to `visit`, without its head. Returns where they end.
std::uintmax_t each_message(std::ifstream& in, std::uintmax_t size,
                            const std::function<void(std::string_view)>& visit) {
  std::uintmax_t at = kHead;
  std::string message;
  while (at + 16 <= size) {
    std::array<unsigned char, 16> head{};
    in.seekg(static_cast<std::streamoff>(at));
    if (!in.read(reinterpret_cast<char*>(head.data()), head.size())) break;
    if (!std::equal(kMessage.begin(), kMessage.end(), head.begin())) break;
    std::uintmax_t length = 0;  // bytes 12 to 15
    for (std::size_t i = 12; i < 16; ++i) length = length << 8 | head[i];
    length += kAround;
    if (at + length > size) break;
    message.resize(length - head.size());
    if (!in.read(message.data(), static_cast<std::streamsize>(message.size()))) break;
    visit(message);
    at += length;
  }
  return at;
}

/// The value of an attribute of a message: its name and type are four letters each, then its length.
std::string_view attribute(std::string_view message, std::string_view name_and_type, std::size_t unit) {
  std::size_t at = message.find(name_and_type);
  if (at == message.npos || at + 12 > message.size()) return {};
  std::size_t length = unit * big_endian_at(message, at + 8);
  return at + 12 + length > message.size() ? std::string_view() : message.substr(at + 12, length);
}

/// Draws a block of pixels; false where it is none, or lies elsewhere.
bool draw_block(std::string_view message, const Tone& tone, Raster& picture) {
  constexpr std::size_t kChannels = 5;  // the last two are transparency
  std::string_view pixels = attribute(message, "PBloVFL4", 4);
  if (pixels.empty()) return false;
  // What follows them is asked for behind them: they may hold any bytes.
  std::string_view rest = message.substr(static_cast<std::size_t>(pixels.end() - message.begin()));
  std::array<int, 4> box{};
  for (std::size_t side = 0; std::string_view name : {"LeftINT4", "Top INT4", "RighINT4", "BottINT4"}) {
    std::string_view value = attribute(rest, name, 1);
    if (value.size() != 4) return false;
    box[side++] = static_cast<int>(big_endian_at(value, 0));
  }
  auto [left, top, right, bottom] = box;
  if (left < 0 || top < 0 || right < left || bottom < top || right >= picture.width ||
      bottom >= picture.height)
    return false;
  if (pixels.size() !=
      4 * kChannels * static_cast<std::size_t>(right - left + 1) * static_cast<std::size_t>(bottom - top + 1))
    return false;
  std::size_t at = 0;
  for (int y = top; y <= bottom; ++y)
    for (int x = left; x <= right; ++x, at += 4 * kChannels) {
      std::array<double, 3> light{};
      for (std::size_t c = 0; c < 3; ++c)
        light[c] = std::clamp<double>(std::bit_cast<float>(big_endian_at(pixels, at + 4 * c)), 0, 1);
      light = seen(light, tone, {x, y}, {picture.width, picture.height});
      for (int c = 0; c < 3; ++c)
        picture.data[picture.index(x, y, c)] = to_byte(light[static_cast<std::size_t>(c)]);
    }
  return true;
}

/// A colour picture at a size, each pixel the nearest of it; grey without one.
Raster enlarged(const Raster* picture, std::array<int, 2> size) {
  constexpr std::uint8_t kBlank = 64;
  Raster large(size[0], size[1], 3);
  if (!picture || picture->channels != 3) {
    std::ranges::fill(large.data, kBlank);
    return large;
  }
  for (int y = 0; y < size[1]; ++y)
    for (int x = 0; x < size[0]; ++x)
      std::copy_n(&picture->data[picture->index(x * picture->width / size[0], y * picture->height / size[1])],
                  3, &large.data[large.index(x, y)]);
  return large;
}

}  // namespace

Errors keep_traced(const fs::path& state) {
  std::error_code error;
  std::uintmax_t size = fs::file_size(state, error);
  std::ifstream in(state, std::ios::binary);
  if (error || !is_notes(in)) return {};
  bool coarse = false, first = false;
  std::uintmax_t end = each_message(in, size, [&](std::string_view message) {
    coarse = coarse || message.substr(0, 128).find(kCoarse) != message.npos;
    first = first || message.find(kFirstBlock) != message.npos;
  });
  if (end == kHead || (coarse && !first)) end = 0;
  if (end < size) fs::resize_file(state, end, error);
  if (error) return {{state.string(), reason_of(error)}};
  return {};
}

std::optional<Raster> traced_picture(const fs::path& state, std::array<int, 2> size, const Tone& tone,
                                     const Raster* below) {
  std::error_code error;
  std::uintmax_t bytes = fs::file_size(state, error);
  std::ifstream in(state, std::ios::binary);
  if (error || !is_notes(in)) return std::nullopt;
  Raster picture = enlarged(below, size);
  bool any = false;
  each_message(in, bytes, [&](std::string_view message) { any = draw_block(message, tone, picture) || any; });
  if (!any) return std::nullopt;
  return picture;
}

}  // namespace frond
