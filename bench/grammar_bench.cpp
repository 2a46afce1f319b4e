#include <benchmark/benchmark.h>

#include <cstring>

#include "core/parallel.h"
#include "grammar/figure.h"
#include "grammar/stream.h"

namespace frond {
namespace {

struct Job {
  const char* axiom;
  int steps;
  std::vector<GrammarText::Rule> rules;
  const char* ignore = "";
  std::vector<std::pair<std::string, std::string>> constants = {};
};

const Job kKoch{"F-F-F-F", 6, {{"F -> F-F+F+FF-F-F+F"}}};
const Job kKochLong{"F-F-F-F", 8, {{"F -> F-F+F+FF-F-F+F"}}};
const Job kPlant{"X", 8, {{"X -> F-[[X]+X]+F[+FX]-X"}, {"F -> FF"}}};
const Job kAlgae{"A", 27, {{"A -> AB"}, {"B -> A"}}};
const Job kChance{"F", 13, {{"F ->(0.33) F[+F]F[-F]F"}, {"F ->(0.33) F[+F]F"}, {"F ->(0.34) F[-F]F"}}};
const Job kHogeweg{"F1F1F1",
                   40,
                   {{"0 < 0 > 0 -> 1"},
                    {"0 < 0 > 1 -> 1[-F1F1]"},
                    {"0 < 1 > 0 -> 1"},
                    {"0 < 1 > 1 -> 1"},
                    {"1 < 0 > 0 -> 0"},
                    {"1 < 0 > 1 -> 1F1"},
                    {"1 < 1 > 0 -> 1"},
                    {"1 < 1 > 1 -> 0"},
                    {"+ -> -"},
                    {"- -> +"}},
                   "+-F"};
const Job kHonda{"A(1,10)",
                 20,
                 {{"A(l,w) -> !(w)F(l)[&(a0)B(l*r2,w*wr)]/(d)A(l*r1,w*wr)"},
                  {"B(l,w) -> !(w)F(l)[-(a2)$C(l*r2,w*wr)]C(l*r1,w*wr)"},
                  {"C(l,w) -> !(w)F(l)[+(a2)$B(l*r2,w*wr)]B(l*r1,w*wr)"}},
                 "",
                 {{"r1", "0.9"}, {"r2", "0.6"}, {"a0", "45"}, {"a2", "45"}, {"d", "137.5"}, {"wr", "0.707"}}};

Grammar grammar_of(const Job& job) {
  GrammarText text;
  text.axiom = job.axiom;
  text.rules = job.rules;
  text.ignore = job.ignore;
  text.constants = job.constants;
  text.angle = 22.5;
  return std::move(*compile(text));
}

/// Modules a second of the last word over the whole derivation.
void derive_job(benchmark::State& state, const Job& job) {
  Grammar grammar = grammar_of(job);
  parallel_for(64, [](std::size_t) {});  // threads held back from the start would not be called later
  limit_threads(static_cast<int>(state.range(0)));
  std::size_t modules = 0, bytes = 0;
  for (auto _ : state) {
    Result<Word> word = derive(grammar, job.steps, Seed{1});
    modules = word->size(), bytes = word->bytes();
    benchmark::DoNotOptimize(word->symbols.data());
  }
  limit_threads(0);
  state.counters["modules"] = static_cast<double>(modules);
  state.counters["bytes/module"] = static_cast<double>(bytes) / static_cast<double>(modules);
  state.counters["Mmod/s"] =
      benchmark::Counter(static_cast<double>(modules) * static_cast<double>(state.iterations()) / 1e6,
                         benchmark::Counter::kIsRate);
}

/// What a tight loop can do: one letter a byte, no parameters, every step in turn, successors stored in
/// blocks of 16 bytes into one of two buffers.
void tight_job(benchmark::State& state, const Job& job) {
  std::array<std::string, 256> successor;
  for (int c = 0; c < 256; ++c) successor[static_cast<std::size_t>(c)] = std::string(1, static_cast<char>(c));
  for (const auto& rule : job.rules)
    successor[static_cast<unsigned char>(rule.text[0])] = rule.text.substr(5);
  std::array<std::array<char, 32>, 256> block{};
  std::array<std::uint8_t, 256> length{};
  for (std::size_t c = 0; c < 256; ++c) {
    length[c] = static_cast<std::uint8_t>(successor[c].size());
    std::memcpy(block[c].data(), successor[c].data(), length[c]);
  }
  std::size_t modules = 0;
  for (auto _ : state) {
    Buffer<char> word(job.axiom, job.axiom + std::strlen(job.axiom)), next;
    for (int step = 0; step < job.steps; ++step) {
      std::size_t size = 0;
      for (char c : word) size += length[static_cast<unsigned char>(c)];
      next.clear();
      next.resize(size + 32);
      char* out = next.data();
      for (char c : word) {
        auto index = static_cast<unsigned char>(c);
        std::memcpy(out, block[index].data(), 16);
        if (length[index] > 16) std::memcpy(out + 16, block[index].data() + 16, 16);
        out += length[index];
      }
      next.resize(size);
      std::swap(word, next);
    }
    modules = word.size();
    benchmark::DoNotOptimize(word.data());
  }
  state.counters["Mmod/s"] =
      benchmark::Counter(static_cast<double>(modules) * static_cast<double>(state.iterations()) / 1e6,
                         benchmark::Counter::kIsRate);
}

struct Count {
  std::size_t segments = 0;
  double sum = 0;
  void segment(const Segment& s, TurtleState&) { ++segments, sum += s.to.y; }
};

void walk_job(benchmark::State& state, const Job& job, bool streamed) {
  Grammar grammar = grammar_of(job);
  Word word = *derive(grammar, job.steps, Seed{1});
  Count count;
  for (auto _ : state) {
    if (streamed)
      benchmark::DoNotOptimize(draw(grammar, job.steps, Seed{1}, count).ok());
    else
      walk(grammar, word, Seed{1}, count);
  }
  benchmark::DoNotOptimize(count.sum);
  double all = static_cast<double>(state.iterations()) / 1e6;
  state.counters["Mseg/s"] =
      benchmark::Counter(static_cast<double>(count.segments) / 1e6, benchmark::Counter::kIsRate);
  state.counters["Mmod/s"] =
      benchmark::Counter(static_cast<double>(word.size()) * all, benchmark::Counter::kIsRate);
}

#define FROND_DERIVE(name, job) \
  BENCHMARK_CAPTURE(derive_job, name, job)->Arg(1)->MinTime(0.3)->MeasureProcessCPUTime()

FROND_DERIVE(koch_6, kKoch);
BENCHMARK_CAPTURE(tight_job, koch_6, kKoch)->MinTime(0.3);
FROND_DERIVE(plant_8, kPlant);
BENCHMARK_CAPTURE(tight_job, plant_8, kPlant)->MinTime(0.3);
FROND_DERIVE(algae_27, kAlgae);
BENCHMARK_CAPTURE(tight_job, algae_27, kAlgae)->MinTime(0.3);
FROND_DERIVE(koch_8, kKochLong)->Arg(2);
BENCHMARK_CAPTURE(tight_job, koch_8, kKochLong)->MinTime(0.3);
FROND_DERIVE(chance_13, kChance)->Arg(2);
FROND_DERIVE(hogeweg_40, kHogeweg);
FROND_DERIVE(honda_20, kHonda)->Arg(2);
BENCHMARK_CAPTURE(walk_job, plant_8, kPlant, false)->MinTime(0.3);
BENCHMARK_CAPTURE(walk_job, honda_20, kHonda, false)->MinTime(0.3);
BENCHMARK_CAPTURE(walk_job, plant_8_streamed, kPlant, true)->MinTime(0.3);
BENCHMARK_CAPTURE(walk_job, koch_6_streamed, kKoch, true)->MinTime(0.3);

}  // namespace
}  // namespace frond
