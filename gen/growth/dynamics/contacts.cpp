#include "dynamics/contacts.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr double kGridCell = 0.5;     // metres
constexpr double kYoung = 0.08;       // metres, diameter from which on colonies grow at their full rate
constexpr double kOvergrowth = 0.35;  // of its growth, over colonies of lower ranks (Connell et al. 2004)
constexpr double kClearance = 0.005;  // metres that stay between a crown and what is under it

ColonyShape shape_of(const Colony& colony, std::span<const ColonySpecies> species) {
  return shape_of(species[colony.species], colony.radius, colony.height);
}

double distance(const Colony& a, const Colony& b) { return std::hypot(a.x - b.x, a.z - b.z); }

/// Grows colonies upward, below crowns that are over them only as far as these were.
void grow_up(std::vector<Colony>& colonies, std::span<const ColonySpecies> species, const ColonyGrid& grid,
             std::span<const double> vigour) {
  std::vector<double> height(colonies.size());
  parallel_for(colonies.size(), [&](std::size_t i) {
    const Colony& own = colonies[i];
    const ColonySpecies& kind = species[own.species];
    double most = std::min(kind.tallest, 0.01 + 2 * own.radius * kind.slenderness);
    double next = std::min(own.height + 0.01 * kind.rise * vigour[i], most);
    grid.each_near(own.x, own.z, own.radius, [&](std::uint32_t j) {
      if (j == i || distance(own, colonies[j]) >= own.radius + colonies[j].radius) return;
      double under = shape_of(colonies[j], species).under;
      if (under >= own.height) next = std::min(next, under - kClearance);
    });
    height[i] = std::max(next, own.height);
  });
  for (std::size_t i = 0; i < colonies.size(); ++i) colonies[i].height = height[i];
}

/// The strongest first: by rank, then by size.
std::vector<std::uint32_t> by_strength(std::span<const Colony> colonies,
                                       std::span<const ColonySpecies> species) {
  std::vector<std::uint32_t> order(colonies.size());
  std::iota(order.begin(), order.end(), 0u);
  std::ranges::sort(order, [&](std::uint32_t a, std::uint32_t b) {
    double rank_a = species[colonies[a].species].rank, rank_b = species[colonies[b].species].rank;
    if (rank_a != rank_b) return rank_a > rank_b;
    if (colonies[a].radius != colonies[b].radius) return colonies[a].radius > colonies[b].radius;
    return a < b;
  });
  return order;
}

/// The radius up to which a colony has room beside another one.
double radius_beside(const ColonyShape& own, double foot_share, const ColonyShape& other, double distance) {
  // As room_between() tells, for each of its cases.
  double most = (distance - other.foot) / foot_share;
  if (share_heights(own.under, own.top, other.under, other.top))
    most = std::min(most, distance - other.radius);
  if (share_heights(0, own.under, other.under, other.top))
    most = std::min(most, (distance - other.radius) / foot_share);
  if (share_heights(0, other.under, own.under, own.top)) most = std::min(most, distance - other.foot);
  return most;
}

}  // namespace

ColonyGrid::ColonyGrid(std::span<const Colony> colonies, Vec2 area) : area_(area) {
  columns_ = std::max(1, static_cast<int>(std::ceil(static_cast<double>(area.x) / kGridCell)));
  rows_ = std::max(1, static_cast<int>(std::ceil(static_cast<double>(area.y) / kGridCell)));
  first_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  auto cell = [&](const Colony& c) {
    return static_cast<std::size_t>(row_of(c.z) * columns_ + column_of(c.x));
  };
  for (const Colony& c : colonies) {
    ++first_[cell(c) + 1];
    largest_ = std::max(largest_, c.radius);
  }
  std::partial_sum(first_.begin(), first_.end(), first_.begin());
  std::vector<std::uint32_t> next = first_;
  colony_.resize(colonies.size());
  for (std::uint32_t i = 0; i < colonies.size(); ++i) colony_[next[cell(colonies[i])]++] = i;
}

int ColonyGrid::column_of(double x) const {
  return std::clamp(static_cast<int>(std::floor((x + static_cast<double>(area_.x) / 2) / kGridCell)), 0,
                    columns_ - 1);
}

int ColonyGrid::row_of(double z) const {
  return std::clamp(static_cast<int>(std::floor((z + static_cast<double>(area_.y) / 2) / kGridCell)), 0,
                    rows_ - 1);
}

double light_response(const ColonySpecies& species, double light) {
  return std::pow(std::clamp(light, 0.0, 1.0), 1 - species.tolerance);
}

std::vector<double> light_on(std::span<const Colony> colonies, std::span<const ColonySpecies> species,
                             const ColonyGrid& grid) {
  std::vector<double> light(colonies.size(), 1);
  parallel_for(colonies.size(), [&](std::size_t i) {
    const Colony& own = colonies[i];
    grid.each_near(own.x, own.z, own.radius, [&](std::uint32_t j) {
      if (j == i || colonies[j].height <= own.height) return;
      double over = own.radius + colonies[j].radius - distance(own, colonies[j]);
      double covered = std::clamp(over / (2 * own.radius), 0.0, 1.0);
      light[i] *= 1 - species[colonies[j].species].shade * covered;
    });
  });
  return light;
}

void grow_year(std::vector<Colony>& colonies, std::span<const ColonySpecies> species, const ColonyGrid& grid,
               std::span<const double> vigour) {
  grow_up(colonies, species, grid, vigour);
  std::vector<char> settled(colonies.size(), false);  // whether its radius is that of the next year
  auto gain = [&](const Colony& c, double well) {
    const ColonySpecies& kind = species[c.species];
    double young = std::min(1.0, 0.3 + 1.4 * c.radius / kYoung);
    double old = std::max(0.0, 1 - std::pow(2 * c.radius / kind.widest, 4));
    return 0.01 * kind.extension * well * young * old;
  };
  double most = 0;
  for (std::size_t i = 0; i < colonies.size(); ++i) most = std::max(most, gain(colonies[i], vigour[i]));
  for (std::uint32_t i : by_strength(colonies, species)) {
    Colony& own = colonies[i];
    const ColonySpecies& kind = species[own.species];
    double grows = gain(own, vigour[i]), radius = own.radius + grows;
    ColonyShape shape = shape_of(own, species);
    double foot_share = shape.foot / shape.radius;
    grid.each_near(own.x, own.z, own.radius + 2 * most, [&](std::uint32_t j) {
      if (j == i) return;
      const Colony& other = colonies[j];
      ColonyShape beside = shape_of(other, species);
      // What is weaker has to give way.
      if (!settled[j] && species[other.species].rank < kind.rank) {
        double left = std::max(0.0, 1 - kOvergrowth * grows / other.radius);
        beside.radius *= left, beside.foot *= left;
      }
      radius = std::min(radius, radius_beside(shape, foot_share, beside, distance(own, other)));
    });
    own.radius = std::max(radius, 0.0);
    own.widest = std::max(own.widest, own.radius);
    settled[i] = true;
  }
}

}  // namespace frond
