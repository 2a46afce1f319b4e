#include <fmt/format.h>

#include <atomic>

#include "draw/draw_list.h"
#include "export/formats.h"
#include "python/python.h"
#include "scene/scene.h"

namespace frond {

namespace {

/// A scene with the preset that it was grown from.
struct Grown {
  std::shared_ptr<Preset> preset;
  Scene scene;
};
using GrownPtr = std::shared_ptr<Grown>;

/// Tells a function of Python how far a scene is. What that throws ends the growing.
class Listener {
 public:
  explicit Listener(py::object told) : told_(std::move(told)) {}

  ProgressSink watch() {
    if (told_.is_none()) return {[](auto, auto) {}, [] {}};
    return {
        .begin = [this](std::string_view phase, std::size_t steps) { tell(std::string(phase), 0, steps); },
        .step = [this] { tell({}, 1, 0); },
        .cancelled = [this] { return failed_.load(); }};
  }
  /// Throws what the function has thrown.
  void rethrow() {
    if (thrown_) std::rethrow_exception(thrown_);
  }

 private:
  void tell(const std::string& phase, std::size_t step, std::size_t steps) {
    py::gil_scoped_acquire lock;  // which also keeps threads apart
    if (failed_) return;
    if (step == 0) phase_ = phase, done_ = 0, steps_ = steps;
    done_ += step;
    try {
      told_(phase_, done_, steps_);
    } catch (...) {
      thrown_ = std::current_exception();
      failed_ = true;
    }
  }

  py::object told_;
  std::string phase_;
  std::size_t done_ = 0, steps_ = 0;
  std::exception_ptr thrown_;
  std::atomic<bool> failed_ = false;
};

GrownPtr grow(const std::shared_ptr<Preset>& preset, const py::object& progress) {
  Listener listener(progress);
  ProgressSink watch = listener.watch();
  std::optional<Result<Scene>> scene;
  {
    py::gil_scoped_release others;
    scene.emplace(build_scene(*preset, watch));
  }
  listener.rethrow();
  return std::make_shared<Grown>(Grown{preset, or_raise(std::move(*scene))});
}

/// The time of a frame; of the last one where there is none.
double time_of(const Grown& grown, std::optional<int> frame) {
  const Film& film = grown.scene.film;
  int number = frame.value_or(film.frames);
  if (number < 1 || number > film.frames)
    raise({Error{"frame", fmt::format("{} is no frame of this film; expected 1-{}", number, film.frames)}});
  return film.time(number);
}

std::vector<std::shared_ptr<Specimen>> organisms_of(const GrownPtr& grown) {
  std::vector<std::shared_ptr<Specimen>> list;
  for (const Specimen& specimen : grown->scene.specimens) list.push_back(part_of(grown, specimen));
  return list;
}

/// A specimen as it is at a time, and the pose of its branches then.
struct Posed {
  std::shared_ptr<Specimen> specimen;
  Pose pose;
};

std::shared_ptr<Posed> posed_at(const std::shared_ptr<Specimen>& specimen, double time) {
  py::gil_scoped_release others;
  Result<std::shared_ptr<const Specimen>> then = developed(*specimen, time);
  auto posed = std::make_shared<Posed>();
  if (then) {
    posed->specimen = then->get() == specimen.get() ? specimen : std::const_pointer_cast<Specimen>(*then);
    pose_specimen(*posed->specimen, time, posed->pose);
  }
  py::gil_scoped_acquire back;
  if (!then) raise(then.errors());
  return posed;
}

ExportOptions options_of(double detail, int sides, int texture, double voxel, bool instances, int levels) {
  if (!(detail >= 100 && detail <= 1e9)) throw py::value_error("detail: expected 100 to 1e9 triangles");
  if (sides < 3 || sides > 256) throw py::value_error("sides: expected 3 to 256");
  if (texture < 0 || texture > 4096) throw py::value_error("texture: expected 0 to 4096 pixels");
  if (!(voxel >= 0)) throw py::value_error("voxel: expected metres, 0 or more");
  if (levels < 1 || levels > 6) throw py::value_error("levels: expected 1 to 6");
  return {.sides = sides,
          .voxel = voxel,
          .detail = detail,
          .texture = texture,
          .instances = instances,
          .levels = levels};
}

/// A mesh where it stands, with the name of what it belongs to and its plain material.
py::list meshes_of(const Grown& grown, std::optional<int> frame, double detail, int sides) {
  double time = time_of(grown, frame);
  ExportOptions options = options_of(detail, sides, 0, 0, false, 1);
  std::optional<Result<ExportScene>> made;
  {
    py::gil_scoped_release others;
    made.emplace(export_scene(grown.scene, time, options));
  }
  ExportScene exported = or_raise(std::move(*made));
  py::list list;
  for (const ExportPlacement& placement : exported.placements)
    for (const ExportPart& part : exported.meshes[placement.mesh].parts) {
      const ExportMaterial& material = exported.materials[part.material];
      list.append(
          py::make_tuple(exported.groups[placement.group].name, material.name,
                         py::make_tuple(material.color.red, material.color.green, material.color.blue),
                         std::make_shared<Surface>(placed(part, placement))));
    }
  return list;
}

std::vector<std::string> write(const Grown& grown, const std::filesystem::path& path,
                               std::optional<int> frame, double detail, int sides, int texture, double voxel,
                               bool instances, int levels, const std::filesystem::path& home,
                               const std::filesystem::path& cache) {
  const Format& format = *or_raise(format_of(path));
  double time = time_of(grown, frame);
  ExportOptions options = options_of(detail, sides, texture, voxel, instances, levels);
  if (!home.empty()) options.bake = {.home = home, .cache = cache};
  py::gil_scoped_release others;
  auto written = write_scene(format, grown.scene, time, options, path, [](const ExportTold&) {});
  py::gil_scoped_acquire back;
  return or_raise(std::move(written));
}

}  // namespace

void add_scenes(py::module_& module) {
  py::class_<Posed, std::shared_ptr<Posed>>(module, "Pose")
      .def_property_readonly("skeleton",
                             [](const Posed& p) { return part_of(p.specimen, p.specimen->model.skeleton); })
      .def_property_readonly(
          "position", [](py::object self) { return viewed(self.cast<const Posed&>().pose.position, self); })
      .def_property_readonly(
          "radius", [](py::object self) { return viewed(self.cast<const Posed&>().pose.radius, self); })
      .def_property_readonly(
          "turn", [](py::object self) { return viewed(self.cast<const Posed&>().pose.turn, self); })
      .def_property_readonly("front", [](const Posed& p) { return p.pose.front; });
  py::class_<Specimen, std::shared_ptr<Specimen>>(module, "Organism")
      .def_readonly("name", &Specimen::name)
      .def_property_readonly("entry",
                             [](const Specimen& s) -> std::optional<std::size_t> {
                               if (s.entry == Traits::kNoEntry) return std::nullopt;
                               return s.entry;
                             })
      .def_property_readonly("skeleton",
                             [](const std::shared_ptr<Specimen>& s) { return part_of(s, s->model.skeleton); })
      .def_property_readonly("organs",
                             [](const std::shared_ptr<Specimen>& s) { return part_of(s, s->model.organs); })
      .def_property_readonly("prototypes",
                             [](const Specimen& s) {
                               std::vector<std::string> names;
                               for (const Prototype& organ : s.model.prototypes) names.push_back(organ.name);
                               return names;
                             })
      .def_property_readonly("bodies",
                             [](const std::shared_ptr<Specimen>& s) { return part_of(s, s->model.solids); })
      .def_property_readonly(
          "blades", [](const std::shared_ptr<Specimen>& s) { return part_of(s, s->model.blades.surface); })
      .def("pose", &posed_at, py::arg("time"));
  py::class_<Grown, GrownPtr>(module, "Scene")
      .def_property_readonly("preset", [](const Grown& g) { return g.preset; })
      .def_property_readonly("organisms", &organisms_of)
      .def_property_readonly("notes", [](const Grown& g) { return g.scene.notes; })
      .def_property_readonly("nodes", [](const Grown& g) { return g.scene.nodes(); })
      .def(
          "time", [](const Grown& g, int frame) { return time_of(g, frame); }, py::arg("frame"))
      .def("meshes", &meshes_of, py::arg("frame") = py::none(), py::arg("detail") = 2.5e5,
           py::arg("sides") = 10)
      .def("write", &write);
  module.def("grow", &grow, py::arg("preset"), py::arg("progress") = py::none());
}

}  // namespace frond
