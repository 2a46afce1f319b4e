#include "film/model_summary.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace frond {
namespace {

ModelSummary summary_of(Seed seed) {
  ModelSummary summary;
  Model model;
  for (std::size_t i = 0; i < 200; ++i) {
    auto part = [&](std::size_t k) { return static_cast<float>(seed.child(i).child(k).range(-3, 3)); };
    model.skeleton.add({part(0), part(1), part(2)}, 0.01f, static_cast<std::int32_t>(i) - 1, 0);
  }
  Look look;
  look.branches.bark = Bark{};
  summary.surfels = surfels_of(look, model);
  std::vector<int> halvings(summary.surfels.size());
  for (std::size_t i = 0; i < halvings.size(); i += 9) halvings[i] = 3;
  refine(summary.surfels, halvings, look, model);
  summary.parts = {{{0, 3}, {}}, {{2, -1}, {0, 1, 12}}, {{2, 0}, {1}}};
  return summary;
}

TEST(ModelSummary, WhatALaterRunReadsIsWhatThisRunHas) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    ModelSummary summary = summary_of(Seed{seed});
    ASSERT_GT(summary.surfels.size(), 50u);
    std::optional<ModelSummary> read = read_summary(summary_text(summary));
    ASSERT_TRUE(read);
    EXPECT_EQ(read->surfels, summary.surfels);
    EXPECT_EQ(read->parts, summary.parts);
  }
}

TEST(ModelSummary, APartOfAFileIsNoSummary) {
  std::string text = summary_text(summary_of(Seed{7}));
  for (std::size_t size = 0; size + 2 < text.size(); size += std::max<std::size_t>(1, size / 40))
    EXPECT_FALSE(read_summary(text.substr(0, size))) << size;
  text.replace(text.find("files"), 5, "fails");
  EXPECT_FALSE(read_summary(text));
}

}  // namespace
}  // namespace frond
