#include "plan/layout.h"

#include <gtest/gtest.h>

#include <queue>
#include <set>

#include "plan/picture.h"

namespace frond {
namespace {

/// A plan with everything: rooms behind rooms, loops, random sizes, branches that find no room.
PlanText walled() {
  PlanText text;
  text.size = {11, 9};
  text.grammar.axiom = "FFC[+FW][-FW]FW";
  text.grammar.steps = 7;
  for (const char* rule : {"W ->(0.3) [+B(floor(rand(1,3.99)),floor(rand(1,2.99)))]FW", "W ->(0.3) [-B]FW",
                           "W ->(0.2) [+FFW]F[-FW]FW", "W ->(0.1) C[+FW]FW", "W ->(0.1) +F-FW"})
    text.grammar.rules.push_back({rule});
  text.rooms = {{.symbol = "B", .name = "bed", .size = {2, 1}, .ground = RoomGround::earth},
                {.symbol = "C", .name = "court", .size = {3, 3}, .inset = 0.2}};
  return text;
}

bool within(const PlanSite& site, Vec2 at, double more) {
  auto c = static_cast<float>(std::cos(site.turn)), s = static_cast<float>(std::sin(site.turn));
  Vec2 away = at - site.at, own(c * away.x - s * away.y, s * away.x + c * away.y);
  return std::abs(own.x) <= site.size.x / 2 + more && std::abs(own.y) <= site.size.y / 2 + more;
}

/// Points `step` metres apart of the plan and of what lies a metre around it, each with a mark.
struct Raster {
  static constexpr float kStep = 0.1f;
  Vec2 low;
  int columns, rows;
  std::vector<int> marks;

  explicit Raster(const PlanText& text) {
    Vec2 size = static_cast<float>(text.cell) * Vec2(text.size[0], text.size[1]) + 2.0f;
    low = -0.5f * size;
    columns = static_cast<int>(size.x / kStep) + 1, rows = static_cast<int>(size.y / kStep) + 1;
    marks.assign(static_cast<std::size_t>(columns * rows), 0);
  }
  Vec2 place(int x, int y) const { return low + kStep * Vec2(x, y); }
  int& at(int x, int y) { return marks[static_cast<std::size_t>(y * columns + x)]; }
  bool inside(int x, int y) const { return x >= 0 && y >= 0 && x < columns && y < rows; }

  /// Calls `what` with the mark of each point within a rectangle that is wider by `more` metres.
  template <class What>
  void each(const PlanSite& site, float more, What what) {
    Vec2 half =
        0.5f * (std::abs(std::sin(site.turn)) > 0.5 ? Vec2(site.size.y, site.size.x) : site.size) + more;
    glm::ivec2 first = glm::max(glm::ivec2((site.at - half - low) / kStep), 0),
               last = glm::min(glm::ivec2((site.at + half - low) / kStep) + 1, glm::ivec2(columns, rows) - 1);
    for (int y = first.y; y <= last.y; ++y)
      for (int x = first.x; x <= last.x; ++x)
        if (within(site, place(x, y), more)) what(at(x, y));
  }
};

enum Mark { kGround = 1, kWall = 2, kReached = 4, kBed = 8, kWayMark = 16 };

/// Floods from before the gate over ways and rooms, not through walls.
void flood(Raster& raster, Vec2 from) {
  std::queue<std::pair<int, int>> front;
  auto reach = [&](int x, int y) {
    if (!raster.inside(x, y)) return;
    int& mark = raster.at(x, y);
    if (!(mark & kGround) || (mark & (kWall | kReached))) return;
    mark |= kReached;
    front.push({x, y});
  };
  Vec2 start = (from - raster.low) / Raster::kStep;
  reach(static_cast<int>(start.x), static_cast<int>(start.y));
  for (; !front.empty(); front.pop()) {
    auto [x, y] = front.front();
    reach(x + 1, y), reach(x - 1, y), reach(x, y + 1), reach(x, y - 1);
  }
}

/// What holds of a plan, as it is laid: of its walls and grounds alone.
void expect_laws(const PlanText& text, const GroundPlan& plan) {
  Raster raster(text);
  std::vector<PlanSite> ways = way_sites(text, plan), rooms, walls = sites_along(text, plan, kPlanWalls);
  for (const RoomKind& kind : text.rooms)
    for (const PlanSite& edge : sites_along(text, plan, kind.name)) walls.push_back(edge);
  for (const PlanRoom& room : plan.rooms) rooms.push_back(room_site(text, room));
  int crossed = 0, overlaps = 0, beds_on_ways = 0;
  for (const PlanSite& way : ways) raster.each(way, -0.02f, [](int& m) { m |= kWayMark; });
  for (const PlanSite& room : rooms)
    raster.each(room, -0.02f, [&](int& m) {
      overlaps += (m & kBed) != 0, beds_on_ways += (m & kWayMark) != 0;
      m |= kBed;
    });
  // Ways end where rooms begin: no row of points between them is left out.
  for (const std::vector<PlanSite>& some : {ways, rooms})
    for (const PlanSite& site : some) raster.each(site, 0.02f, [](int& m) { m |= kGround; });
  for (const PlanSite& wall : walls)
    raster.each(wall, 0.09f, [&](int& m) { m |= kWall, crossed += (m & kWayMark) != 0; });
  EXPECT_EQ(crossed, 0) << "walls do not cross ways";
  EXPECT_EQ(overlaps, 0) << "rooms do not overlap";
  EXPECT_EQ(beds_on_ways, 0) << "no room lies on a way";
  flood(raster, sites_in(text, plan, kPlanGate)[0].at + Vec2(0, 0.5f));
  auto reached = [&](const PlanSite& site, float within) {
    int all = 0, some = 0;
    raster.each(site, within, [&](int& m) { ++all, some += (m & kReached) != 0; });
    return all > 0 && some == all;
  };
  for (const PlanSite& way : ways)
    EXPECT_TRUE(reached(way, -0.45f)) << "the way at " << way.at.x << " " << way.at.y;
  for (const PlanSite& room : rooms)
    EXPECT_TRUE(reached(room, -0.3f)) << "the room at " << room.at.x << " " << room.at.y;
  // All lies in the outer wall, but for the way that comes in.
  Vec2 half = static_cast<float>(text.cell / 2) * Vec2(text.size[0], text.size[1]);
  int outside = 0;
  for (int y = 0; y < raster.rows; ++y)
    for (int x = 0; x < raster.columns; ++x) {
      Vec2 at = raster.place(x, y);
      bool in = std::abs(at.x) < half.x && at.y > -half.y && at.y < half.y + 0.15f;
      outside += !in && at.y < half.y + 0.15f && (raster.at(x, y) & kGround);
    }
  EXPECT_EQ(outside, 0) << "all lies in the outer wall";
}

TEST(PlanLayout, EverythingIsReachedFromTheGateWhateverTheSeed) {
  PlanText text = walled();
  Result<Grammar> grammar = compile_plan(text);
  ASSERT_TRUE(grammar.ok()) << grammar.errors()[0].text();
  std::set<std::vector<int>> different;
  std::size_t rooms = 0;
  for (std::uint64_t seed = 1; seed <= 1000; ++seed) {
    Result<GroundPlan> plan = derive_plan(text, *grammar, Seed{seed});
    ASSERT_TRUE(plan.ok());
    expect_laws(text, *plan);
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
    different.insert(plan->cells);
    rooms += plan->rooms.size();
  }
  EXPECT_GT(different.size(), 900u);
  EXPECT_GT(rooms, 4000u);
}

TEST(PlanLayout, WallsAreFewLongPieces) {
  PlanText text = walled();
  text.grammar.axiom = "F[+B(3,1)]FFF", text.grammar.rules.clear(), text.grammar.steps = 0;
  Result<GroundPlan> plan = derive_plan(text, *compile_plan(text), Seed{1});
  ASSERT_TRUE(plan.ok());
  // Four sides, one of them in two beside the gate.
  EXPECT_EQ(sites_along(text, *plan, kPlanWalls).size(), 5u);
  EXPECT_EQ(sites_along(text, *plan, "bed").size(), 5u);
  EXPECT_EQ(way_sites(text, *plan).size(), 2u);
  double length = 0;
  for (const PlanSite& wall : sites_along(text, *plan, kPlanWalls))
    length += static_cast<double>(wall.size.x);
  EXPECT_NEAR(length, 2 * (22 + 18) - 1.3, 1e-4);
  EXPECT_EQ(sites_in(text, *plan, "doors").size(), 1u);
  EXPECT_EQ(sites_in(text, *plan, "corners").size(), 4u);
}

/// What stands in a room looks out of it, whichever way it was opened.
TEST(PlanLayout, RoomsFaceTheirDoors) {
  for (const char* axiom : {"FFFB", "FFF+B", "FFF-B", "FFF+F+B"}) {
    PlanText text = walled();
    text.grammar.axiom = axiom, text.grammar.rules.clear(), text.grammar.steps = 0;
    GroundPlan plan = *derive_plan(text, *compile_plan(text), Seed{1});
    PlanSite room = sites_in(text, plan, "bed").at(0), door = sites_in(text, plan, kPlanDoors).at(0);
    Vec2 out(static_cast<float>(std::sin(room.turn)), static_cast<float>(std::cos(room.turn)));
    EXPECT_NEAR(glm::dot(door.at - room.at, out), room.size.y / 2, 1e-4) << axiom;
    EXPECT_NEAR(std::cos(door.turn - room.turn), 1, 1e-5) << axiom;
    EXPECT_NEAR(room.size.x, 3.4, 1e-5) << axiom;
  }
}

TEST(PlanPicture, ShowsEachPlan) {
  PlanText text = walled();
  GroundPlan plan = *derive_plan(text, *compile_plan(text), Seed{1});
  std::vector<GroundPlan> two{plan, plan};
  std::string svg = plans_svg(text, two);
  EXPECT_NE(svg.find("viewBox=\"0 0 48 20\""), svg.npos) << svg.substr(0, 200);
  std::size_t letters = 0;
  for (std::size_t at = svg.find("<text"); at != svg.npos; at = svg.find("<text", at + 1)) ++letters;
  EXPECT_EQ(letters, 2 * plan.rooms.size());
}

}  // namespace
}  // namespace frond
