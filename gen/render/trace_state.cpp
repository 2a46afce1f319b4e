#include "render/trace_state.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <fstream>
#include <string>
#include <string_view>

#include "core/files.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t kHead = 512;   // bytes in front of the messages
constexpr std::uintmax_t kAround = 20;  // bytes of a message that its length does not count
constexpr std::string_view kFile = "POV-Ray Render State File", kMessage = "POVRAYMS";
constexpr std::string_view kCoarse = "PxSe";  // of a message that holds coarse pixels
// Of one that holds the first block: the whole number PiId, 4 bytes long, is 0.
constexpr std::string_view kFirstBlock("PiIdINT4\0\0\0\4\0\0\0\0PiSi", 20);

}  // namespace

Errors keep_traced(const fs::path& state) {
  std::error_code error;
  std::uintmax_t size = fs::file_size(state, error), at = kHead;
  std::ifstream in(state, std::ios::binary);
  std::array<char, kFile.size()> name{};
  if (error || !in.read(name.data(), name.size())) return {};
  if (std::string_view(name.data(), name.size()) != kFile) return {};
  bool coarse = false, first = false;
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
    coarse = coarse || message.substr(0, 128).find(kCoarse) != message.npos;
    first = first || message.find(kFirstBlock) != message.npos;
    at += length;
  }
  if (at == kHead || (coarse && !first)) at = 0;
  if (at < size) fs::resize_file(state, at, error);
  if (error) return {{state.string(), reason_of(error)}};
  return {};
}

}  // namespace frond
