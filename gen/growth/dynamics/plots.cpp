#include "dynamics/plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/plot_panel.h"
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
const char* color_of(const TreeSpecies& species) {
  return kTreeColors[static_cast<std::size_t>(species.name)];
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
  std::vector<int> years;
  std::vector<std::vector<double>> areas(history.species.size());
  std::vector<std::string_view> colors;
  for (const auto& [year, f] : all) {
    years.push_back(year);
    for (std::size_t s = 0; s < areas.size(); ++s) areas[s].push_back(f.basal_area[s]);
  }
  for (const TreeSpecies& species : history.species) colors.emplace_back(color_of(species));
  return stack_svg(p, years, areas, colors) + frame_svg(p, "Basal area by species", "year", "m2 a hectare");
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

std::string map_svg(const PlotPanel& p, const StandHistory& history, double year) {
  std::vector<std::pair<TreeSize, std::uint32_t>> trees;
  for (std::uint32_t i : living_at(history, year))
    if (TreeSize size = size_at(history, i, year); size.height > 3) trees.emplace_back(size, i);
  std::ranges::stable_sort(trees, {}, [](const auto& tree) { return tree.first.height; });
  std::string out = "<g stroke=\"#0003\" stroke-width=\"0.2\">\n";
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
  return map_frame_svg(p, history.area, "#f3eee2", out + "</g>\n");
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
  std::vector<double> diameters(now.diameters.begin(), now.diameters.end()),
      ages(now.ages.begin(), now.ages.end());
  for (double& count : diameters) count *= 1e4 / static_cast<double>(history.area.x * history.area.y);
  for (double& count : ages) count *= 1e4 / static_cast<double>(history.area.x * history.area.y);
  std::vector<std::pair<std::string_view, std::string_view>> legend;
  for (const TreeSpecies& species : history.species)
    legend.emplace_back(name_of(species.name), color_of(species));
  return sheet_svg(
      fmt::format("The stand in year {:g}: {:.0f} trees a hectare", year, now.density),
      legend_svg(legend, 570, 45, 76) + basal_svg(panel_at(0, 0), history, all) +
          thinning_svg(panel_at(1, 0), all) + map_svg(panel_at(2, 0), history, year) +
          bars_svg(panel_at(0, 1), diameters, 5, "Diameters", "cm at breast height", "trees a hectare") +
          bars_svg(panel_at(1, 1), ages, 10, "Ages", "years", "trees a hectare") +
          gaps_svg(panel_at(2, 1), now.gaps));
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
