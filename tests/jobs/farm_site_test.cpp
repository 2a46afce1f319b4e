#include "jobs/farm_site.h"

#include <gtest/gtest.h>

namespace frond {
namespace {

std::string fault_of(std::string_view text) {
  Result<FarmSite> site = read_farm_site(text, "site.json");
  return site ? "" : site.errors().front().text();
}

TEST(FarmSite, IsReadFromJson) {
  Result<FarmSite> site =
      read_farm_site(R"({"partition": "cpu", "cpus": 8, "modules": ["povray/3.7"]})", "site.json");
  ASSERT_TRUE(site);
  EXPECT_EQ(site->partition, "cpu");
  EXPECT_EQ(site->cpus, 8);
  EXPECT_EQ(site->modules, std::vector<std::string>{"povray/3.7"});
  EXPECT_EQ(site->minutes, 0);
}

TEST(FarmSite, FaultsHaveTheirPlace) {
  EXPECT_TRUE(fault_of(R"({"acount": "x"})").starts_with("site.json:1:2: /acount"));
  EXPECT_TRUE(fault_of(R"({"cpus": 0})").starts_with("site.json:1:10: /cpus"));
}

TEST(FarmSite, ModulesAndOptionsAreWhatTheyClaim) {
  EXPECT_TRUE(fault_of(R"({"modules": ["a", "-f"]})").starts_with("site.json:1:19: /modules/1"));
  EXPECT_NE(fault_of(R"({"modules": ["a\nb"]})"), "");
  EXPECT_NE(fault_of(R"({"options": ["rm"]})"), "");
  EXPECT_NE(fault_of(R"({"options": ["--a\n--b"]})"), "");
  EXPECT_EQ(fault_of(R"({"options": ["--constraint=a b"]})"), "");
}

}  // namespace
}  // namespace frond
