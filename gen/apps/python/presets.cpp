#include "core/files.h"
#include "organisms/kinds.h"
#include "preset/json.h"
#include "python/python.h"
#include "scene/preset.h"
#include "settings/settings.h"

namespace frond {

namespace {

using PresetPtr = std::shared_ptr<Preset>;

PresetPtr preset_of(const std::string& text, const std::string& name, const std::vector<std::string>& sets,
                    const std::optional<std::filesystem::path>& assets) {
  py::gil_scoped_release others;
  Result<Preset> preset = read_preset(text, name, sets, assets);
  py::gil_scoped_acquire back;
  return std::make_shared<Preset>(or_raise(std::move(preset)));
}

std::vector<std::pair<std::string, std::string>> pairs(const Errors& errors) {
  std::vector<std::pair<std::string, std::string>> list;
  for (const Error& error : errors) list.emplace_back(error.where, error.what);
  return list;
}

/// The table of kinds or of settings: names with their sentences.
py::dict names_of(const auto& rows) {
  py::dict names;
  for (const auto& row : rows) names[py::str(std::string(row.name))] = std::string(row.doc);
  return names;
}

}  // namespace

void add_presets(py::module_& module) {
  py::class_<Preset, PresetPtr>(module, "ReadPreset")
      .def(py::init(&preset_of), py::arg("text"), py::arg("name"), py::arg("sets"), py::arg("assets"))
      .def_readonly("title", &Preset::title)
      .def_readonly("seed", &Preset::seed)
      .def_readonly("text", &Preset::text)
      .def_readonly("files", &Preset::files)
      .def_property_readonly("notes", [](const Preset& p) { return pairs(p.notes); })
      .def_property_readonly("frames", [](const Preset& p) { return p.film.frames; })
      .def_property_readonly("fps", [](const Preset& p) { return p.film.fps; })
      .def_property_readonly("size",
                             [](const Preset& p) { return py::make_tuple(p.film.size[0], p.film.size[1]); });
  module.def("read_text", [](const std::filesystem::path& path) { return or_raise(read_file(path)); });
  module.def("pretty", [](const std::string& text) {
    return serialize_pretty(or_raise(parse_json(text, "preset")).root) + "\n";
  });
  module.def("schema", [] { return serialize_pretty(preset_schema()); });
  module.def("kinds", [] { return names_of(organism_kinds()); });
  module.def("settings", [] { return names_of(settings()); });
}

}  // namespace frond
