#pragma once

#include <emscripten/bind.h>

#include <vector>

#include "core/result.h"
#include "core/vec.h"

// Answers of the engine to the page: objects of JavaScript.

namespace frond {

using emscripten::val;

/// An array of JavaScript's own, which stays when the memory of the engine grows.
template <class T>
val copied(const std::vector<T>& numbers) {
  return val(emscripten::typed_memory_view(numbers.size(), numbers.data())).call<val>("slice");
}

inline val list(const Errors& errors) {
  val out = val::array();
  for (const Error& error : errors) {
    val one = val::object();
    one.set("where", error.where), one.set("what", error.what);
    out.call<void>("push", one);
  }
  return out;
}

inline val failed(const Errors& errors) {
  val out = val::object();
  out.set("errors", list(errors));
  return out;
}

inline void put(std::vector<float>& out, Vec3 v) { out.insert(out.end(), {v.x, v.y, v.z}); }

inline void put_color(std::vector<float>& out, const Color& color) {
  put(out, {color.red, color.green, color.blue});
}

}  // namespace frond
