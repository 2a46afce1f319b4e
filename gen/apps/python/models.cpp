#include "model/model.h"
#include "python/python.h"

namespace frond {

void add_models(py::module_& module) {
  py::class_<Skeleton, std::shared_ptr<Skeleton>>(module, "Skeleton")
      .def("__len__", &Skeleton::size)
      .def_property_readonly("position", array_of(&Skeleton::position))
      .def_property_readonly("radius", array_of(&Skeleton::radius))
      .def_property_readonly("parent", array_of(&Skeleton::parent))
      .def_property_readonly("distance", array_of(&Skeleton::distance))
      .def_property_readonly("to_tip", array_of(&Skeleton::to_tip))
      .def_property_readonly("birth", array_of(&Skeleton::birth))
      .def_property_readonly("order", array_of(&Skeleton::order));
  py::class_<Surface, std::shared_ptr<Surface>>(module, "Mesh")
      .def("__len__", [](const Surface& s) { return s.triangle.size(); })
      .def_property_readonly("position", array_of(&Surface::position))
      .def_property_readonly("normal", array_of(&Surface::normal))
      .def_property_readonly("triangle", array_of(&Surface::triangle))
      .def_property_readonly("uv", [](py::object self) {
        const Surface& surface = self.cast<const Surface&>();
        return surface.uv.empty() ? py::none() : py::object(viewed(surface.uv, self));
      });
  py::class_<Organs, std::shared_ptr<Organs>>(module, "Organs")
      .def("__len__", &Organs::size)
      .def_property_readonly("prototype", array_of(&Organs::prototype))
      .def_property_readonly("position", array_of(&Organs::position))
      .def_property_readonly("turn", array_of(&Organs::turn))
      .def_property_readonly("scale", array_of(&Organs::scale))
      .def_property_readonly("node", array_of(&Organs::node))
      .def_property_readonly("birth", array_of(&Organs::birth))
      .def_property_readonly("color", array_of(&Organs::color));
  py::class_<Solids, std::shared_ptr<Solids>>(module, "Bodies")
      .def("__len__", &Solids::size)
      .def_property_readonly("shapes",
                             [](const std::shared_ptr<Solids>& self) {
                               std::vector<std::shared_ptr<Surface>> shapes;
                               for (const Solid& solid : self->shapes)
                                 shapes.push_back(part_of(self, solid.surface));
                               return shapes;
                             })
      .def_property_readonly("shape", array_of(&Solids::shape))
      .def_property_readonly("position", array_of(&Solids::position))
      .def_property_readonly("turn", array_of(&Solids::turn))
      .def_property_readonly("scale", array_of(&Solids::scale))
      .def("merged", [](const Solids& self) { return std::make_shared<Surface>(merged(self)); });
}

}  // namespace frond
