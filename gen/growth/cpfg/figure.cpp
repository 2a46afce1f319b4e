#include <algorithm>
#include <cmath>

#include "core/bounds.h"
#include "cpfg/shapes.h"
#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

constexpr double kPixelsAcross = 600;  ///< of the window that widths in pixels are meant for
constexpr double kShortest = 1e-5;     ///< of a piece of a cylinder
constexpr int kStrips = 4, kMostStrips = 64, kRingCorners = 24;

int held_strips(float n) { return static_cast<int>(std::clamp(n, 1.0f, float{kMostStrips})); }

constexpr std::size_t kMostParts = 40'000'000;

/// A polygon or a cylinder between `{` and `}`.
struct OpenOutline {
  int kind = 0;  ///< 0: a polygon; 1, 2: Hermite's curve open and closed; 3, 4: a B-spline open and closed
  int strips = kStrips;
  std::vector<DVec3> points;
  std::vector<ControlPlace> places;
  int color = 0;            ///< of a polygon: that at its first point
  std::int32_t first = -1;  ///< of Hermite's curves: the place that they begin at
  std::int32_t segment = -1;
};

/// Pieces of a cylinder in a row, drawn as one skin.
struct SkinRow {
  std::int32_t end = -1;  ///< the control place that it has come to
  int sides = 8;
  std::vector<CylinderRing> rings;
  std::int32_t segment = -1;
};

class FigureBuilder {
 public:
  FigureBuilder(const CpfgModel& model, const CpfgDrawing& drawing)
      : shapes_(*model.shapes), settings_(turtle_settings(model)), turtle_(settings_, drawing) {}

  Result<CpfgFigure> draw() {
    for (std::size_t at = 0; at < turtle_.modules().size();) {
      at = step(at);
      if (parts_ > kMostParts) return Error{"", "the figure has more than 40,000,000 parts"};
    }
    taper();
    finish_row();
    if (shapes_.lines == LineStyle::pixel) widen_pixels();
    finish();
    bool bounded = std::isfinite(glm::length(figure_.low)) && std::isfinite(glm::length(figure_.high));
    if (!bounded || glm::length(figure_.high) + glm::length(figure_.low) > 1e15)
      return Error{"", "the turtle walks beyond all that can be drawn; its lengths grow too large"};
    return std::move(figure_);
  }

 private:
  const CpfgTurtleState& state() const { return turtle_.state; }
  std::span<const float> values(std::size_t at) const { return turtle_.parameters(at); }
  double radius() const { return state().width / 2; }

  std::size_t step(std::size_t at) {
    char symbol = turtle_.symbol(at);
    bool polygon = values(at).empty() || values(at)[0] == 0;
    if (std::string_view("FGfg[]{~@").find(symbol) != std::string_view::npos || (symbol == '}' && polygon))
      taper();
    DVec3 from = state().position;
    if (symbol == '~') place_surface(at + 1);
    if (symbol == '@') draw_special(at + 1);
    std::size_t next = turtle_.step(at);
    if (symbol == 'F' || symbol == 'G') add_line(from);
    if (symbol == 'F' || symbol == 'f' || symbol == '.') add_vertex(at);
    if (symbol == '{') open_outline(at);
    if (symbol == '}') close_outline();
    figure_.max_stack_depth = std::max(figure_.max_stack_depth, state().depth);
    return next;
  }

  /// Gives the last line the width that has been set since.
  void taper() {
    if (tapering_ < 0) return;
    if (shapes_.tapered && shapes_.lines != LineStyle::pixel && tapering_ == state().segment)
      figure_.segments[static_cast<std::size_t>(tapering_)].radius_to = radius();
    tapering_ = -1;
  }

  void add_line(DVec3 from) {
    add_segment(from, state().position, radius(), radius(), state().color);
    tapering_ = state().segment;
  }

  /// Adds a segment, which the turtle stands at the end of.
  void add_segment(DVec3 from, DVec3 to, double radius_from, double radius_to, int color) {
    std::int32_t before = state().segment;
    if (before >= 0 && figure_.segments[static_cast<std::size_t>(before)].to != from) before = -1;
    turtle_.state.segment = static_cast<std::int32_t>(figure_.segments.size());
    figure_.segments.push_back({from, to, radius_from, radius_to, color, before, state().depth});
    ++parts_;
  }

  void open_outline(std::size_t at) {
    OpenOutline outline;
    if (std::span<const float> n = values(at); !n.empty() && n[0] >= 1 && n[0] <= 4) {
      outline.kind = static_cast<int>(n[0]);
      if (n.size() > 1 && n[1] >= 1) outline.strips = held_strips(n[1]);
    }
    outline.segment = state().segment;
    outlines_.push_back(std::move(outline));
  }

  void add_vertex(std::size_t at) {
    if (outlines_.empty()) return;
    OpenOutline& outline = outlines_.back();
    ++parts_;
    bool point = turtle_.symbol(at) == '.';
    int strips = point && !values(at).empty() ? held_strips(values(at)[0]) : outline.strips;
    if (outline.kind == 0) {
      if (outline.points.empty()) outline.color = state().color;
      if (outline.points.empty() || outline.points.back() != state().position)
        outline.points.push_back(state().position);
    } else if (outline.kind <= 2) {
      control(outline.first < 0 ? 's' : 'c', strips);
      if (outline.first < 0) outline.first = state().place;
    } else {
      outline.places.push_back(control_place());
      outline.places.back().strips = strips;
    }
  }

  void close_outline() {
    if (outlines_.empty()) return;
    OpenOutline outline = std::move(outlines_.back());
    outlines_.pop_back();
    if (outline.kind > 0) return close_cylinder(outline);
    if (outline.points.size() > 3 && outline.points.front() == outline.points.back())
      outline.points.pop_back();
    if (outline.points.size() >= 3)
      figure_.polygons.push_back({std::move(outline.points), outline.color, outline.segment});
  }

  static int strips(std::span<const float> n) { return n.empty() ? kStrips : held_strips(n[0]); }

  ControlPlace control_place() const { return {state(), radius(), state().sides.value_or(shapes_.sides)}; }

  /// The end of a cylinder between `{(n)` and `}(n)`.
  void close_cylinder(const OpenOutline& outline) {
    if (outline.kind == 2 && outline.first >= 0 && state().place >= 0) {
      const ControlPlace& from = places_[static_cast<std::size_t>(state().place)];
      ControlPlace to = places_[static_cast<std::size_t>(outline.first)];
      if (glm::distance(from.position, to.position) >= kShortest)
        add_piece(from, to, outline.strips, from.segment);
    }
    if (outline.kind <= 2) turtle_.state.place = -1;
    finish_row();
    if (outline.kind < 3 || outline.places.empty()) return;
    add_rings(spline_rings(outline.places, outline.kind == 4, outline.strips), outline.segment,
              outline.places.front().sides);
    finish_row();
  }

  /// Adds a piece that goes on from a segment; its end takes the frame that was carried there. Gives the
  /// segment that it ends with.
  std::int32_t add_piece(const ControlPlace& from, ControlPlace& to, int strips, std::int32_t segment) {
    std::vector<CylinderRing> rings = piece_rings(from, to, strips, shapes_.twisted);
    if (!shapes_.twisted) to.left = rings.back().left, to.up = rings.back().up;
    return add_rings(rings, segment, from.sides);
  }

  /// Adds rings: circles as segments, others to the row of a skin.
  std::int32_t add_rings(const std::vector<CylinderRing>& rings, std::int32_t segment, int sides) {
    if (rings.empty()) return segment;
    parts_ += rings.size() * static_cast<std::size_t>(sides);
    if (shapes_.lines == LineStyle::pixel || is_round(rings, shapes_.contours))
      return add_stem(rings, segment);
    if (row_.rings.empty()) row_.segment = segment, row_.sides = sides;
    row_.rings.insert(row_.rings.end(), rings.begin() + (row_.rings.empty() ? 0 : 1), rings.end());
    return segment;
  }

  std::int32_t add_stem(const std::vector<CylinderRing>& rings, std::int32_t segment) {
    std::int32_t kept = std::exchange(turtle_.state.segment, segment);
    for (std::size_t i = 1; i < rings.size(); ++i)
      add_segment(rings[i - 1].position, rings[i].position, rings[i - 1].radius, rings[i].radius,
                  rings[i].color);
    return std::exchange(turtle_.state.segment, kept);
  }

  /// `@Gs`, `@Gc` and `@Ge`: the cylinder comes here from the control place before.
  void control(char kind, int strips) {
    std::int32_t before = kind == 's' ? -1 : state().place;
    ControlPlace here = control_place();
    if (before < 0 || row_.end != before) finish_row();
    if (before >= 0) {
      ControlPlace from = places_[static_cast<std::size_t>(before)];
      bool drawn = glm::distance(from.position, here.position) >= kShortest;
      here.segment = turtle_.state.segment =
          drawn ? add_piece(from, here, strips, from.segment) : from.segment;
      row_.end = static_cast<std::int32_t>(places_.size());
    }
    turtle_.state.place = kind == 'e' ? -1 : static_cast<std::int32_t>(places_.size());
    places_.push_back(here);
  }

  /// Draws the row of rings as skins of one colour each.
  void finish_row() {
    SkinRow row = std::exchange(row_, {});
    if (row.rings.size() < 2) return;
    Surface skin = skin_of(row.rings, shapes_.contours, row.sides);
    std::size_t across = skin.position.size() / row.rings.size();
    for (std::size_t first = 0, last = 1; first + 1 < row.rings.size(); first = last++) {
      while (last + 1 < row.rings.size() && row.rings[last + 1].color == row.rings[last].color) ++last;
      figure_.skins.push_back({part_of(skin, first * across, (last + 1) * across), row.rings[first].position,
                               row.rings[last].color, row.segment});
    }
  }

  /// The triangles of a skin whose vertices lie within a range.
  static Surface part_of(const Surface& skin, std::size_t first, std::size_t end) {
    auto cut = [&](const auto& all) { return std::vector(all.begin() + first, all.begin() + end); };
    Surface part{cut(skin.position), cut(skin.normal), {}, cut(skin.uv)};
    auto offset = static_cast<std::uint32_t>(first);
    for (const auto& [a, b, c] : skin.triangle)
      if (std::min({a, b, c}) >= first && std::max({a, b, c}) < end)
        part.triangle.push_back({a - offset, b - offset, c - offset});
    return part;
  }

  void place_surface(std::size_t at) {
    if (at >= turtle_.modules().size()) return;
    char symbol = turtle_.symbol(at);
    auto found = shapes_.surfaces.find(symbol);
    if (found == shapes_.surfaces.end()) return;
    std::span<const float> n = values(at);
    DVec3 factors(n.empty() ? 1 : n[0]);
    if (n.size() >= 3) factors = {n[0], n[1], n[2]};
    const CpfgTurtleState& s = state();
    figure_.placed.push_back(
        {symbol, s.position, s.heading, s.left, s.up, factors * state().scale, s.color, s.segment});
    figure_.surfaces.try_emplace(symbol, found->second.mesh);
    ++parts_;
  }

  /// What follows `@` and draws.
  void draw_special(std::size_t at) {
    char first = turtle_.symbol(at), second = '\0';
    if (first == '\0') return;
    bool pair = values(at).empty() && std::string_view("Gb").find(first) != std::string_view::npos;
    if (pair) second = turtle_.symbol(at + 1);
    if (pair && second == '\0') return;
    std::span<const float> n = values(at + (pair ? 1 : 0));
    double size = n.empty() ? radius() : std::abs(n[0]) * state().scale / 2;
    const CpfgTurtleState& s = state();
    DVec3 flat{s.position.x, s.position.y, 0}, forward{0, 0, 1};
    if (first == 'G' && (second == 's' || second == 'c' || second == 'e'))
      control(second, strips(values(at + 1)));
    if (first == 'O') figure_.spheres.push_back({s.position, DVec3(0), size, s.color, s.segment});
    if (first == 'o') figure_.discs.push_back({flat, forward, size, s.color, s.segment});
    if (first == 'c') figure_.discs.push_back({s.position, s.up, size, s.color, s.segment});
    if (first == 'b' && second == 'o') add_ring(flat, {1, 0, 0}, {0, 1, 0}, size, radius());
    if (first == 'b' && second == 'c') add_ring(s.position, s.heading, s.left, size, radius());
    ++parts_;
  }

  /// A circle as a line.
  void add_ring(DVec3 center, DVec3 across, DVec3 along, double size, double thickness) {
    CpfgTurtleState kept = turtle_.state;
    turtle_.state.segment = -1;
    auto corner = [&](int i) {
      double angle = 2 * kPi * i / kRingCorners;
      return center + across * (size * std::cos(angle)) + along * (size * std::sin(angle));
    };
    for (int i = 0; i < kRingCorners; ++i)
      add_segment(corner(i), corner(i + 1), thickness, thickness, state().color);
    turtle_.state = std::move(kept);
  }

  template <class Visit>
  void for_each_place(const Visit& visit) const {
    for (const CpfgSegment& s : figure_.segments) visit(s.from, s.radius_from), visit(s.to, s.radius_to);
    for (const CpfgPolygon& polygon : figure_.polygons)
      for (DVec3 p : polygon.points) visit(p, 0);
    for (const CpfgSkin& skin : figure_.skins)
      for (const Vec3& p : skin.mesh.position) visit(DVec3(p), 0);
    for (const CpfgRound& sphere : figure_.spheres) visit(sphere.center, sphere.radius);
    for (const CpfgRound& disc : figure_.discs) visit(disc.center, disc.radius);
    for (const CpfgPlaced& p : figure_.placed)
      for (const Vec3& at : figure_.surfaces.at(p.surface).position) visit(p.at(at), 0);
  }

  /// The box round all that is drawn; without the thickness of lines where that is not known yet.
  void set_box(bool thick) {
    bool first = true;
    for_each_place([&](DVec3 p, double size) {
      DVec3 reach(thick ? size : 0);
      figure_.low = first ? p - reach : glm::min(figure_.low, p - reach);
      figure_.high = first ? p + reach : glm::max(figure_.high, p + reach);
      first = false;
    });
  }

  /// Widths in pixels are those of a window that the figure fills.
  void widen_pixels() {
    set_box(false);
    DVec3 size = figure_.high - figure_.low;
    double pixel = std::max({size.x, size.y, size.z}) / kPixelsAcross;
    for (CpfgSegment& s : figure_.segments) s.radius_from *= pixel, s.radius_to *= pixel;
  }

  void finish() {
    set_box(true);
    figure_.colors = shapes_.colors;
    figure_.end = state().position;
    figure_.end_heading = state().heading, figure_.end_left = state().left, figure_.end_up = state().up;
  }

  const Shapes& shapes_;
  TurtleSettings settings_;
  CpfgTurtle turtle_;
  CpfgFigure figure_;
  std::vector<OpenOutline> outlines_;
  std::vector<ControlPlace> places_;
  SkinRow row_;
  std::int32_t tapering_ = -1;  ///< the line whose width at its end is not known yet
  std::size_t parts_ = 0;
};

}  // namespace

}  // namespace frond::cpfg

namespace frond {

Result<CpfgFigure> draw(const CpfgModel& model, const CpfgDrawing& drawing) {
  if (model.shapes->missing) return *model.shapes->missing;
  Result<CpfgFigure> figure = cpfg::FigureBuilder(model, drawing).draw();
  if (figure) return figure;
  return Error{model.files.grammar.string(), figure.errors()[0].what};
}

}  // namespace frond
