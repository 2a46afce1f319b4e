#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "appearance/picture_bounds.h"
#include "core/parallel.h"
#include "grove/age.h"
#include "grove/edit_tree.h"
#include "organisms/kinds.h"
#include "organisms/tree/topple.h"
#include "organisms/tree/tree.h"

namespace frond {

namespace {

constexpr int kNeighbours = 6;
constexpr double kMostLightCells = 50'000'000;  // tiles in the directory of a field of light

constexpr double kStormHeight = 0.5;    // of a cycle, in the course of which comes down what a storm breaks
constexpr double kShortestStorm = 0.8;  // seconds of a film

constexpr double kGrownASecond = 3e5;  // nodes of a tree of twenty cycles; each is a look at all of it

Filming filming_of(const Growth& growth, int cycles, double time) {
  Filming filming;
  if (growth.duration <= 0) return filming;
  filming.seconds_a_year = growth.duration / (cycles + 0.5);
  filming.overtime = std::max(0.0, time - growth.start - growth.duration);
  return filming;
}

/// Lets a tree grow in fewer cycles, each of which adds as much more: it is as tall and of the same habit,
/// with about `share` of its twigs.
void hurry(TreeParams& tree, double share) {
  constexpr double kTwigsByCycles = 2.3;  // twigs grow as the cycles to this power
  double fewer = std::pow(std::clamp(share, 0.05, 1.), 1 / kTwigsByCycles);
  tree.species.pace *= fewer;
  tree.species.internode /= fewer;
  tree.species.leaf_area /= fewer * fewer;
  tree.species.wood.twig_radius /= fewer;
  tree.light.voxel /= fewer;
  tree.leaves.size /= fewer;
  if (std::size_t most = tree.budget.most())
    tree.budget.internodes = static_cast<int>(std::clamp(share * static_cast<double>(most), 1., 1e8));
}

/// Trees of a scene grow together, in one light.
class TreeGrower final : public Described<TreeParams, Grower>, public Perennial {
 public:
  static constexpr std::string_view kLeading[] = {"years",
                                                  "habit/height",
                                                  "habit/internode",
                                                  "habit/branching_angle",
                                                  "habit/apical_control",
                                                  "habit/tropism",
                                                  "habit/droop",
                                                  "habit/wander",
                                                  "habit/shade_tolerance",
                                                  "habit/clear_trunk",
                                                  "leaves/kind",
                                                  "leaves/size",
                                                  "leaves/colors",
                                                  "bark/kind"};

  GrowerTraits traits() const override {
    const bool grows = params.growth.duration > 0;
    return {.stage = GrowthStage::in_light,
            .branches = true,
            .rebuilt = params.season ? Rebuilt::always
                       : grows       ? Rebuilt::in_films
                                     : Rebuilt::never,
            .tallest = params.species.height,
            .sunk = 0.3f,
            .sunk_most = 0,
            .faults_together = too_much_light};
  }
  const Perennial* perennial() const override { return this; }
  Review review() const override {
    if (Errors errors = check_guide(params.guide); !errors.empty()) return {errors};
    if (axes_of(*axes_of_guide(params.guide)).size() > 1)
      return {{{"/guide", "forks; expected one line: the stem of a tree that grows for light has one"}}};
    if (Errors errors = season_faults(params.season); !errors.empty()) return {errors};
    if (params.growth.rate > 0)
      return {{{"/growth/rate", "found one; expected none, as trees grow in years of their own"}}};
    return {check_pictures(params.coat, params.leaves.picture, "/leaves/picture/pixels")};
  }
  std::shared_ptr<const Grower> coarse(double share) const override {
    return changed(*this, [&](TreeParams& tree) { hurry(tree, share); });
  }
  Result<SizeEstimate> estimate_size(Seed seed) const override {
    SizeEstimate tree;
    // Once its life is over it bears no leaves, and its twigs drop within some years.
    TreeParams living = params;
    living.years = std::min(params.years, std::max(1, static_cast<int>(params.species.lifespan)));
    double bare = (params.years - living.years) / std::max(0.5, params.species.wood.deadwood);
    double grown = estimate_tree_nodes(living, seed);
    if (std::size_t most = params.budget.most()) grown = std::min(grown, static_cast<double>(most));
    tree.nodes = grown * std::exp(-bare);
    tree.word.modules = tree.word.segments = tree.nodes;
    if (params.leaves.size > 0 && bare == 0) tree.organs = tree.parts = 1.1 * tree.nodes;
    tree.seconds = grown * std::max(20, cycles_of(params)) / (20 * kGrownASecond);
    tree.nodes_a_second = 1e7;  // those seconds are all
    return tree;
  }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.branches = {.bark = params.bark, .coat = params.coat};
    if (params.leaves.size > 0 && params.leaves.picture) appearance.look.leaves = pictured_leaves(params);
    set_season(appearance, params.season);
    appearance.motion = {params.growth, params.wave, {}, 1, true};
    const Wood& wood = params.species.wood;
    appearance.motion.wood = SwayWood{wood.density, wood.stiffness, wood.leaf_mass};
    appearance.variation = params.bark.variation;
    return appearance;
  }
  std::optional<StormTime> storm_of(const Event& event) const override {
    const int cycles = cycles_of(params);
    double cycle = std::max(1.0, std::floor(cycle_at_age(params.species, event.year)));
    if (params.growth.duration <= 0 || cycle > cycles) return std::nullopt;
    double seconds = filming_of(params.growth, cycles, 0).seconds_a_year;
    return StormTime{params.growth.start + (cycle + kStormHeight) * seconds,
                     std::max(kShortestStorm, kStormHeight * seconds), storm_gust(params.wind, event.storm)};
  }

  std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                     const Step& step) const override {
    std::vector<std::pair<const Bed*, const Planting*>> all;
    std::vector<TreeSite> sites;
    bool history = false;
    for (const Bed& bed : beds) {
      const TreeParams& own = grower_of<TreeGrower>(*bed.organism).params;
      history = history || (own.growth.duration > 0 && world.filmed());
      for (std::size_t i = 0; i < bed.plantings.size(); ++i) {
        const Planting& planting = bed.plantings[i];
        all.emplace_back(&bed, &planting);
        sites.push_back({&own, planting.foot, lean_of(*bed.organism, planting.seed),
                         age_of(*bed.organism, planting.seed, "size"), planting.seed.child("grow"),
                         bed.organism->name, edits_of(bed.organism->edits, i)});
      }
    }
    std::vector<Surface> bodies = world.bodies();
    Detour detour;
    if (!bodies.empty()) {
      Result<std::shared_ptr<const Obstacles>> obstacles = world.obstacles();
      if (!obstacles) return std::vector<Result<Specimen>>(all.size(), obstacles.errors());
      detour = [round = *obstacles](Vec3 from, Vec3 to, float clearance) {
        return round->way(from, to, clearance);
      };
    }
    Grove grove = grow_trees(sites, history, world.seed().child("weather"), bodies, detour, world.events(),
                             world.storms_toward());

    std::vector<Specimen> trees(all.size());
    parallel_for(all.size(), [&](std::size_t i) {
      auto [bed, planting] = all[i];
      const Grower& grower = *bed->organism->grower;
      Specimen& tree = trees[i];
      tree.name = bed->organism->name;
      tree.entry = bed->entry;
      apply_appearance(tree, grower.appearance(), world, planting->seed);
      tree.placement.foot = planting->foot;
      GrowthRecord record{*sites[i].params,    grove.cycles,   world.filmed(),
                          world.film_length(), world.ground(), planting->seed.child("look")};
      set_grown(tree, record, std::make_shared<const GrownTree>(std::move(grove.trees[i])));
      step();
    });
    return {std::make_move_iterator(trees.begin()), std::make_move_iterator(trees.end())};
  }

  std::shared_ptr<const Grower> at_age(double years, double dead, double clear) const override {
    return changed(*this, [&](TreeParams& p) {
      p.species.clear_trunk = std::max(p.species.clear_trunk, clear);
      p.years = std::clamp(static_cast<int>(std::lround(years)), 1, params.years);
      p.growth.duration = 0;
      if (dead <= 0) return;
      p.species.lifespan = p.years;
      p.years += static_cast<int>(std::lround(dead));
    });
  }

  std::vector<float> heights(const Organism& organism, Seed seed) const override {
    const std::vector<Size> sizes = grow_crowded(organism, seed).trees[0].sizes;
    std::vector<float> result;
    for (int year = 1; year <= params.years; ++year) {
      auto cycle = static_cast<std::size_t>(growth_cycles(params.species, year));
      if (cycle <= sizes.size()) result.push_back(sizes[cycle - 1].height);
    }
    return result;
  }

  Result<Model> grow_copy(const Organism& organism, Seed seed) const override {
    Grove grove = grow_crowded(organism, seed);
    const GrownTree& grown = grove.trees[0];
    double cycle = cycle_at({}, grove.cycles, 0);
    Model model = tree_model(params, grown, cycle, {}, seed.child("look"));
    if (grown.uprooting.time <= cycle) lay_down(model, tree_fall(params, grown, Heights()));
    return model;
  }

 private:
  /// The field of light of all of them together may be too large.
  static Errors too_much_light(std::span<const Organism* const> all, double relief) {
    double reach = 0, low = 0, high = 0;
    for (const Organism* o : all) {
      double tall = o->grower->traits().tallest * (1 + o->place.size_variation);
      reach = std::max(reach, reach_of(*o) + tall / 2);
      low = std::min(low, o->place.raise), high = std::max(high, o->place.raise + tall);
    }
    high += relief;
    double voxel = grower_of<TreeGrower>(*all[0]).params.light.voxel;
    double tiles = std::pow(2 * reach / (16 * voxel), 2) * (high - low) / voxel;
    if (tiles <= kMostLightCells) return {};
    return {{"/light/voxel",
             fmt::format("cells of {:g} m are too many for light {:.3g} m wide and {:.3g} m high; expected "
                         "{:.2g} m or more, or trees nearer to each other",
                         voxel, 2 * reach, high - low, voxel * std::cbrt(tiles / kMostLightCells) * 1.05)}};
  }

  /// One that grew up among others at the distance that the sowing says.
  Grove grow_crowded(const Organism& organism, Seed seed) const {
    double crowd = organism.sown->crowd, age = age_of(organism, seed, "age");
    std::vector<TreeSite> sites{{&params,
                                 Vec3(0),
                                 Quat(1, 0, 0, 0),
                                 age,
                                 seed.child("tree"),
                                 {},
                                 edits_of(organism.edits, std::nullopt)}};
    double turn = seed.child("ring").range(0, 2 * kPi);
    for (std::uint64_t k = 0; crowd > 0 && k < kNeighbours; ++k) {
      Seed own = seed.child("neighbour", k);
      double angle = turn + 2 * kPi * (static_cast<double>(k) + own.child(0).range(-0.2, 0.2)) / kNeighbours;
      double far = crowd * own.child(1).range(0.85, 1.15);
      sites.push_back({&params, Vec3(far * std::cos(angle), 0, far * std::sin(angle)), Quat(1, 0, 0, 0),
                       age * own.child(2).range(0.75, 0.95), own.child("tree")});
    }
    return grow_trees(sites, false, seed.child("weather"));
  }
  static double age_of(const Organism& organism, Seed seed, std::string_view purpose) {
    return 1 + organism.place.size_variation * seed.child(purpose).range(-1, 1);
  }

  /// The fall of an uprooted tree, from when it begins.
  static Fall tree_fall(const TreeParams& params, const GrownTree& grown, const Heights& ground) {
    return fall_of(standing(grown, params.species, grown.uprooting.time, {}), grown, params.species,
                   [&](double x, double z) { return ground(x, z); });
  }

  /// What a grown tree is modelled by.
  struct GrowthRecord {
    TreeParams params;
    int cycles = 0;
    bool filmed = false;
    double film_length = 0;
    std::shared_ptr<const Heights> ground;
    Seed look;
    std::vector<Edit> edits = {};  ///< that say what branches bear and wear
  };

  /// Gives a tree its model, and its life where that is filmed.
  static void set_grown(Specimen& tree, const GrowthRecord& record, std::shared_ptr<const GrownTree> grown) {
    const auto& [params, cycles, filmed, film_length, ground, look, edits] = record;
    bool grows = filmed && params.growth.duration > 0;
    double cycle = filmed ? cycles + 0.5 : cycle_at(params.growth, cycles, film_length);
    Filming filming = filming_of(params.growth, cycles, 0);
    double leafy = 0;
    if (grown->uprooting.time <= cycle) {
      Fall fall = tree_fall(params, *grown, *ground);
      leafy = grows ? fall.length() : 0;
      fall.start = grows ? tree.motion.growth.start + grown->uprooting.time * filming.seconds_a_year : -1e9;
      tree.life.fall = std::make_shared<const Fall>(std::move(fall));
      tree.life.ground = ground;
    }
    tree.model = tree_model(params, *grown, cycle, filming, look);
    const std::size_t colors = tree.look.branches.own_colors();
    strip_model(tree.model, edits);
    color_barks(tree.model, edits, colors);
    tree.model.notes = grown->notes;
    tree.life.held = grown->held();
    tree.life.edit = [record, grown](Specimen& same, std::span<const Edit> given) {
      auto changed = std::make_shared<GrownTree>(*grown);
      std::vector<std::string> notes = edit_tree(*changed, given);
      GrowthRecord edited = record;
      edited.edits.assign(given.begin(), given.end());
      set_grown(same, edited, std::move(changed));
      same.model.notes.insert(same.model.notes.end(), notes.begin(), notes.end());
    };
    const Growth growth = tree.motion.growth;
    tree.life.age = [species = params.species, cycles = cycles, born = grown->born[0], growth](double time) {
      return age_at_cycle(species, std::max(0.0, cycle_at(growth, cycles, time) - born));
    };
    if (!grows) return;
    tree.life.develop = [params = params, grown, cycles = cycles, look = look, leafy, growth, edits = edits,
                         colors](double time) -> Result<Model> {
      Filming now = filming_of(growth, cycles, time);
      now.leafy = leafy;
      Model model = tree_model(params, *grown, cycle_at(growth, cycles, time), now, look);
      strip_model(model, edits);
      color_barks(model, edits, colors);
      return model;
    };
  }
};

}  // namespace

Kind<Organism> tree_kind() {
  return make_grower<TreeGrower>("tree", "A tree that fights for light; all of a scene grow together");
}

}  // namespace frond
