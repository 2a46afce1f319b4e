#include "dynamics/reef_floor.h"

#include <algorithm>
#include <cmath>

namespace frond {

namespace {

constexpr double kFloorCell = 0.5;   // metres, the widest cell
constexpr int kDots = 10;            // of a survey along the side of a cell
constexpr int kSteps = 12;           // of algae in a year
constexpr double kSpores = 0.02;     // 1/year: turf on which macroalgae come up from afar
constexpr double kFromBeside = 0.3;  // share of their growth that comes from the cells beside
constexpr double kScarce = 0.1;      // free share below which grazing grows no denser
constexpr double kCoralline = 0.4;   // share of the grazed ground that coralline algae come to cover
constexpr double kCrusting = 0.4;    // 1/year, at which they do (Adey and Vassar 1975)

/// Height of the surface of a colony at a share of its radius: mounds are domes, what spreads is flat.
double surface_at(const ColonyShape& shape, double share) {
  return shape.under > 0 ? shape.top : shape.top * std::sqrt(std::max(0.0, 1 - share * share));
}

}  // namespace

ReefFloor::ReefFloor(Vec2 area) : area_(area) {
  columns_ = std::max(1, static_cast<int>(std::ceil(static_cast<double>(area.x) / kFloorCell)));
  rows_ = std::max(1, static_cast<int>(std::ceil(static_cast<double>(area.y) / kFloorCell)));
  wide_ = static_cast<double>(area.x) / columns_, deep_ = static_cast<double>(area.y) / rows_;
  cells_.resize(static_cast<std::size_t>(columns_ * rows_));
}

std::size_t ReefFloor::index(double x, double z) const {
  auto number = [](double at, float side, double cell, int count) {
    return std::clamp(static_cast<int>(std::floor((at + static_cast<double>(side) / 2) / cell)), 0,
                      count - 1);
  };
  return static_cast<std::size_t>(number(z, area_.y, deep_, rows_) * columns_ +
                                  number(x, area_.x, wide_, columns_));
}

const FloorCell& ReefFloor::at(double x, double z) const { return cells_[index(x, z)]; }

ReefYear ReefFloor::survey(std::span<const Colony> colonies, std::span<const ColonySpecies> species) {
  double step_x = wide_ / kDots, step_z = deep_ / kDots;
  int across = columns_ * kDots, along = rows_ * kDots;
  std::vector<double> height(static_cast<std::size_t>(across * along), 0);
  std::vector<int> top(height.size(), -1);
  double low_x = -static_cast<double>(area_.x) / 2, low_z = -static_cast<double>(area_.y) / 2;
  ReefYear year;
  year.cover.assign(species.size(), 0);
  double ground = static_cast<double>(area_.x) * static_cast<double>(area_.y);
  for (const Colony& c : colonies) {
    if (c.radius >= 0.025) year.colonies += 1 / ground;
    ColonyShape shape = shape_of(species[c.species], c.radius, c.height);
    auto first = [&](double at, double low, double step) {
      return std::max(0, static_cast<int>(std::ceil((at - c.radius - low) / step - 0.5)));
    };
    for (int j = first(c.z, low_z, step_z); j < along; ++j) {
      double dz = low_z + (j + 0.5) * step_z - c.z;
      if (dz > c.radius) break;
      for (int i = first(c.x, low_x, step_x); i < across; ++i) {
        double dx = low_x + (i + 0.5) * step_x - c.x, share = std::hypot(dx, dz) / c.radius;
        if (dx > c.radius) break;
        auto dot = static_cast<std::size_t>(j * across + i);
        if (double h = surface_at(shape, share); share <= 1 && h >= height[dot])
          height[dot] = h, top[dot] = static_cast<int>(c.species);
      }
    }
  }
  for (FloorCell& cell : cells_) cell.free = 0;
  double surface = 0, dots = static_cast<double>(top.size());
  for (int j = 0; j < along; ++j)
    for (int i = 0; i < across; ++i) {
      auto dot = static_cast<std::size_t>(j * across + i);
      if (top[dot] < 0)
        cells_[static_cast<std::size_t>(j / kDots * columns_ + i / kDots)].free += 1.0 / (kDots * kDots);
      else
        year.cover[static_cast<std::size_t>(top[dot])] += 1 / dots;
      if (i > 0) surface += std::hypot(step_x, height[dot] - height[dot - 1]);
    }
  year.rugosity = across > 1 ? surface / (along * (across - 1) * step_x) : 1;
  for (FloorCell& cell : cells_) {
    cell.macroalgae = std::min(cell.macroalgae, cell.free);
    cell.coralline = std::min(cell.coralline, cell.free - cell.macroalgae);
    double loose = cell.rubble * (cell.free - cell.macroalgae), crust = cell.coralline * (1 - cell.rubble);
    double part = 1 / static_cast<double>(cells_.size());
    year.macroalgae += part * cell.macroalgae, year.rubble += part * loose;
    year.coralline += part * crust, year.turf += part * (cell.free - cell.macroalgae - loose - crust);
  }
  return year;
}

void ReefFloor::grow_year(const ReefOptions& options) {
  double free = 0;
  for (const FloorCell& cell : cells_) free += cell.free / static_cast<double>(cells_.size());
  // Mumby et al. 2007: what is grazed in all spreads over what algae there are.
  double grazed = options.grazing / std::max(free, kScarce);
  std::vector<double> before(cells_.size());
  for (int step = 0; step < kSteps; ++step) {
    for (std::size_t c = 0; c < cells_.size(); ++c) before[c] = cells_[c].macroalgae;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        auto near = [&](int dx, int dz) {
          int i = std::clamp(column + dx, 0, columns_ - 1), j = std::clamp(row + dz, 0, rows_ - 1);
          return before[static_cast<std::size_t>(j * columns_ + i)];
        };
        FloorCell& cell = cells_[static_cast<std::size_t>(row * columns_ + column)];
        double beside = (near(-1, 0) + near(1, 0) + near(0, -1) + near(0, 1)) / 4;
        double spreads = std::lerp(near(0, 0), beside, kFromBeside), turf = cell.free - cell.macroalgae;
        double change = options.algae * spreads * turf + kSpores * turf - grazed * cell.macroalgae;
        cell.macroalgae = std::clamp(cell.macroalgae + change / kSteps, 0.0, cell.free);
      }
  }
  for (FloorCell& cell : cells_) {
    double goal = kCoralline * (cell.free - cell.macroalgae) * std::min(1.0, options.grazing / 0.4);
    cell.coralline += (goal - cell.coralline) * (1 - std::exp(-kCrusting));
    cell.coralline = std::clamp(cell.coralline, 0.0, cell.free - cell.macroalgae);
    cell.rubble *= std::exp(-options.binding);
  }
}

void ReefFloor::strew(double x, double z, double area) {
  // On as many cells as it takes, each covered by a half.
  int reach = static_cast<int>(std::ceil(std::sqrt(area / (2 * wide_ * deep_))));
  double side = 2 * reach + 1, each = area / (side * side * wide_ * deep_);
  for (int j = -reach; j <= reach; ++j)
    for (int i = -reach; i <= reach; ++i) {
      double at_x = x + i * wide_, at_z = z + j * deep_;
      if (2 * std::abs(at_x) > wide_ * columns_ || 2 * std::abs(at_z) > deep_ * rows_) continue;
      FloorCell& cell = cells_[index(at_x, at_z)];
      cell.rubble = std::min(1.0, cell.rubble + each * (1 - cell.rubble));
    }
}

}  // namespace frond
