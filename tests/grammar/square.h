#pragma once

#include <string>

#include "grammar/figure.h"

namespace frond {

/// A grammar that only has a word to draw, with turns of a right angle.
inline Grammar grammar_for(const std::string& axiom) {
  GrammarText text;
  text.axiom = axiom;
  text.angle = 90;
  return std::move(*compile(text));
}

}  // namespace frond
