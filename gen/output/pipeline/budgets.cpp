#include "pipeline/write_film.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>

#include "jobs/jobs.h"

namespace frond {

namespace {

constexpr int kMeasuredInternodes = 20'000;      // internodes of the tree that tells the pace
constexpr double kShortestGrowth = 1e-4;         // seconds that growing it is taken to last at least
constexpr double kMostInternodes = 100'000'000;  // internodes of a budget

/// How many internodes a tree of an entry grows in a second, alone and up to kMeasuredInternodes of them.
Result<double> pace_of_growth(const ReadAgain& again, std::size_t entry, const std::string& pointer) {
  Result<Preset> preset = again({set_of({pointer, 0, kMeasuredInternodes})});
  if (!preset) return preset.errors();
  Organism organism = preset->organisms[entry];
  organism.sown = Sowing{};
  auto start = std::chrono::steady_clock::now();
  Result<Model> tree = organism.grower->grow_copy(organism, Seed{1});
  std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
  if (!tree) return tree.errors();
  return static_cast<double>(tree->skeleton.size()) / std::max(took.count(), kShortestGrowth);
}

/// A number rounded to two digits.
int two_digits(double number) {
  double unit = std::pow(10, std::floor(std::log10(std::max(number, 1.0))) - 1);
  return static_cast<int>(std::clamp(std::round(number / unit) * unit, 1.0, kMostInternodes));
}

/// The seconds of a budget that has no internodes; 0: none.
double seconds_of(const Value& organism) {
  const Value* budget = organism.find("budget");
  const Value* seconds = budget ? budget->find("seconds") : nullptr;
  const Value* internodes = budget ? budget->find("internodes") : nullptr;
  return !seconds || (internodes && internodes->number > 0) ? 0 : seconds->number;
}

/// Counts those of a preset that have not been, see count_budgets().
Result<std::vector<Manifest::Budget>> counted_budgets(const Preset& preset, const ReadAgain& again,
                                                      const std::filesystem::path& film) {
  std::vector<Manifest::Budget> counted;
  const Value* organisms = preset.written->find("organisms");
  for (std::size_t i = 0; organisms && i < organisms->items.size(); ++i) {
    double seconds = seconds_of(organisms->items[i]);
    if (seconds <= 0) continue;
    Manifest::Budget budget{fmt::format("/organisms/{}/budget", i), seconds};
    if (Result<Manifest> before = manifest_in(film)) {
      auto same = std::ranges::find_if(before->budgets, [&](const Manifest::Budget& b) {
        return b.pointer == budget.pointer && b.seconds == seconds;
      });
      if (same != before->budgets.end()) budget = *same;
    }
    if (budget.internodes == 0) {
      Result<double> pace = pace_of_growth(again, i, budget.pointer);
      if (!pace) return pace.errors();
      budget.internodes = two_digits(seconds * *pace);
    }
    counted.push_back(budget);
  }
  return counted;
}

}  // namespace

std::string set_of(const Manifest::Budget& budget) {
  return fmt::format("{}/internodes={}", budget.pointer, budget.internodes);
}

Result<std::vector<Manifest::Budget>> count_budgets(Preset& preset, const ReadAgain& again,
                                                    const std::filesystem::path& out, RunEvents& events) {
  Result<std::vector<Manifest::Budget>> budgets = counted_budgets(preset, again, out);
  if (!budgets || budgets->empty()) return budgets;
  std::vector<std::string> sets;
  for (const Manifest::Budget& budget : *budgets) {
    events.note(fmt::format(
        "note: {}: {:g} s are counted as {} internodes; \"internodes\": {} in the preset gives the "
        "same trees in any folder",
        budget.pointer, budget.seconds, budget.internodes, budget.internodes));
    sets.push_back(set_of(budget));
  }
  Result<Preset> counted = again(sets);
  if (!counted) return counted.errors();
  preset = std::move(*counted);
  return budgets;
}

}  // namespace frond
