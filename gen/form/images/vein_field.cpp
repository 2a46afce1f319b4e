#include "images/vein_field.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/linear.h"

namespace frond {

namespace {

constexpr float kFieldCell = 0.02f;  // side of a cell
constexpr float kBulge = 0.028f;     // from a vein to where the blade has risen
constexpr int kBulges = 3;           // the finest order of veins between which it bulges
constexpr double kPixels = 0.8;      // half the width of a line is at least that share of a pixel
constexpr double kSoft = 1.6;        // a line ends at that many times half its width
/// How strongly veins of an order show.
constexpr std::array<double, 8> kShows{1, 1, 0.86, 0.60, 0.42, 0.30, 0.3, 0.3};

double shows(std::uint8_t order) { return kShows[std::min<std::size_t>(order, kShows.size() - 1)]; }

}  // namespace

VeinField::VeinField(const Veins& v, double pixel) {
  auto add = [&](std::size_t a, std::size_t b) {
    // Width is that of the finer end.
    pieces_.push_back({v.point[a], v.point[b] - v.point[a], std::min(v.width[a], 1.15f * v.width[b]), 0,
                       std::max(v.order[a], v.order[b])});
    pieces_.back().taper = v.width[b] - pieces_.back().width;
  };
  for (std::size_t i = 1; i < v.size(); ++i) add(static_cast<std::size_t>(v.parent[i]), i);
  for (auto [a, b] : v.joins) add(a, b);
  if (pieces_.empty()) return;
  Vec2 low(1e9f), high(-1e9f);
  for (Vec2 p : v.point) low = glm::min(low, p), high = glm::max(high, p);
  corner_ = low - kBulge;
  columns_ = static_cast<int>((high.x - low.x + 2 * kBulge) / kFieldCell) + 1;
  rows_ = static_cast<int>((high.y - low.y + 2 * kBulge) / kFieldCell) + 1;
  auto each_cell = [&](const Piece& piece, auto visit) {
    float drawn = static_cast<float>(kSoft * std::max<double>(piece.width, kPixels * pixel));
    float reach = piece.order <= kBulges ? std::max(drawn, kBulge) : drawn;
    Vec2 to = piece.from + piece.way;
    Vec2 from_cell = (glm::min(piece.from, to) - reach - corner_) / kFieldCell,
         to_cell = (glm::max(piece.from, to) + reach - corner_) / kFieldCell;
    for (int y = std::max(0, static_cast<int>(from_cell.y));
         y <= std::min(rows_ - 1, static_cast<int>(to_cell.y)); ++y)
      for (int x = std::max(0, static_cast<int>(from_cell.x));
           x <= std::min(columns_ - 1, static_cast<int>(to_cell.x)); ++x)
        visit(static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x));
  };
  first_.assign(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_) + 1, 0);
  for (const Piece& piece : pieces_) each_cell(piece, [&](std::size_t cell) { ++first_[cell + 1]; });
  for (std::size_t i = 1; i < first_.size(); ++i) first_[i] += first_[i - 1];
  piece_.resize(first_.back());
  std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
  for (std::uint32_t i = 0; i < pieces_.size(); ++i)
    each_cell(pieces_[i], [&](std::size_t cell) { piece_[next[cell]++] = i; });
}

VeinSight VeinField::at(Vec2 p, double pixel) const {
  VeinSight sight;
  Vec2 cell = (p - corner_) / kFieldCell;
  if (cell.x < 0 || cell.y < 0 || cell.x >= static_cast<float>(columns_) ||
      cell.y >= static_cast<float>(rows_))
    return sight;
  std::size_t index = static_cast<std::size_t>(cell.y) * static_cast<std::size_t>(columns_) +
                      static_cast<std::size_t>(cell.x);
  float away = kBulge;
  for (std::uint32_t k = first_[index]; k < first_[index + 1]; ++k) {
    const Piece& piece = pieces_[piece_[k]];
    Vec2 off = p - piece.from;
    float t =
        std::clamp(glm::dot(off, piece.way) / std::max(glm::dot(piece.way, piece.way), 1e-12f), 0.0f, 1.0f);
    float d = glm::length(off - t * piece.way), width = piece.width + t * piece.taper;
    if (piece.order <= kBulges) away = std::min(away, std::max(d - width, 0.0f));
    double drawn = std::max<double>(width, kPixels * pixel);
    if (d > kSoft * drawn) continue;
    double line = std::sqrt(width / drawn) * smooth_step(0.0, 1.0, kSoft - d / drawn);
    sight.line = std::max(sight.line, shows(piece.order) * line);
  }
  sight.bulge = smooth_step(0.0, 1.0, static_cast<double>(away) / kBulge);
  return sight;
}

}  // namespace frond
