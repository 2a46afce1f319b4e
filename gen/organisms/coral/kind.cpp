#include "organisms/coral/describe.h"
#include "organisms/grammar_faults.h"
#include "organisms/kinds.h"

namespace frond {

namespace {

class CoralGrower final : public Described<CoralParams, LoneGrower> {
 public:
  Errors check() const override {
    bool own = params.form == CoralForm::own;
    if (own && params.grammar.where.ends_with("/steps"))
      return {{"/form", "found \"own\" and no rules; expected a \"grammar\""}};
    if (!own && params.own_rules)
      return {
          {"/grammar", "found rules, but the coral grows by those of its form; expected \"form\": \"own\""}};
    Result<Grammar> grammar = coral_grammar(params);
    Errors errors = grammar ? foreseen_trouble(*grammar) : grammar.errors();
    if (own) return pointed(params.grammar, std::move(errors));
    for (Error& error : errors) error.where.clear();  // its rules are ours
    return errors;
  }
  Errors doubts() const override {
    Result<Grammar> grammar = coral_grammar(params);
    return grammar ? pointed(params.grammar, grammar->warnings) : Errors{};
  }
  Result<Foresight> foresee(Seed seed) const override {
    Result<Foresight> coral = foresee_word(coral_grammar(params), seed, params.smoothing);
    if (coral) coral->riding = true;
    return coral;
  }
  double tallest() const override { return 0; }
  Dress dress() const override {
    Dress dress;
    dress.look.skin = params.skin;
    dress.motion = {params.growth, params.wave, params.food, 1};
    dress.variation = params.skin.tint.variation;
    return dress;
  }
  bool develops(bool) const override { return false; }
  std::optional<Result<Grammar>> grammar() const override { return coral_grammar(params); }
  Result<Model> grow_alone(Seed seed) const override {
    Result<Skeleton> skeleton = grow_coral(params, seed);
    if (!skeleton) return skeleton.errors();
    Model model;
    model.skeleton = std::move(*skeleton);
    return model;
  }
  std::function<Result<Model>(double)> develop(const Motion&, Seed) const override { return {}; }
};

}  // namespace

Kind<Organism> coral_kind() {
  return make_grower<CoralGrower>("coral", "A branching coral from an L-system");
}

}  // namespace frond
