#include "scene/edit_checks.h"

#include <fmt/format.h>

namespace frond {

Errors edit_faults(const Organism& organism) {
  const Grower& grower = *organism.grower;
  if (organism.edits.empty()) return {};
  if (const GrowerTraits traits = grower.traits(); !traits.branches || traits.creeps())
    return {{"/edits", "are of branches; expected a kind that has them and does not creep"}};
  Errors errors;
  for (std::size_t i = 0; i < organism.edits.size(); ++i) {
    const Edit& edit = organism.edits[i];
    auto add = [&](std::string_view name, std::string what) {
      errors.push_back({fmt::format("/edits/{}{}", i, name), std::move(what)});
    };
    const int given = edit.cut.has_value() + edit.bend.has_value() + edit.strength.has_value() +
                      (edit.bare ? 1 : 0) + edit.bark.has_value();
    if (given != 1)
      add("", fmt::format("has {} of cut, bend, strength, bare and bark; expected one of them", given));
    if (edit.bark && !grower.appearance().look.branches.plant())
      add("/bark", "is of plants; expected an edit of a kind whose branches have bark");
    if (edit.dated() && !grower.perennial())
      add("/cut", "names a year; expected true, or the kind tree, which grows over years");
    if (edit.bend && edit.at.share == 0)
      add("/at", "is where the limb is held; expected a place farther along it to pull at, as \"3:0.8\"");
  }
  return errors;
}

Errors edit_warnings(const Organism& organism) {
  Errors warnings;
  for (std::size_t i = 0; i < organism.edits.size(); ++i) {
    const auto& plant = organism.edits[i].plant;
    if (plant && (organism.sown || *plant >= static_cast<std::size_t>(organism.count)))
      warnings.push_back({fmt::format("/edits/{}/plant", i),
                          organism.sown
                              ? "does nothing: what is sown has copies only"
                              : fmt::format("finds no plant: there are {}, counted from 0", organism.count)});
  }
  return warnings;
}

}  // namespace frond
