#pragma once

#include <pybind11/functional.h>
#include <pybind11/numpy.h>
#include <pybind11/pybind11.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <memory>
#include <vector>

#include "core/result.h"
#include "core/vec.h"
#include "model/skeleton.h"

// The module `_frond` of Python, a file for each part of it. What it offers is documented for its users in
// frond/_frond.pyi; frond/__init__.py gives it its names.

namespace frond {

namespace py = pybind11;

/// Throws frond.FrondError with those errors.
[[noreturn]] void raise(const Errors& errors);

/// The value, or the exception.
template <class T>
T or_raise(Result<T> result) {
  if (!result) raise(result.errors());
  return std::move(*result);
}

/// How many numbers an element holds, and of which type they are.
template <class T>
struct Row {
  using Number = T;
  static constexpr py::ssize_t kWidth = 0;  ///< a number by itself
};
template <glm::length_t N, class T, glm::qualifier Q>
struct Row<glm::vec<N, T, Q>> {
  using Number = T;
  static constexpr py::ssize_t kWidth = N;
};
template <>
struct Row<Quat> {
  using Number = float;
  static constexpr py::ssize_t kWidth = 4;
};
template <class T, std::size_t N>
struct Row<std::array<T, N>> {
  using Number = T;
  static constexpr py::ssize_t kWidth = N;
};

/// A list of numbers or vectors as a read-only array of numpy that shares its memory and keeps `owner` alive.
template <class T, class Allocator>
py::array_t<typename Row<T>::Number> viewed(const std::vector<T, Allocator>& list, py::handle owner) {
  using Number = typename Row<T>::Number;
  std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(list.size())};
  if (Row<T>::kWidth > 0) shape.push_back(Row<T>::kWidth);
  py::array_t<Number> array(shape, reinterpret_cast<const Number*>(list.data()), owner);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/// The property of a class that is such an array: `array_of(&Skeleton::position)`.
template <class Owner, class List>
py::cpp_function array_of(List Owner::*list) {
  return py::cpp_function([list](py::object self) { return viewed(self.cast<const Owner&>().*list, self); });
}

/// A part of something that is shared, which keeps the whole alive. Python sees constants only.
template <class Whole, class Part>
std::shared_ptr<Part> part_of(const std::shared_ptr<Whole>& whole, const Part& part) {
  return {whole, const_cast<Part*>(&part)};
}

void add_models(py::module_& module);
void add_presets(py::module_& module);
void add_scenes(py::module_& module);
void add_grammars(py::module_& module);
void add_cpfg_models(py::module_& module);
void add_renders(py::module_& module);

}  // namespace frond
