#include "emit/twigs.h"

#include <gtest/gtest.h>

#include "core/parallel.h"
#include "draw/twigs_scene.h"
#include "emit/texts.h"

namespace frond {
namespace {

TEST(TwigText, ALargeTreeTakesLessThanHalfOfTheBytes) {
  std::string single = text_of(aspen_scene(60, 0), 1), copied = text_of(aspen_scene(60, 25), 1);
  EXPECT_EQ(count(single, "Twig"), 0u);
  EXPECT_LT(copied.size(), single.size() / 2);
  EXPECT_GT(count(copied, "object{Twig"), 1000u);
}

TEST(TwigText, DeclaresWhatItUses) {
  std::string text = text_of(aspen_scene(60, 25), 1);
  EXPECT_EQ(count(text, kTwigInclude.data()), 1u);
  for (std::size_t at = text.find("object{Twig"); at != text.npos; at = text.find("object{Twig", at + 1)) {
    std::string name = text.substr(at + 7, text.find(' ', at) - at - 7);
    ASSERT_NE(text.find("#declare " + name + " = mesh2{"), text.npos) << name;
  }
}

TEST(TwigText, IsTheSameWithAnyNumberOfThreads) {
  Scene scene = aspen_scene(60, 25);
  std::string many = text_of(scene, 2);
  limit_threads(1);
  std::string alone = text_of(scene, 2);
  limit_threads(0);
  EXPECT_TRUE(many == alone);
}

TEST(TwigText, FramesOfAFilmPlaceTheSameTwigs) {
  Scene scene = aspen_scene(60, 25);
  auto placed = [](const std::string& text) {
    std::vector<std::string> names;
    for (std::size_t at = text.find("object{Twig"); at != text.npos; at = text.find("object{Twig", at + 1))
      names.push_back(text.substr(at, text.find(' ', at) - at));
    return names;
  };
  std::string first = text_of(scene, 1), second = text_of(scene, 2);
  EXPECT_FALSE(first == second) << "the wind blows";
  EXPECT_EQ(placed(first), placed(second));
}

}  // namespace
}  // namespace frond
