#include "images/exr.h"

#include <Imath/half.h>
#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>

namespace frond {
namespace {

constexpr std::array<int, 2> kSize{5, 37};  // more lines than one block of compression has
constexpr std::size_t kPixels = 5 * 37;

/// A file that the library itself reads.
class ReadBack {
 public:
  explicit ReadBack(const std::string& bytes) {
    stream_.str(bytes);
    file_ = std::make_unique<Imf::InputFile>(stream_, 0);
  }
  const Imf::Header& header() const { return file_->header(); }

  template <class T>
  std::vector<T> values(const char* name, Imf::PixelType type) {
    std::vector<T> values(kPixels);
    Imf::FrameBuffer buffer;
    buffer.insert(name,
                  Imf::Slice(type, reinterpret_cast<char*>(values.data()), sizeof(T), sizeof(T) * kSize[0]));
    file_->setFrameBuffer(buffer);
    file_->readPixels(0, kSize[1] - 1);
    return values;
  }

 private:
  Imf::StdISStream stream_;
  std::unique_ptr<Imf::InputFile> file_;
};

std::vector<float> ramp(float step) {
  std::vector<float> values;
  for (std::size_t i = 0; i < kPixels; ++i) values.push_back(static_cast<float>(i) * step);
  return values;
}

std::vector<ExrChannel> some_channels() {
  std::vector<std::uint32_t> wholes;
  for (std::uint32_t i = 0; i < kPixels; ++i) wholes.push_back(0xffffffffu - i * i);
  return {{"R", ExrChannel::Kind::half, ramp(0.25f), {}},
          {"Z", ExrChannel::Kind::single, ramp(0.1234567f), {}},
          {"a channel with a name of more than 31 bytes", ExrChannel::Kind::whole, {}, wholes}};
}

TEST(Exr, IsReadBackAsItWasWritten) {
  std::vector<ExrChannel> channels = some_channels();
  Result<std::string> bytes = exr_bytes(kSize, channels, {{"comment", "leaves \"and\" stems"}});
  ASSERT_TRUE(bytes) << bytes.errors()[0].text();
  ReadBack back(*bytes);
  EXPECT_EQ(back.header().dataWindow().max.x, kSize[0] - 1);
  EXPECT_EQ(back.header().dataWindow().max.y, kSize[1] - 1);
  EXPECT_EQ(back.header().compression(), Imf::ZIP_COMPRESSION);
  EXPECT_EQ(back.header().typedAttribute<Imf::StringAttribute>("comment").value(), "leaves \"and\" stems");
  const Imf::ChannelList& list = back.header().channels();
  EXPECT_EQ(list.findChannel("R")->type, Imf::HALF);
  EXPECT_EQ(list.findChannel("Z")->type, Imf::FLOAT);
  EXPECT_EQ(list.findChannel(channels[2].name)->type, Imf::UINT);
  EXPECT_EQ(back.values<float>("Z", Imf::FLOAT), channels[1].values);
  EXPECT_EQ(back.values<std::uint32_t>(channels[2].name.c_str(), Imf::UINT), channels[2].wholes);
  EXPECT_EQ(back.values<float>("R", Imf::FLOAT), channels[0].values) << "quarters are halves without loss";
}

TEST(Exr, EqualPicturesGiveEqualBytesThatNameNeitherTimeNorOwner) {
  std::string bytes = *exr_bytes(kSize, some_channels());
  EXPECT_EQ(*exr_bytes(kSize, some_channels()), bytes);
  ReadBack back(bytes);
  for (const char* name : {"capDate", "utcOffset", "owner", "software"})
    EXPECT_EQ(back.header().find(name), back.header().end()) << name;
}

TEST(Exr, AHalfHoldsNoMoreThanItsLargest) {
  std::vector<float> values(kPixels, 1e9f);
  values[1] = -1e9f;
  values[2] = std::numeric_limits<float>::infinity();
  std::vector<ExrChannel> channels{{"R", ExrChannel::Kind::half, values, {}}};
  std::vector<float> back = ReadBack(*exr_bytes(kSize, channels)).values<float>("R", Imf::FLOAT);
  EXPECT_EQ(back[0], 65504);
  EXPECT_EQ(back[1], -65504);
  EXPECT_TRUE(std::isinf(back[2]));
}

TEST(Exr, ChannelsNeedNamesOfTheirOwn) {
  std::vector<ExrChannel> twice(2, {"R", ExrChannel::Kind::single, ramp(1), {}});
  EXPECT_EQ(exr_bytes(kSize, twice).errors()[0].what, "OpenEXR: two channels have the name R");
  std::vector<ExrChannel> nameless{{"", ExrChannel::Kind::single, ramp(1), {}}};
  EXPECT_FALSE(exr_bytes(kSize, nameless));
  EXPECT_FALSE(exr_bytes({0, 0}, {})) << "a picture without pixels";
}

}  // namespace
}  // namespace frond
