#include "world/world.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/cancellation.h"

namespace frond {

namespace {

constexpr int kSkyRings = 6, kSkyRays = 16;  // directions that are looked in, and in each ring
constexpr double kSkyFar = 200;              // metres; what is beyond hides nothing

}  // namespace

void World::add(std::vector<Specimen> grown) {
  std::move(grown.begin(), grown.end(), std::back_inserter(standing_));
  hosts_.clear();
  obstacles_.reset();
}

std::vector<Surface> World::bodies() const {
  std::vector<Surface> skins;
  for (const Specimen& s : standing_)
    if (s.entry != Specimen::kNoEntry && s.model.solids.size() > 0) skins.push_back(skin_of(s.model));
  return skins;
}

World::HostOrNot World::build_host(const std::vector<std::string>& names) const {
  Surface all;
  for (const Specimen& s : standing_)
    if (names.empty() || std::ranges::find(names, s.name) != names.end()) append(all, skin_of(s.model));
  if (all.triangle.empty())
    return error_at("", "nothing stands here{} to grow on; expected a body such as a wall, a rock or a mesh",
                    names.empty() ? "" : fmt::format(" of \"{}\"", fmt::join(names, "\", \"")));
  Result<TriangleSurface> host = TriangleSurface::build(all, "");
  if (!host) return host.errors();
  return std::make_shared<const TriangleSurface>(std::move(*host));
}

Result<std::shared_ptr<const TriangleSurface>> World::host(const std::vector<std::string>& names,
                                                           std::string_view asker) const {
  std::scoped_lock lock(hosts_in_work_);
  auto known = hosts_.find(names);
  // Threads build in a pool that this one is of. What it might take up meanwhile asks here, too, so it takes
  // up nothing.
  if (known == hosts_.end()) isolated([&] { known = hosts_.emplace(names, build_host(names)).first; });
  if (known->second) return known->second;
  Errors errors = known->second.errors();
  for (Error& error : errors) error.where = asker;
  return errors;
}

Result<std::shared_ptr<const Obstacles>> World::obstacles() const {
  std::scoped_lock lock(hosts_in_work_);
  if (obstacles_) return *obstacles_;
  isolated([&] {
    Result<Obstacles> built = Obstacles::build(bodies());
    if (built)
      obstacles_.emplace(std::make_shared<const Obstacles>(std::move(*built)));
    else
      obstacles_.emplace(built.errors());
  });
  return *obstacles_;
}

double World::open_sky(const DVec3& at) const {
  Result<std::shared_ptr<const TriangleSurface>> bodies = host({}, "");
  if (!bodies) return 1;
  double open = 0;
  for (int ring = 0; ring < kSkyRings; ++ring) {
    // Rings of equal share of a sky whose light counts by the sine of its height.
    double up = std::sqrt((ring + 0.5) / kSkyRings), flat = std::sqrt(1 - up * up);
    for (int k = 0; k < kSkyRays; ++k) {
      double turn = 2 * kPi * (k + 0.5 * (ring % 2)) / kSkyRays;
      DVec3 direction(flat * std::cos(turn), up, flat * std::sin(turn));
      if (!(*bodies)->crossing(at + 1e-3 * direction, at + kSkyFar * direction)) ++open;
    }
  }
  return open / (kSkyRings * kSkyRays);
}

std::vector<FoodLeft> food_places(std::span<const Specimen> specimens, double time) {
  std::vector<FoodLeft> places;
  for (const Specimen& s : specimens) {
    const Food& food = s.motion.food;
    for (std::size_t i = 0; food.pulls() && i < food.places(); ++i) {
      FoodLeft meal{food.place(i).at(time), food.left(i, time)};
      if (meal.left > 0 && std::ranges::find(places, meal) == places.end()) places.push_back(meal);
    }
  }
  return places;
}

}  // namespace frond
