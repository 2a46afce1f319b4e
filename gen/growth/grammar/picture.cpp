#include "grammar/picture.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/printable.h"
#include "core/text.h"
#include "grammar/between.h"
#include "grammar/figure.h"
#include "model/model.h"

namespace frond {

namespace {

constexpr std::size_t kMostModules = 2000;

struct Node {
  std::string label;
  std::ptrdiff_t parent = -1;
  double x = 0;
};

using Row = std::vector<Node>;

Row row_of(const Grammar& grammar, const Word& word, const std::vector<std::uint32_t>& parents) {
  Row row;
  const double* parameters = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    Word module;
    int arity = grammar.symbols[word.symbols[i]].arity;
    module.symbols.push_back(word.symbols[i]);
    module.parameters.assign(parameters, parameters + arity);
    parameters += arity;
    row.push_back({text(grammar, module), parents.empty() ? -1 : static_cast<std::ptrdiff_t>(parents[i]), 0});
  }
  return row;
}

double width_of(const Node& node) {
  // A letter is about 7 wide; UTF-8 continuation bytes are no letters.
  auto letters =
      std::count_if(node.label.begin(), node.label.end(), [](char c) { return (c & 0xC0) != 0x80; });
  return 12.0 + 7.0 * static_cast<double>(letters);
}

/// Places the last row side by side and every parent above the middle of its children, then pushes apart what
/// overlaps. Modules without children keep their order between their neighbours.
double place(std::vector<Row>& rows) {
  double width = 0;
  for (std::size_t level = rows.size(); level-- > 0;) {
    Row& row = rows[level];
    std::vector<double> low(row.size(), 1e30), high(row.size(), -1e30);
    if (level + 1 < rows.size()) {
      for (const Node& child : rows[level + 1]) {
        auto parent = static_cast<std::size_t>(child.parent);
        low[parent] = std::min(low[parent], child.x);
        high[parent] = std::max(high[parent], child.x);
      }
    }
    double edge = 0;
    for (std::size_t i = 0; i < row.size(); ++i) {
      double half = width_of(row[i]) / 2;
      double wish = high[i] >= low[i] ? (low[i] + high[i]) / 2 : 0;
      row[i].x = std::max(wish, edge + half);
      edge = row[i].x + half;
    }
    width = std::max(width, edge);
  }
  return width;
}

std::string hundredths(double number) { return number_text(number, 2); }

std::string draw_rows(const std::vector<Row>& rows, double width) {
  constexpr double kRow = 56, kTop = 28;
  double height = kTop * 2 + kRow * static_cast<double>(rows.size() - 1);
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0} {1}\" width=\"{0}\" height=\"{1}\">\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"#fff\"/>\n<g stroke=\"#7a8f6a\" stroke-width=\"1\" "
      "fill=\"none\">\n",
      hundredths(width + 56), hundredths(height));
  for (std::size_t level = 1; level < rows.size(); ++level) {
    for (const Node& node : rows[level]) {
      const Node& parent = rows[level - 1][static_cast<std::size_t>(node.parent)];
      double y = kTop + kRow * static_cast<double>(level);
      out += fmt::format("<line x1=\"{}\" y1=\"{}\" x2=\"{}\" y2=\"{}\"/>\n", hundredths(parent.x + 48),
                         hundredths(y - kRow + 8), hundredths(node.x + 48), hundredths(y - 14));
    }
  }
  out += "</g>\n<g font-family=\"monospace\" font-size=\"12\" text-anchor=\"middle\" fill=\"#233\">\n";
  for (std::size_t level = 0; level < rows.size(); ++level) {
    double y = kTop + kRow * static_cast<double>(level);
    out += fmt::format("<text x=\"18\" y=\"{}\" fill=\"#99a\">{}</text>\n", static_cast<int>(y), level);
    for (const Node& node : rows[level])
      out += fmt::format("<text x=\"{}\" y=\"{}\">{}</text>\n", hundredths(node.x + 48), hundredths(y),
                         xml_quoted(node.label));
  }
  return out + "</g>\n</svg>\n";
}

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

Result<std::string> derivation_tree_svg(const Grammar& grammar, int steps, Seed seed) {
  std::vector<Row> rows;
  Derivation state = begin(grammar, seed);
  std::vector<std::uint32_t> parents;
  for (int step = 0;; ++step) {
    if (state.word.size() > kMostModules)
      return error_at("",
                      "the word has {} modules after {} steps; a derivation tree is drawn for {} at most: "
                      "use fewer steps",
                      state.word.size(), step, kMostModules);
    rows.push_back(row_of(grammar, state.word, parents));
    if (step == steps) break;
    Errors errors = advance_tracked(grammar, state, seed, parents, grammar.text.limits);
    if (!errors.empty()) return errors;
  }
  double width = place(rows);
  return draw_rows(rows, width);
}

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
  std::string out = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\">\n<rect width=\"100%\" "
      "height=\"100%\" fill=\"#fff\"/>\n<g stroke-linecap=\"round\" fill=\"none\">\n",
      number_text(width, 3), number_text(height, 3));
  for (std::size_t i = 0; i < canvas.lines.size();) {
    // Lines that join and look alike share one path.
    const TurtleDrawing::Stroke& first = canvas.lines[i];
    double stroke = std::clamp(first.width * scale, 0.5, 60.0);
    out += fmt::format("<path stroke=\"{}\" stroke-width=\"{}\" d=\"", color_of(first.color),
                       number_text(stroke, 3));
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
    out += fmt::format("<polygon fill=\"{}\" points=\"", color_of(fill.color));
    for (DVec3 p : fill.points)
      put_thousandths(out, x(p)), out += ',', put_thousandths(out, y(p)), out += ' ';
    out += "\"/>\n";
  }
  for (const TurtleDrawing::Ball& ball : canvas.balls)
    out += fmt::format("<circle fill=\"{}\" cx=\"{}\" cy=\"{}\" r=\"{}\"/>\n", color_of(ball.color),
                       number_text(x(ball.center), 3), number_text(y(ball.center), 3),
                       number_text(ball.radius * scale, 3));
  return out + "</g>\n</svg>\n";
}

}  // namespace frond
