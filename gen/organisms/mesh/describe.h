#pragma once

#include "geometry/obj.h"
#include "organisms/mesh/mesh.h"
#include "preset/reader.h"

// The properties of bodies from files, as presets spell them; see preset/describe.h.

namespace frond {

inline constexpr Choice<Matter> kMeshMatters[] = {
    {"plain", Matter::plain, "one matt colour"},
    {"limestone", Matter::limestone, "dressed stone, weathered"},
    {"plaster", Matter::plaster, "lime plaster that flakes off"},
    {"brick", Matter::brick, "fired clay"},
    {"paint", Matter::paint, "painted wood"}};

template <class Visitor>
void describe(Visitor& v, MeshParams& m) {
  v.file(
      "file", m.file, [&](const NamedFile& file) { return load_unit_mesh(file, m.mesh); },
      "A Wavefront OBJ file, as seen from the preset's folder or from where Frond runs");
  v.required("file");
  v.number("size", m.size, {.min = 0.001, .max = 100, .unit = "m"}, "Of its longest side");
  v.choice("matter", m.matter, kMeshMatters, "What it is made of");
  v.color("color", m.color, "Of its surface");
  v.color("second", m.second, "Of stains and cracks");
  v.number("scale", m.scale, {.min = 0.001, .max = 10, .unit = "m"}, "Of the pattern");
  v.number("weathering", m.weathering, {.min = 0, .max = 1}, "Soot, damp and moss");
}

}  // namespace frond
