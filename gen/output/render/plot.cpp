#include "render/plot.h"

#include <fmt/format.h>

#include <algorithm>

namespace frond {

namespace {

/// One chart: its axes, its largest value and its line, which is broken where nothing is known.
std::string chart(std::span<const PlotFrame> frames, std::optional<double> PlotFrame::*value,
                  const char* title, int row) {
  constexpr double kLeft = 60, kWidth = 560, kHeight = 100;
  double top = 0;
  for (const PlotFrame& frame : frames) top = std::max(top, (frame.*value).value_or(0));
  int y = 30 + 150 * row;
  bool millions = top >= 1e6;
  std::string text = fmt::format(
      "<text x=\"60\" y=\"{}\">{}</text>\n<path class=\"axis\" d=\"M60 {}V{}H620\"/>\n"
      "<text class=\"tick\" x=\"54\" y=\"{}\">{:.4g}{}</text><text class=\"tick\" x=\"54\" "
      "y=\"{}\">0</text>\n"
      "<path class=\"line\" d=\"",
      y - 8, title, y, y + 100, y + 8, millions ? top / 1e6 : top, millions ? " M" : "", y + 104);
  double first = frames.front().number, last = frames.back().number;
  bool down = false;
  for (const PlotFrame& frame : frames) {
    if (!(frame.*value)) {
      down = false;
      continue;
    }
    double x = kLeft + (last > first ? kWidth * (frame.number - first) / (last - first) : 0);
    double height = top > 0 ? kHeight * *(frame.*value) / top : 0;
    text += fmt::format("{}{:.1f} {:.1f}{}", down ? "L" : "M", x, y + kHeight - height, down ? "" : "h.1");
    down = true;
  }
  return text + "\"/>\n";
}

}  // namespace

std::string plot_text(std::span<const PlotFrame> frames) {
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 470\" font-family=\"sans-serif\" "
         "font-size=\"12\">\n"
         "<style>.axis{fill:none;stroke:#888}.line{fill:none;stroke:#c2552d;stroke-width:1.5;"
         "stroke-linecap:round}.tick{text-anchor:end;fill:#666}</style>\n"
         "<rect width=\"640\" height=\"470\" fill=\"#fff\"/>\n" +
         chart(frames, &PlotFrame::nodes, "nodes", 0) +
         chart(frames, &PlotFrame::bytes, "bytes of the scene", 1) +
         chart(frames, &PlotFrame::seconds, "seconds of processor", 2) +
         fmt::format("<text class=\"tick\" x=\"620\" y=\"450\">frames {} to {}</text>\n</svg>\n",
                     frames.front().number, frames.back().number);
}

}  // namespace frond
