#pragma once

#include <optional>
#include <type_traits>

#include "core/ease.h"
#include "preset/describe.h"

namespace frond {

/// What presets call the ways in which something begins and ends.
inline constexpr Choice<Ease> kEases[] = {{"none", Ease::none, "at an even pace"},
                                          {"in", Ease::in, "slow at the beginning"},
                                          {"out", Ease::out, "slow at the end"},
                                          {"both", Ease::both, "slow at the beginning and at the end"}};

/// What a keyframe may say besides its time and its value.
template <class T>
struct KeyShape {
  std::optional<Ease> ease;
  std::optional<T> in, out;
};

template <class T>
void describe(Properties& v, KeyShape<T>& s) {
  v.shorthand("ease");
  v.choice("ease", s.ease, kEases,
           "How the way to the next key begins and ends; not given: as fast as at the keys beside it");
  if constexpr (!std::is_arithmetic_v<T>) {
    v.vector("in", s.in,
             "Handle, from the value, on the side that the way comes from; not given: opposite to out");
    v.vector("out", s.out,
             "Handle, from the value, on the side that the way goes on to; not given: opposite to in");
  }
}

}  // namespace frond
