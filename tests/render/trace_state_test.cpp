#include "render/trace_state.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "core/files.h"

namespace frond {

namespace {

namespace fs = std::filesystem;

/// The head of a state file of POV-Ray.
std::string head() {
  std::string text = "POV-Ray Render State File";
  text.resize(512, '\0');
  return text;
}

/// A message of it that holds this.
std::string message(const std::string& body) {
  std::string text = "POVRAYMS....";
  auto length = static_cast<unsigned>(16 + body.size() - 20);
  for (unsigned shift : {24u, 16u, 8u, 0u}) text += static_cast<char>(length >> shift & 255);
  return text + body;
}

std::string first_block() { return message(std::string("PxBSPiIdINT4\0\0\0\4\0\0\0\0PiSi 1234", 29)); }
std::string other_block() { return message(std::string("PxBSPiIdINT4\0\0\0\4\0\0\0\7PiSi 1234", 29)); }
std::string coarse() { return message("PxSe and so on, as many"); }

std::size_t kept(const std::string& state) {
  fs::path file = fs::path(::testing::TempDir()) / ("frond_trace_state_" + std::to_string(::getpid()));
  EXPECT_FALSE(write_new(file, state));
  EXPECT_TRUE(keep_traced(file).empty());
  std::size_t size = fs::file_size(file);
  EXPECT_EQ(*read_file(file), state.substr(0, size));
  fs::remove(file);
  return size;
}

}  // namespace

TEST(TraceState, WholeBlocksAreKept) {
  std::string state = head() + other_block() + other_block();
  EXPECT_EQ(kept(state), state.size());
}

TEST(TraceState, WhatIsCutOffGoes) {
  std::string whole = head() + other_block(), cut = other_block();
  for (std::size_t length = 0; length < cut.size(); ++length)
    EXPECT_EQ(kept(whole + cut.substr(0, length)), whole.size()) << length;
  EXPECT_EQ(kept(whole + "something else, which is no message"), whole.size());
}

TEST(TraceState, CoarsePixelsNeedTheFirstBlock) {
  std::string good = head() + coarse() + other_block() + first_block();
  EXPECT_EQ(kept(good), good.size());
  EXPECT_EQ(kept(head() + coarse() + other_block()), 0u);
}

TEST(TraceState, WithoutBlocksNothingIsKept) { EXPECT_EQ(kept(head()), 0u); }

TEST(TraceState, AnotherRenderersIsLeftAlone) {
  EXPECT_EQ(kept(std::string(700, '\0')), 700u);
  EXPECT_EQ(kept("short"), 5u);
  EXPECT_EQ(kept(""), 0u);
}

}  // namespace frond
