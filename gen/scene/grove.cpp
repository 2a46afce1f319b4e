#include "scene/grove.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"

namespace frond {

namespace {

void take(Branches& branches, Model&& model) {
  branches.rest = std::move(model.skeleton);
  branches.girth = std::move(model.girth);
  branches.prototypes = std::move(model.prototypes);
  branches.organs = std::move(model.organs);
}

Filming filming_of(const Growth& growth, int years, double time) {
  Filming filming;
  if (growth.duration <= 0) return filming;
  filming.seconds_a_year = growth.duration / (years + 0.5);
  filming.overtime = std::max(0.0, time - growth.start - growth.duration);
  return filming;
}

}  // namespace

std::vector<Branches> grow_together(const Preset& preset, const std::vector<TreePlanting>& plantings,
                                    std::span<const Surface> bodies) {
  std::vector<TreeSite> sites;
  bool film = false;
  for (const TreePlanting& p : plantings) {
    const auto& params = std::get<TreeParams>(p.organism->body);
    const Place& place = p.organism->place;
    film = film || (params.growth.duration > 0 && preset.film.frames > 1);
    double toward = p.seed.child("toward").range(0, 2 * kPi);
    Vec3 axis(static_cast<float>(std::cos(toward)), 0, static_cast<float>(std::sin(toward)));
    sites.push_back({&params, p.foot,
                     glm::angleAxis(static_cast<float>(place.lean * p.seed.child("lean").unit()), axis),
                     1 + place.size_variation * p.seed.child("size").range(-1, 1), p.seed.child("grow")});
  }
  Grove grove = grow_trees(sites, film, Seed{preset.seed}.child("weather"), bodies);

  std::vector<Branches> trees(plantings.size());
  parallel_for(trees.size(), [&](std::size_t i) {
    Branches& b = trees[i];
    const TreeParams& params = *sites[i].params;
    b.name = plantings[i].organism->name;
    b.entry = static_cast<std::size_t>(plantings[i].organism - preset.organisms.data());
    Seed look = plantings[i].seed.child("look");
    bool grows = film && params.growth.duration > 0;
    double year = grows || preset.film.frames > 1 ? grove.years + 0.5
                                                  : year_at(params.growth, grove.years, preset.film.length());
    take(b, tree_model(params, grove.trees[i], year, filming_of(params.growth, grove.years, 0), look));
    if (grows)
      b.life = std::make_shared<TreeLife>(TreeLife{params, std::move(grove.trees[i]), grove.years, look});
  });
  return trees;
}

Branches tree_at(const Branches& tree, double time) {
  const TreeLife& life = *tree.life;
  Branches now;
  now.name = tree.name;
  now.entry = tree.entry;
  now.bark = tree.bark;
  now.coat = tree.coat;
  now.brightness = tree.brightness;
  now.style = tree.style;
  now.motion = tree.motion;
  const Growth& growth = tree.motion.growth;
  take(now, tree_model(life.params, life.tree, year_at(growth, life.years, time),
                       filming_of(growth, life.years, time), life.look));
  now.motion.growth = {};
  return now;
}

}  // namespace frond
