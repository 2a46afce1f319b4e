#include <benchmark/benchmark.h>

#include "dynamics/stand.h"

// Two hundred years of a wood, by the side of the land in metres.

namespace frond {
namespace {

void Wood(benchmark::State& state) {
  auto side = static_cast<float>(state.range(0));
  StandOptions options;
  options.area = {side, side};
  options.species.assign(tree_species().begin(), tree_species().end());
  StandHistory history;
  for (auto _ : state) history = simulate_stand(options, level_land(), Seed{1});
  double living = 0;
  for (int year = 10; year <= options.years; year += 10)
    living += static_cast<double>(living_at(history, year).size()) / (options.years / 10);
  state.counters["living"] = living;
  state.counters["lives"] = static_cast<double>(history.lives.size());
  state.counters["bytes"] =
      static_cast<double>(history.lives.size() * sizeof(TreeLife) + history.sizes.size() * sizeof(TreeSize));
}
BENCHMARK(Wood)->Unit(benchmark::kSecond)->UseRealTime()->Iterations(1)->Arg(100)->Arg(200)->Arg(400);

}  // namespace
}  // namespace frond
