#include "pruning/address.h"

#include <gtest/gtest.h>

#include "pruning/tiny_tree.h"

namespace frond {
namespace {

TEST(Address, ReadsAndWritesItsText) {
  for (const char* name : {"", "3", "3/1", "3/1:0.4", ":0.7", "#2", "#2/3:0.25", "12/10/999999:1"}) {
    Result<Address> address = parse_address(name);
    ASSERT_TRUE(address) << name;
    EXPECT_EQ(text(*address), name);
  }
  EXPECT_EQ(*parse_address("#1/3"), *parse_address("3"));
  EXPECT_EQ((*parse_address("3/1:0.4")), (Address{1, {3, 1}, 0.4}));
}

TEST(Address, RefusesWhatIsNone) {
  for (const char* name : {"0", "-1", "3/", "/3", "3//1", "a", "3:", "3:1.5", "3:-0.1", "3:0.4x", "#", "#0/1",
                           "3 /1", "3:nan", "99999999999", "3:0.1:0.2"})
    EXPECT_FALSE(parse_address(name)) << name;
}

TEST(Address, CountsBranchesFromTheFoot) {
  Skeleton s = tiny_tree();
  std::vector<AxisNode> axes = axis_nodes(s);
  EXPECT_EQ(axes[0].number, 1);  // the stem
  EXPECT_EQ(axes[kLowBranch].number, 1);
  EXPECT_EQ(axes[kHighBranch].number, 2);
  EXPECT_EQ(axes[kTwig].number, 1);
  Branching plant{s.parent, axes};
  EXPECT_EQ(text(*address_of(plant, {kTwig, 0.75f})), "1/1:0.25");
  EXPECT_EQ(text(*address_of(plant, {2, 1})), ":0.5");
}

TEST(Address, EachNodeIsFoundByItsOwn) {
  Skeleton s = tiny_tree();
  std::vector<AxisNode> axes = axis_nodes(s);
  Branching plant{s.parent, axes};
  for (std::int32_t i = 0; i < static_cast<std::int32_t>(s.size()); ++i) {
    std::string name = text(*address_of(plant, {i, 1}));
    Result<BranchPlace> place = find_place(plant, axis_starts(plant), *parse_address(name));
    ASSERT_TRUE(place) << name;
    EXPECT_EQ(place->node, i) << name;
    EXPECT_NEAR(place->within, 1, 1e-4f) << name;
  }
}

TEST(Address, TellsHowManyBranchesThereAre) {
  Skeleton s = tiny_tree();
  std::vector<AxisNode> axes = axis_nodes(s);
  Branching plant{s.parent, axes};
  auto said = [&](const char* name) {
    return find_place(plant, axis_starts(plant), *parse_address(name)).errors().front().what;
  };
  EXPECT_EQ(said("3"), "finds no branch: the stem has 2 branches");
  EXPECT_EQ(said("1/4"), "finds no branch: 1 has 1 branch");
  EXPECT_EQ(said("2/1/5"), "finds no branch: 2 has no branches");
  EXPECT_EQ(said("#2/1"), "finds no stem: there are 1");
}

}  // namespace
}  // namespace frond
