#include <algorithm>

#include "core/text.h"
#include "grammar/between.h"
#include "grammar/figure.h"
#include "grammar/picture.h"
#include "model/model.h"

namespace frond {

namespace {

const std::vector<std::string> kColors{"#4a6b35", "#6f9a3e", "#8fbf4d", "#c9b458",
                                       "#b3763c", "#a8455a", "#7a5a9e", "#3f7d9a"};

/// Keeps what is drawn.
struct Canvas : TurtleDrawing {
  double wrong = 0;  ///< not finite as soon as a place is not

  void reach(DVec3 p) { low = glm::min(low, p), high = glm::max(high, p), wrong += (p.x + p.y + p.z) * 0; }
  void segment(const Segment& s, TurtleState& state) {
    lines.push_back({s.from, s.to, (s.width_from + s.width_to) / 2, state.color});
    wrong += lines.back().width * 0;
    reach(s.from), reach(s.to);
  }
  void polygon(std::span<const DVec3> points, const TurtleState& state) {
    fills.push_back({{points.begin(), points.end()}, state.color + 1});
    for (DVec3 p : points) reach(p);
  }
  void sign(Act act, std::span<const double> parameters, const TurtleState& state) {
    if (act != Act::sphere && act != Act::disc) return;
    double radius = (parameters.empty() ? state.width : parameters[0]) / 2;
    balls.push_back({state.position, radius, state.color});
    wrong += radius * 0;
    reach(state.position - radius), reach(state.position + radius);
  }
};

void put_thousandths(std::string& out, double number) { append(out, number, 3); }

}  // namespace

Result<std::string> turtle_svg(const Grammar& grammar, double steps, Seed seed, const Limits& limits) {
  Canvas canvas;
  Result<TurtleState> end = draw_between(grammar, steps, seed, canvas, limits);
  if (!end) return end.errors();
  DVec3 size = canvas.low.x > canvas.high.x ? DVec3(0) : canvas.high - canvas.low;
  if (!std::isfinite(std::max(size.x, size.y) + canvas.wrong)) return out_of_range();
  canvas.colors = kColors;
  return svg_of(canvas);
}

std::string svg_of(const TurtleDrawing& canvas) {
  auto color_of = [&](int index) {
    return canvas.colors[frond::color_index(std::int32_t{index}, canvas.colors.size())];
  };
  DVec3 low = canvas.low, high = canvas.high;
  if (low.x > high.x) low = high = DVec3(0);
  // The picture is 1000 units along its longer side, whatever the plant measures.
  double size = std::max({high.x - low.x, high.y - low.y, 1e-9}), scale = 1000 / size;
  auto x = [&](DVec3 p) { return (p.x - low.x) * scale + 20; };
  auto y = [&](DVec3 p) { return (high.y - p.y) * scale + 20; };
  double width = (high.x - low.x) * scale + 40, height = (high.y - low.y) * scale + 40;
  std::string out = "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 ";
  put_thousandths(out, width), out += ' ', put_thousandths(out, height);
  out +=
      "\">\n<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke-linecap=\"round\" "
      "fill=\"none\">\n";
  for (std::size_t i = 0; i < canvas.lines.size();) {
    // Lines that join and look alike share one path.
    const TurtleDrawing::Stroke& first = canvas.lines[i];
    double stroke = std::clamp(first.width * scale, 0.5, 60.0);
    out += "<path stroke=\"", out += color_of(first.color), out += "\" stroke-width=\"",
        put_thousandths(out, stroke), out += "\" d=\"";
    DVec3 pen(1e300);
    for (; i < canvas.lines.size(); ++i) {
      const TurtleDrawing::Stroke& line = canvas.lines[i];
      if (line.color != first.color || line.width != first.width) break;
      if (line.from != pen)
        out += 'M', put_thousandths(out, x(line.from)), out += ' ', put_thousandths(out, y(line.from));
      out += 'L', put_thousandths(out, x(line.to)), out += ' ', put_thousandths(out, y(line.to));
      pen = line.to;
    }
    out += "\"/>\n";
  }
  out += "</g>\n<g>\n";
  for (const TurtleDrawing::Fill& fill : canvas.fills) {
    out += "<polygon fill=\"", out += color_of(fill.color), out += "\" points=\"";
    for (DVec3 p : fill.points)
      put_thousandths(out, x(p)), out += ',', put_thousandths(out, y(p)), out += ' ';
    out += "\"/>\n";
  }
  for (const TurtleDrawing::Ball& ball : canvas.balls) {
    out += "<circle fill=\"", out += color_of(ball.color), out += "\" cx=\"",
        put_thousandths(out, x(ball.center));
    out += "\" cy=\"", put_thousandths(out, y(ball.center)), out += "\" r=\"",
        put_thousandths(out, ball.radius * scale), out += "\"/>\n";
  }
  return out + "</g>\n</svg>\n";
}

}  // namespace frond
