#include "organisms/plant/flower_organ.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "organisms/plant/describe_flower.h"
#include "organisms/plant/organ_prototypes.h"

namespace frond {

namespace {

/// The stage of a number.
double stage_at(const FloralDiagram& diagram, int index) {
  int n = diagram.stages, after = (n + 1) / 2;
  return index <= n ? static_cast<double>(index) / n : 1 + static_cast<double>(index - n) / after;
}

/// The smallest capsule along +y about some shapes, from their foot.
class Room {
 public:
  void add(const Surface& surface, float size) {
    for (const Vec3& p : surface.position) {
      low_ = std::min(low_, p.y * size), high_ = std::max(high_, p.y * size);
      wide_ = std::max(wide_, glm::length(Vec2(p.x, p.z)) * size);
    }
  }
  void add(Vec3 at) {
    low_ = std::min(low_, at.y), high_ = std::max(high_, at.y),
    wide_ = std::max(wide_, glm::length(Vec2(at.x, at.z)));
  }

  OrganRoom room() const {
    OrganRoom made{low_ + wide_, high_ - wide_, wide_};
    if (made.from > made.to) made.from = made.to = 0.5 * (low_ + high_);
    return made;
  }

 private:
  float low_ = 0, high_ = 0, wide_ = 0;
};

/// The rooms of a plant's organs, each found once.
class Rooms {
 public:
  Rooms(const PlantParams& params, std::span<const Prototype> prototypes)
      : params_(params), prototypes_(prototypes) {}

  OrganRoom of(const std::string& symbol, double stage) {
    Variants kinds = variants_of(params_, symbol);
    if (kinds.organ < 0) return {};
    const OrganParams& organ = params_.organs[static_cast<std::size_t>(kinds.organ)];
    int step = organ.diagram ? stage_index(*organ.diagram, stage) : static_cast<int>(std::lround(8 * stage));
    auto [at, fresh] = known_.try_emplace({kinds.organ, step});
    if (fresh) {
      OrganRoom found = organ.inflorescence ? laid(organ, step / 8.0) : shown(organ, kinds, stage);
      at->second = found;
    }
    return at->second;
  }

  LaidInflorescence lay(const OrganParams& organ, double stage, Vec3 down, Seed seed) {
    Inflorescence params = *organ.inflorescence;
    params.length = organ.size;
    auto room = [&](FloretRole role, double at) {
      return of(role == FloretRole::flower ? params.flower
                : role == FloretRole::ray  ? params.ray
                                           : params.bract,
                at);
    };
    return lay_inflorescence(params, stage - 1, down, room, seed);
  }

 private:
  OrganRoom shown(const OrganParams& organ, const Variants& kinds, double stage) const {
    Room room;
    for (int which : prototypes_at(params_, kinds, stage))
      for (const OrganPart& part : prototypes_[static_cast<std::size_t>(which)].parts)
        room.add(part.surface, static_cast<float>(organ.size));
    return room.room();
  }

  OrganRoom laid(const OrganParams& organ, double stage) {
    Room room;
    for (const LaidFloret& f : lay(organ, stage, Vec3(0, -1, 0), Seed{0}).florets) {
      OrganRoom own = of(f.role == FloretRole::flower ? organ.inflorescence->flower
                         : f.role == FloretRole::ray  ? organ.inflorescence->ray
                                                      : organ.inflorescence->bract,
                         f.stage);
      auto tip = static_cast<float>((own.to + own.radius) * f.scale);
      room.add(f.at), room.add(f.at + f.heading * tip);
    }
    return room.room();
  }

  const PlantParams& params_;
  std::span<const Prototype> prototypes_;
  std::map<std::pair<int, int>, OrganRoom> known_;
};

/// Puts an inflorescence where its site is.
void expand(Figure& figure, const Site& site, const OrganParams& organ, Rooms& rooms, Seed seed) {
  constexpr double kLeast = 1e-5;
  Seed own = seed.child(site.id);
  auto size = static_cast<float>(1 + organ.size_variation * own.child(0).range(-1, 1));
  size *= std::max({std::abs(site.scale.x), std::abs(site.scale.y), std::abs(site.scale.z)});
  if (size < kLeast) return;
  Quat turn = glm::normalize(glm::quat_cast(glm::mat3(-site.left, site.heading, site.up)));
  double most = organ.turn_variation;
  turn = turn * glm::angleAxis(static_cast<float>(most * own.child(1).range(-1, 1)), Vec3(1, 0, 0)) *
         glm::angleAxis(static_cast<float>(most * own.child(3).range(-1, 1)), Vec3(0, 0, 1));
  Vec3 down = glm::inverse(turn) * Vec3(0, -1, 0);
  LaidInflorescence laid = rooms.lay(organ, site.stage, down, own.child("laid"));
  Skeleton& s = figure.skeleton;
  std::int32_t below = site.node;
  std::uint16_t order =
      below == Skeleton::kRoot ? 0 : static_cast<std::uint16_t>(s.order[static_cast<std::size_t>(below)] + 1);
  auto add = [&](Vec3 at, double radius, std::int32_t parent, int depth) {
    figure.color.push_back(site.color);
    return s.add(at, static_cast<float>(std::max(radius, 1e-5)), parent,
                 static_cast<std::uint16_t>(order + depth));
  };
  double foot = laid.nodes.empty() ? 0 : laid.nodes[0].radius * static_cast<double>(size);
  if (below == Skeleton::kRoot ||
      glm::distance(s.position[static_cast<std::size_t>(below)], site.position) > 1e-5f)
    below = add(site.position, foot, below, 0);
  std::vector<std::int32_t> numbers;
  for (const LaidNode& node : laid.nodes) {
    std::int32_t parent = node.parent < 0 ? below : numbers[static_cast<std::size_t>(node.parent)];
    Vec3 at = site.position + turn * (node.at * size);
    bool same = glm::distance(at, s.position[static_cast<std::size_t>(parent)]) < 1e-6f;
    numbers.push_back(same ? parent : add(at, node.radius * static_cast<double>(size), parent, node.order));
  }
  for (std::size_t i = 0; i < laid.florets.size(); ++i) {
    const LaidFloret& f = laid.florets[i];
    Site made;
    made.name = f.role == FloretRole::flower ? organ.inflorescence->flower
                : f.role == FloretRole::ray  ? organ.inflorescence->ray
                                             : organ.inflorescence->bract;
    made.position = site.position + turn * (f.at * size);
    made.heading = turn * f.heading, made.up = turn * f.up;
    made.left = glm::cross(made.up, made.heading);
    made.scale = Vec3(static_cast<float>(f.scale) * size), made.stage = f.stage, made.color = site.color;
    made.node = f.node < 0 ? below : numbers[static_cast<std::size_t>(f.node)];
    made.id = own.child("floret", i).bits();
    figure.sites.push_back(std::move(made));
  }
}

const OrganParams* organ_of(std::span<const OrganParams> organs, std::string_view symbol) {
  auto at = std::ranges::find(organs, symbol, &OrganParams::symbol);
  return at == organs.end() ? nullptr : &*at;
}

/// How many florets each organ bears that is an inflorescence, with those of what it bears; others count
/// as 1. What an inflorescence bears stands before it in the list.
std::vector<double> floret_counts(std::span<const OrganParams> organs) {
  std::vector<double> counts(organs.size(), 1);
  for (std::size_t i = 0; i < organs.size(); ++i) {
    if (!organs[i].inflorescence) continue;
    const Inflorescence& by = *organs[i].inflorescence;
    auto of = [&](const std::string& symbol, int number) {
      const OrganParams* organ = symbol.empty() ? nullptr : organ_of(organs, symbol);
      return organ ? number * counts[static_cast<std::size_t>(organ - organs.data())] : 0.0;
    };
    counts[i] = of(by.flower, by.flowers) + of(by.ray, by.rays) +
                of(by.bract, std::max({by.flowers, by.involucre, by.branches}));
  }
  return counts;
}

}  // namespace

int piece_count(const FloralDiagram& diagram) {
  int count = diagram.receptacle.radius > 0 && diagram.receptacle.height > 0 ? 1 : 0;
  for (std::size_t i = 0; i < diagram.whorls.size(); ++i) count += pieces_of(diagram, i);
  return count;
}

int stage_count(const FloralDiagram& diagram) { return diagram.stages + 1 + (diagram.stages + 1) / 2; }

int stage_index(const FloralDiagram& diagram, double stage) {
  int n = diagram.stages, after = (n + 1) / 2;
  double at = stage <= 1 ? stage * n : n + (stage - 1) * after;
  return static_cast<int>(std::lround(std::clamp(at, 0.0, static_cast<double>(n + after))));
}

std::vector<Prototype> flower_stages(const OrganParams& organ) {
  const FloralDiagram& diagram = *organ.diagram;
  int pieces = piece_count(diagram), stages = stage_count(diagram);
  std::vector<Prototype> all(static_cast<std::size_t>(pieces * stages));
  for (int i = 0; i < stages; ++i) {
    std::vector<Prototype> made = flower_prototypes(diagram, stage_at(diagram, i));
    for (std::size_t k = 0; k < made.size(); ++k) {
      made[k].name = organ.symbol, made[k].piece = true;
      if (!made[k].luster) made[k].luster = organ.luster;
      all[k * static_cast<std::size_t>(stages) + static_cast<std::size_t>(i)] = std::move(made[k]);
    }
  }
  return all;
}

bool borne_by_others(std::span<const OrganParams> organs, std::string_view symbol) {
  return std::ranges::any_of(organs, [&](const OrganParams& organ) {
    const std::optional<Inflorescence>& by = organ.inflorescence;
    return by && (by->flower == symbol || by->ray == symbol || by->bract == symbol);
  });
}

Errors flower_faults(std::span<const OrganParams> organs, std::size_t which) {
  const OrganParams& organ = organs[which];
  if (organ.diagram.has_value() != (organ.shape == OrganShape::diagram))
    return {{"/diagram",
             organ.diagram ? "needs \"shape\": \"diagram\"" : "is missing; the shape \"diagram\" needs it"}};
  if (organ.inflorescence.has_value() != (organ.shape == OrganShape::inflorescence))
    return {{"/inflorescence", organ.inflorescence ? "needs \"shape\": \"inflorescence\""
                                                   : "is missing; the shape \"inflorescence\" needs it"}};
  Errors errors;
  if (organ.diagram) {
    errors = diagram_faults(*organ.diagram);
    for (Error& error : errors) error.where = "/diagram" + error.where;
    if (organ.dew > 0) errors.push_back({"/dew", "is for organs of one piece, not for a diagram"});
  }
  if (!organ.inflorescence) return errors;
  const Inflorescence& by = *organ.inflorescence;
  auto check = [&](const char* name, const std::string& symbol) {
    if (symbol.empty()) return;
    const OrganParams* borne = organ_of(organs, symbol);
    std::string where = fmt::format("/inflorescence/{}", name);
    if (!borne)
      errors.push_back({where, fmt::format("found \"{}\"; organs has none with that symbol", symbol)});
    else if (borne->inflorescence && borne >= &organ)
      errors.push_back(
          {where,
           fmt::format(
               "found \"{}\", an inflorescence; expected one that stands before this one, or another organ",
               symbol)});
  };
  check("flower", by.flower), check("ray", by.ray), check("bract", by.bract);
  constexpr int kMostCrowded = 500;
  constexpr double kMostFlorets = 1e5;
  const bool packed = by.type == InflorescenceType::capitulum || by.type == InflorescenceType::spadix;
  if (!packed && by.flowers > kMostCrowded)
    errors.push_back(
        {"/inflorescence/flowers", fmt::format("found {}; expected at most {} but in a capitulum or a spadix",
                                               by.flowers, kMostCrowded)});
  if (errors.empty())
    if (double all = floret_counts(organs)[which]; all > kMostFlorets)
      errors.push_back(
          {"/inflorescence", fmt::format("bears {:.0f} florets with what they bear; expected at most "
                                         "{:.0f}",
                                         all, kMostFlorets)});
  return errors;
}

Errors expand_inflorescences(Figure& figure, const PlantParams& params, std::span<const Prototype> prototypes,
                             Seed seed) {
  constexpr double kMost = 2e6;
  if (std::ranges::none_of(params.organs,
                           [](const OrganParams& organ) { return organ.inflorescence.has_value(); }))
    return {};
  const std::vector<double> counts = floret_counts(params.organs);
  double all = 0;
  for (const Site& site : figure.sites)
    if (const OrganParams* organ = organ_of(params.organs, site.name))
      all += counts[static_cast<std::size_t>(organ - params.organs.data())];
  if (all > kMost)
    return {{"/organs",
             fmt::format("its inflorescences bear {:.0f} florets; expected at most {:.0f}", all, kMost)}};
  Rooms rooms(params, prototypes);
  std::vector<Site> kept;
  // Inflorescences may bear others, whose sites are added at the end.
  for (std::size_t i = 0; i < figure.sites.size(); ++i) {
    Site site = figure.sites[i];
    const OrganParams* organ = organ_of(params.organs, site.name);
    if (organ && organ->inflorescence)
      expand(figure, site, *organ, rooms, seed);
    else
      kept.push_back(std::move(site));
  }
  figure.sites = std::move(kept);
  return {};
}

}  // namespace frond
