#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/parallel.h"
#include "organisms/ivy/describe.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

class IvyGrower final : public Described<IvyParams, Grower> {
 public:
  GrowthStage stage() const override { return GrowthStage::creeping; }
  bool stands_on_rock() const override { return false; }
  Errors check() const override {
    const Crawl& crawl = params.crawl;
    if (crawl.lure == Lure::point || crawl.bias <= 0 || glm::length(crawl.toward) >= 1e-3f) return {};
    return {{"/crawl/toward", "found a vector of length 0; expected the direction that strands turn to"}};
  }
  Errors doubts() const override { return {}; }
  Errors check_together(std::span<const Organism* const>, double) const override { return {}; }
  /// How far ivy comes shows only on its host: here it always finds room.
  Result<Foresight> foresee(Seed) const override {
    const Crawl& crawl = params.crawl;
    double length = std::min(crawl.max_age * crawl.speed, crawl.max_length);
    double steps = length / crawl.speed, branches = crawl.branch_depth > 0 ? length / crawl.branch_every : 0;
    Foresight ivy;
    ivy.nodes = std::min(steps * (1 + 1.5 * branches), static_cast<double>(crawl.most_nodes));
    ivy.organs = ivy.parts = 0.5 * ivy.nodes * crawl.speed / std::max(params.leaves.spacing, 1e-3);
    ivy.shapes = 9000;
    ivy.riding = true;
    ivy.nodes_a_second = kTreeNodesASecond;
    return ivy;
  }
  double tallest() const override { return 0; }
  Dress dress() const override {
    Dress dress;
    dress.look.bark = params.bark;
    dress.motion = {params.growth, {}, {}, 1, false, params.flutter, params.leaves.unfold};
    dress.variation = params.bark.variation;
    return dress;
  }
  bool develops(bool) const override { return false; }
  std::optional<Result<Grammar>> grammar() const override { return std::nullopt; }
  const std::vector<std::string>* hosts() const override { return &params.on; }

  std::vector<Result<Specimen>> grow(std::span<const Bed> beds, const World& world,
                                     const Step& step) const override {
    std::vector<std::optional<Result<Specimen>>> grown(beds.size());
    parallel_for(beds.size(), [&](std::size_t i) {
      grown[i] = grower_of<IvyGrower>(*beds[i].organism).grow_bed(beds[i], world);
      step();
    });
    std::vector<Result<Specimen>> list;
    for (auto& one : grown) list.push_back(std::move(*one));
    return list;
  }
  Result<Model> grow_copy(const Organism&, Seed) const override {
    return Error{"", "ivy grows on other bodies"};
  }
  float copy_depth(const Model&) const override { return 0; }

 private:
  Result<Specimen> grow_bed(const Bed& bed, const World& world) const {
    const Organism& organism = *bed.organism;
    auto named = [&](Errors errors) {
      for (Error& error : errors)
        error.where = organism.name.empty() ? fmt::format("organism {}", bed.entry) : organism.name;
      return errors;
    };
    auto ground = [&](double x, double z) { return (*world.ground())(x, z); };
    IvyRoots roots;
    for (Vec2 at : organism.place.at)
      roots.emplace_back(at.x, ground(at.x, at.y) + organism.place.raise, at.y);
    auto host = world.host(params.on, "what the ivy grows on");
    if (!host) return named(host.errors());
    Result<Ivy> ivy = grow_ivy(params, **host, roots, organism.count, ground, bed.seed.child("grow"));
    if (!ivy) return named(ivy.errors());
    Specimen specimen{{organism.name, bed.entry}, std::move(ivy->model)};
    Dress worn = dress();
    specimen.look = worn.look;
    specimen.brightness = 1 + worn.variation * bed.seed.child("brightness").range(-1, 1);
    specimen.motion = worn.motion;
    specimen.motion.film_length = world.film_length();
    specimen.life.hanging = Hanging{std::move(ivy->strands), params.breeze};
    specimen.life.hanging->breeze.film_length = world.film_length();
    return specimen;
  }
};

}  // namespace

Kind<Organism> ivy_kind() { return make_grower<IvyGrower>("ivy", "Ivy that creeps over other bodies"); }

}  // namespace frond
