#include "passes/frame_passes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "cli/commands.h"
#include "cli/messages.h"
#include "cli/streams.h"
#include "cli/traced_run.h"
#include "core/files.h"
#include "core/frame_name.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "core/seed.h"
#include "emit/frame.h"
#include "film/film_files.h"
#include "images/raster.h"
#include "pipeline/pass_picture.h"
#include "render/process.h"

// What compositors want to know of frames besides their colours: passes.

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr float kSwiftest = 0.02f;  // of the picture's width a frame, which has the full colour

template <class Color>
Raster painted(const FramePasses& passes, const Color& color) {
  Raster picture(passes.width, passes.height, 3);
  for (std::size_t i = 0; i < passes.depth.size(); ++i) {
    Vec3 here = color(i);
    for (int c = 0; c < 3; ++c)
      picture.data[3 * i + static_cast<std::size_t>(c)] = to_byte(static_cast<double>(here[c]));
  }
  return picture;
}

/// A full colour, `turn` times round the circle of them.
Vec3 hue(float turn) {
  return glm::clamp(glm::abs(glm::fract(turn + Vec3(0, 2, 1) / 3.0f) * 6.0f - 3.0f) - 1.0f, 0.0f, 1.0f);
}

Vec3 color_of(const Thing& thing) {
  Seed seed =
      Seed{1}.child("part", static_cast<std::uint64_t>(thing.kind)).child(thing.owner).child(thing.number);
  return glm::mix(Vec3(0.35f), hue(static_cast<float>(seed.child(1).unit())), 0.8f) *
         static_cast<float>(seed.child(2).range(0.55, 1));
}

/// Passes of a frame as a person looks at them.
struct PassView {
  std::string name;
  Raster picture;
};

/// depth: near is bright, and half as bright `middle` metres away; normal: x, y and z as red, green and blue;
/// sun: what it shines on; parts: a colour each; motion to the next frame: its direction as a hue, full from
/// 2 % of the picture's width on; albedo, where it is known.
std::vector<PassView> pass_views(const FramePasses& passes, float middle) {
  std::vector<PassView> views;
  views.push_back({"depth", painted(passes, [&](std::size_t i) {
                     return Vec3(std::isinf(passes.depth[i]) ? 0 : middle / (middle + passes.depth[i]));
                   })});
  views.push_back({"normal", painted(passes, [&](std::size_t i) {
                     return passes.normal[i] == Vec3(0) ? Vec3(0) : 0.5f + 0.5f * passes.normal[i];
                   })});
  views.push_back({"sun", painted(passes, [&](std::size_t i) { return Vec3(passes.sun[i]); })});
  views.push_back({"parts", painted(passes, [&](std::size_t i) {
                     Vec3 sum(0);
                     for (const auto& [thing, share] : passes.things[i]) sum += share * color_of(thing);
                     return sum;
                   })});
  views.push_back({"motion", painted(passes, [&](std::size_t i) {
                     Vec2 moved = passes.forward[i];
                     float far = glm::length(moved) / (kSwiftest * static_cast<float>(passes.width));
                     return hue(std::atan2(moved.y, moved.x) / (2 * static_cast<float>(kPi))) *
                            std::min(std::sqrt(far), 1.0f);
                   })});
  if (!passes.albedo.empty())
    views.push_back({"albedo", painted(passes, [&](std::size_t i) {
                       Vec3 seen(0);
                       for (int c = 0; c < 3; ++c)
                         seen[c] = static_cast<float>(encoded(static_cast<double>(passes.albedo[i][c])));
                       return seen;
                     })});
  return views;
}

/// The colours of surfaces as POV-Ray's textures have them, without light.
class Albedo {
 public:
  /// The albedo of a scene, which must outlive it. What POV-Ray reads, and models, are written into a folder.
  Albedo(Scene& scene, fs::path folder) : scene_(scene), folder_(std::move(folder)) {
    ProgressSink quiet{[](auto, auto) {}, [] {}};
    layout_ = or_fail(read_file(or_fail(home(), kCouldNot) / "templates" / "frame.pov"), kCouldNot);
    or_fail(write_drawings(scene, folder_, quiet), kCouldNot);
    parts_ = prepare_frames(scene, or_fail(write_models(scene, folder_, quiet), kCouldNot));
    for (const Picture& file : parts_.files) or_fail(write_file(folder_ / file.name, file.bytes), kCouldNot);
  }

  /// Adds the colours to the passes of that frame.
  void add_to(FramePasses& passes, int frame) const {
    write_scene(frame);
    std::string scene = (folder_ / (frame_name(frame) + ".pov")).string(),
                picture = (folder_ / (frame_name(frame) + ".png")).string();
    OutputCapture said;
    Command command;
    command.out = command.err = said.descriptor();
    command.environment = {fmt::format("FROND_THREADS={}", thread_count())};
    command.words = {own_program().string(), "frame", scene, picture};
    command.add({fmt::format("{}x{}", passes.width, passes.height), "--", "+Q1", "-A", "-J", "+FN16",
                 "File_Gamma=1.0", "Declare=Frond_Albedo=1"});
    if (or_fail(run(command), kCouldNot) != 0)
      fail({{"", "POV-Ray could not draw the colours: " + said.text()}}, kCouldNot);
    LinearRaster raster = or_fail(read_linear_png(or_fail(read_file(picture), kCouldNot)), kCouldNot);
    passes.albedo.assign(passes.depth.size(), Vec3(0));
    for (std::size_t i = 0; i < passes.albedo.size(); ++i)
      for (int c = 0; c < 3 && passes.normal[i] != Vec3(0); ++c)
        passes.albedo[i][c] = static_cast<float>(raster.data[3 * i + static_cast<std::size_t>(c)]) / 65535;
  }

 private:
  /// Sharp, as rays through the middles of pixels see it.
  void write_scene(int frame) const {
    auto aperture = std::exchange(scene_.setup.camera.aperture, std::nullopt);
    Result<FrameFile> written = write_frame_file(scene_, parts_, layout_, folder_, frame);
    scene_.setup.camera.aperture = aperture;
    or_fail(std::move(written), kCouldNot);
  }

  Scene& scene_;
  fs::path folder_;
  FrameParts parts_;
  std::string layout_;
};

}  // namespace

void passes(const PassesArguments& arguments) {
  limit_threads(arguments.threads);
  Preset preset = or_fail(load_preset(arguments.preset), kWrongInput);
  std::string povray = environment_or("FROND_POVRAY", "povray");
  if (arguments.albedo && !find_program(povray))
    fail({{"--albedo", povray + ": no such program; it is what draws the colours"}}, kCouldNot);
  TracedRun run;
  run.begin(preset,
            arguments.out.empty() ? out_folder("", arguments.preset) / "passes" : fs::path(arguments.out),
            arguments.frames);
  std::optional<Albedo> albedo;
  if (arguments.albedo) albedo.emplace(*run.scene, run.models.path() / "frames");
  const Camera& camera = run.scene->setup.camera;
  float middle = std::max(glm::distance(camera.location.at(0), camera.look_at.at(0)), 1e-3f);
  now_doing("tracing frames");
  for (int frame = run.range.first; frame <= run.range.last; ++frame) {
    FramePasses made = or_fail(frame_passes(*run.scene, *run.film, frame, arguments.side), kCouldNot);
    if (albedo) albedo->add_to(made, frame);
    std::string picture = or_fail(pass_picture(*run.scene, made), kCouldNot);
    fs::path file = run.out / (frame_name(frame) + ".exr");
    or_fail(write_file(file, picture), kCouldNot);
    put(file.string() + "\n");
    if (!arguments.views) continue;
    for (const PassView& view : pass_views(made, middle)) {
      std::string png = or_fail(png_text(view.picture), kCouldNot);
      or_fail(write_file(run.out / fmt::format("{}_{}.png", frame_name(frame), view.name), png), kCouldNot);
    }
  }
}

}  // namespace frond
