#include <algorithm>

#include "organisms/grammar_faults.h"
#include "organisms/kinds.h"
#include "organisms/plant/describe.h"
#include "organisms/plant/foresee.h"

namespace frond {

namespace {

class PlantGrower final : public Described<PlantParams, LoneGrower> {
 public:
  Errors check() const override {
    Result<Grammar> grammar = plant_grammar(params);
    return pointed(params.grammar, grammar ? foreseen_trouble(*grammar) : grammar.errors());
  }
  Errors doubts() const override {
    Result<Grammar> grammar = plant_grammar(params);
    return grammar ? pointed(params.grammar, grammar->warnings) : Errors{};
  }
  Result<Foresight> foresee(Seed seed) const override {
    Result<Foresight> plant = foresee_word(plant_grammar(params), seed, params.smoothing);
    if (plant) count_organs(params, seed, *plant);
    return plant;
  }
  double tallest() const override { return params.height; }
  Dress dress() const override {
    Dress dress;
    dress.look.bark = params.bark;
    dress.look.blades = params.blades;
    dress.season = params.season;
    dress.motion = {params.growth, params.wave, {}, 1};
    dress.variation = params.bark.variation;
    return dress;
  }
  bool develops(bool) const override { return params.by_steps || params.season; }
  std::optional<Result<Grammar>> grammar() const override { return plant_grammar(params); }
  Result<Model> grow_alone(Seed seed) const override { return grow_plant(params, seed); }
  /// By steps it grows anew for each frame.
  std::function<Result<Model>(double)> develop(const Motion& motion, Seed seed) const override {
    if (!params.by_steps) return {};
    return [params = params, growth = motion.growth, seed](double time) {
      double share = std::min(growth_front(growth, time) / (1 + growth.ripen), 1.0);
      return grow_plant(params, seed, share);
    };
  }
};

}  // namespace

Kind<Organism> plant_kind() {
  return make_grower<PlantGrower>("plant", "Anything that an L-system draws: herbs, trees, curves");
}

}  // namespace frond
