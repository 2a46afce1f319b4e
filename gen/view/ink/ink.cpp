#include "ink/ink.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr float kOutline = 1e6f;  // strength of a line before the paper
constexpr float kWeakest = 0.5f;  // strength of a line that is drawn at all

constexpr float kFine = 1.5f;  // lines for the room of one: leaves too small for hatching of their own

/// Finds the lines of a drawing and draws them.
class InkMaker {
 public:
  InkMaker(const InkSamples& of, const InkStyle& style)
      : of_(of),
        pen_(style.pen),
        style_(style),
        columns_(of.width * of.fine),
        rows_(of.height * of.fine),
        strength_(of.samples.size()) {}

  Grid draw() {
    find_lines();
    thin_lines();
    Grid ink(of_.width, of_.height);
    float share = 1 / static_cast<float>(of_.fine * of_.fine);
    parallel_for(static_cast<std::size_t>(of_.height), [&](std::size_t row) {
      int y = static_cast<int>(row);
      for (int x = 0; x < of_.width; ++x)
        for (int k = 0; k < of_.fine * of_.fine; ++k) {
          int u = x * of_.fine + k % of_.fine, v = y * of_.fine + k / of_.fine;
          ink.at(x, y) += share * (1 - (1 - outline(u, v)) * (1 - hatching(u, v)));
        }
    });
    return ink;
  }

 private:
  const InkSample& at(int x, int y) const { return of_.samples[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }

  /// How strong a line between two neighbours is, in pixels by which one surface lies behind the other.
  float between(const InkSample& a, const InkSample& b) const {
    if (a.depth == 0 || b.depth == 0) return a.depth == b.depth ? 0 : kOutline;
    float pixel = of_.metres * std::min(a.depth, b.depth);
    Vec3 gap = b.at - a.at;
    float off = std::min(std::abs(glm::dot(a.normal, gap)), std::abs(glm::dot(b.normal, gap))) / pixel;
    constexpr float kCrease = 0.6f;  // cosine
    float bend = glm::dot(a.normal, b.normal);
    if (bend < kCrease) off = std::max(off, 1 - bend);
    if (a.thing != b.thing) off = std::max(off, 1.2f * kWeakest);
    return off;
  }

  /// Lines belong to what lies in front.
  void find_lines() {
    parallel_for(static_cast<std::size_t>(rows_), [&](std::size_t row) {
      int y = static_cast<int>(row);
      for (int x = 0; x < columns_; ++x) {
        const InkSample& here = at(x, y);
        if (here.depth == 0) continue;
        float strongest = 0;
        for (auto [u, v] :
             {std::pair(x + 1, y), std::pair(x - 1, y), std::pair(x, y + 1), std::pair(x, y - 1)}) {
          if (u < 0 || v < 0 || u >= columns_ || v >= rows_) continue;
          const InkSample& beside = at(u, v);
          if (beside.depth == 0 || beside.depth >= here.depth)
            strongest = std::max(strongest, between(here, beside));
        }
        strength_[index(x, y)] = strongest < kWeakest ? 0 : strongest;
      }
    });
  }

  /// Where lines lie close, the weaker ones go: in each cell so many stay as there is room for, and what must
  /// be exceeded changes smoothly from cell to cell. How close they lie says what is too fine for hatching of
  /// its own.
  void thin_lines() {
    cell_ = std::max(static_cast<int>(std::lround(12 * pen_ * static_cast<float>(of_.fine))), 4);
    int wide = (columns_ + cell_ - 1) / cell_, high = (rows_ + cell_ - 1) / cell_;
    least_ = Grid(wide, high), crowd_ = Grid(wide, high), dark_ = Grid(wide, high);
    parallel_for(least_.data.size(),
                 [&](std::size_t i) { cell_of(static_cast<int>(i) % wide, static_cast<int>(i) / wide); });
    Grid dark = dark_;
    for (int y = 0; y < high; ++y)
      for (int x = 0; x < wide; ++x) dark_.at(x, y) = mean_about(dark, x, y);
  }

  static float mean_about(const Grid& grid, int x, int y) {
    float sum = 0, count = 0;
    for (int v = std::max(y - 1, 0); v <= std::min(y + 1, grid.height - 1); ++v)
      for (int u = std::max(x - 1, 0); u <= std::min(x + 1, grid.width - 1); ++u)
        if (grid.at(u, v) >= 0) sum += grid.at(u, v), ++count;
    return count > 0 ? sum / count : 0.0f;
  }

  void cell_of(int cx, int cy) {
    constexpr float kApart = 6;  // pens between lines
    std::vector<float> lines;
    float shade = 0, there = 0;
    for (int y = cy * cell_; y < std::min((cy + 1) * cell_, rows_); ++y)
      for (int x = cx * cell_; x < std::min((cx + 1) * cell_, columns_); ++x) {
        const InkSample& one = at(x, y);
        if (one.depth == 0) continue;
        ++there, shade += one.shade;
        float strength = strength_[index(x, y)];
        if (strength > 0 && strength < kOutline) lines.push_back(strength);
      }
    dark_.at(cx, cy) = there > 0 ? shade / there : -1;
    float gap = kApart * pen_ * static_cast<float>(of_.fine);
    float dark = there > 0 ? smooth_step(0.4f, 0.85f, shade / there) : 0;
    auto room = static_cast<std::size_t>(there / gap * (0.15f + 0.85f * dark));
    crowd_.at(cx, cy) = there > 0 ? static_cast<float>(lines.size()) * gap / there : 0;
    float& least = least_.at(cx, cy);
    least = std::log2(kWeakest);
    if (lines.size() <= room) return;
    std::ranges::nth_element(lines, lines.begin() + static_cast<std::ptrdiff_t>(room), std::greater{});
    least = std::log2(lines[room]);
  }

  /// A value of cells, between their middles.
  float in_cells(const Grid& grid, int x, int y) const {
    float u = (static_cast<float>(x) + 0.5f) / static_cast<float>(cell_) - 0.5f,
          v = (static_cast<float>(y) + 0.5f) / static_cast<float>(cell_) - 0.5f;
    int left = static_cast<int>(std::floor(u)), top = static_cast<int>(std::floor(v));
    auto get = [&](int i, int j) {
      return grid.at(std::clamp(i, 0, grid.width - 1), std::clamp(j, 0, grid.height - 1));
    };
    float s = u - static_cast<float>(left), t = v - static_cast<float>(top);
    return std::lerp(std::lerp(get(left, top), get(left + 1, top), s),
                     std::lerp(get(left, top + 1), get(left + 1, top + 1), s), t);
  }

  /// Width of a line in samples; 0: it is left out.
  float width(int x, int y) const {
    float strength = strength_[index(x, y)];
    float fine = pen_ * static_cast<float>(of_.fine);
    if (strength >= kOutline) return fine * (in_cells(crowd_, x, y) > kFine ? 0.7f : 1.5f);
    if (strength <= 0) return 0;
    float over = std::log2(strength) - in_cells(least_, x, y);
    float fade = std::clamp(over * 4, 0.0f, 1.0f);
    return fine * fade * std::clamp(0.55f + 0.17f * std::log2(strength), 0.5f, 1.5f);
  }

  float outline(int x, int y) const {
    int reach = static_cast<int>(std::ceil(0.75f * pen_ * static_cast<float>(of_.fine))) + 1;
    float ink = 0;
    for (int v = std::max(y - reach, 0); v <= std::min(y + reach, rows_ - 1); ++v)
      for (int u = std::max(x - reach, 0); u <= std::min(x + reach, columns_ - 1); ++u) {
        if (strength_[index(u, v)] <= 0) continue;
        float wide = width(u, v);
        if (wide <= 0) continue;
        float away = std::hypot(static_cast<float>(u - x), static_cast<float>(v - y));
        ink = std::max(ink, std::clamp(0.5f * wide - away + 0.5f, 0.0f, 1.0f));
      }
    return ink;
  }

  /// Ink of one layer of lines that cover `share` of the surface.
  float lines(float phase, float slope, float share) const {
    float wanted = style_.hatch * pen_ * slope;
    float level = std::log2(wanted), power = std::floor(level), fade = level - power;
    float period = std::exp2(power), place = phase / period, nearest = std::round(place);
    bool odd = std::fmod(std::abs(nearest), 2.0f) > 0.5f;
    float away = std::abs(place - nearest) * period / slope;  // pixels
    float half = 0.5f * share * style_.hatch * pen_ * (odd ? 1 - fade : 1.0f);
    float edge = 1 / static_cast<float>(of_.fine);
    return std::clamp((half - away) / edge + 0.5f, 0.0f, 1.0f) * std::min(1.0f, 2 * half / edge);
  }

  float hatching(int x, int y) const {
    const InkSample& one = at(x, y);
    if (one.depth == 0 || style_.hatch <= 0) return 0;
    bool fine = in_cells(crowd_, x, y) > kFine;
    // Leaves turn every way: a crown in the light is darker than one surface.
    float shade = fine ? 1.6f * (in_cells(dark_, x, y) - 0.35f) : one.shade;
    float first = 0.45f * smooth_step(0.35f, 0.95f, shade), second = 0.4f * smooth_step(0.72f, 1.0f, shade);
    float pixel = of_.metres * one.depth;
    float ink = 0;
    if (first > 0) ink = fine ? lines(one.across, pixel, first) : lines(one.phase[0], one.slope[0], first);
    if (second > 0 && !fine) ink = 1 - (1 - ink) * (1 - lines(one.phase[1], one.slope[1], second));
    return ink;
  }

  const InkSamples& of_;
  float pen_;
  const InkStyle& style_;
  int columns_, rows_, cell_ = 1;
  std::vector<float> strength_;  // of the line at each sample; 0: none
  Grid least_, crowd_, dark_;    // of each cell: logarithm of the weakest line; lines for the room; shade
};

}  // namespace

Grid ink_drawing(const InkSamples& samples, const InkStyle& style) { return InkMaker(samples, style).draw(); }

Raster ink_picture(const Grid& ink, bool paper) {
  constexpr std::array<double, 3> kInk{0.09, 0.08, 0.075};  // sRGB
  Raster picture(ink.width, ink.height, paper ? 3 : 4);
  auto channels = static_cast<std::size_t>(picture.channels);
  for (std::size_t i = 0; i < ink.data.size(); ++i) {
    auto share = static_cast<double>(ink.data[i]);
    for (std::size_t c = 0; c < 3; ++c)
      picture.data[channels * i + c] = to_byte(paper ? 1 - share * (1 - kInk[c]) : kInk[c]);
    if (!paper) picture.data[channels * i + 3] = to_byte(share);
  }
  return picture;
}

}  // namespace frond
