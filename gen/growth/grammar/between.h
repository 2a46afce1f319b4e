#pragma once

#include "grammar/stream.h"

namespace frond {

/// An interpolated last derivation step: both words, and how far each module of the later word has grown.
struct Between {
  Word word;                        ///< the later one
  std::vector<Unfolding> growth;    ///< of each of its modules
  std::vector<std::uint64_t> name;  ///< of each module, constant over the steps that it lives; see between()
};

/// The shape after `steps` steps, which may be fractional. At first the result of a module occupies the place
/// of the module: its segments share the old length, turns are straight and branches empty; then they grow to
/// their final values. A module rewritten to one of its own kind keeps its place, and its parameters change
/// from the old to the new ones. So the shape passes each whole step smoothly, with zero speed. Only what a
/// rule removes disappears at once. Random jitter is drawn anew at each step, or with `named` by names that
/// modules keep while they live; that is slower, because all steps are followed.
Result<Between> between(const Grammar& grammar, double steps, Seed seed, const Limits& limits,
                        bool named = false);

/// Derives and walks to a step number that may be fractional. Returns the final state. With `named`, the
/// sink's `void module(std::uint64_t name)`, if any, is called before each module.
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
