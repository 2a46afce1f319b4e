#include "images/exr.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <exception>

namespace frond {

namespace {

constexpr Imf::PixelType kTypes[] = {Imf::HALF, Imf::FLOAT, Imf::UINT};  // by ExrChannel::Kind

/// Numbers that are too large become the largest; what is none or infinite stays so.
std::vector<half> halves_of(std::span<const float> values) {
  constexpr float kLargest = 65504;
  std::vector<half> halves;
  halves.reserve(values.size());
  for (float value : values)
    halves.push_back(half(std::isfinite(value) ? std::clamp(value, -kLargest, kLargest) : value));
  return halves;
}

/// The numbers of a channel where the library finds them, without a copy of their own: `first` is the first.
template <class T>
Imf::Slice slice_of(Imf::PixelType type, const std::vector<T>& values, std::size_t width) {
  auto* first = reinterpret_cast<char*>(const_cast<T*>(values.data()));  // it only reads them
  return Imf::Slice(type, first, sizeof(T), sizeof(T) * width);
}

/// Throws what the library throws.
std::string written(std::array<int, 2> size, std::span<const ExrChannel> channels,
                    const ExrAttributes& attributes) {
  Imf::Header header(size[0], size[1]);
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const auto& [name, value] : attributes) header.insert(name, Imf::StringAttribute(value));
  std::vector<std::vector<half>> halves(channels.size());
  Imf::FrameBuffer buffer;
  auto width = static_cast<std::size_t>(size[0]);
  for (std::size_t i = 0; i < channels.size(); ++i) {
    const ExrChannel& channel = channels[i];
    Imf::PixelType type = kTypes[static_cast<std::size_t>(channel.kind)];
    header.channels().insert(channel.name, Imf::Channel(type));
    if (channel.kind == ExrChannel::Kind::half) {
      halves[i] = halves_of(channel.values);
      buffer.insert(channel.name, slice_of(type, halves[i], width));
    } else if (channel.kind == ExrChannel::Kind::single) {
      buffer.insert(channel.name, slice_of(type, channel.values, width));
    } else {
      buffer.insert(channel.name, slice_of(type, channel.wholes, width));
    }
  }
  Imf::StdOSStream stream;
  {
    Imf::OutputFile file(stream, header, 0);  // by this thread alone
    file.setFrameBuffer(buffer);
    file.writePixels(size[1]);
  }  // which writes where the lines are
  return stream.str();
}

/// What is wrong with the names of the channels, or nothing.
std::string wrong_names(std::span<const ExrChannel> channels) {
  std::vector<std::string> names;
  for (const ExrChannel& channel : channels) names.push_back(channel.name);
  std::sort(names.begin(), names.end());
  if (auto twice = std::adjacent_find(names.begin(), names.end()); twice != names.end())
    return "two channels have the name " + *twice;
  for (const std::string& name : names)
    if (name.empty() || name.size() > 255) return "a channel needs a name of 1 to 255 bytes";
  return "";
}

}  // namespace

Result<std::string> exr_bytes(std::array<int, 2> size, std::span<const ExrChannel> channels,
                              const ExrAttributes& attributes) {
  if (std::string wrong = wrong_names(channels); !wrong.empty()) return Error{"", "OpenEXR: " + wrong};
  for ([[maybe_unused]] const ExrChannel& channel : channels)
    assert((channel.kind == ExrChannel::Kind::whole ? channel.wholes.size() : channel.values.size()) ==
           static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]));
  try {
    return written(size, channels, attributes);
  } catch (const std::exception& error) {
    return Error{"", std::string("OpenEXR: ") + error.what()};
  }
}

}  // namespace frond
