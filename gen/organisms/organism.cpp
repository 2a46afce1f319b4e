#include "organisms/organism.h"

namespace frond {

namespace {

struct Grow {
  Seed seed;
  Result<Skeleton> operator()(const CoralParams& params) const { return grow_coral(params, seed); }
};

struct Check {
  Errors operator()(const CoralParams& params) const {
    Result<Grammar> grammar = coral_grammar(params);
    if (!grammar) return grammar.errors();
    return refuse(forecast(*grammar, grammar->text.steps, Seed{1}, grammar->text.limits),
                  grammar->text.limits);
  }
};

struct Foresee {
  Seed seed;
  Result<Foresight> operator()(const CoralParams& params) const {
    Result<Grammar> grammar = coral_grammar(params);
    if (!grammar) return grammar.errors();
    Forecast word = forecast(*grammar, grammar->text.steps, seed, grammar->text.limits);
    if (Errors errors = refuse(word, grammar->text.limits); !errors.empty()) return errors;
    return Foresight{word, 1 + word.segments * params.smoothing};
  }
};

}  // namespace

Result<Skeleton> grow(const Organism& organism, Seed seed) { return std::visit(Grow{seed}, organism.body); }

Result<Foresight> foresee(const Organism& organism, Seed seed) {
  return std::visit(Foresee{seed}, organism.body);
}

Errors check(const Organism& organism) { return std::visit(Check{}, organism.body); }

}  // namespace frond
