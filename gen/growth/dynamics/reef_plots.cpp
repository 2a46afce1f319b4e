#include "dynamics/reef_plots.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "dynamics/plot_panel.h"

namespace frond {

namespace {

constexpr const char* kColonyColors[] = {"#4f8fb8", "#e0a43c", "#d9698f", "#8a6fb5", "#5b9a5f",
                                         "#b0633f", "#4bb3a6", "#c9b458", "#8c8c8c"};  // of ColonyName

std::string_view color_of(const ColonySpecies& species) {
  return kColonyColors[static_cast<std::size_t>(species.name)];
}

std::vector<int> years_of(const ReefHistory& history) {
  std::vector<int> years;
  for (int year = 0; year <= history.years; ++year) years.push_back(year);
  return years;
}

/// A line of one figure over the years.
std::string course_svg(const PlotPanel& p, const ReefHistory& history, double factor,
                       double (*figure)(const ReefYear&), std::string_view color) {
  std::vector<std::pair<double, double>> points;
  for (int year = 0; year <= history.years; ++year)
    points.emplace_back(year, factor * figure(history.course[static_cast<std::size_t>(year)]));
  return polyline_svg(p, points, fmt::format("fill=\"none\" stroke=\"{}\" stroke-width=\"2\"", color));
}

/// When storms and heat waves came.
std::string events_svg(const PlotPanel& p, const ReefHistory& history) {
  std::string out;
  for (const ReefEvent& event : history.events)
    for (auto [strength, color] : {std::pair(event.storm, "#3a6f8f"), std::pair(event.heat, "#c0392b")})
      if (strength > 0 && event.year <= history.years)
        out += polyline_svg(p, {{event.year, p.y0}, {event.year, p.y1}},
                            fmt::format("stroke=\"{}\" stroke-dasharray=\"3 3\"", color));
  return out;
}

std::string cover_svg(PlotPanel p, const ReefHistory& history) {
  p.x1 = history.years, p.y1 = 100;
  std::vector<std::vector<double>> cover(history.species.size());
  std::vector<std::string_view> colors;
  for (const ReefYear& year : history.course)
    for (std::size_t s = 0; s < cover.size(); ++s) cover[s].push_back(100 * year.cover[s]);
  for (const ColonySpecies& species : history.species) colors.push_back(color_of(species));
  return stack_svg(p, years_of(history), cover, colors) + events_svg(p, history) +
         frame_svg(p, "Cover by species", "year; red: heat, blue: storm", "% of the floor");
}

std::string floor_svg(PlotPanel p, const ReefHistory& history) {
  p.x1 = history.years, p.y1 = 100;
  const std::vector<std::pair<std::string_view, std::string_view>> names{
      {"macroalgae", "#4d7c2a"}, {"coralline", "#c56b8c"}, {"turf", "#9c9a5a"}, {"rubble", "#777777"}};
  return course_svg(
             p, history, 100, [](const ReefYear& y) { return y.macroalgae; }, names[0].second) +
         course_svg(
             p, history, 100, [](const ReefYear& y) { return y.coralline; }, names[1].second) +
         course_svg(
             p, history, 100, [](const ReefYear& y) { return y.turf; }, names[2].second) +
         course_svg(
             p, history, 100, [](const ReefYear& y) { return y.rubble; }, names[3].second) +
         frame_svg(p, "Ground between them", "year", "% of the floor") +
         legend_svg(names, p.left + 100, p.top + 24, 100, 2);
}

std::string count_svg(PlotPanel p, const ReefHistory& history) {
  double most = 1;
  for (const ReefYear& year : history.course) most = std::max(most, year.colonies);
  p.x1 = history.years, p.y1 = std::ceil(most / tick_step(most)) * tick_step(most);
  return course_svg(
             p, history, 1, [](const ReefYear& y) { return y.colonies; }, "#3a6f8f") +
         frame_svg(p, "Colonies of 5 cm and more", "year", "on a m2");
}

std::string rugosity_svg(PlotPanel p, const ReefHistory& history) {
  p.x1 = history.years, p.y0 = 1, p.y1 = 1.5;
  for (const ReefYear& year : history.course) p.y1 = std::max(p.y1, std::ceil(2 * year.rugosity) / 2);
  return course_svg(
             p, history, 1, [](const ReefYear& y) { return y.rugosity; }, "#8a6fb5") +
         frame_svg(p, "Rugosity", "year", "length over the surface");
}

std::string sizes_svg(const PlotPanel& p, const ReefHistory& history, double year) {
  std::vector<double> counts;
  double ground = static_cast<double>(history.area.x) * static_cast<double>(history.area.y);
  for (std::uint32_t i : living_at(history, year)) {
    auto c = static_cast<std::size_t>(20 * static_cast<double>(size_at(history, i, year).radius));
    if (counts.size() <= c) counts.resize(c + 1);
    counts[c] += 1 / ground;
  }
  return bars_svg(p, counts, 10, "Diameters", "cm", "colonies on a m2");
}

std::string map_svg(const PlotPanel& p, const ReefHistory& history, double year) {
  std::vector<std::pair<ColonySize, std::uint32_t>> colonies;
  for (std::uint32_t i : living_at(history, year)) colonies.emplace_back(size_at(history, i, year), i);
  std::ranges::stable_sort(colonies, {}, [](const auto& colony) { return colony.first.height; });
  std::string out = "<g stroke=\"#0006\" stroke-width=\"0.01\">\n";
  for (const auto& [size, i] : colonies) {
    const ColonyLife& life = history.lives[i];
    out += fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"{:.3f}\" fill=\"{}\"/>\n", life.x, life.z,
                       size.radius, color_of(history.species[life.species]));
  }
  return map_frame_svg(p, history.area, "#e9e2cf", out + "</g>\n");
}

}  // namespace

std::string reef_svg(const ReefHistory& history, double year) {
  const ReefYear& now = history.course[static_cast<std::size_t>(std::lround(year))];
  std::vector<std::pair<std::string_view, std::string_view>> legend;
  for (const ColonySpecies& species : history.species)
    legend.emplace_back(name_of(species.name), color_of(species));
  return sheet_svg(fmt::format("The reef in year {:g}: {:.0f} % covered", year, 100 * now.colony_cover()),
                   legend_svg(legend, 480, 36, 110, 5) + cover_svg(panel_at(0, 0), history) +
                       floor_svg(panel_at(1, 0), history) + map_svg(panel_at(2, 0), history, year) +
                       count_svg(panel_at(0, 1), history) + sizes_svg(panel_at(1, 1), history, year) +
                       rugosity_svg(panel_at(2, 1), history));
}

std::string reef_csv(const ReefHistory& history) {
  std::string out = "year";
  for (const ColonySpecies& species : history.species) out += fmt::format(",{}", name_of(species.name));
  out += ",colonies_cover,macroalgae,coralline,rubble,turf,colonies,rugosity\n";
  for (std::size_t year = 0; year < history.course.size(); ++year) {
    const ReefYear& y = history.course[year];
    out += fmt::format("{}", year);
    for (double cover : y.cover) out += fmt::format(",{:.2f}", 100 * cover);
    for (double share : {y.colony_cover(), y.macroalgae, y.coralline, y.rubble, y.turf})
      out += fmt::format(",{:.2f}", 100 * share);
    out += fmt::format(",{:.2f},{:.3f}\n", y.colonies, y.rugosity);
  }
  return out;
}

}  // namespace frond
