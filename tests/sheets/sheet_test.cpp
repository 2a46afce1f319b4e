#include "sheets/sheet.h"

#include <gtest/gtest.h>

#include <set>

namespace frond {

TEST(SheetSweep, GoesEvenlyFromOneValueToTheOther) {
  std::optional<Sweep> sweep = read_sweep("/organisms/0/pitch=1e1:30:3");
  ASSERT_TRUE(sweep);
  EXPECT_EQ(sweep->pointer, "/organisms/0/pitch");
  EXPECT_EQ(sweep->values, (std::vector<std::string>{"10", "20", "30"}));
  EXPECT_EQ(read_sweep("/seed=4:9:1")->values, std::vector<std::string>{"4"});
  for (const char* text : {"", "/seed", "seed=1:2:2", "/seed=1:2", "/seed=1:2:0", "/seed=1:2:1.5",
                           "/seed=1:2:100", "/seed=1:2:2x", "/seed=1:inf:2"})
    EXPECT_FALSE(read_sweep(text)) << text;
}

TEST(SheetCells, AreOfAllPairsAndHaveFoldersOfTheirOwn) {
  std::vector<Sweep> sweeps{sweep_of("/seed", 1, 2, 2), sweep_of("/organisms/0/pitch", 10, 30, 3)};
  std::vector<SheetCell> cells = cells_of(sweeps, "pictures");
  ASSERT_EQ(cells.size(), 6u);
  EXPECT_EQ(cells[2].sets, (std::vector<std::string>{"/seed=1", "/organisms/0/pitch=20"}));
  EXPECT_EQ(cells[2].text, "seed 1   pitch 20");
  std::set<std::filesystem::path> folders;
  for (const SheetCell& cell : cells) folders.insert(cell.folder);
  EXPECT_EQ(folders.size(), 6u);
  EXPECT_EQ(columns_of(sweeps), 2);
  // Another sheet finds what this one has rendered.
  sweeps[1] = sweep_of("/organisms/0/pitch", 20, 20, 1);
  EXPECT_EQ(cells_of(sweeps, "pictures")[0].folder, cells[2].folder);
}

TEST(SheetCells, OfPropertiesOfOneNameAreCalledByTheirWholePointers) {
  std::vector<Sweep> sweeps{sweep_of("/a/pitch", 1, 1, 1), sweep_of("/b/pitch", 2, 2, 1)};
  EXPECT_EQ(cells_of(sweeps, "")[0].text, "/a/pitch 1   /b/pitch 2");
  EXPECT_EQ(cells_of({sweep_of("/size/0", 3, 3, 1)}, "")[0].text, "size/0 3");
}

TEST(SheetCells, OfOneSweepStandAboutInASquare) {
  EXPECT_EQ(columns_of({sweep_of("/seed", 1, 5, 5)}), 3);
  EXPECT_EQ(columns_of({sweep_of("/seed", 1, 4, 4)}), 2);
}

}  // namespace frond
