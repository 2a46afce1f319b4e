#include <algorithm>

#include "dynamics/stand.h"

namespace frond {

TreeSize size_at(const StandHistory& history, std::uint32_t life, double year) {
  const TreeLife& lived = history.lives[life];
  std::span<const TreeSize> sizes = std::span(history.sizes).subspan(lived.first, lived.count);
  auto when = static_cast<float>(year);
  auto after = std::ranges::upper_bound(sizes, when, {}, &TreeSize::year);
  if (after == sizes.begin()) return {.year = when};
  const TreeSize& a = *(after - 1);
  const TreeSize& b = after == sizes.end() ? a : *after;
  float t = b.year > a.year ? (when - a.year) / (b.year - a.year) : 0;
  auto mix = [&](float TreeSize::*of) { return a.*of + (b.*of - a.*of) * t; };
  return {when, mix(&TreeSize::height), mix(&TreeSize::diameter), mix(&TreeSize::crown_radius),
          mix(&TreeSize::crown_base)};
}

std::vector<std::uint32_t> living_at(const StandHistory& history, double year) {
  std::vector<std::uint32_t> living;
  for (std::uint32_t i = 0; i < history.lives.size(); ++i)
    if (static_cast<double>(history.lives[i].born) <= year &&
        year < static_cast<double>(history.lives[i].died))
      living.push_back(i);
  return living;
}

std::vector<Deadwood> deadwood_at(const StandHistory& history, double year) {
  std::vector<Deadwood> dead;
  auto when = static_cast<float>(year);
  for (std::uint32_t i = 0; i < history.lives.size(); ++i) {
    const TreeLife& life = history.lives[i];
    if (life.died <= when && when < life.rotted)
      dead.push_back({i, life.fell <= when, (when - life.died) / (life.rotted - life.died)});
  }
  return dead;
}

}  // namespace frond
