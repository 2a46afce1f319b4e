#include "emit/worn.h"

#include <fmt/format.h>

#include "emit/branch_materials.h"
#include "emit/solid.h"

namespace frond {

std::string worn_name(std::size_t organism, std::size_t shape) {
  return fmt::format("Worn{}_{}", organism, shape);
}

std::string worn_text(const Scene& scene, std::span<const std::size_t> first_skin, double time) {
  std::string text;
  for (std::size_t i = 0; i < scene.specimens.size(); ++i) {
    const Specimen& b = scene.specimens[i];
    if (!b.life.condition) continue;
    const std::vector<Solid>& shapes = b.model.solids.shapes;
    // Macros, as POV-Ray declares no layers whose own macros declare something.
    for (std::size_t k = 0; k < shapes.size(); ++k)
      text += fmt::format("#macro {}(){} #end\n", worn_name(i, k),
                          material_text(material_at(shapes[k].material, k, *b.life.condition, time), b.wet));
    append_skin_declarations(text, look_at(b.look, *b.life.condition, time).branches, b.brightness,
                             first_skin[i], !b.model.light.empty(), b.name);
  }
  return text;
}

Solids worn_at(const Solids& solids, const Specimen& specimen, double time) {
  Solids now = solids;
  for (std::size_t k = 0; k < now.shapes.size(); ++k)
    now.shapes[k].material = material_at(now.shapes[k].material, k, *specimen.life.condition, time);
  return now;
}

}  // namespace frond
