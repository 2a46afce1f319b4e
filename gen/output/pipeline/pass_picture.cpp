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
  template <class Value, class Of>
  void add(const std::string& name, const std::vector<Value>& values, const Of& of) {
    ExrChannel channel{name, ExrChannel::Kind::single, {}, {}};
    for (const Value& value : values) channel.values.push_back(of(value));
    all.push_back(std::move(channel));
  }
  void add(const std::string& name, const std::vector<float>& values) {
    add(name, values, [](float value) { return value; });
  }
  void add(const std::string& name, const std::vector<Vec3>& values) {
    for (int axis = 0; axis < 3; ++axis)
      add(name + '.' + "XYZ"[axis], values, [axis](Vec3 value) { return value[axis]; });
  }
  void add(const std::string& name, const std::vector<Vec2>& values) {
    for (int axis = 0; axis < 2; ++axis)
      add(name + '.' + "uv"[axis], values, [axis](Vec2 value) { return value[axis]; });
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
  channels.add("N", passes.normal);
  channels.add("P", passes.position);
  channels.add("forward", passes.forward);
  channels.add("backward", passes.backward);
  channels.add("sun.Y", passes.sun);
  for (int c = 0; c < 3 && !passes.albedo.empty(); ++c)
    channels.add(std::string("albedo.") + "RGB"[c], passes.albedo, [c](Vec3 color) { return color[c]; });
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
