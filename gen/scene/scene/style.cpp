#include "scene/style.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/bounds.h"
#include "field/volume.h"

namespace frond {

Style settled(Style style, const Skeleton& rest) {
  if (style.voxel > 0 || rest.size() == 0) return style;
  double size = std::max(bounds_of(rest.position).longest(), 0.01f);
  style.voxel = size / (style.build == Build::voxels ? 44 : style.build == Build::rough ? 90 : 160);
  return style;
}

namespace {

Errors resolve_style(Specimen& b, const Style& style) {
  b.style = settled(style, b.model.skeleton);
  if (b.style.build == Build::sweeps || b.model.skeleton.size() < 2) return {};
  VolumeOptions options{b.style.voxel, b.style.adaptivity, b.style.limit};
  Errors errors = refuse_volume(boughs_of(b.model.skeleton, static_cast<float>(b.style.blend)), options);
  for (Error& error : errors) error.where = fmt::format("/organisms/{}/body/voxel", b.entry);
  return errors;
}

}  // namespace

Errors resolve_styles(Scene& scene, const Preset& preset) {
  for (Specimen& b : scene.specimens) {
    if (b.entry >= preset.organisms.size()) continue;  // of the setting itself
    Errors errors = resolve_style(b, preset.organisms[b.entry].style);
    for (Error& error : errors) error = fault_at(preset, error.where, error.what);
    if (!errors.empty()) return errors;
  }
  return {};
}

}  // namespace frond
