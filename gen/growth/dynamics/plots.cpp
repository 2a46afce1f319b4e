#include "dynamics/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/trees.h"

namespace frond {

namespace {

constexpr double kGapCell = 2;  // metres

/// Flat areas of cells that are open, joined over their sides, in cells.
std::vector<int> open_areas(const StandGrid& grid, std::vector<char>& open) {
  std::vector<int> areas;
  std::vector<std::size_t> front;
  for (std::size_t begin = 0; begin < open.size(); ++begin) {
    if (!open[begin]) continue;
    int area = 0;
    open[begin] = false, front = {begin};
    while (!front.empty()) {
      std::size_t cell = front.back();
      front.pop_back(), ++area;
      int column = static_cast<int>(cell) % grid.columns, row = static_cast<int>(cell) / grid.columns;
      auto reach = [&](int c, int r) {
        if (c < 0 || r < 0 || c >= grid.columns || r >= grid.rows || !open[grid.index(c, r)]) return;
        open[grid.index(c, r)] = false, front.push_back(grid.index(c, r));
      };
      reach(column - 1, row), reach(column + 1, row), reach(column, row - 1), reach(column, row + 1);
    }
    areas.push_back(area);
  }
  return areas;
}

constexpr const char* kTreeColors[] = {"#e3c24f", "#a9c86a", "#d4633f", "#96703f",
                                       "#d99a4e", "#4f9a56", "#1f5f5b", "#5b8fb0"};  // of TreeName
constexpr double kPanelWidth = 300, kPanelHeight = 270;

const char* color_of(const TreeSpecies& species) {
  return kTreeColors[static_cast<std::size_t>(species.name)];
}

/// A frame with axes from 0 or, where `log`, in decades; its values are those of x and y.
struct PlotPanel {
  double left = 0, top = 0;
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  bool log = false;

  static double scaled(double v, double low, double high, bool log) {
    return log ? (std::log10(v) - std::log10(low)) / (std::log10(high) - std::log10(low))
               : (v - low) / (high - low);
  }
  double x(double v) const { return left + kPanelWidth * scaled(v, x0, x1, log); }
  double y(double v) const { return top + kPanelHeight * (1 - scaled(v, y0, y1, log)); }
};

/// A step of 1, 2 or 5 times a power of ten that divides a range into about five.
double tick_step(double range) {
  double power = std::pow(10, std::floor(std::log10(range / 5))), part = range / 5 / power;
  return power * (part < 1.5 ? 1 : part < 3.5 ? 2 : part < 7.5 ? 5 : 10);
}

std::vector<double> ticks_of(double low, double high, bool log) {
  std::vector<double> ticks;
  if (log)
    for (double v = low; v < high * 1.001; v *= 10) ticks.push_back(v);
  else
    for (double v = low; v < high * 1.001; v += tick_step(high - low)) ticks.push_back(v);
  return ticks;
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

/// The figures of each fifth year, from 5 on.
std::vector<std::pair<int, StandFigures>> all_figures(const StandHistory& history) {
  std::vector<std::pair<int, StandFigures>> all;
  for (int year = 5; year <= history.years; year += 5) all.emplace_back(year, figures_at(history, year));
  return all;
}

using YearFigures = std::vector<std::pair<int, StandFigures>>;

std::string basal_svg(PlotPanel p, const StandHistory& history, const YearFigures& all) {
  p.x1 = history.years, p.y1 = 10;
  for (const auto& [year, f] : all) {
    double sum = 0;
    for (double area : f.basal_area) sum += area;
    p.y1 = std::max(p.y1, std::ceil(sum / 10) * 10);
  }
  std::string out;
  std::vector<double> below(all.size(), 0);
  for (std::size_t s = 0; s < history.species.size(); ++s) {
    std::vector<std::pair<double, double>> outline{{0, 0}};
    std::vector<double> above = below;
    for (std::size_t i = 0; i < all.size(); ++i) {
      above[i] += all[i].second.basal_area[s];
      outline.emplace_back(all[i].first, above[i]);
    }
    for (std::size_t i = all.size(); i-- > 0;) outline.emplace_back(all[i].first, below[i]);
    out += polyline_svg(p, outline, fmt::format("fill=\"{}\"", color_of(history.species[s])));
    below = above;
  }
  return out + frame_svg(p, "Basal area by species", "year", "m2 a hectare");
}

std::string thinning_svg(PlotPanel p, const YearFigures& all) {
  p.log = true, p.x0 = 100, p.x1 = 10000, p.y0 = 1, p.y1 = 1000;
  auto inside = [&](double n, double mass) { return n >= p.x0 && n <= p.x1 && mass >= p.y0 && mass <= p.y1; };
  std::vector<std::pair<double, double>> course;
  double line = 0;  // mass * density^1.5, the greatest
  for (const auto& [year, f] : all) {
    if (inside(f.density, f.mean_mass)) course.emplace_back(f.density, f.mean_mass);
    line = std::max(line, f.mean_mass * std::pow(f.density, 1.5));
  }
  std::string out = frame_svg(p, "Self-thinning", "trees a hectare", "mean stem, kg");
  double low = std::max(p.x0, std::pow(line / p.y1, 2 / 3.0)),
         high = std::min(p.x1, std::pow(line / p.y0, 2 / 3.0));
  if (low < high)
    out += polyline_svg(p, {{low, line * std::pow(low, -1.5)}, {high, line * std::pow(high, -1.5)}},
                        "fill=\"none\" stroke=\"#999\" stroke-dasharray=\"5 4\"");
  out += polyline_svg(p, course, "fill=\"none\" stroke=\"#3a6f8f\" stroke-width=\"2\"");
  for (const auto& [n, mass] : course)
    out +=
        fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.4\" fill=\"#3a6f8f\"/>\n", p.x(n), p.y(mass));
  return out + fmt::format("<text class=\"y\" x=\"{:.1f}\" y=\"{:.1f}\">dashed: slope -3/2</text>\n",
                           p.left + kPanelWidth - 6, p.top + 16);
}

/// Bars of classes of a width, which begin at 0.
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

/// How many gaps are larger than an area, over the area.
std::string gaps_svg(PlotPanel p, const std::vector<double>& gaps) {
  p.log = true, p.x0 = 1, p.x1 = 10000, p.y0 = 1, p.y1 = 1000;
  std::string out = frame_svg(p, "Gaps in the canopy", "m2 and more", "number");
  for (std::size_t i = 0; i < gaps.size(); ++i)
    if (gaps[i] <= p.x1 && static_cast<double>(i + 1) <= p.y1)
      out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"2.4\" fill=\"#b0663a\"/>\n", p.x(gaps[i]),
                         p.y(static_cast<double>(i + 1)));
  return out;
}

std::string map_svg(double left, double top, const StandHistory& history, double year) {
  auto wide = static_cast<double>(history.area.x), deep = static_cast<double>(history.area.y);
  double scale = kPanelWidth / std::max(wide, deep);
  std::string out = fmt::format(
      "<text class=\"title\" x=\"{:.1f}\" y=\"{:.1f}\">Map, {:g} x {:g} m</text>\n<g "
      "transform=\"translate({:.2f} {:.2f}) scale({:.4f})\" clip-path=\"url(#land)\">\n<clipPath "
      "id=\"land\"><rect x=\"{:g}\" y=\"{:g}\" width=\"{:g}\" height=\"{:g}\"/></clipPath>\n<rect x=\"{:g}\" "
      "y=\"{:g}\" width=\"{:g}\" height=\"{:g}\" fill=\"#f3eee2\"/>\n",
      left, top - 14, wide, deep, left + kPanelWidth / 2, top + scale * deep / 2, scale, -wide / 2, -deep / 2,
      wide, deep, -wide / 2, -deep / 2, wide, deep);
  std::vector<std::pair<TreeSize, std::uint32_t>> trees;
  for (std::uint32_t i : living_at(history, year))
    if (TreeSize size = size_at(history, i, year); size.height > 3) trees.emplace_back(size, i);
  std::ranges::stable_sort(trees, {}, [](const auto& tree) { return tree.first.height; });
  out += "<g stroke=\"#0003\" stroke-width=\"0.2\">\n";
  for (const auto& [size, i] : trees)
    out += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{:.2f}\" fill=\"{}\"/>\n", history.lives[i].x,
                       history.lives[i].z, size.crown_radius,
                       color_of(history.species[history.lives[i].species]));
  out += "</g>\n<g stroke=\"#4a3526\">\n";
  for (const Deadwood& dead : deadwood_at(history, year)) {
    const TreeLife& life = history.lives[dead.life];
    TreeSize size = size_at(history, dead.life, year);
    if (!dead.lies || size.diameter < 0.2f) continue;
    float length = size.height - life.broken;
    out +=
        fmt::format("<path d=\"M{:.1f} {:.1f}l{:.1f} {:.1f}\" stroke-width=\"{:.2f}\" opacity=\"{:.2f}\"/>\n",
                    life.x, life.z, length * std::sin(life.azimuth), length * std::cos(life.azimuth),
                    size.diameter, 1 - 0.7f * dead.decay);
  }
  return out + "</g>\n</g>\n";
}

std::string legend_svg(const StandHistory& history, double x, double y) {
  std::string out;
  for (const TreeSpecies& species : history.species) {
    out += fmt::format(
        "<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"13\" height=\"13\" fill=\"{}\"/><text x=\"{:.1f}\" "
        "y=\"{:.1f}\">{}</text>\n",
        x, y - 11, color_of(species), x + 18, y, name_of(species.name));
    x += 76;
  }
  return out;
}

}  // namespace

std::vector<double> gaps_at(const StandHistory& history, double year) {
  StandGrid grid = grid_of(history.area, kGapCell);
  std::vector<TreeSize> sizes;
  std::vector<float> heights;
  std::vector<std::uint32_t> living = living_at(history, year);
  for (std::uint32_t i : living) {
    sizes.push_back(size_at(history, i, year));
    if (sizes.back().diameter > 0.1f) heights.push_back(sizes.back().height);
  }
  std::ranges::sort(heights);
  float high = heights.empty() ? 0 : heights[heights.size() * 95 / 100] / 2;
  std::vector<char> open(grid.size(), true);
  for (std::size_t n = 0; n < living.size(); ++n) {
    if (sizes[n].height < std::max(high, 3.0f)) continue;
    const TreeLife& life = history.lives[living[n]];
    auto x = static_cast<double>(life.x), z = static_cast<double>(life.z),
         radius = static_cast<double>(sizes[n].crown_radius);
    for (int row = grid.row(z - radius); row <= grid.row(z + radius); ++row)
      for (int column = grid.column(x - radius); column <= grid.column(x + radius); ++column) {
        double dx = grid.low_x + (column + 0.5) * kGapCell - x, dz = grid.low_z + (row + 0.5) * kGapCell - z;
        if (dx * dx + dz * dz <= radius * radius) open[grid.index(column, row)] = false;
      }
  }
  std::vector<double> gaps;
  for (int cells : open_areas(grid, open))
    if (cells > 1) gaps.push_back(cells * kGapCell * kGapCell);
  std::ranges::sort(gaps, std::greater());
  return gaps;
}

StandFigures figures_at(const StandHistory& history, double year) {
  StandFigures figures;
  double hectares = static_cast<double>(history.area.x * history.area.y) / 1e4;
  figures.basal_area.assign(history.species.size(), 0);
  int count = 0;
  auto add = [](std::vector<int>& classes, double at) {
    auto c = static_cast<std::size_t>(std::max(at, 0.0));
    if (classes.size() <= c) classes.resize(c + 1);
    ++classes[c];
  };
  for (std::uint32_t i : living_at(history, year)) {
    const TreeLife& life = history.lives[i];
    TreeSize size = size_at(history, i, year);
    auto diameter = static_cast<double>(size.diameter);
    if (size.height < 1.3f) continue;
    ++count;
    figures.mean_mass += stem_mass(history.species[life.species], size);
    figures.basal_area[life.species] += kPi / 4 * diameter * diameter / hectares;
    add(figures.diameters, diameter / 0.05);
    add(figures.ages, (year - static_cast<double>(life.born)) / 10);
  }
  figures.density = count / hectares;
  figures.mean_mass /= std::max(count, 1);
  figures.gaps = gaps_at(history, year);
  return figures;
}

std::string stand_svg(const StandHistory& history, double year) {
  YearFigures all = all_figures(history);
  StandFigures now = figures_at(history, year);
  auto panel = [](int column, int row) {
    return PlotPanel{.left = 80.0 + 400 * column, .top = 96.0 + 370 * row};
  };
  std::vector<double> diameters(now.diameters.begin(), now.diameters.end()),
      ages(now.ages.begin(), now.ages.end());
  for (double& count : diameters) count *= 1e4 / static_cast<double>(history.area.x * history.area.y);
  for (double& count : ages) count *= 1e4 / static_cast<double>(history.area.x * history.area.y);
  PlotPanel map = panel(2, 0);
  return fmt::format(
             "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1210 800\" font-family=\"sans-serif\" "
             "font-size=\"13\" "
             "fill=\"#333\">\n<style>.title{{font-size:16px;font-weight:bold}}.grid{{stroke:#0002;fill:none}}"
             ".x{{text-anchor:middle}}.y{{text-anchor:end}}</style>\n<rect width=\"1210\" height=\"800\" "
             "fill=\"#fff\"/>\n<text x=\"80\" y=\"46\" font-size=\"20\">The stand in year {:g}: {:.0f} trees "
             "a hectare</text>\n",
             year, now.density) +
         legend_svg(history, 570, 45) + basal_svg(panel(0, 0), history, all) +
         thinning_svg(panel(1, 0), all) + map_svg(map.left, map.top, history, year) +
         bars_svg(panel(0, 1), diameters, 5, "Diameters", "cm at breast height", "trees a hectare") +
         bars_svg(panel(1, 1), ages, 10, "Ages", "years", "trees a hectare") +
         gaps_svg(panel(2, 1), now.gaps) + "</svg>\n";
}

std::string stand_csv(const StandHistory& history) {
  std::string out = "year,density,mean_mass";
  for (const TreeSpecies& species : history.species) out += fmt::format(",{}", name_of(species.name));
  out += ",gaps,gap_area\n";
  for (const auto& [year, f] : all_figures(history)) {
    double area = 0;
    for (double gap : f.gaps) area += gap;
    out += fmt::format("{},{:.1f},{:.2f}", year, f.density, f.mean_mass);
    for (double basal : f.basal_area) out += fmt::format(",{:.3f}", basal);
    out += fmt::format(",{},{:g}\n", f.gaps.size(), area);
  }
  return out;
}

}  // namespace frond
