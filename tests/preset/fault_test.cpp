#include "preset/fault.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

Origin at(int line, int column) { return Origin{std::make_shared<const std::string>("f"), line, column}; }

TEST(Faults, SameWordsAboutTheSamePlaceAreKeptOnce) {
  Faults faults;
  faults.add({at(2, 3), "/a/0", "found 1; expected 2"});
  faults.add({at(2, 3), "/a/1", "found 1; expected 2"});
  faults.add({at(2, 3), "/a/1", "found 1; expected 3"});
  faults.add({at(1, 9), "/b", "found 1; expected 2"});
  Errors errors = faults.errors();
  ASSERT_EQ(errors.size(), 3u);
  EXPECT_EQ(errors[0].text(), "f:1:9: /b: found 1; expected 2") << "in the order of the file";
  EXPECT_EQ(errors[1].text(), "f:2:3: /a/0: found 1; expected 2");
  EXPECT_EQ(errors[2].text(), "f:2:3: /a/1: found 1; expected 3");
}

TEST(Faults, OfAValueThatMayBeOfSeveralKinds) {
  Fault one_knows_not{at(1, 1), "/wave", "", "wave", {"size"}};
  Fault range{at(1, 2), "/wave/speed", "found 9; expected 1"};
  Fault stranger{at(1, 3), "/wvae", "", "wvae", {"size"}};
  Fault stranger_too{at(1, 3), "/wvae", "", "wvae", {"size", "wave"}};

  std::vector<Fault> common = common_faults({{one_knows_not, stranger}, {range, stranger_too}});
  ASSERT_EQ(common.size(), 2u);
  EXPECT_EQ(common[0].error().what,
            "unknown property \"wvae\"; expected one of size, wave; did you mean \"wave\"?");
  EXPECT_EQ(common[1].error().text(), "f:1:2: /wave/speed: found 9; expected 1")
      << "the one kind that has it refuses it";

  EXPECT_TRUE(common_faults({{one_knows_not}, {}}).empty()) << "one kind reads it well";
  EXPECT_TRUE(common_faults({}).empty());
}

}  // namespace
}  // namespace frond
