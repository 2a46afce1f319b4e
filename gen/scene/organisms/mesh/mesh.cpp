#include "organisms/mesh/mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "organisms/kinds.h"
#include "preset/value.h"

namespace frond {

inline constexpr Choice<Matter> kMeshMatters[] = {
    {"plain", Matter::plain, "one matt colour"},
    {"limestone", Matter::limestone, "dressed stone, weathered"},
    {"plaster", Matter::plaster, "lime plaster that flakes off"},
    {"brick", Matter::brick, "fired clay"},
    {"paint", Matter::paint, "painted wood"}};

inline constexpr Choice<UpAxis> kUpAxes[] = {{"y", UpAxis::y, "y is up, and z comes to the front"},
                                             {"z", UpAxis::z, "z is up, and -y comes to the front"}};

inline constexpr Choice<LengthUnit> kLengthUnits[] = {{"mm", LengthUnit::millimetres, "millimetres"},
                                                      {"cm", LengthUnit::centimetres, "centimetres"},
                                                      {"m", LengthUnit::metres, "metres"},
                                                      {"in", LengthUnit::inches, "inches"},
                                                      {"ft", LengthUnit::feet, "feet"}};

// The file is cut as `up` and `parts` say, so these are read before it.
void describe(Properties& v, MeshParams& m) {
  v.choice("up", m.up, kUpAxes, "Axis of the file that points up");
  v.list("parts", m.parts,
         "Names of the objects, groups or materials of the file that are taken; without any, all");
  v.file(
      "file", m.file, [&](const NamedFile& file) { return load_mesh_body(file, m); },
      "A mesh as Wavefront OBJ, PLY, STL or GLB, named as seen from the preset's folder or from where Frond "
      "runs; the middle of its underside stands at its place");
  v.required("file");
  v.number("size", m.size, metres(0.001, 100), "Length of its longest side, to which the file is scaled");
  v.given("size", m.own_size);
  v.choice("unit", m.unit, kLengthUnits,
           "Unit of length of the file, which keeps its size; in place of size");
  v.list("carries", m.carries,
         "Names of the objects, groups or materials of the file that others may creep on; without any, all");
  v.choice("matter", m.matter, kMeshMatters,
           "What it is made of; without it, what the file's materials say of colour, picture and opacity, if "
           "it has any");
  v.given("matter", m.own_matter);
  v.color("color", m.color,
          "Colour of its surface; without it, the colours of the file's materials, if it has any");
  v.given("color", m.own_color);
  v.color("second", m.second, "Colour of stains and cracks");
  v.number("scale", m.scale, metres(0.001, 10), "Size of the pattern");
  v.number("weathering", m.weathering, kShare, "How much soot, damp and moss there is");
  v.aspect(Aspect::look, "matter", "color", "second", "scale", "weathering");
}

namespace {

class MeshGrower final : public Described<MeshParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"file",   "size",  "matter",    "color",
                                                  "second", "scale", "weathering"};

  Review review() const override { return {faults(), mesh_warnings(params)}; }
  Appearance appearance() const override {
    Appearance appearance;
    appearance.look.pictures = mesh_pictures(params);
    return appearance;
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    std::size_t triangles = params.body ? params.body->cut.surface.triangle.size() : 0;
    return SizeEstimate{.triangles = static_cast<double>(triangles), .blocks = 1};
  }
  Result<Model> grow_alone(Seed) const override { return build_mesh_model(params); }

 private:
  Errors faults() const {
    if (params.file.empty()) return {Error{"/file", "is empty; expected the name of a file"}};
    if (params.unit && params.own_size)
      return {Error{"/size", "says how large the body is, and so does unit; expected one of them"}};
    if (!params.body) return {};
    constexpr double kLeast = 0.001, kMost = 1000;
    if (double size = size_of(params); params.unit && !(size >= kLeast && size <= kMost))
      return {error_at("/unit", "makes the body {:.4g} m long; expected {} to {} m", size, kLeast, kMost)};
    for (auto [pointer, names] : {std::pair("/parts", &params.parts), {"/carries", &params.carries}})
      if (Errors errors = name_faults(pointer, *names); !errors.empty()) return errors;
    return {};
  }

  /// An error for the first of these names that the file does not have; empty where it has all of them.
  Errors name_faults(std::string_view pointer, const std::vector<std::string>& names) const {
    std::vector<std::string_view> known(params.body->names.begin(), params.body->names.end());
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (std::ranges::find(known, names[i]) != known.end()) continue;
      std::string what = fmt::format("no part of {} is named \"{}\"", params.file.name, names[i]);
      if (known.empty()) return {Error{fmt::format("{}/{}", pointer, i), what + "; none has a name"}};
      return {Error{fmt::format("{}/{}", pointer, i), what + expected_names(names[i], known)}};
    }
    return {};
  }
};

}  // namespace

Kind<Organism> mesh_kind() { return make_grower<MeshGrower>("mesh", "A body from a file of a mesh"); }

}  // namespace frond
