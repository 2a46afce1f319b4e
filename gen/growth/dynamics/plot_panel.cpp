#include "dynamics/plot_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

double scaled(double v, double low, double high, bool log) {
  return log ? (std::log10(v) - std::log10(low)) / (std::log10(high) - std::log10(low))
             : (v - low) / (high - low);
}

std::vector<double> ticks_of(double low, double high, bool log) {
  std::vector<double> ticks;
  if (log)
    for (double v = low; v < high * 1.001; v *= 10) ticks.push_back(v);
  else
    for (double v = low; v < high * 1.001; v += tick_step(high - low)) ticks.push_back(v);
  return ticks;
}

}  // namespace

double PlotPanel::x(double v) const { return left + kPanelWidth * scaled(v, x0, x1, log); }

double PlotPanel::y(double v) const { return top + kPanelHeight * (1 - scaled(v, y0, y1, log)); }

PlotPanel panel_at(int column, int row) { return {.left = 80.0 + 400 * column, .top = 96.0 + 370 * row}; }

std::string sheet_svg(std::string_view title, std::string_view content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1210 800\" font-family=\"sans-serif\" "
      "font-size=\"13\" "
      "fill=\"#333\">\n<style>.title{{font-size:16px;font-weight:bold}}.grid{{stroke:#0002;fill:none}}"
      ".x{{text-anchor:middle}}.y{{text-anchor:end}}</style>\n<rect width=\"1210\" height=\"800\" "
      "fill=\"#fff\"/>\n<text x=\"80\" y=\"46\" font-size=\"20\">{}</text>\n{}</svg>\n",
      title, content);
}

double tick_step(double range) {
  double power = std::pow(10, std::floor(std::log10(range / 5))), part = range / 5 / power;
  return power * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

std::string frame_svg(const PlotPanel& p, std::string_view title, std::string_view below,
                      std::string_view beside) {
  std::string out =
      fmt::format("<text class=\"title\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", p.left, p.top - 14, title);
  for (double v : ticks_of(p.x0, p.x1, p.log))
    out += fmt::format("<text class=\"x\" x=\"{:.1f}\" y=\"{:.1f}\">{:g}</text>\n", p.x(v),
                       p.top + kPanelHeight + 17, v);
  for (double v : ticks_of(p.y0, p.y1, p.log))
    out += fmt::format(
        "<path class=\"grid\" d=\"M{:.1f} {:.1f}h{:g}\"/><text class=\"y\" x=\"{:.1f}\" "
        "y=\"{:.1f}\">{:g}</text>\n",
        p.left, p.y(v), kPanelWidth, p.left - 7, p.y(v) + 4, v);
  return out + fmt::format(
                   "<text class=\"x\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n<text class=\"x\" "
                   "transform=\"translate({:.1f} {:.1f}) rotate(-90)\">{}</text>\n",
                   p.left + kPanelWidth / 2, p.top + kPanelHeight + 36, below, p.left - 46,
                   p.top + kPanelHeight / 2, beside);
}

std::string polyline_svg(const PlotPanel& p, const std::vector<std::pair<double, double>>& points,
                         std::string_view style) {
  std::string out = fmt::format("<path {} d=\"", style);
  for (std::size_t i = 0; i < points.size(); ++i)
    out += fmt::format("{}{:.1f} {:.1f}", i ? "L" : "M", p.x(points[i].first), p.y(points[i].second));
  return out + "\"/>\n";
}

std::string stack_svg(const PlotPanel& p, const std::vector<int>& years,
                      const std::vector<std::vector<double>>& values,
                      const std::vector<std::string_view>& colors) {
  std::string out;
  std::vector<double> below(years.size(), 0);
  for (std::size_t s = 0; s < values.size(); ++s) {
    std::vector<std::pair<double, double>> outline{{0, 0}};
    std::vector<double> above = below;
    for (std::size_t i = 0; i < years.size(); ++i) {
      above[i] += values[s][i];
      outline.emplace_back(years[i], above[i]);
    }
    for (std::size_t i = years.size(); i-- > 0;) outline.emplace_back(years[i], below[i]);
    out += polyline_svg(p, outline, fmt::format("fill=\"{}\"", colors[s]));
    below = above;
  }
  return out;
}

std::string bars_svg(PlotPanel p, const std::vector<double>& counts, double width, std::string_view title,
                     std::string_view below, std::string_view beside) {
  p.x1 = std::max(width * static_cast<double>(counts.size()), width);
  double most = counts.empty() ? 1 : std::max(*std::ranges::max_element(counts), 1.0);
  double step = tick_step(most);
  p.y1 = std::ceil(most / step) * step;
  std::string out = frame_svg(p, title, below, beside);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    double x = width * static_cast<double>(i);
    out +=
        fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\" fill=\"#6f9a68\"/>\n",
                    p.x(x) + 0.5, p.y(counts[i]), p.x(x + width) - p.x(x) - 1, p.y(0) - p.y(counts[i]));
  }
  return out;
}

std::string legend_svg(const std::vector<std::pair<std::string_view, std::string_view>>& names_and_colors,
                       double x, double y, double step, std::size_t across) {
  std::string out;
  for (std::size_t i = 0; i < names_and_colors.size(); ++i) {
    const auto& [name, color] = names_and_colors[i];
    double left = x + step * static_cast<double>(i % across), foot = y + 20 * static_cast<double>(i / across);
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"13\" height=\"13\" fill=\"{}\"/><text x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        left, foot - 11, color, left + 18, foot, name);
  }
  return out;
}

std::string map_frame_svg(const PlotPanel& p, Vec2 area, std::string_view ground, std::string_view content) {
  auto wide = static_cast<double>(area.x), deep = static_cast<double>(area.y);
  double scale = kPanelWidth / std::max(wide, deep);
  return fmt::format(
      "<text class=\"title\" x=\"{:.1f}\" y=\"{:.1f}\">Map, {:g} x {:g} m</text>\n<g "
      "transform=\"translate({:.2f} {:.2f}) scale({:.4f})\" clip-path=\"url(#land)\">\n<clipPath "
      "id=\"land\"><rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\"/></clipPath>\n<rect x=\"{:g}\" "
      "y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" fill=\"{}\"/>\n{}</g>\n",
      p.left, p.top - 14, wide, deep, p.left + kPanelWidth / 2, p.top + scale * deep / 2, scale, -wide / 2,
      -deep / 2, wide, deep, -wide / 2, -deep / 2, wide, deep, ground, content);
}

}  // namespace frond
