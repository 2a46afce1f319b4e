#include "dynamics/reef.h"

#include <algorithm>
#include <cmath>

#include "dynamics/lives.h"

namespace frond {

namespace {

constexpr double kMostColonies = 2e7;  // that may come over all years

/// Up to how many colonies come over all years, where the ground is always free.
double colonies_of(const ReefOptions& options) {
  double on_m2 = 0, larvae = 0;
  for (const ColonySpecies& kind : options.species)
    on_m2 += kind.arrival, larvae = std::max(larvae, kind.larvae);
  on_m2 = options.settling ? options.years * (on_m2 + larvae) : 0;
  for (const Outplant& plants : options.planted) on_m2 += plants.density;
  return static_cast<double>(options.area.x) * static_cast<double>(options.area.y) * on_m2;
}

}  // namespace

double ReefYear::colony_cover() const {
  double sum = 0;
  for (double share : cover) sum += share;
  return sum;
}

ReefOptions options_of(const ReefText& text) {
  ReefOptions options{.area = text.area,
                      .years = text.years,
                      .species = {},
                      .planted = text.planted,
                      .settling = text.settling,
                      .storms = text.storms,
                      .grazing = text.grazing,
                      .algae = text.algae,
                      .binding = text.binding,
                      .events = {}};
  if (text.species.empty()) options.species.assign(colony_species().begin(), colony_species().end());
  for (const ColonyText& wanted : text.species) {
    ColonySpecies& colony = options.species.emplace_back(species(wanted.name));
    for (std::size_t r = 0; r < kColonyRates; ++r) {
      double& rate = colony.*colony_rates()[r].at;
      rate = wanted.rates[r].value_or(rate);
    }
  }
  return options;
}

Errors reef_faults(const ReefText& text) {
  Errors faults = species_faults(text, "reef");
  if (double colonies = colonies_of(options_of(text)); colonies > kMostColonies)
    faults.push_back(error_at("/area",
                              "up to {:.2g} colonies would come; expected {:g} at most, by a smaller area, "
                              "fewer years or lower rates",
                              colonies, kMostColonies));
  add_shown_fault(text, faults);
  return faults;
}

ColonySize size_at(const ReefHistory& history, std::uint32_t life, double year) {
  const ColonyLife& lived = history.lives[life];
  std::span<const ColonySize> sizes = std::span(history.sizes).subspan(lived.first, lived.count);
  auto when = static_cast<float>(year);
  auto after = std::ranges::upper_bound(sizes, when, {}, &ColonySize::year);
  if (after == sizes.begin()) return {.year = when};
  auto i = static_cast<std::size_t>(after - sizes.begin()) - 1, next = std::min(i + 1, sizes.size() - 1);
  const ColonySize &a = sizes[i], &b = sizes[next];
  float t = b.year > a.year ? std::min((when - a.year) / (b.year - a.year), 1.0f) : 0;
  return {when, std::lerp(a.radius, b.radius, t), std::lerp(a.height, b.height, t)};
}

std::vector<std::uint32_t> living_at(const ReefHistory& history, double year) {
  std::vector<std::uint32_t> living;
  for (std::uint32_t i = 0; i < history.lives.size(); ++i)
    if (static_cast<double>(history.lives[i].born) <= year &&
        year < static_cast<double>(history.lives[i].died))
      living.push_back(i);
  return living;
}

ColonyShape shape_of(const ColonySpecies& species, double radius, double height) {
  bool spreads = species.foot < 1 && species.crown < 1;
  return {radius, height, spreads ? height * (1 - species.crown) : 0,
          spreads ? radius * species.foot : radius};
}

bool share_heights(double low_a, double high_a, double low_b, double high_b) {
  return std::max(low_a, low_b) < std::min(high_a, high_b);
}

double room_between(const ColonyShape& a, const ColonyShape& b, double distance) {
  double reach = a.foot + b.foot;  // feet always stand beside each other
  if (share_heights(a.under, a.top, b.under, b.top)) reach = std::max(reach, a.radius + b.radius);
  if (share_heights(0, a.under, b.under, b.top)) reach = std::max(reach, a.foot + b.radius);
  if (share_heights(0, b.under, a.under, a.top)) reach = std::max(reach, b.foot + a.radius);
  return distance - reach;
}

}  // namespace frond
