#include "emit/foretell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "emit/setting.h"
#include "emit/soft_light.h"
#include "organisms/organism.h"
#include "settings/settings.h"

namespace frond {

namespace {

// Bytes of text, as measured over the presets.
constexpr double kStillNode = 45, kMovingNode = 85;  // of a branch as a sweep; with textures that ride on it
constexpr double kCoatNode = 650, kTwigCoatNode = 280;  // of one that is a mesh; where twigs are sweeps
constexpr double kPoint = 29, kChain = 135, kChunkTexture = 200;  // what a node's text is made of
constexpr double kBodyNode = 1100;                                // of a fused body or one of cubes
constexpr double kPlacement = 122;                                // of an organ, a stone, a patch of grass
constexpr double kTriangle = 45, kGrassTriangle = 100;  // of a mesh; of one whose triangles share few corners
constexpr double kCorner = 86;                          // of a leaf that the turtle outlined
constexpr double kLayout = 5000;
constexpr double kAsideBytes = 5e6;  // of what goes to a file of its own, see frame.cpp
// Bytes of memory.
constexpr double kProgram = 4e7;
constexpr double kHeldNode = 40, kGrowingNode = 60, kPosedNode = 50;
constexpr double kHeldOrgan = 70, kGrowingOrgan = 130, kPosedOrgan = 50;
constexpr double kHeldTriangle = 40;
constexpr double kFrameBuffers = 3e7;
// A second.
constexpr double kOrgansGrown = 5e5, kTrianglesMade = 5e5, kBytesWritten = 3e7, kPixelsDrawn = 5e5;
constexpr double kLightWorkedOut = 4e6, kLightMemory = 2e8;  // bytes a second; bytes

constexpr double kPictureBytes = 1.8;  // of a pixel
// Of POV-Ray: bytes a second that it reads, and of models, each frame a part of them; seconds a pixel of a
// picture of kTracedPixels, by quality, and by which power of their number a pixel of a larger picture, where
// fewer lie on edges, takes less; crowded scenes take more.
constexpr double kBytesRead = 4e6, kModelsRead = 4e7, kTracedPixels = 160 * 90, kCrowd = 100, kCrowded = 5;
constexpr double kPixelTraced[] = {1.2e-4, 3.6e-4, 1.1e-3}, kEdges[] = {0.1, 0.3, 0.3};

double render_seconds(const Foretold& f, const Film& film) {
  double pixels = double(film.size[0]) * film.size[1];
  auto quality = static_cast<std::size_t>(film.quality);
  double traced =
      pixels * kPixelTraced[quality] * std::pow(kTracedPixels / std::max(pixels, 1.0), kEdges[quality]);
  return f.frame_bytes / kBytesRead + f.shared_bytes / kModelsRead +
         traced * (f.copies > kCrowd ? kCrowded : 1);
}

/// Bytes of text that a node takes.
double node_bytes(const Foresight& size, const Dress& dress) {
  const Look& look = dress.look;
  bool moves = dress.motion.wave.amplitude != 0 || dress.motion.growth.duration > 0;
  if (look.coat) return look.coat->twigs > 0 ? kTwigCoatNode : kCoatNode;
  if (size.riding) return kMovingNode;
  if (!size.chains) return moves ? kMovingNode : kStillNode;
  bool plain = look.bark && look.bark->kind == BarkKind::stem && look.bark->young_length <= 0;
  double bytes = kPoint + kChain * *size.chains;
  if (moves && !plain) bytes += kChunkTexture * (*size.chains + 1.0 / 11);
  return bytes;
}

/// The files of the models of what is sown, each at two of its levels.
double model_bytes(const Foresight& size) {
  return 2 * (250 * size.nodes + std::min(90 * 12 * size.parts, 90 * 3e5) + kTriangle * size.triangles);
}

}  // namespace

int Foretold::at_once(const Machine& machine) const {
  double spare = 0.8 * machine.memory - scene_memory;
  return static_cast<int>(std::clamp(spare / std::max(frame_memory, 1.0), 1.0, double(machine.threads)));
}

double Foretold::memory(int at_once) const {
  return std::max(growth_memory, scene_memory + at_once * frame_memory);
}

double Foretold::seconds(int threads) const { return (growth_seconds + frames * frame_seconds) / threads; }

Result<Foretold> foretell(const Preset& preset, int frames) {
  Foretold f;
  f.frames = frames;
  f.scene_memory = kProgram;
  f.frame_memory = kFrameBuffers;
  bool changing = false;
  double ground = 0, materials = 0, text = kLayout, most = 0, growing = 0;
  GroundForesight laid = settings()[preset.stage.setting].answers.foresee(preset.stage, preset.film);
  ground += kTriangle * 0.87 * laid.triangles + kGrassTriangle * laid.grass + kPlacement * laid.placed;
  f.scene_memory += kHeldTriangle * (laid.triangles + laid.grass) + 60 * laid.placed;
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    if (organism.count == 0) continue;
    const Grower& grower = *organism.grower;
    Result<Foresight> foreseen = grower.foresee(Seed{preset.seed}.child("organism", o));
    if (!foreseen) return foreseen.errors();
    const Foresight& size = *foreseen;
    Dress dress = grower.dress();
    double nodes = size.nodes;
    double held = kHeldNode * nodes + kHeldOrgan * size.organs + kCorner * size.corners +
                  kHeldTriangle * (size.triangles + size.shapes) + 100 * size.blocks;
    double grows = held + kGrowingNode * nodes + kGrowingOrgan * size.organs + 2 * size.word.bytes +
                   3 * kHeldTriangle * size.triangles;
    double wood = organism.style.build == Build::sweeps ? node_bytes(size, dress) : kBodyNode;
    double own = wood * nodes + kPlacement * size.parts + kCorner * size.corners;
    double made = nodes / size.nodes_a_second + size.organs / kOrgansGrown + size.triangles / kTrianglesMade;
    changing = changing || dress.motion.growth.duration > 0 || grower.develops(preset.film.frames > 1);
    double count = std::max<double>(organism.count, static_cast<double>(organism.place.at.size()));
    for (const Drawing& drawing : drawings(dress.look)) {
      f.shared_bytes += 4e5 * static_cast<double>(drawing.names.size());
      f.growth_seconds += 3e5 / kPixelsDrawn * static_cast<double>(drawing.names.size());
    }
    if (organism.sown) {
      f.copies += count;
      f.models += organism.sown->models;
      double model = model_bytes(size);
      f.shared_bytes += organism.sown->models * model;
      f.growth_seconds += organism.sown->models * (made + model / kBytesWritten);
      // What is too far or out of view is left out.
      double lines = 0.4 * count * 2.5 * kPlacement;
      bool sways = dress.motion.wave.amplitude > 0 && preset.film.frames > 1;
      (sways ? text : ground) += lines;
      f.scene_memory += 40 * count;
      growing = std::max(growing, grows + 2 * model);
      if (lines + model > most) most = lines + model, f.largest = o;
      continue;
    }
    bool at_once = finds_its_way(grower.stage());
    f.organisms += count;
    f.modules += count * size.word.modules;
    f.nodes += count * nodes;
    f.organs += count * size.organs;
    f.scene_memory += count * held;
    f.frame_memory += count * ((grower.develops(preset.film.frames > 1) ? held : 0)) + kPosedNode * nodes +
                      kPosedOrgan * size.organs + (wood > kMovingNode ? own : 0);
    growing = std::max(growing, (at_once ? count : 1) * grows);
    text += count * own;
    ground += count * (kTriangle * size.triangles + kPlacement * size.blocks);
    materials += kTriangle * size.shapes;
    f.growth_seconds += count * made;
    if (count * own > most) most = count * own, f.largest = o;
  }
  if (has_soft_light(preset.stage)) {
    double light = light_bytes(preset.film);
    bool each = changing && preset.film.frames > 1;
    (each ? f.picture_bytes : f.shared_bytes) += light;
    (each ? f.frame_seconds : f.growth_seconds) += light / kLightWorkedOut;
    (each ? f.frame_memory : f.growth_memory) += kLightMemory;
  }
  f.scene_memory += 2 * (ground + materials);
  f.growth_memory += f.scene_memory + growing;
  // What all frames share is written once where it is surely long.
  for (double same : {ground, materials})
    (preset.film.frames > 1 && same > kAsideBytes ? f.shared_bytes : text) += same;
  f.frame_bytes = text;
  f.picture_bytes += kPictureBytes * preset.film.size[0] * preset.film.size[1];
  f.render_seconds = render_seconds(f, preset.film);
  int each = exposures(preset.film, preset.stage.camera);
  f.frame_bytes *= each, f.render_seconds *= each;
  f.frame_seconds += f.frame_bytes / kBytesWritten;
  return f;
}

Errors refuse(const Foretold& f, const Machine& machine) {
  Errors errors;
  std::string most = fmt::format("/organisms/{} takes most of it", f.largest);
  if (double memory = f.memory(1); memory > machine.memory)
    errors.push_back(
        {"", fmt::format("the run would take about {} of memory, and {} can be had; {}: fewer or "
                         "smaller ones, or fewer steps or years",
                         bytes_text(memory), bytes_text(machine.memory), most)});
  if (f.disk() > machine.disk)
    errors.push_back(
        {"", fmt::format("the run would write about {}, {} frames of {} and {} beside them, and "
                         "{} of the disk are free; fewer frames (film.frames, --frames), or "
                         "another --out; {}",
                         bytes_text(f.disk()), f.frames, bytes_text(f.frame_bytes + f.picture_bytes),
                         bytes_text(f.shared_bytes), bytes_text(machine.disk), most)});
  return errors;
}

}  // namespace frond
