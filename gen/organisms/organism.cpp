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
    return grammar ? Errors{} : grammar.errors();
  }
};

}  // namespace

Result<Skeleton> grow(const Organism& organism, Seed seed) { return std::visit(Grow{seed}, organism.body); }

Errors check(const Organism& organism) { return std::visit(Check{}, organism.body); }

}  // namespace frond
