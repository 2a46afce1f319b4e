#include <algorithm>

#include "cpfg/cpfg.h"
#include "grammar/figure.h"
#include "organisms/cpfg_picture.h"
#include "python/python.h"

namespace frond {

namespace {

using ModelPtr = std::shared_ptr<CpfgModel>;

/// What a derivation gives, with the model that knows its letters.
struct DerivedModel {
  ModelPtr model;
  CpfgWord word;
};

ModelPtr model_of(const std::filesystem::path& path) {
  return std::make_shared<CpfgModel>(or_raise(read_cpfg(path)));
}

/// A derivation, without holding other threads up.
CpfgDerived derived(const CpfgModel& model, std::optional<int> steps, bool drawing) {
  if (steps && *steps < 0) throw py::value_error("steps: expected a number of 0 or more");
  CpfgRequest request;
  request.steps = steps, request.drawing = drawing;
  py::gil_scoped_release others;
  Result<CpfgDerived> result = derive(model, request);
  py::gil_scoped_acquire back;
  return or_raise(std::move(result));
}

/// The branches, polygons and surfaces of a figure, as those of other grammars are given.
std::shared_ptr<Figure> figure_of_model(const CpfgFigure& drawn) {
  auto figure = std::make_shared<Figure>();
  Skeleton& bones = figure->skeleton;
  std::vector<std::int32_t> end;  // of each segment, its node
  auto add = [&](DVec3 at, double radius, std::int32_t below, int depth, int color) {
    figure->color.push_back(color);
    return bones.add(Vec3(at), static_cast<float>(std::max(radius, 1e-9)), below,
                     static_cast<std::uint16_t>(std::clamp(depth, 0, 65535)));
  };
  for (const CpfgSegment& s : drawn.segments) {
    std::int32_t below = s.before >= 0 ? end[static_cast<std::size_t>(s.before)]
                                       : add(s.from, s.radius_from, Skeleton::kRoot, s.depth, s.color);
    end.push_back(add(s.to, s.radius_to, below, s.depth, s.color));
  }
  set_tip_distances(bones);
  auto node_of = [&](std::int32_t segment) {
    return segment >= 0 ? end[static_cast<std::size_t>(segment)] : Skeleton::kRoot;
  };
  for (const CpfgPolygon& polygon : drawn.polygons) {
    Outline outline{{}, polygon.color, node_of(polygon.segment), figure->outlines.size()};
    for (const DVec3& at : polygon.points) outline.points.emplace_back(at);
    figure->outlines.push_back(std::move(outline));
  }
  for (const CpfgPlaced& placed : drawn.placed)
    figure->sites.push_back({std::string(1, placed.surface), Vec3(placed.position), Vec3(placed.heading),
                             Vec3(placed.left), Vec3(placed.up), Vec3(placed.factors), placed.color,
                             node_of(placed.segment), figure->sites.size()});
  return figure;
}

}  // namespace

void add_cpfg_models(py::module_& module) {
  auto steps = py::arg("steps") = py::none();
  py::class_<DerivedModel, std::shared_ptr<DerivedModel>>(module, "CpfgWord")
      .def("__len__", [](const DerivedModel& d) { return d.word.modules.size(); })
      .def("__str__", [](const DerivedModel& d) { return text(d.word, *d.model); })
      .def_property_readonly("counts", [](const DerivedModel& d) {
        py::dict found;
        for (const CpfgModule& m : d.word.modules) {
          py::str name(std::string(1, m.symbol));
          found[name] = found.contains(name) ? py::cast<std::size_t>(found[name]) + 1 : 1;
        }
        return found;
      });
  py::class_<CpfgModel, ModelPtr>(module, "CpfgModel")
      .def(py::init(&model_of), py::arg("path"))
      .def_property_readonly("steps", [](const CpfgModel& m) { return m.steps; })
      .def_property_readonly("notes", [](const CpfgModel& m) { return m.notes; })
      .def(
          "derive",
          [](const ModelPtr& m, std::optional<int> count) {
            return std::make_shared<DerivedModel>(DerivedModel{m, derived(*m, count, false).word});
          },
          steps)
      .def(
          "draw",
          [](const ModelPtr& m, std::optional<int> count) {
            return figure_of_model(or_raise(draw(*m, derived(*m, count, true).drawing)));
          },
          steps)
      .def(
          "picture",
          [](const ModelPtr& m, std::optional<int> count) {
            return svg_of(drawing_of(or_raise(draw(*m, derived(*m, count, true).drawing))));
          },
          steps);
}

}  // namespace frond
