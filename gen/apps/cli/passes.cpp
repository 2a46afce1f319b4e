#include "passes/frame_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <map>

#include "cli/albedo.h"
#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/pass_views.h"
#include "cli/streams.h"
#include "cli/traced_run.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/parallel.h"
#include "images/cryptomatte.h"
#include "images/exr.h"
#include "render/process.h"

// What compositors want to know of frames besides their colours: passes.

namespace frond {

namespace fs = std::filesystem;

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

Result<std::string> picture_of(const Scene& scene, const FramePasses& passes) {
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
  struct Layer {
    std::string name;
    std::string ThingNames::*which;
  };
  for (const Layer& layer :
       {Layer{"CryptoEntry", &ThingNames::entry}, Layer{"CryptoOrganism", &ThingNames::organism},
        Layer{"CryptoPart", &ThingNames::part}}) {
    Cryptomatte masks = masks_of(scene, passes, layer.name, layer.which);
    std::ranges::move(masks.channels, std::back_inserter(channels.all));
    std::ranges::move(masks.attributes, std::back_inserter(attributes));
  }
  return exr_bytes({passes.width, passes.height}, channels.all, attributes);
}

}  // namespace

int passes(const PassesArguments& arguments) {
  limit_threads(arguments.threads);
  Result<Preset> preset = load_preset(arguments.preset);
  if (!preset) return fail(preset.errors(), kWrongInput);
  std::string povray = environment_or("FROND_POVRAY", "povray");
  if (arguments.albedo && !find_program(povray))
    return fail({{"--albedo", povray + ": no such program; it is what draws the colours"}}, kCouldNot);
  TracedRun run;
  if (int code = run.begin(*preset, arguments, "passes"); code != kDone) return code;
  std::optional<Albedo> albedo;
  if (arguments.albedo) {
    Result<Albedo> made = Albedo::of(*run.scene, run.models.path() / "frames");
    if (!made) return fail(made.errors(), kCouldNot);
    albedo.emplace(std::move(*made));
  }
  const Camera& camera = run.scene->stage.camera;
  float middle = std::max(glm::distance(camera.location.at(0), camera.look_at.at(0)), 1e-3f);
  now_doing("tracing frames");
  for (int frame = run.range.first; frame <= run.range.last; ++frame) {
    Result<FramePasses> made = frame_passes(*run.scene, *run.film, frame, arguments.side);
    if (!made) return fail(made.errors(), kCouldNot);
    if (Errors errors = albedo ? albedo->add_to(*made, frame) : Errors{}; !errors.empty())
      return fail(errors, kCouldNot);
    Result<std::string> picture = picture_of(*run.scene, *made);
    if (!picture) return fail(picture.errors(), kCouldNot);
    fs::path file = run.out / (frame_name(frame) + ".exr");
    Result<bool> written = write_file(file, *picture);
    if (!written) return fail(written.errors(), kCouldNot);
    put(file.string() + "\n");
    if (!arguments.views) continue;
    for (const PassView& view : pass_views(*made, middle)) {
      Result<std::string> png = png_text(view.picture);
      if (!png) return fail(png.errors(), kCouldNot);
      if (written = write_file(run.out / fmt::format("{}_{}.png", frame_name(frame), view.name), *png);
          !written)
        return fail(written.errors(), kCouldNot);
    }
  }
  return kDone;
}

}  // namespace frond
