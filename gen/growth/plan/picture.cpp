#include "plan/picture.h"

#include <fmt/format.h>

#include "plan/layout.h"

namespace frond {

namespace {

constexpr const char* kGroundColors[] = {"#b9cf8e", "#d9cfb8", "#9c7a5b"};  // of RoomGround
constexpr double kMargin = 1;                                               // metres round each plan

std::string rectangle_svg(const PlanSite& site, std::string_view fill) {
  return fmt::format(
      "<rect x=\"{:.2f}\" y=\"{:.2f}\" width=\"{:.2f}\" height=\"{:.2f}\" transform=\"translate({:.2f} "
      "{:.2f}) rotate({:.0f})\" fill=\"{}\"/>\n",
      -site.size.x / 2, -site.size.y / 2, site.size.x, site.size.y, site.at.x, site.at.y, -degrees(site.turn),
      fill);
}

std::string lines_svg(const std::vector<PlanSite>& lines, double width, std::string_view color) {
  std::string out = fmt::format("<path stroke=\"{}\" stroke-width=\"{:g}\" d=\"", color, width);
  for (const PlanSite& line : lines) {
    Vec2 half = 0.5f * line.size.x * Vec2(std::cos(line.turn), -std::sin(line.turn));
    Vec2 from = line.at - half, to = line.at + half;
    out += fmt::format("M{:.2f} {:.2f}L{:.2f} {:.2f}", from.x, from.y, to.x, to.y);
  }
  return out + "\"/>\n";
}

std::string plan_svg(const PlanText& text, const GroundPlan& plan) {
  std::string out;
  for (const PlanSite& way : way_sites(text, plan)) out += rectangle_svg(way, kGroundColors[1]);
  for (const PlanRoom& room : plan.rooms) {
    const RoomKind& kind = text.rooms[room.kind];
    PlanSite site = room_site(text, room);
    out += rectangle_svg(site, kGroundColors[static_cast<std::size_t>(kind.ground)]);
    out +=
        fmt::format("<text x=\"{:.2f}\" y=\"{:.2f}\">{}</text>\n", site.at.x, site.at.y + 0.35, kind.symbol);
  }
  for (const RoomKind& kind : text.rooms)
    out += lines_svg(sites_along(text, plan, kind.name), 0.12, "#6b5a45");
  return out + lines_svg(sites_along(text, plan, kPlanWalls), 0.4, "#7a3f2c");
}

}  // namespace

std::string plans_svg(const PlanText& text, std::span<const GroundPlan> plans) {
  double width = text.size[0] * text.cell + 2 * kMargin, height = text.size[1] * text.cell + 2 * kMargin;
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:g} {1:g}\" font-size=\"1\" "
      "text-anchor=\"middle\">\n<rect width=\"{0:g}\" height=\"{1:g}\" fill=\"#fff\"/>\n",
      width * static_cast<double>(plans.size()), height);
  for (std::size_t i = 0; i < plans.size(); ++i)
    out += fmt::format("<g transform=\"translate({:g} {:g})\">\n{}{}</g>\n",
                       (static_cast<double>(i) + 0.5) * width, height / 2,
                       rectangle_svg({Vec2(0), Vec2(width - 2 * kMargin, height - 2 * kMargin)}, "#a9c27c"),
                       plan_svg(text, plans[i]));
  return out + "</svg>\n";
}

}  // namespace frond
