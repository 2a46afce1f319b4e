#include "sheets/sheet.h"

#include <fmt/format.h>

#include <cmath>
#include <string_view>

#include "core/content.h"
#include "core/frame_name.h"
#include "core/read_as.h"
#include "core/work_folder.h"
#include "jobs/jobs.h"
#include "render/film.h"
#include "render/label.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

bool consume_number(std::string_view& text, double& number) {
  number = consume_as<double>(text).value_or(HUGE_VAL);
  return std::isfinite(number);
}

bool consume_colon(std::string_view& text) {
  if (!text.starts_with(':')) return false;
  text.remove_prefix(1);
  return true;
}

/// What a picture is called by: the last step of the pointer, with the one before where that is an index.
std::string name_of(const std::string& pointer) {
  std::size_t last = pointer.rfind('/');
  std::string name = pointer.substr(last + 1);
  if (name.empty() || last == 0 || name.find_first_not_of("0123456789") != name.npos) return name;
  return pointer.substr(pointer.rfind('/', last - 1) + 1);
}

/// What the sweeps are called on pictures: by their whole pointers where they would be called the same.
std::vector<std::string> names_of(const std::vector<Sweep>& sweeps) {
  std::vector<std::string> names;
  for (const Sweep& sweep : sweeps) names.push_back(name_of(sweep.pointer));
  if (names.size() > 1 && names[0] == names[1]) names = {sweeps[0].pointer, sweeps[1].pointer};
  return names;
}

}  // namespace

Sweep sweep_of(std::string pointer, double from, double to, int count) {
  Sweep sweep{std::move(pointer), {}};
  for (int i = 0; i < count; ++i)
    sweep.values.push_back(fmt::format("{:.6g}", from + (count > 1 ? i * (to - from) / (count - 1) : 0)));
  return sweep;
}

std::optional<Sweep> read_sweep(const std::string& text) {
  constexpr int kMost = 99;
  std::size_t equals = text.rfind('=');
  double from = 0, to = 0, count = 0;
  std::string_view rest = std::string_view(text).substr(equals == text.npos ? text.size() : equals + 1);
  if (text.starts_with('/') && consume_number(rest, from) && consume_colon(rest) &&
      consume_number(rest, to) && consume_colon(rest) && consume_number(rest, count) && rest.empty() &&
      count >= 1 && count <= kMost && count == std::floor(count))
    return sweep_of(text.substr(0, equals), from, to, static_cast<int>(count));
  return std::nullopt;
}

std::vector<SheetCell> cells_of(const std::vector<Sweep>& sweeps, const fs::path& pictures) {
  std::vector<SheetCell> cells;
  std::vector<std::string> names = names_of(sweeps);
  std::vector<std::string> down = sweeps.size() > 1 ? sweeps[1].values : std::vector<std::string>{""};
  for (const std::string& second : down)
    for (const std::string& first : sweeps[0].values) {
      SheetCell cell{{sweeps[0].pointer + "=" + first}, names[0] + " " + first, {}};
      if (sweeps.size() > 1) {
        cell.sets.push_back(sweeps[1].pointer + "=" + second);
        cell.text += "   " + names[1] + " " + second;
      }
      std::string all;
      for (const std::string& set : cell.sets) all += set + '\n';
      cell.folder = pictures / content_id(all).substr(0, 12);
      cells.push_back(std::move(cell));
    }
  return cells;
}

int columns_of(const std::vector<Sweep>& sweeps) {
  int count = static_cast<int>(sweeps[0].values.size());
  if (sweeps.size() > 1) return count;
  int columns = 1;
  while (columns * columns < count) ++columns;
  return columns;
}

Errors make_sheet(const std::vector<SheetCell>& cells, int frame, int columns, const fs::path& sheet) {
  WorkFolder work;
  if (work.path().empty()) return {{"", "no folder can be made for the labels"}};
  std::string ffmpeg = environment_or("FROND_FFMPEG", "ffmpeg");
  Result<Manifest> manifest = manifest_in(cells[0].folder);
  if (!manifest) return manifest.errors();
  Labels labels(work.path());
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (Errors errors = labels.add(fmt::format("label{}", i), cells[i].text, manifest->size[0]);
        !errors.empty())
      return errors;
  constexpr int kWidest = 16384;
  SheetJob job{{}, sheet, columns, kWidest, ffmpeg};
  for (std::size_t i = 0; i < cells.size(); ++i) {
    fs::path picture = cells[i].folder / "frames" / (frame_name(frame) + ".png");
    job.pictures.push_back(work.path() / fmt::format("{}.png", i));
    Command command;
    command.folder = work.path();
    std::string filter = "format=rgb24," + labels.filter(fmt::format("label{}", i));
    if (manifest->transparent) filter = "format=gbrap,premultiply=inplace=1," + over_checks() + "," + filter;
    command.words = {ffmpeg, "-hide_banner", "-nostdin", "-loglevel", "error", "-y"};
    command.add({"-i", "file:" + picture.string(), "-vf", filter, "-frames:v", "1", "-update", "1",
                 job.pictures.back().string()});
    Result<int> code = run(command);
    if (!code || *code != 0) return {{"", picture.string() + " could not be labelled"}};
  }
  return tile_sheet(job);
}

}  // namespace frond
