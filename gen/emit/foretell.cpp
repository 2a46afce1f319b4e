#include "emit/foretell.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grammar/figure.h"
#include "organisms/organ_prototypes.h"
#include "scene/copies.h"

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
constexpr double kAside = 5e6;  // of what goes to a file of its own, see frame.cpp
// Bytes of memory.
constexpr double kProgram = 4e7;
constexpr double kHeldNode = 40, kGrowingNode = 60, kPosedNode = 50;
constexpr double kHeldOrgan = 70, kGrowingOrgan = 130, kPosedOrgan = 50;
constexpr double kHeldTriangle = 40;
constexpr double kFrameBuffers = 3e7;
// A second.
constexpr double kNodesGrown = 5e5, kTreeNodesGrown = 5e4, kTrianglesMade = 5e5, kBytesWritten = 3e7,
                 kPixelsDrawn = 5e5;

/// What one organism takes.
struct Share {
  Foresight size;
  double organs = 0, lines = 0, corners = 0;  // lines: placements of all parts of its organs
  double shapes = 0;                          // triangles of its organs' shapes, once for an entry
  double triangles = 0, blocks = 0;           // of a body, and how many placements it is made of
  double node_bytes = kStillNode;
  double growing = kNodesGrown;  // nodes a second
  double chains = 0.1;           // runs of nodes for each node: short ones take more text
};

/// What a grammar hangs on its branches: as counted where it is small, and on a smaller one otherwise.
void count_organs(const PlantParams& params, Seed seed, Share& share) {
  constexpr double kCounted = 1e5;  // modules or segments
  Result<Grammar> grammar = plant_grammar(params);
  if (!grammar) return;
  int steps = grammar->text.steps;
  auto large = [&](int n) {
    Forecast word = forecast(*grammar, n, seed);
    return std::max(word.modules, word.segments) > kCounted;
  };
  while (steps > 1 && large(steps)) --steps;
  std::vector<std::string> names;
  for (const OrganParams& organ : params.organs) names.push_back(organ.symbol);
  Limits limits{2'000'000, std::size_t{64} << 20};
  Result<Figure> figure = figure_of(*grammar, steps, seed, limits, names, params.by_steps);
  if (!figure) return;
  auto segments = static_cast<double>(figure->skeleton.size());
  std::vector<bool> goes_on(figure->skeleton.size());
  for (std::int32_t below : figure->skeleton.parent)
    if (below != Skeleton::kRoot) goes_on[static_cast<std::size_t>(below)] = true;
  auto tips = static_cast<double>(std::count(goes_on.begin(), goes_on.end(), false));
  share.chains = tips / std::max(1.0, segments * params.smoothing);
  double scale = 1;
  if (steps == grammar->text.steps)
    share.size.nodes = segments * params.smoothing;
  else
    scale = std::max(1.0, share.size.word.segments / std::max(segments, 1.0));
  std::vector<Prototype> prototypes = organ_prototypes(params);
  std::vector<bool> used(prototypes.size());
  for (const Site& site : figure->sites) {
    Variants kinds = variants_of(params, site.name);
    if (kinds.first < 0) continue;
    share.organs += scale;
    share.lines +=
        scale * static_cast<double>(prototypes[static_cast<std::size_t>(kinds.first)].parts.size());
    for (int k = 0; k < kinds.count; ++k) used[static_cast<std::size_t>(kinds.first + k)] = true;
  }
  for (const Outline& outline : figure->outlines)
    share.corners += scale * static_cast<double>(outline.points.size());
  for (std::size_t p = 0; p < prototypes.size(); ++p)
    for (const OrganPart& part : prototypes[p].parts)
      if (used[p]) share.shapes += static_cast<double>(part.surface.triangle.size());
}

/// Triangles of a rock: as many as its tolerance asks for and its finest cells can make.
double rock_triangles(const RockShape& shape) {
  double flat = 6e4 * std::pow(0.0003 / std::max(shape.cells.tolerance, 1e-9), 0.87);
  return std::min(flat, 6.6 * std::pow(4.0, shape.cells.depth));
}

double coat_bytes(const std::optional<BarkCoat>& coat, bool moves) {
  if (!coat) return moves ? kMovingNode : kStillNode;
  return coat->twigs > 0 ? kTwigCoatNode : kCoatNode;
}

struct Measure {
  Seed seed;
  Share& share;

  void operator()(const CoralParams&) { share.node_bytes = kMovingNode; }
  void operator()(const PlantParams& params) {
    count_organs(params, seed, share);
    bool moves = params.wave.amplitude != 0 || params.growth.duration > 0;
    bool plain = params.bark.kind == BarkKind::stem && params.bark.young_length <= 0;
    share.node_bytes = kPoint + kChain * share.chains;
    if (moves && !plain) share.node_bytes += kChunkTexture * (share.chains + 1.0 / 11);
  }
  void operator()(const RockParams& params) {
    share.triangles = params.native ? 0 : rock_triangles(params.shape), share.blocks = 1;
  }
  void operator()(const PebblesParams& params) {
    share.triangles = params.shapes * rock_triangles(params.shape), share.blocks = params.number;
  }
  void operator()(const WallParams& params) {
    const WallShape& w = params.shape;
    share.blocks = w.width * w.height / ((w.brick.x + w.joint) * (w.brick.y + w.joint));
    share.triangles = 18'000;
  }
  void operator()(const ColumnParams& params) { share.triangles = params.shape.broken > 0 ? 23e3 : 39e3; }
  void operator()(const MeshParams& params) {
    share.triangles = static_cast<double>(params.mesh.triangle.size()), share.blocks = 1;
  }
  void operator()(const BridgeParams& params) {
    const BridgeShape& b = params.shape;
    share.blocks = b.length / (b.plank + b.gap) + 4.0 * b.posts * (2 + b.balusters);
    share.triangles = b.style == BridgeStyle::stone ? 2.2e5 : 260 * share.blocks;
  }
  void operator()(const VaseParams& params) {
    share.triangles = 4.4 * params.shape.sides * params.shape.rings, share.blocks = 1;
  }
  void operator()(const WeberPennParams& params) {
    const WeberPenn& tree = params.tree;
    const StemLevel& last = tree.stem(tree.levels - 1);
    share.organs = 0.72 * share.size.nodes * std::abs(tree.leaves) * tree.leaf_quality /
                   std::max(1, last.curve_res * tree.smoothing);
    wear(params.dress);
  }
  void operator()(const ColonizedParams& params) {
    double length = share.size.nodes * params.growth_into.step / params.smoothing;
    if (params.leaf_reach > 0) share.organs = 0.5 * length / params.leaf_spacing;
    share.growing = kTreeNodesGrown;
    wear(params.dress);
  }
  void operator()(const TreeParams& params) {
    if (params.leaves.size > 0) share.organs = 1.1 * share.size.nodes;
    share.lines = share.organs;
    share.node_bytes = coat_bytes(params.coat, params.wave.amplitude != 0 || params.growth.duration > 0);
    share.growing = kTreeNodesGrown * 20 / std::max(20, params.years);
  }
  void operator()(const IvyParams& params) {
    share.organs = 0.5 * share.size.nodes * params.crawl.speed / std::max(params.leaves.spacing, 1e-3);
    share.lines = share.organs;
    share.shapes = 9000;
    share.node_bytes = kMovingNode;
    share.growing = kTreeNodesGrown;
  }
  void wear(const TreeDress& dress) {
    share.lines = share.organs;
    share.node_bytes = coat_bytes(dress.coat, dress.wave.amplitude != 0 || dress.growth.duration > 0);
  }
};

/// Whether it is another shape in each frame, made from a copy of all of it.
bool develops(const Organism& organism, const Film& film) {
  if (seasons_of(organism)) return true;
  const auto* plant = std::get_if<PlantParams>(&organism.body);
  const auto* tree = std::get_if<TreeParams>(&organism.body);
  return (plant && plant->by_steps) || (tree && tree->growth.duration > 0 && film.frames > 1);
}

/// Triangles and placements of what the setting lays on its ground, but for organisms.
void add_ground(const Preset& preset, Foretold& f, double& shared) {
  const Stage& stage = preset.stage;
  bool draft = preset.film.quality == Quality::draft, best = preset.film.quality == Quality::best;
  double triangles = 0, grass = 0, placed = 0;
  switch (stage.setting) {
    case Setting::underwater:
      triangles = 14'280 + (best ? 102'400 : 25'600), placed = 1.6 * stage.floor.stones;
      break;
    case Setting::studio:
      break;
    case Setting::forest: {
      // Litter lies wherever the camera passes by.
      double way = 0;
      const Film& film = preset.film;
      for (int frame = 2, step = std::max(1, film.frames / 200); frame <= film.frames; frame += step) {
        Vec3 moved = stage.camera.location.at(film.time(frame)) -
                     stage.camera.location.at(film.time(std::max(1, frame - step)));
        way += std::hypot(moved.x, moved.z);
      }
      triangles = 39'200, grass = 13'700, placed = 3000 + 170 * way;
      break;
    }
    case Setting::garden:
      triangles = 89'700 + 66'400, placed = 1000;
      [[fallthrough]];
    case Setting::meadow: {
      const Meadow& meadow = stage.meadow;
      if (stage.setting == Setting::meadow) triangles = 48'180;
      if (meadow.blade <= 0 || meadow.blades <= 0) break;
      double side = 5 * meadow.blade, thin = draft ? 0.6 : 1;
      grass = 9 * 4 * 1.25 * side * side * meadow.blades * thin;
      placed += kPi * std::pow(meadow.extent / side + 0.5, 2);
      if (stage.setting == Setting::garden) grass *= 1.3, placed *= 1.6;
    }
  }
  shared += kTriangle * 0.87 * triangles + kGrassTriangle * grass + kPlacement * placed;
  f.scene_memory += kHeldTriangle * (triangles + grass) + 60 * placed;
}

/// The files of the models of what is sown, each at two of its levels.
double model_bytes(const Share& share) {
  return 2 *
         (250 * share.size.nodes + std::min(90 * 12 * share.lines, 90 * 3e5) + kTriangle * share.triangles);
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
  double ground = 0, materials = 0, text = kLayout, most = 0, growing = 0;
  add_ground(preset, f, ground);
  for (std::size_t o = 0; o < preset.organisms.size(); ++o) {
    const Organism& organism = preset.organisms[o];
    if (organism.count == 0) continue;
    Share share;
    Result<Foresight> size = foresee(organism, Seed{preset.seed}.child("organism", o));
    if (!size) return size.errors();
    share.size = *size;
    std::visit(Measure{Seed{preset.seed}, share}, organism.body);
    double nodes = share.size.nodes;
    double held = kHeldNode * nodes + kHeldOrgan * share.organs + kCorner * share.corners +
                  kHeldTriangle * (share.triangles + share.shapes) + 100 * share.blocks;
    double grows = held + kGrowingNode * nodes + kGrowingOrgan * share.organs + 2 * share.size.word.bytes +
                   3 * kHeldTriangle * share.triangles;
    double wood = organism.style.build == Build::sweeps ? share.node_bytes : kBodyNode;
    double own = wood * nodes + kPlacement * share.lines + kCorner * share.corners;
    double made = nodes / share.growing + share.organs / kNodesGrown + share.triangles / kTrianglesMade;
    double count = std::max<double>(organism.count, static_cast<double>(organism.place.at.size()));
    for (const Drawing& drawing : drawings(organism)) {
      f.shared_bytes += 4e5 * static_cast<double>(drawing.names.size());
      f.growth_seconds += 3e5 / kPixelsDrawn * static_cast<double>(drawing.names.size());
    }
    if (organism.sown) {
      f.copies += count;
      f.models += organism.sown->models;
      double model = model_bytes(share);
      f.shared_bytes += organism.sown->models * model;
      f.growth_seconds += organism.sown->models * (made + model / kBytesWritten);
      // What is too far or out of view is left out.
      double lines = 0.4 * count * 2.5 * kPlacement;
      const Wave* wave = wave_of(organism);
      (wave && wave->amplitude > 0 && preset.film.frames > 1 ? text : ground) += lines;
      f.scene_memory += 40 * count;
      growing = std::max(growing, grows + 2 * model);
      if (lines + model > most) most = lines + model, f.largest = o;
      continue;
    }
    bool ivy = std::holds_alternative<IvyParams>(organism.body);
    f.organisms += count;
    f.modules += count * share.size.word.modules;
    f.nodes += count * nodes;
    f.organs += count * share.organs;
    f.scene_memory += count * held;
    f.frame_memory += count * ((develops(organism, preset.film) ? held : 0)) + kPosedNode * nodes +
                      kPosedOrgan * share.organs + (wood > kMovingNode ? own : 0);
    growing = std::max(growing, (ivy ? count : 1) * grows);
    text += count * own;
    ground += count * (kTriangle * share.triangles + kPlacement * share.blocks);
    materials += kTriangle * share.shapes;
    f.growth_seconds += count * made;
    if (count * own > most) most = count * own, f.largest = o;
  }
  f.scene_memory += 2 * (ground + materials);
  f.growth_memory = f.scene_memory + growing;
  // What all frames share is written once where it is surely long.
  for (double same : {ground, materials})
    (preset.film.frames > 1 && same > kAside ? f.shared_bytes : text) += same;
  f.frame_bytes = text;
  f.frame_seconds = text / kBytesWritten;
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
    errors.push_back({"", fmt::format("the run would write about {}, {} frames of {} and {} beside them, and "
                                      "{} of the disk are free; fewer frames (film.frames, --frames), or "
                                      "another --out; {}",
                                      bytes_text(f.disk()), f.frames, bytes_text(f.frame_bytes),
                                      bytes_text(f.shared_bytes), bytes_text(machine.disk), most)});
  return errors;
}

}  // namespace frond
