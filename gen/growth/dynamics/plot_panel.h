#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/vec.h"

// What plots of stands and reefs are drawn from, as SVG: a sheet of two rows of three panels.

namespace frond {

inline constexpr double kPanelWidth = 300, kPanelHeight = 270;

/// A frame with axes from 0 or, where `log`, in decades; its values are those of x and y.
struct PlotPanel {
  double left = 0, top = 0;
  double x0 = 0, x1 = 1, y0 = 0, y1 = 1;
  bool log = false;

  double x(double v) const;
  double y(double v) const;
};

/// The panel of a column 0..2 and a row 0..1 of the sheet.
PlotPanel panel_at(int column, int row);

/// A sheet with a title; `content` is what stands on it.
std::string sheet_svg(std::string_view title, std::string_view content);

/// A step of 1, 2 or 5 times a power of ten that divides a range into about five.
double tick_step(double range);

/// Axes with figures, a title and the names of the axes.
std::string frame_svg(const PlotPanel& p, std::string_view title, std::string_view below,
                      std::string_view beside);

/// A line through points; `style` are its attributes.
std::string polyline_svg(const PlotPanel& p, const std::vector<std::pair<double, double>>& points,
                         std::string_view style);

/// What several things add up to over the years, one upon the other; `values` are those of each at each of
/// the years.
std::string stack_svg(const PlotPanel& p, const std::vector<int>& years,
                      const std::vector<std::vector<double>>& values,
                      const std::vector<std::string_view>& colors);

/// Bars of classes of a width, which begin at 0, with their axes.
std::string bars_svg(PlotPanel p, const std::vector<double>& counts, double width, std::string_view title,
                     std::string_view below, std::string_view beside);

/// Names beside their colours, from x on, each of which takes `step`; `across` of them in a row.
std::string legend_svg(const std::vector<std::pair<std::string_view, std::string_view>>& names_and_colors,
                       double x, double y, double step, std::size_t across = 100);

/// A map of an area of metres, -z at the top: a title, and `content` drawn in metres from the middle, on a
/// ground of a colour.
std::string map_frame_svg(const PlotPanel& p, Vec2 area, std::string_view ground, std::string_view content);

}  // namespace frond
