#include "organisms/mesh/mesh.h"

#include "geometry/obj.h"
#include "organisms/kinds.h"
#include "preset/reader.h"

namespace frond {

Result<Model> build_mesh_model(const MeshParams& params) {
  if (params.mesh.triangle.empty()) return Error{"", "file \"" + params.file.name + "\" has not been read"};
  Model model;
  Material matter{params.matter, params.color, params.second, params.scale};
  matter.moss = params.weathering;
  Vec3 size(static_cast<float>(params.size));
  model.solids.place(model.solids.add_shape({params.mesh, matter}), Vec3(0), Quat(1, 0, 0, 0), size);
  return model;
}

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
      "A Wavefront OBJ file, named as seen from the preset's folder or from where Frond runs; y is up, and "
      "the middle of its underside stands at its place");
  v.required("file");
  v.number("size", m.size, {.min = 0.001, .max = 100, .unit = "m"},
           "Length of its longest side, to which the file is scaled");
  v.choice("matter", m.matter, kMeshMatters, "What it is made of");
  v.color("color", m.color, "Colour of its surface");
  v.color("second", m.second, "Colour of stains and cracks");
  v.number("scale", m.scale, {.min = 0.001, .max = 10, .unit = "m"}, "Size of the pattern");
  v.number("weathering", m.weathering, {.min = 0, .max = 1}, "How much soot, damp and moss there is");
  v.aspect(Aspect::look, "matter", "color", "second", "scale", "weathering");
}

namespace {

class MeshGrower final : public Described<MeshParams, BodyBuilder> {
 public:
  static constexpr std::string_view kLeading[] = {"file",   "size",  "matter",    "color",
                                                  "second", "scale", "weathering"};

  Errors check() const override {
    if (params.file.empty()) return {Error{"/file", "is empty; expected the name of a file"}};
    return {};
  }
  Result<SizeEstimate> estimate_size(Seed) const override {
    SizeEstimate mesh;
    mesh.triangles = static_cast<double>(params.mesh.triangle.size());
    mesh.blocks = 1;
    return mesh;
  }
  Result<Model> grow_alone(Seed) const override { return build_mesh_model(params); }
};

}  // namespace

Kind<Organism> mesh_kind() { return make_grower<MeshGrower>("mesh", "A body from an OBJ file"); }

}  // namespace frond
