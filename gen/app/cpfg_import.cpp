#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "app/commands.h"
#include "app/cpfg_models.h"
#include "app/messages.h"
#include "app/streams.h"
#include "core/files.h"
#include "cpfg/cpfg.h"

// A preset of a model of cpfg: import.

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr double kLongest = 1;  ///< metres, the longest side of what is imported
constexpr double kAngle = 32;   ///< degrees, what the camera sees across

/// Three numbers of a line of the view.
std::optional<DVec3> vector_in(const CpfgModel& model, std::string_view key) {
  for (const CpfgViewLine& line : model.view) {
    DVec3 v;
    if (line.key == key && std::sscanf(line.value.c_str(), "%lf , %lf , %lf", &v.x, &v.y, &v.z) == 3)
      return v;
  }
  return std::nullopt;
}

/// From where the view looks at its model.
DVec3 side_of(const CpfgModel& model) {
  DVec3 from = vector_in(model, "viewpoint").value_or(DVec3{0, 0, 1}),
        to = vector_in(model, "view reference point").value_or(DVec3{0, 0, 0});
  DVec3 side = from - to;
  if (!(glm::length(side) > 1e-9) || !std::isfinite(glm::length(side))) side = {0, 0, 1};
  side = glm::normalize(side);
  side.y = std::max(side.y, 0.04);  // from below the floor nothing is seen
  return glm::normalize(side);
}

/// How far from the middle of a box an eye on a side of it sees the whole box with a rim of a tenth.
double distance_to_see(DVec3 size, DVec3 side) {
  DVec3 right = glm::normalize(glm::cross(DVec3{0, 1, 0}, side)), up = glm::cross(side, right);
  double slope = 0.9 * std::tan(radians(kAngle / 2)), distance = 0;
  for (int corner = 0; corner < 8; ++corner) {
    DVec3 at = size * DVec3{corner & 1 ? 0.5 : -0.5, corner & 2 ? 0.5 : -0.5, corner & 4 ? 0.5 : -0.5};
    double across = std::max(std::abs(glm::dot(at, right)), std::abs(glm::dot(at, up)));
    distance = std::max(distance, glm::dot(at, side) + across / slope);
  }
  return distance;
}

std::string place(DVec3 v) { return fmt::format("[{:.4g}, {:.4g}, {:.4g}]", v.x, v.y, v.z); }

std::string preset_of(const CpfgModel& model, const CpfgFigure& figure, const fs::path& file, int steps) {
  DVec3 size = figure.high - figure.low;
  double scale = kLongest / std::max({size.x, size.y, size.z}), height = size.y * scale;
  DVec3 middle{0, height / 2, 0}, side = side_of(model);
  DVec3 eye = middle + side * distance_to_see(size * scale, side);
  eye.y = std::max(eye.y, 0.05);
  return fmt::format(
      R"json({{
  "title": "{0}",
  "film": {{"frames": 1, "size": [640, 640], "quality": "good"}},
  "scene": {{
    "setting": "studio",
    "camera": {{"location": {1}, "look_at": {2}, "angle": {3}}},
    "studio": {{"wall": "#dfe3e0", "distance": {4:.3g}}}
  }},
  "organisms": [
    {{
      "kind": "plant", "name": "{0}",
      "place": {{"at": [[0, 0]], "lean": 0, "size_variation": 0, "turn_variation": 0}},
      "height": {5:.4g}, "stand": "middle", "smoothing": 1,
      "thickness": {{"least": 0.0002}},
      "grammar": {{"file": "{6}", "steps": {7}}}
    }}
  ]
}}
)json",
      file.stem().string(), place(eye), place(middle), kAngle, 1.2 + size.z * scale, height,
      file.generic_string(), steps);
}

/// Whether a name can stand in JSON as it is.
bool is_plain(const std::string& name) {
  return std::ranges::none_of(
      name, [](char c) { return c == '"' || c == '\\' || static_cast<unsigned char>(c) < ' '; });
}

}  // namespace

int import_model(const ImportArguments& arguments) {
  if (!is_cpfg_model(arguments.path))
    return fail({{arguments.path, "expected a model of cpfg, a file .l"}}, kWrongInput);
  Result<CpfgModel> model = read_cpfg(arguments.path);
  if (!model) return fail(model.errors(), kWrongInput);
  int steps = arguments.steps.value_or(film_of(*model, model->steps).last);
  CpfgRequest request;
  request.steps = steps, request.drawing = true;
  Result<CpfgDerived> derived = derive(*model, request);
  if (!derived) return fail(derived.errors(), kWrongInput);
  Result<CpfgFigure> figure = draw(*model, derived->drawing);
  if (!figure) return fail(figure.errors(), kWrongInput);
  if (!(glm::length(figure->high - figure->low) > 0))
    return fail({{arguments.path, "its turtle draws nothing; does it need more steps? --steps sets them"}},
                kWrongInput);
  fs::path out =
      arguments.out.empty() ? fs::path(arguments.path).replace_extension(".json") : fs::path(arguments.out);
  std::error_code error;
  fs::path file = fs::proximate(arguments.path, out.has_parent_path() ? out.parent_path() : ".", error);
  if (error || !is_plain(file.string()))
    return fail({{arguments.path, "a preset cannot name this file; give it a plain name"}}, kWrongInput);
  Result<bool> written = write_file(out.string(), preset_of(*model, *figure, file, steps));
  return written ? kDone : fail(written.errors(), kCouldNot);
}

}  // namespace frond
