#include "images/cryptomatte.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfStdIO.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>

namespace frond {
namespace {

std::uint32_t bits(float value) { return std::bit_cast<std::uint32_t>(value); }

TEST(Murmur, GivesItsKnownAnswers) {
  EXPECT_EQ(murmur_hash(""), 0u);
  EXPECT_EQ(murmur_hash("hello"), 0x248bfa47u);
  EXPECT_EQ(murmur_hash("hello, world"), 0x149bbb7fu);
  EXPECT_EQ(murmur_hash("The quick brown fox jumps over the lazy dog"), 0x2e4ff723u);
}

TEST(CryptomatteId, IsThatOfTheSpecificationAndOfItsSamples) {
  EXPECT_EQ(cryptomatte_id("bunny"), 0x13851a76u);
  EXPECT_EQ(cryptomatte_id("default"), 0x42c9679fu);
  EXPECT_EQ(cryptomatte_id("bunny_porcelain_mat"), 0xb24b26d4u);
  EXPECT_EQ(cryptomatte_id("bush"), 0xf763d090u);
  EXPECT_EQ(cryptomatte_id("flowerA.flowerA_petal1.:2261"), 0x00af91aeu);
}

TEST(CryptomatteId, IsACommonNumberWhateverTheName) {
  int turned = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string name = "leaf " + std::to_string(i);
    std::uint32_t id = cryptomatte_id(name);
    EXPECT_TRUE(std::isnormal(std::bit_cast<float>(id))) << name;
    if (id != murmur_hash(name)) ++turned;
    EXPECT_EQ((id ^ murmur_hash(name)) & ~(1u << 23), 0u) << name;
  }
  EXPECT_GT(turned, 4);
  EXPECT_LT(turned, 40);
}

/// Four pixels: nothing, one thing, three that need ranking, and one name that was given twice.
Cryptomatte four_pixels(int ranks) {
  std::vector<std::string> names{"oak", "fern \"tall\" \\ \n", "moss", "oak"};
  Coverages coverages{{{2, 1}, {0, 0.25f}, {1, 0.5f}, {2, 0.125f}, {0, 0.25f}, {2, 0.375f}, {3, 0.25f}},
                      {0, 1, 4, 7}};
  return cryptomatte("Organism", names, coverages, ranks);
}

TEST(Cryptomatte, RanksWhatCoversMostFirst) {
  Cryptomatte made = four_pixels(3);
  ASSERT_EQ(made.channels.size(), 8u) << "three ranks need two times two";
  const char* expected[] = {"Organism00.R", "Organism00.G", "Organism00.B", "Organism00.A",
                            "Organism01.R", "Organism01.G", "Organism01.B", "Organism01.A"};
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(made.channels[i].name, expected[i]);
    EXPECT_EQ(made.channels[i].kind, ExrChannel::Kind::single);
    EXPECT_EQ(made.channels[i].values[0], 0) << "nothing is there";
  }
  auto id = [&](std::size_t rank, std::size_t pixel) { return bits(made.channels[2 * rank].values[pixel]); };
  auto share = [&](std::size_t rank, std::size_t pixel) { return made.channels[2 * rank + 1].values[pixel]; };
  EXPECT_EQ(id(0, 1), cryptomatte_id("moss"));
  EXPECT_EQ(share(0, 1), 1);
  EXPECT_EQ(id(1, 1), 0u);
  EXPECT_EQ(id(0, 2), cryptomatte_id("fern \"tall\" \\ \n"));
  EXPECT_EQ(id(1, 2), cryptomatte_id("oak"));
  EXPECT_EQ(id(2, 2), cryptomatte_id("moss"));
  EXPECT_EQ(share(2, 2), 0.125f);
  EXPECT_EQ(id(0, 3), cryptomatte_id("oak"));
  EXPECT_EQ(share(0, 3), 0.5f) << "of a name that was given twice, both";
  EXPECT_EQ(id(2, 3), 0u);
}

TEST(Cryptomatte, KeepsNoMoreThanItsRanks) {
  EXPECT_EQ(cryptomatte("A", {}, {}).channels.size(), 12u) << "six ranks";
  Cryptomatte made = four_pixels(1);
  ASSERT_EQ(made.channels.size(), 4u);
  EXPECT_EQ(made.channels[2].values[2], 0);
  EXPECT_EQ(made.channels[3].values[2], 0);
}

TEST(Cryptomatte, NamesItsLayerAsTheSampleImagesDo) {
  EXPECT_EQ(cryptomatte("uCryptoAsset", {}, {}).attributes[0].first, "cryptomatte/d593dd7/name");
}

TEST(Cryptomatte, IsReadBackFromItsFile) {
  Cryptomatte made = four_pixels(6);
  Imf::StdISStream stream;
  stream.str(*exr_bytes({2, 2}, made.channels, made.attributes));
  Imf::InputFile file(stream, 0);
  auto text = [&](const char* key) {
    std::string name = made.attributes[0].first.substr(0, 20) + key;
    return file.header().typedAttribute<Imf::StringAttribute>(name).value();
  };
  EXPECT_EQ(text("name"), "Organism");
  EXPECT_EQ(text("hash"), "MurmurHash3_32");
  EXPECT_EQ(text("conversion"), "uint32_to_float32");
  EXPECT_EQ(text("manifest"), R"({"fern \"tall\" \\ \u000a":"12ecc4a1","moss":"ef2739ff","oak":"418dfaa2"})");
  float ids[4] = {};
  Imf::FrameBuffer buffer;
  buffer.insert("Organism00.R", Imf::Slice(Imf::FLOAT, reinterpret_cast<char*>(ids), 4, 8));
  file.setFrameBuffer(buffer);
  file.readPixels(0, 1);
  EXPECT_EQ(bits(ids[1]), cryptomatte_id("moss"));
}

}  // namespace
}  // namespace frond
