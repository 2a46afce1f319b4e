#include "cli/flower_bed.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "cli/named.h"
#include "core/files.h"
#include "core/home.h"
#include "core/seed.h"
#include "draw/sizes.h"
#include "preset/json.h"
#include "scene/scene.h"
#include "scene/taxon.h"
#include "settings/settings.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

/// A species in the bed: what it is, how large it grows and where its drift lies.
struct Drift {
  std::string species, name;
  double height = 0, width = 0;  // of one plant, metres
  int count = 1;
  double half_width = 0, half_depth = 0;  // of what the drift takes of the bed
  double x = 0, z = 0;
};

/// As gardeners plant: the lower, the more.
int usual_count(double height) {
  struct Step {
    double below;
    int count;
  };
  constexpr Step kSteps[] = {{0.3, 25}, {0.7, 13}, {1.2, 7}, {2.5, 3}};
  for (const Step& step : kSteps)
    if (height < step.below) return step.count;
  return 1;
}

/// Radius of a drift as a share of a plant's width, times the root of their number: they touch.
constexpr double kCloseness = 0.4;
/// How much wider than deep a drift is.
constexpr double kStretch = 1.8;

/// From what height on it is a tree, which the camera need not show whole.
constexpr double kTree = 2.5;

Result<Drift> grown_drift(const std::string& name) {
  fs::path file = preset_named(name);
  std::error_code error;
  if (!fs::is_regular_file(file, error)) {
    std::set<std::string> known;
    for (const ShippedSpecies& one : shipped_species()) {
      known.insert(one.file.stem().string());
      known.insert(one.taxon.names.begin(), one.taxon.names.end());
    }
    std::vector<std::string_view> views(known.begin(), known.end());
    return error_at("--with", "\"{}\" is no species, and no preset{}", name, expected_names(name, views));
  }
  Drift drift{.species = fs::absolute(file, error).string(), .name = name};
  Result<std::string> text = read_file(file);
  Result<Preset> own = text ? read_preset(*text, file.string(), {}) : text.errors();
  if (!own) return own.errors();
  if (settings()[own->setup.setting].name == "underwater")
    return error_at("--with", "\"{}\" lives under water; expected what grows in a garden", name);
  // What is shipped is named as it is, whatever folder the bed will be in.
  std::string stem = file.stem().string();
  if (std::optional<fs::path> shipped = shipped_preset(stem);
      shipped && fs::equivalent(*shipped, file, error))
    drift.species = stem;
  Value one = make_object();
  one.set("species", make_text(drift.species));
  Value whole = make_object().set("organisms", make_list({one}));
  Result<Preset> alone = read_preset(serialize(whole), "bed.json", {"/film/frames=1"});
  if (!alone) return error_at("--with", "\"{}\" cannot stand alone: {}", name, alone.errors().front().what);
  Result<Scene> scene = build_scene(*alone);
  if (!scene) return scene.errors();
  Result<std::vector<GrownSize>> sizes = sizes_of(*scene, *alone, 0);
  if (!sizes) return sizes.errors();
  drift.height = sizes->front().height, drift.width = sizes->front().width;
  if (!(drift.height > 0 && drift.width > 0))
    return error_at("--with", "\"{}\" shows nothing at the end of its growth", name);
  drift.count = usual_count(drift.height);
  double radius = kCloseness * drift.width * std::sqrt(drift.count);  // were it round
  bool tree = drift.height >= kTree;  // whose crown reaches over what stands before it
  drift.half_width = tree ? 0.3 : radius * std::sqrt(kStretch);
  drift.half_depth = tree ? 0.3 : radius / std::sqrt(kStretch);
  return drift;
}

Value numbers(std::initializer_list<double> values) {
  Value list = make_list();
  for (double value : values) list.items.push_back(make_number(std::round(value * 100) / 100));
  return list;
}

/// The low ones in front, drifts to the left and right by turns so that each shows beside that before it.
void lay_out(std::vector<Drift>& drifts) {
  std::ranges::stable_sort(drifts, {}, &Drift::height);
  double z = 0, widest = 0;
  for (const Drift& drift : drifts) widest = std::max(widest, drift.half_width);
  for (std::size_t i = 0; i < drifts.size(); ++i) {
    if (i > 0) z -= 0.8 * (drifts[i - 1].half_depth + drifts[i].half_depth);
    drifts[i].z = z;
    if (drifts.size() > 1) drifts[i].x = (i % 2 == 0 ? -0.5 : 0.5) * widest;
  }
  for (Drift& drift : drifts) drift.z -= 0.5 * z;
}

/// Where the plants of a drift stand: on a spiral by the golden angle (Vogel 1979), by hand, so not quite.
Value places_of(const Drift& drift) {
  Value places = make_list();
  Seed seed = Seed{1}.child(drift.name);
  for (int i = 0; i < drift.count; ++i) {
    double share = drift.count > 1 ? std::sqrt((i + 0.5) / drift.count) : 0, turn = kGoldenAngle * i;
    Seed own = seed.child("place", static_cast<std::uint64_t>(i));
    auto shake = [&](const char* axis) {
      return drift.count > 1 ? 0.2 * drift.width * own.child(axis).range(-1, 1) : 0;
    };
    places.items.push_back(numbers({drift.x + drift.half_width * share * std::cos(turn) + shake("x"),
                                    drift.z + drift.half_depth * share * std::sin(turn) + shake("z")}));
  }
  return places;
}

Value organism_of(const Drift& drift) {
  Value one = make_object();
  one.set("species", make_text(drift.species)).set("name", make_text(drift.name));
  one.set("count", make_number(drift.count));
  Value place = make_object();
  place.set("at", places_of(drift));
  return one.set("place", place);
}

/// An oval of earth round what stands in the bed.
Value earth_of(const std::vector<Drift>& drifts) {
  constexpr double kRim = 0.15;  // metres of bare earth
  double left = 0, right = 0, back = 0, front = 0;
  for (const Drift& drift : drifts) {
    double x = drift.half_width + kRim, z = drift.half_depth + kRim;
    left = std::min(left, drift.x - x), right = std::max(right, drift.x + x);
    back = std::min(back, drift.z - z), front = std::max(front, drift.z + z);
  }
  constexpr int kCorners = 12;
  Value outline = make_list();
  for (int i = 0; i < kCorners; ++i) {
    double turn = 2 * kPi * i / kCorners, wave = 1 + 0.06 * std::sin(3 * turn + 1);
    outline.items.push_back(numbers({0.5 * (left + right) + 0.56 * (right - left) * wave * std::cos(turn),
                                     0.5 * (back + front) + 0.6 * (front - back) * wave * std::sin(turn)}));
  }
  return make_object()
      .set("kind", make_text("earth"))
      .set("outline", outline)
      .set("curve", make_boolean(true));
}

Value scene_of(const std::vector<Drift>& drifts) {
  Value shown = make_list();
  double tallest = 0;
  for (const Drift& drift : drifts)
    if (drift.height < kTree || drifts.front().height >= kTree) {
      shown.items.push_back(make_text(drift.name));
      tallest = std::max(tallest, drift.height);
    }
  Value camera = make_object();
  camera.set("location", numbers({0, 0.7 + 0.5 * tallest, 6})).set("look_at", numbers({0, 0.5 * tallest, 0}));
  camera.set("angle", make_number(38)).set("fit", shown).set("margin", make_number(0.03));
  camera.set("exposure", make_number(0.6))
      .set("highlights", make_number(2.2))
      .set("contrast", make_number(1.15));
  camera.set("saturation", make_number(0.85))
      .set("warmth", make_number(0.06))
      .set("vignette", make_number(0.2));
  Value garden = make_object();
  garden.set("hour", make_number(8.5)).set("south", make_number(200)).set("clods", make_number(0.02));
  garden.set("areas", make_list({earth_of(drifts)}));
  Value meadow = make_object();
  meadow.set("blade", make_number(0.06)).set("blades", make_number(1400)).set("extent", make_number(16));
  Value scene = make_object();
  scene.set("setting", make_text("garden")).set("camera", camera);
  return scene.set("meadow", meadow).set("garden", garden);
}

}  // namespace

Result<Value> flower_bed(const std::vector<std::string>& names) {
  std::vector<Drift> drifts;
  Errors errors;
  for (const std::string& name : names) {
    if (std::ranges::find(drifts, name, &Drift::name) != drifts.end()) continue;
    Result<Drift> drift = grown_drift(name);
    if (drift)
      drifts.push_back(std::move(*drift));
    else
      errors.insert(errors.end(), drift.errors().begin(), drift.errors().end());
  }
  if (!errors.empty()) return errors;
  lay_out(drifts);
  Value organisms = make_list();
  for (const Drift& drift : drifts) organisms.items.push_back(organism_of(drift));
  Value film = make_object();
  film.set("frames", make_number(1)).set("size", numbers({960, 540})).set("quality", make_text("good"));
  return make_object().set("film", film).set("scene", scene_of(drifts)).set("organisms", organisms);
}

}  // namespace frond
