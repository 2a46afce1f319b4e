#include "pipeline/pass_picture.h"

#include <algorithm>
#include <iterator>
#include <map>

#include "film/film_files.h"
#include "images/cryptomatte.h"
#include "images/exr.h"

namespace frond {

namespace {

/// The channels of a picture, one after the other.
class Channels {
 public:
  void add(const std::string& name, std::vector<float> values) {
    all.push_back({name, ExrChannel::Kind::single, std::move(values), {}});
  }
  /// One for each letter, as "normal.X".
  template <class V>
  void add(const std::string& name, const std::vector<V>& values, std::string_view letters) {
    for (int axis = 0; char letter : letters) {
      std::vector<float> along;
      for (const V& value : values) along.push_back(value[axis]);
      add(name + '.' + letter, std::move(along)), ++axis;
    }
  }

  std::vector<ExrChannel> all;
};

/// The masks of all that one of the names tells apart.
Cryptomatte masks_of(const Scene& scene, const FramePasses& passes, const std::string& layer,
                     std::string ThingNames::*which) {
  std::map<Thing, std::uint32_t> of_thing;
  std::map<std::string, std::uint32_t> numbers;
  std::vector<std::string> names;
  Coverages shown;
  for (const auto& things : passes.things) {
    for (const auto& [thing, share] : things) {
      auto [known, fresh] = of_thing.try_emplace(thing, 0);
      if (fresh) {
        std::string name = names_of(scene, thing).*which;
        auto [number, added] = numbers.try_emplace(name, static_cast<std::uint32_t>(names.size()));
        if (added) names.push_back(name);
        known->second = number->second;
      }
      shown.entries.push_back({known->second, share});
    }
    shown.ends.push_back(shown.entries.size());
  }
  return cryptomatte(layer, names, shown);
}

}  // namespace

Result<TracedFilm> traced_film(const Scene& scene, const std::filesystem::path& models) {
  Result<CopyPlan> plan = write_models(scene, models, {[](auto, auto) {}, [] {}});
  if (!plan) return plan.errors();
  return TracedFilm::of(scene, std::move(*plan));
}

Result<std::string> pass_picture(const Scene& scene, const FramePasses& passes) {
  Channels channels;
  channels.add("A", passes.coverage);
  channels.add("Z", passes.depth);
  channels.add("N", passes.normal, "XYZ");
  channels.add("P", passes.position, "XYZ");
  channels.add("forward", passes.forward, "uv");
  channels.add("backward", passes.backward, "uv");
  channels.add("sun.Y", passes.sun);
  if (!passes.albedo.empty()) channels.add("albedo", passes.albedo, "RGB");
  ExrAttributes attributes;
  struct MaskLayer {
    std::string name;
    std::string ThingNames::*which;
  };
  for (const MaskLayer& layer :
       {MaskLayer{"CryptoEntry", &ThingNames::entry}, MaskLayer{"CryptoOrganism", &ThingNames::organism},
        MaskLayer{"CryptoPart", &ThingNames::part}}) {
    Cryptomatte masks = masks_of(scene, passes, layer.name, layer.which);
    std::ranges::move(masks.channels, std::back_inserter(channels.all));
    std::ranges::move(masks.attributes, std::back_inserter(attributes));
  }
  return exr_bytes({passes.width, passes.height}, channels.all, attributes);
}

}  // namespace frond
