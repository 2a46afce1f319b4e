#include <gtest/gtest.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <sstream>

#include "texts.h"

namespace frond {
namespace {

/// The matrices of a text, and those of them that POV-Ray could not invert.
std::array<std::size_t, 2> matrices_of(const std::string& text) {
  std::array<std::size_t, 2> all_and_singular{0, 0};
  constexpr std::string_view kOpen = "matrix<";
  for (std::size_t at = text.find(kOpen); at != text.npos; at = text.find(kOpen, at + 1)) {
    std::istringstream numbers(text.substr(at + kOpen.size(), 200));
    glm::dmat3 m(0);
    char comma;
    for (int i = 0; i < 9; ++i) numbers >> m[i / 3][i % 3] >> comma;
    ++all_and_singular[0];
    all_and_singular[1] += std::abs(glm::determinant(m)) < 1e-28;
  }
  return all_and_singular;
}

/// What grows, eats and swims, each over two seconds of 24 frames.
Scene growing(std::string_view setting, std::string_view organisms) {
  std::string text = fmt::format(
      R"({{"seed": 3, "film": {{"frames": 24, "fps": 12, "size": [320, 180]}}, "scene": {{"setting": "{}",
          "camera": {{"location": [0, 0.5, 1.2], "look_at": [0, 0.15, 0], "angle": 50}}}},
          "defaults": {{"growth": {{"duration": 1.8}}}}, "organisms": [{}]}})",
      setting, organisms);
  Result<Preset> preset = read_preset(text, "growing.json", {});
  if (!preset) ADD_FAILURE() << preset.errors().front().text();
  return *build_scene(*preset);
}

void expect_matrices_of_some_size(const Scene& scene, std::size_t least) {
  FrameParts parts = prepare_frames(scene);
  std::string layout = *read_file(FROND_ROOT "/templates/frame.pov");
  std::size_t most = 0;
  for (int frame = 1; frame <= scene.film.frames; ++frame) {
    std::string text = *frame_text(scene, parts, layout, frame);
    auto [all, singular] = matrices_of(text);
    EXPECT_EQ(singular, 0u) << "frame " << frame;
    EXPECT_EQ(text.find("face_indices{0 "), text.npos) << "frame " << frame;
    most = std::max(most, all);
  }
  EXPECT_GT(most, least);
}

TEST(Matrices, ArePovRaysToInvertWherePolypsComeUpOnWhatGrows) {
  expect_matrices_of_some_size(growing("underwater", R"(
      {"kind": "table", "across": 0.4, "height": 0.2, "edge": 0.012, "tissue": {"polyps": 0.012}, "place": {"at": [[0, 0]]}},
      {"kind": "massive", "across": 0.2, "height": 0.12, "relief": "plain", "edge": 0.01, "tissue": {"polyps": 0.012},
       "place": {"at": [[0.5, 0]]}},
      {"kind": "coral", "height": 0.25, "skin": {"polyps": 0.01}, "place": {"at": [[-0.5, 0]]}})"),
                               300);
}

TEST(Matrices, ArePovRaysToInvertWhereOrgansUnfold) {
  expect_matrices_of_some_size(growing("studio", R"(
      {"kind": "plant", "height": 0.4, "grammar": {"axiom": "S", "steps": 9, "rules": ["S -> F[&(50)L]/(137)S"], "symbols": ["L"]},
       "organs": [{"symbol": "L", "shape": "leaf", "size": 0.1, "colors": ["#4a7a2e"]}]})"),
                               8);
}

TEST(Matrices, ArePovRaysToInvertAmongFoodFishAndBranchesThatSway) {
  expect_matrices_of_some_size(growing("underwater", R"(
      {"kind": "coral", "height": 0.3, "place": {"at": [[0, 0]]}, "wave": {"amplitude": 9},
       "food": {"strength": 30, "position": [[0, [0.4, 0.3, 0]], [2, [-0.4, 0.3, 0]]]}},
      {"kind": "rock", "size": 0.2, "place": {"at": [[0.4, -0.2]]}},
      {"kind": "pebbles", "number": 20, "place": {"at": [[-0.4, -0.2]]}},
      {"kind": "school", "count": 5, "place": {"center": [0, 0], "raise": 0.4}, "swim": {"home": 0.5}})"),
                               20);
}

}  // namespace
}  // namespace frond
