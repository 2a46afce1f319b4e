#pragma once

#include "grammar/stream.h"

namespace frond {

/// The last step of a derivation in the making: both words, and how far each module of the later one has
/// grown.
struct Between {
  Word word;                        ///< the later one
  std::vector<Unfolding> growth;    ///< of each of its modules
  std::vector<std::uint64_t> name;  ///< of each module, the same in all steps that it lives; see between()
};

/// The shape after `steps` steps, a number that need not be whole. What a module becomes takes its place at
/// first: the segments of the outcome share the length that was there, turns are straight and branches are
/// empty; then they grow to what they will be. A module that became one of its own kind keeps its place, and
/// its parameters change from the old ones to the new. So the shape passes each whole step without a jump,
/// and with speed zero. Only what a rule removes is gone at once. Random jitter is drawn anew with each step,
/// or, with `named`, by names that modules keep as long as they live, which costs time: all steps are
/// followed then.
Result<Between> between(const Grammar& grammar, double steps, Seed seed, const Limits& limits,
                        bool named = false);

/// Derives and walks to a number of steps that need not be whole. The state at the end. With `named`, a sink
/// that has `void module(std::uint64_t name)` is told of each module before it is walked.
template <class Sink>
Result<TurtleState> draw_between(const Grammar& grammar, double steps, Seed seed, Sink& sink,
                                 const Limits& limits = {}, bool named = false) {
  if (!named && steps == std::floor(steps)) return draw(grammar, static_cast<int>(steps), seed, sink, limits);
  Result<Between> growing = between(grammar, steps, seed, limits, named);
  if (!growing) return growing.errors();
  Turtle<Sink> turtle(grammar, seed, sink, start_of(grammar));
  const double* parameters = growing->word.parameters.data();
  for (std::size_t i = 0; i < growing->word.size(); ++i) {
    SymbolId symbol = growing->word.symbols[i];
    turtle.set_growth(growing->growth[i]);
    if (named) {
      turtle.set_name(growing->name[i]);
      if constexpr (requires { sink.module(growing->name[i]); }) sink.module(growing->name[i]);
    }
    turtle.feed(symbol, parameters);
    parameters += grammar.symbols[symbol].arity;
  }
  if (Errors errors = turtle.trouble(); !errors.empty()) return errors;
  return turtle.finish();
}

}  // namespace frond
