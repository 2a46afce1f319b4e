#include "core/home.h"
#include "core/parallel.h"
#include "core/version.h"
#include "python/python.h"

namespace frond {

void raise(const Errors& errors) {
  py::list faults;
  py::module_ package = py::module_::import("frond.faults");
  for (const Error& error : errors) faults.append(package.attr("Fault")(error.where, error.what));
  py::object type = package.attr("FrondError");
  PyErr_SetObject(type.ptr(), type(faults).ptr());
  throw py::error_already_set();
}

}  // namespace frond

PYBIND11_MODULE(_frond, module) {
  using namespace frond;
  module.attr("__version__") = version();
  module.def("limit_threads", &limit_threads, py::arg("count"));
  module.def("set_home", &set_home_folder, py::arg("folder"));
  add_models(module);
  add_presets(module);
  add_grammars(module);
  add_cpfg_models(module);
  add_renders(module);
  add_scenes(module);
}
