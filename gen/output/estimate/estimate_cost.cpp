#include "estimate/estimate_cost.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <string>

#include "appearance/mask_drawing.h"
#include "draw/eyes.h"
#include "draw/levels.h"
#include "draw/solids.h"
#include "estimate/estimate_fruit.h"
#include "estimate/estimate_ground_cost.h"
#include "estimate/estimate_pictures.h"
#include "estimate/estimate_twigs.h"
#include "field/volume.h"
#include "film/soft_light.h"
#include "organisms/organism.h"
#include "scene/bounds.h"
#include "scene/copies.h"
#include "scene/entry_seeds.h"
#include "scene/style.h"
#include "scene/wind.h"
#include "settings/meadow.h"
#include "settings/settings.h"

namespace frond {

namespace {

// Bytes of text, as measured over the presets.
constexpr double kStillNode = 45, kMovingNode = 85;  // of a branch as a sweep; with textures that ride on it
constexpr double kCoatNode = 650, kTwigCoatNode = 170;  // of one that is a mesh; where twigs are sweeps
constexpr double kPoint = 29, kChain = 135, kChunkTexture = 200;  // what a node's text is made of
constexpr double kBodyNode = 1100;                                // of a fused body or one of cubes
constexpr double kPlacement = 122;                                // of an organ, a stone, a patch of grass
constexpr double kTriangle = 45;                                  // of a mesh
constexpr double kCorner = 86;                                    // of a leaf that the turtle outlined
constexpr double kLayout = 5000;
constexpr double kAsideBytes = 4e6;  // of what goes to a file of its own, see frame.cpp
// Bytes of memory.
constexpr double kProgram = 4.2e7;
constexpr double kHeldNode = 40, kGrowingNode = 60, kPosedNode = 50;
constexpr double kHeldOrgan = 70, kGrowingOrgan = 130, kPosedOrgan = 50;
constexpr double kHeldTriangle = 40, kHeldPixel = 6;
constexpr double kFrameBuffers = 1e7;
// A second.
constexpr double kOrgansGrown = 5e5, kTrianglesMade = 1e6, kModulesDerived = 1e7;
constexpr double kBytesWritten = 4e7, kModelWritten = 4e7;
constexpr double kStart = 0.04;  // seconds to read the preset

constexpr double kPictureBytes = 1.8;   // of a pixel of what is rendered
constexpr double kStreaksText = 400e3;  // bytes of falling drops, and of flakes
constexpr double kRawBytes = 5;         // of one of raw frames
constexpr double kDrawnBytes = 0.6;     // of one of bark or a leaf
// POV-Ray: bytes a second that it reads, and of models; seconds a pixel of a picture of kTracedPixels, by
// quality, and the power of their number by which one of a larger picture takes less; crowds take more.
constexpr double kBytesRead = 4e6, kModelsRead = 4e7, kTracedPixels = 160 * 90, kCrowd = 100, kCrowded = 5;
constexpr double kCrowdedLight = 1000;  // copies that fill the view with cells
constexpr double kPixelTraced[] = {1.2e-4, 3.6e-4, 1.1e-3}, kEdges[] = {0.1, 0.3, 0.3};
constexpr double kRawPixelTraced = 4e-5, kPixelResolved = 2e-5, kPixelAir = 2e-5;  // of raw frames
// What a view in the studio puts into packets, a second.
constexpr double kNodesPacked = 2e6, kOrgansPacked = 2e6, kTrianglesPacked = 1e6;

double render_seconds(const CostEstimate& f, double text, double tracing, const Film& film) {
  double pixels = double(film.size[0]) * film.size[1];
  auto quality = static_cast<std::size_t>(film.quality);
  double traced =
      pixels * kPixelTraced[quality] * std::pow(kTracedPixels / std::max(pixels, 1.0), kEdges[quality]);
  if (film.raw) traced = kRawPixelTraced * film.drawn_size()[0] * film.drawn_size()[1];
  traced *= tracing * (f.crowd > kCrowd ? kCrowded : 1);
  return text / kBytesRead + f.shared_bytes / kModelsRead + traced +
         film.raw * (kPixelResolved + film.air * kPixelAir) * pixels;
}

/// Bytes of text that a node takes.
double node_bytes(const SizeEstimate& size, const Appearance& appearance) {
  const Look& look = appearance.look;
  bool moves = appearance.motion.wave.amplitude != 0 || appearance.motion.growth.duration > 0;
  if (look.branches.coat) return look.branches.coat->twigs > 0 ? kTwigCoatNode : kCoatNode;
  if (size.riding) return kMovingNode;
  if (!size.chains) return moves ? kMovingNode : kStillNode;
  bool plain = look.branches.bark && look.branches.bark->kind == BarkKind::stem &&
               look.branches.bark->young_length <= 0;
  double bytes = kPoint + kChain * *size.chains;
  if (moves && !plain) bytes += kChunkTexture * (*size.chains + 1.0 / 11);
  return bytes;
}

constexpr double kCrown = 0.25;  // the radius of a tree's crown, of its height

/// The files of a model of what is sown, one at each level from where its copies come nearest to the camera
/// to where they are farthest.
double model_bytes(const Preset& preset, const Organism& organism, const SizeEstimate& size, double count) {
  constexpr double kWoodNode = 100, kPart = 540;
  constexpr double kFarthest = 200;  // metres, where copies stand all over the land
  const SowRules& where = organism.sown->where;
  const Camera& camera = preset.setup.camera;
  double reach = where.reach > 0 ? where.reach : kFarthest;
  Vec3 middle(where.center.x, 0, where.center.y);
  double away = 1e30;  // the camera at its nearest
  for (int i = 0; i <= 8; ++i)
    away = std::min<double>(away, glm::distance(camera.location.at(preset.film.length() * i / 8), middle));
  double pixel =
      coarseness(preset.film.quality) * 2 * std::tan(radians(camera.angle.at(0)) / 2) / preset.film.size[0];
  // The next copy of one model is about so far away where the camera is among them.
  double apart = 0.5 * reach * std::sqrt(kPi * organism.sown->models / std::max(1.0, count));
  double next = std::max(away - reach, apart) - kCrown * organism.grower->traits().tallest;
  int first = level_for(pixel * std::max(next, 0.3)), last = level_for(pixel * (away + reach));
  double bytes = 0;
  for (int level = first; level <= last; ++level) {
    double of = std::min(kWoodNode * size.nodes + kPart * size.parts, kTriangle * kLevels[level].leaves);
    // Only the blocks that are so near are there at the finest level.
    bytes += (level == first && last > first ? 0.5 : 1) * of + kTriangle * size.triangles;
  }
  return bytes;
}

/// The branches of one organism as text: in each frame, once its pose is found.
struct WoodCostEstimate {
  double bytes = 0, memory = 0, seconds = 0;
};

/// A body that is fused or built of cubes is estimated by a small one that is grown; where that would take
/// long, by its nodes.
WoodCostEstimate estimate_wood_cost(const Organism& organism, const SizeEstimate& size,
                                    const Appearance& appearance, Seed seed) {
  constexpr double kGrown = 0.2;  // seconds that growing one may take
  constexpr double kBlockBytes = 6800, kBlockSeconds = 2e-3, kBlockHeld = 9000, kOwnVoxelBlocks = 110;
  if (organism.style.build == Build::sweeps) return {node_bytes(size, appearance) * size.nodes, 0, 0};
  WoodCostEstimate wood{kBodyNode * size.nodes, kBodyNode * size.nodes, kBodyNode * size.nodes / 1e6};
  if (size.nodes / size.nodes_a_second + size.seconds > kGrown) return wood;
  Result<Model> one = organism.grower->grow_copy(organism, seed);
  if (!one) return wood;
  BranchVolume boughs = boughs_of(one->skeleton, static_cast<float>(organism.style.blend));
  double blocks = estimate_volume(boughs, settled(organism.style, one->skeleton).voxel).blocks;
  // A voxel that is a share of the size gives bodies of all sizes about as many.
  if (organism.style.voxel <= 0) blocks = std::min(blocks, kOwnVoxelBlocks);
  // Cubes are found without a level set.
  double share = organism.style.build == Build::voxels ? 0.1 : 1;
  return {kBlockBytes * blocks, kBlockHeld * blocks, share * kBlockSeconds * blocks};
}

/// Metres that a pixel is where the camera comes nearest to an organism so tall, which reaches so far from
/// its middle.
double pixel_at(const Preset& preset, const Organism& organism, double tall, double reach) {
  Vec2 foot = organism.place.at.empty() ? organism.place.center : organism.place.at[0];
  Vec3 middle(foot.x, organism.place.raise + tall / 2, foot.y);
  return nearest_pixel(eyes(preset.film, preset.setup.camera), middle, reach);
}

/// Triangles of a body that are written: no finer than the camera sees them.
double drawn_triangles(const Preset& preset, const Organism& organism, const SizeEstimate& size) {
  constexpr double kBodyShown = 0.4;  // share that is left, as measured over the presets
  if (size.area <= 0) return kBodyShown * size.triangles;
  Spread spread = organism.grower->spread().value_or(Spread{});
  // Where others grow beside it, it fills less of the space that it would claim alone.
  float reach = 0.75f * std::max(spread.across, spread.up / 2);
  double pixel = pixel_at(preset, organism, spread.up, reach);
  return left_triangles(size.triangles, size.area, pixel, preset.film.quality);
}

/// Whether its tips may come out of the light of the first frame; see light_changes().
bool moves_far(const Preset& preset, const Organism& organism, const Motion& motion) {
  constexpr double kSway = 0.6, kBend = 0.5, kLonger = 0.3;  // of the height, for an angle of 1, a share of 1
  Spread spread = organism.grower->spread().value_or(Spread{});
  double tall = std::max<double>(organism.grower->traits().tallest, spread.up),
         moved = kSway * motion.wave.amplitude;
  if (!motion.food.position.constant() || motion.food.eaten)
    moved += kBend * motion.food.strength + kLonger * motion.food.stretch;
  if (organism.sown || moved == 0 || tall <= 0) return false;
  double pixel = pixel_at(preset, organism, tall, tall / 2);
  return moved * tall > light_reach(preset.film.quality, pixel);
}

/// How many of an entry stand.
double number_of(const Organism& organism) {
  return std::max<double>(organism.count, static_cast<double>(organism.place.at.size()));
}

constexpr double kLibrary = 3.6;  // models of a stand's organism, in full-grown ones

/// How many individuals of a stand or a reef are drawn as copies of an entry, about.
double lives_of_entry(const Preset& preset, const Organism& organism) {
  constexpr double kTrees = 0.12, kColonies = 8;  // that live or lie on each square metre
  auto drawn = [&](const auto& text, double density) {
    auto named = [&](const auto& s) { return s.organism == organism.name; };
    double part = std::ranges::any_of(text.species, named) ? 1 / static_cast<double>(text.species.size()) : 0;
    return part * density * text.area.x * text.area.y;
  };
  if (!organism.sown) return 0;
  return preset.stand ? drawn(*preset.stand, kTrees) : preset.reef ? drawn(*preset.reef, kColonies) : 0;
}

/// What trees that grow in one light leave of each other: the ground that they cover is less than their
/// crowns would, and what is in shade dies.
double left_in_shade(const Preset& preset) {
  double crowns = 0, reach = 0;
  for (const Organism& o : preset.organisms) {
    if (o.sown || !o.grower->traits().shares_light()) continue;
    double crown = kCrown * o.grower->traits().tallest;
    crowns += number_of(o) * crown * crown;
    reach = std::max(reach, reach_of(o) + crown);
  }
  return crowns > 0 ? std::pow(std::min(1.0, reach * reach / crowns), 2) : 1;
}

/// What the entries of a preset add up to.
struct Sums {
  FrameRange part;
  CostEstimate f;
  ViewCostEstimate view;
  bool changing = false;
  double text = kLayout, materials = 0;  // bytes that each frame writes, that all share
  double still = 0;                      // of what stands and lies, the same in all frames
  double most = 0, growing = 0;          // bytes of the largest entry; of memory while the largest grows
  double body_seconds = 0, body_memory = 0;
  double standing = 0;  // triangles of bodies, each of their blocks as such
  // Names of pictures and models that are counted: several entries may share them.
  std::set<std::string> drawn, grown;

  void add_drawing(const Drawing& drawing, double& memory) {
    if (!drawn.insert(drawing.names.at(0)).second) return;
    f.shared_bytes += kDrawnBytes * drawing.pixels;
    f.growth_seconds += drawing.seconds;
    memory += kHeldPixel * drawing.pixels;
  }

  void add_pictures(const Look& look) {
    double memory = 0;
    for (const Drawing& drawing : drawings(look)) {
      // A mask is held from when the preset is read, each by itself.
      if (drawing.names.at(0).starts_with("mask_")) f.scene_memory += kMaskHeld * drawing.pixels;
      add_drawing(drawing, memory);
    }
    growing = std::max(growing, memory);
  }

  void add_sown(const Preset& preset, std::size_t o, const SizeEstimate& size, const Appearance& appearance,
                double made, double grows) {
    const Organism& organism = preset.organisms[o];
    double trees = lives_of_entry(preset, organism), count = organism.count + trees;
    double models = 0, model = model_bytes(preset, organism, size, count);
    for (int m = 0; m < organism.sown->models; ++m) models += grown.insert(copy_id(organism, m)).second;
    if (trees > 0) models *= kLibrary;
    f.copies += count, f.crowd += organism.place.on.empty() ? count : 0;
    f.models += models;
    f.shared_bytes += models * model;
    f.growth_seconds += models * (made + model / kModelWritten);
    view.seconds += models * (made + size.nodes / kNodesPacked + 12 * size.parts / kTrianglesPacked);
    view.longest = std::max(view.longest, made);
    // Copies that are too far or out of view are left out.
    double lines = 0.4 * count * 2.5 * kPlacement;
    bool sways = (trees > 0 || appearance.motion.wave.amplitude > 0 ||
                  sown_in_wind(organism, appearance.motion, preset.setup)) &&
                 preset.film.frames > 1;
    (sways ? text : still) += lines;
    f.scene_memory += 40 * count;
    growing = std::max(growing, grows + 2 * model);
    if (lines + model > most) most = lines + model, f.largest = o;
  }

  void add_standing(const Preset& preset, std::size_t o, const SizeEstimate& size,
                    const Appearance& appearance, double made, double held, double grows, Seed seed) {
    const Organism& organism = preset.organisms[o];
    const GrowerTraits traits = organism.grower->traits();
    double count = number_of(organism);
    bool together = traits.finds_own_place();
    WoodCostEstimate wood = estimate_wood_cost(organism, size, appearance, seed);
    double own =
        (wood.bytes + kPlacement * size.parts) * share_of_twigs(preset, organism, appearance, size.organs) +
        kCorner * size.corners;
    double solid = kTriangle * drawn_triangles(preset, organism, size) + kPlacement * size.blocks;
    f.organisms += count;
    f.modules += count * size.word.modules;
    f.nodes += count * size.nodes;
    f.organs += count * size.organs;
    f.scene_memory += count * held + kHeldTriangle * size.shapes;
    f.frame_memory += count * (traits.develops(preset.film.frames > 1) ? held : 0) + kPosedNode * size.nodes +
                      kPosedOrgan * size.organs + (wood.bytes > kMovingNode * size.nodes ? own : 0);
    // A block is one of about so many shapes.
    constexpr double kBlockShapes = 13;
    standing += count * size.triangles * std::max(1.0, size.blocks / kBlockShapes);
    f.ungrown_bytes += count * own * frames_ungrown(preset.film, appearance.motion.growth, part);
    body_memory = std::max(body_memory, wood.memory);
    body_seconds += count * wood.seconds;
    growing = std::max(growing, (together ? count : 1) * grows);
    text += count * own;
    still += count * solid;
    materials += kTriangle * size.shapes;
    f.growth_seconds += count * made;
    view.seconds += count * (made + wood.seconds + size.nodes / kNodesPacked + size.organs / kOrgansPacked +
                             size.triangles / kTrianglesPacked);
    view.longest = std::max(view.longest, (together ? count : 1) * (made + wood.seconds));
    if (count * own + solid > most) most = count * own + solid, f.largest = o;
  }
};

Result<Sums> sums_of(const Preset& preset, FrameRange part) {
  Sums sums;
  sums.part = part;
  MaskCostEstimate masks = estimate_masks(preset);
  sums.f.scene_memory = masks.held;
  sums.growing = masks.read;
  if (const Mask& grass = preset.setup.block<Meadow>().lawn.map; !grass.empty())
    sums.add_drawing(mask_drawing(grass), sums.growing);
  const double shaded = left_in_shade(preset);
  const std::vector<Seed> seeds = entry_seeds(preset, "organism");
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    const Grower& grower = *organism.grower;
    if (organism.count == 0 && lives_of_entry(preset, organism) == 0) continue;
    Result<SizeEstimate> sized = grower.estimate_size(seeds[o]);
    if (!sized) return sized.errors();
    SizeEstimate& size = *sized;
    if (!organism.sown && grower.traits().shares_light())
      size.nodes *= shaded, size.organs *= shaded, size.parts *= shaded, size.seconds *= shaded;
    Appearance appearance = grower.appearance();
    count_fruit(size, appearance.season);
    double held = kHeldNode * size.nodes + kHeldOrgan * size.organs + kCorner * size.corners +
                  kHeldTriangle * size.triangles + 100 * size.blocks + size.held / 2;
    double grows = held + kGrowingNode * size.nodes + kGrowingOrgan * size.organs + 2 * size.word.bytes +
                   3 * kHeldTriangle * size.triangles + size.held / 2;
    double made = size.nodes / size.nodes_a_second + size.organs / kOrgansGrown +
                  size.triangles / kTrianglesMade + size.word.work / kModulesDerived + size.seconds;
    bool develops = grower.traits().develops(preset.film.frames > 1);
    sums.changing = sums.changing || appearance.motion.growth.duration > 0 || develops ||
                    (size.organs > 0 && condition_of(organism.courses, appearance.look, {})) ||
                    moves_far(preset, organism, appearance.motion);
    sums.add_pictures(ail_look(appearance.look, organism.courses));
    if (organism.sown)
      sums.add_sown(preset, o, size, appearance, made, grows);
    else
      sums.add_standing(preset, o, size, appearance, made, held, grows, seeds[o]);
  }
  return sums;
}

}  // namespace

int CostEstimate::at_once(const Machine& machine) const {
  double spare = 0.8 * machine.memory - scene_memory;
  double most = std::clamp(frames * exposures, 1, std::max(1, machine.threads));
  return static_cast<int>(std::clamp(spare / std::max(frame_memory, 1.0), 1.0, most));
}

double CostEstimate::memory(int at_once) const {
  return std::max(growth_memory, scene_memory + at_once * frame_memory);
}

double ViewCostEstimate::wait(int threads) const { return std::max(seconds / std::max(1, threads), longest); }

Result<CostEstimate> estimate_cost(const Preset& preset, FrameRange part) {
  Result<Sums> sums = sums_of(preset, part);
  if (!sums) return sums.errors();
  CostEstimate& f = sums->f;
  GroundCostEstimate ground =
      estimate_ground_cost(preset, tallest_of(preset), f.crowd > kCrowdedLight, sums->standing);
  f.frames = part.count();
  f.resolve_memory = estimate_resolving(preset);
  f.tracing_disk = estimate_tracing_disk(preset.film);
  f.exposures = exposures(preset.film, preset.setup.camera);
  f.scene_memory += kProgram + ground.memory;
  f.growth_seconds += kStart + ground.seconds;
  sums->still += ground.bytes;
  f.scene_memory += 2 * (sums->still + sums->materials);
  f.frame_memory += kFrameBuffers + sums->body_memory;
  bool rains = is_rainy(preset.setup) && highest(preset.setup.rain->rate) > 0;
  sums->text += kStreaksText * (rains + (is_snowy(preset.setup) && highest(preset.setup.snow.falling) > 0));
  bool fills = is_rainy(preset.setup) && !preset.setup.rain->fallen.constant();
  bool each = (sums->changing || sun_moves(preset.setup) || fills) && preset.film.frames > 1;
  f.growth_memory = f.scene_memory + std::max(sums->growing, each ? 0 : ground.light_memory);
  if (each) f.frame_memory += ground.light_memory;
  (each ? f.frame_seconds : f.growth_seconds) += ground.light_seconds;
  // What all frames share is written once where it is surely long.
  for (double same : {sums->still, sums->materials})
    (preset.film.frames > 1 && same > kAsideBytes ? f.shared_bytes : sums->text) += same;
  f.picture_bytes = kPictureBytes * preset.film.size[0] * preset.film.size[1];
  if (preset.film.raw)
    f.picture_bytes += kRawBytes * preset.film.drawn_size()[0] * preset.film.drawn_size()[1];
  f.render_seconds = f.exposures * render_seconds(f, sums->text, ground.tracing, preset.film);
  f.frame_bytes = f.exposures * (sums->text + ground.pictures) + (each ? ground.light_bytes : 0);
  f.ungrown_bytes *= f.exposures;
  if (!each) f.shared_bytes += ground.light_bytes;
  f.frame_seconds += f.exposures * (sums->text / kBytesWritten + sums->body_seconds + ground.picture_seconds);
  return std::move(f);
}

Result<ViewCostEstimate> estimate_view_cost(const Preset& preset) {
  Result<Sums> sums = sums_of(preset, {});
  if (!sums) return sums.errors();
  ViewCostEstimate& view = sums->view;
  view.nodes = sums->f.nodes;
  view.memory = kProgram + sums->f.scene_memory + sums->growing;
  view.largest = sums->f.largest;
  return view;
}

}  // namespace frond
