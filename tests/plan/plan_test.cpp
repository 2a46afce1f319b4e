#include "plan/plan.h"

#include <gtest/gtest.h>

#include <set>

namespace frond {
namespace {

PlanText text_of(const std::string& axiom) {
  PlanText text;
  text.grammar.axiom = axiom;
  text.grammar.steps = 0;
  text.size = {7, 6};
  text.rooms = {{.symbol = "B", .name = "bed", .size = {2, 1}},
                {.symbol = "C", .name = "court", .size = {3, 3}}};
  return text;
}

GroundPlan plan_of(const PlanText& text, Seed seed = Seed{1}) {
  Result<Grammar> grammar = compile_plan(text);
  EXPECT_TRUE(grammar.ok()) << (grammar ? "" : grammar.errors()[0].text());
  Result<GroundPlan> plan = derive_plan(text, *grammar, seed);
  EXPECT_TRUE(plan.ok()) << (plan ? "" : plan.errors()[0].text());
  return *plan;
}

/// Rows from the back, as a plan is seen: `.` free, `:` a way, else the symbol of a room.
std::string drawn(const PlanText& text, const GroundPlan& plan) {
  std::string out;
  for (int row = plan.size[1] - 1; row >= 0; --row) {
    for (int column = 0; column < plan.size[0]; ++column) {
      int cell = plan.at({column, row});
      out += cell == GroundPlan::kFree ? '.'
             : cell == GroundPlan::kWay
                 ? ':'
                 : text.rooms[plan.rooms[static_cast<std::size_t>(cell)].kind].symbol[0];
    }
    out += '\n';
  }
  return out;
}

/// What a word lays out.
TEST(GroundPlan, WordsMean) {
  struct Row {
    const char *word, *plan;
  };
  const Row rows[] = {
      // A step joins the ways that there are; a way ends at the wall.
      {"F(2)[+F(9)]-F+F+F+F", ".......\n.......\n...::..\n:::::..\n...:...\n...:...\n"},
      // Rooms of an even width lie to the right of the way; the turtle leaves a room on the side that it
      // faces.
      {"F[-B]FC-FF", "..CCC..\n..CCC::\n..CCC..\n...:...\n...:B..\n...:B..\n"},
      {"F[+B][-B(1,2)]F[-F]F", ".......\n.......\n...:...\n..B::..\n..B:BB.\n...:...\n"},
      // What finds no room ends its branch, and only that.
      {"[+FFBFF]F[C(5,9)F]|BF", ".......\n.......\n.......\n.......\nB..:...\nB:::...\n"},
  };
  for (const Row& row : rows) {
    PlanText text = text_of(row.word);
    EXPECT_EQ(drawn(text, plan_of(text)), row.plan) << row.word;
  }
}

TEST(GroundPlan, MeasuresThatDoNotFit) {
  PlanText text = text_of("F");
  EXPECT_TRUE(plan_faults(text, 30).empty());
  text.way = 1.5;
  text.rooms[0].inset = 0.5, text.rooms[1].symbol = "+";
  text.size = {40, 6};
  std::vector<std::string> where;
  for (const Error& error : plan_faults(text, 30)) where.push_back(error.where);
  EXPECT_EQ(where, (std::vector<std::string>{"/size", "/way", "/rooms/0/inset", "/rooms/1/symbol"}));
}

}  // namespace
}  // namespace frond
