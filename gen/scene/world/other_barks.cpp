#include "world/other_barks.h"

#include "images/bark_photo.h"

namespace frond {

namespace {

/// From afar lichens hide so much of what is below them where they cover all of it.
constexpr double kHidden = 0.8;

Bark changed(const Bark& plant, const BarkChange& change) {
  Bark bark = plant;
  bark.kind = change.kind.value_or(plant.kind);
  bark.colors = {change.color.value_or(plant.colors[0])};
  if (change.color) bark.young = *change.color;
  bark.second = change.second.value_or(plant.second);
  if (change.lichens) {
    auto share = static_cast<float>(kHidden * *change.lichens);
    const Color lichen = BarkImage{}.lichen;
    for (Color* color : {&bark.colors[0], &bark.second, &bark.young}) *color = mixed(*color, lichen, share);
  }
  return bark;
}

BarkCoat changed(const BarkCoat& plant, const BarkChange& change) {
  BarkCoat coat = plant;
  BarkImage& image = coat.image;
  image.color = change.color.value_or(image.color);
  image.second = change.second.value_or(image.second);
  image.lichens = change.lichens.value_or(image.lichens);
  if (change.pattern) {
    image.pattern = *change.pattern;
    // A photograph has the pattern of the plant.
    image.photo = nullptr, coat.photo = {};
  }
  if (image.photo && change.color)
    image.photo = std::make_shared<const Raster>(tinted_tile(*image.photo, *change.color));
  return coat;
}

}  // namespace

bool bark_changes_within(const BranchLook& look, const Model& model) {
  if (look.others.empty() || model.color.empty()) return false;
  const std::vector<std::int32_t>& parent = model.skeleton.parent;
  for (std::size_t i = 1; i < parent.size(); ++i)
    if (parent[i] == static_cast<std::int32_t>(i) - 1 && parent[i - 1] != Skeleton::kRoot &&
        look.color_at(model, parent[i]) != look.color_at(model, static_cast<std::int32_t>(i)))
      return true;
  return false;
}

void add_other_barks(BranchLook& look, std::span<const Edit> edits) {
  if (!look.bark) return;
  for (const Edit& edit : edits) {
    if (!edit.bark) continue;
    OtherBark& other = look.others.emplace_back(OtherBark{changed(*look.bark, *edit.bark)});
    if (look.coat && (edit.bark->pattern || !edit.bark->kind)) other.coat = changed(*look.coat, *edit.bark);
  }
}

}  // namespace frond
