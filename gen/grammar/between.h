#pragma once

#include "grammar/stream.h"

namespace frond {

/// The last step of a derivation in the making: both words, and how far each module of the later one has
/// grown.
struct Between {
  Word word;                      ///< the later one
  std::vector<Unfolding> growth;  ///< of each of its modules
};

/// The shape after `steps` steps, a number that need not be whole. What a module becomes takes its place at
/// first: the segments of the outcome share the length that was there, turns are straight and branches are
/// empty; then they grow to what they will be. A module that became one of its own kind keeps its place, and its
/// parameters change from the old ones to the new. So the shape passes each whole step without a jump, and with
/// speed zero. Only what a rule removes is gone at once, and random jitter is drawn anew with each step.
Result<Between> between(const Grammar& grammar, double steps, Seed seed, const Limits& limits);

/// Derives and walks to a number of steps that need not be whole. The state at the end.
template <class Sink>
Result<TurtleState> draw_between(const Grammar& grammar, double steps, Seed seed, Sink& sink,
                                 const Limits& limits = {}) {
  if (steps == std::floor(steps)) return draw(grammar, static_cast<int>(steps), seed, sink, limits);
  Result<Between> growing = between(grammar, steps, seed, limits);
  if (!growing) return growing.errors();
  Turtle<Sink> turtle(grammar, seed, sink, start_of(grammar));
  const double* parameters = growing->word.parameters.data();
  for (std::size_t i = 0; i < growing->word.size(); ++i) {
    SymbolId symbol = growing->word.symbols[i];
    turtle.set_growth(growing->growth[i]);
    turtle.feed(symbol, parameters);
    parameters += grammar.symbols[symbol].arity;
  }
  return turtle.state();
}

}  // namespace frond
