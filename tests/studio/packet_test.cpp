#include "studio/packet.h"

#include <gtest/gtest.h>

#include <cstring>

namespace frond {
namespace {

DrawnPart part_of(const std::vector<float>& values) {
  DrawnPart part;
  part.head["kind"] = "mesh";
  part.add("/levels/0/position", values);
  return part;
}

/// The header of a packet, and where its arrays begin.
std::pair<Json, std::size_t> opened(const std::string& packet) {
  std::uint32_t length = 0;
  EXPECT_EQ(packet.substr(0, 4), "FRN1");
  std::memcpy(&length, packet.data() + 4, 4);
  return {Json::parse(packet.substr(8, length)), 8 + length};
}

TEST(Packet, ArraysAreWhereTheHeaderSays) {
  DrawnPart odd;
  odd.add("/colors", std::vector<std::uint8_t>{1, 2, 3});
  std::string packet = packet_of({{"nodes", 2}}, {odd, part_of({1.5f, 2.5f, 3.5f})}, {});
  auto [header, start] = opened(packet);
  EXPECT_EQ(header["nodes"], 2);
  EXPECT_EQ(start % 8, 0u);
  Json where = header["parts"][1]["levels"][0]["position"];
  EXPECT_EQ(where["t"], "f32");
  EXPECT_EQ(where["n"], 3);
  EXPECT_EQ(where["at"].get<std::size_t>() % 8, 0u);
  float value = 0;
  std::memcpy(&value, packet.data() + start + where["at"].get<std::size_t>() + 4, 4);
  EXPECT_EQ(value, 2.5f);
  EXPECT_EQ(packet.size() % 8, 0u);
}

TEST(Packet, WhatThePageHasIsNotSentAgain) {
  std::string packet = packet_of({}, {part_of({1, 2, 3})}, {});
  auto [header, start] = opened(packet);
  std::string id = header["parts"][0]["id"];
  std::string again = packet_of({}, {part_of({1, 2, 3})}, {id});
  auto [shorter, end] = opened(again);
  EXPECT_EQ(shorter["parts"][0]["id"], id);
  EXPECT_FALSE(shorter["parts"][0].contains("levels"));
  EXPECT_EQ(again.size(), end);
  EXPECT_NE(opened(packet_of({}, {part_of({1, 2, 4})}, {id})).first["parts"][0]["id"], id);
}

}  // namespace
}  // namespace frond
