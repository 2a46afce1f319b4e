#include "organisms/cpfg_picture.h"

#include <fmt/format.h>

#include <cmath>

namespace frond {

namespace {

std::string hex(const Color& color) {
  auto part = [](float x) { return static_cast<int>(std::lround(255 * x)); };
  return fmt::format("#{:02x}{:02x}{:02x}", part(color.red), part(color.green), part(color.blue));
}

}  // namespace

TurtleDrawing drawing_of(const CpfgFigure& figure) {
  TurtleDrawing drawing;
  drawing.low = figure.low, drawing.high = figure.high;
  for (const Color& color : figure.colors) drawing.colors.push_back(hex(color));
  for (const CpfgSegment& s : figure.segments)
    drawing.lines.push_back({s.from, s.to, s.radius_from + s.radius_to, s.color});
  for (const CpfgPolygon& polygon : figure.polygons) drawing.fills.push_back({polygon.points, polygon.color});
  auto add = [&](const Surface& mesh, int color, const auto& place) {
    for (const auto& [a, b, c] : mesh.triangle)
      drawing.fills.push_back(
          {{place(mesh.position[a]), place(mesh.position[b]), place(mesh.position[c])}, color});
  };
  for (const CpfgSkin& skin : figure.skins)
    add(skin.mesh, skin.color, [](const Vec3& p) { return DVec3(p); });
  for (const CpfgPlaced& placed : figure.placed)
    add(figure.surfaces.at(placed.surface), placed.color, [&](const Vec3& p) { return placed.at(p); });
  for (const std::vector<CpfgRound>& rounds : {figure.spheres, figure.discs})
    for (const CpfgRound& round : rounds) drawing.balls.push_back({round.center, round.radius, round.color});
  return drawing;
}

std::size_t pieces_of(const CpfgFigure& figure) {
  std::size_t pieces =
      figure.segments.size() + figure.polygons.size() + figure.spheres.size() + figure.discs.size();
  for (const CpfgSkin& skin : figure.skins) pieces += skin.mesh.triangle.size();
  for (const CpfgPlaced& placed : figure.placed) pieces += figure.surfaces.at(placed.surface).triangle.size();
  return pieces;
}

}  // namespace frond
