#include "gallery/gallery_list.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "core/text.h"
#include "render/place.h"

namespace frond {

namespace {

constexpr std::string_view kLarge = "large:";

std::vector<std::string> words_in(std::string_view line) {
  std::vector<std::string> words = split(line, ' ');
  std::erase(words, "");
  return words;
}

GalleryPart read_part(const std::string& word) {
  std::vector<std::string> fields = split(word, ',');
  GalleryPart part{fields[0], 1, {fields.begin() + 1, fields.end()}};
  std::size_t at = part.preset.find('@');
  if (at == part.preset.npos) return part;
  part.frame = counting_number(std::string_view(part.preset).substr(at + 1));
  part.preset.resize(at);
  return part;
}

/// Nothing where the words are no picture.
std::optional<GalleryPicture> read_picture(const std::vector<std::string>& words) {
  constexpr std::size_t kFirstPart = 3;
  if (words.size() <= kFirstPart) return std::nullopt;
  GalleryPicture picture{words[0], size_of(words[1]), counting_number(words[2]), {}};
  for (std::size_t i = kFirstPart; i < words.size(); ++i) picture.parts.push_back(read_part(words[i]));
  bool good = picture.size[0] > 0 && picture.columns > 0 &&
              std::ranges::all_of(picture.parts, [](const GalleryPart& part) { return part.frame > 0; });
  return good ? std::optional(picture) : std::nullopt;
}

/// The last cell of a row, which is that of the seconds.
std::string seconds_on(std::string_view row) {
  std::vector<std::string> cells = split(row, '|');
  std::vector<std::string> words = cells.empty() ? cells : words_in(cells.back());
  return words.empty() ? "?" : words[0];
}

}  // namespace

Result<GalleryList> read_gallery(std::string_view text, const std::string& file_name) {
  GalleryList list;
  int number = 0;
  for (const std::string& line : split(text, '\n')) {
    ++number;
    if (line.empty() || line.starts_with('#')) continue;
    std::vector<std::string> words = words_in(line);
    if (!words.empty() && words[0] == kLarge) {
      list.large.assign(words.begin() + 1, words.end());
      continue;
    }
    std::optional<GalleryPicture> picture = read_picture(words);
    if (!picture)
      return Error{fmt::format("{}:{}", file_name, number),
                   "no picture; expected NAME WIDTHxHEIGHT COLUMNS PRESET[@FRAME][,POINTER=VALUE]..."};
    list.pictures.push_back(std::move(*picture));
  }
  return list;
}

std::array<int, 2> large_size(std::array<int, 2> size) {
  constexpr int kWidth = 1280;
  return {kWidth, (size[1] * kWidth + size[0] / 2) / size[0]};
}

std::string gallery_row(const GalleryPicture& picture, const GalleryRow& row, std::string_view page) {
  std::vector<std::string> presets;
  for (const GalleryPart& part : picture.parts)
    if (std::string file = "presets/" + part.preset + ".json";
        std::ranges::find(presets, file) == presets.end())
      presets.push_back(std::move(file));
  std::string seconds =
      row.seconds ? std::to_string(std::lround(*row.seconds)) : seconds_on(row_on_page(page, picture.name));
  return fmt::format(R"(| <img src="gallery/{}.jpg" width="200"> | {} | {}x{} | {} | {} | {} |)",
                     picture.name, fmt::join(presets, ", "), picture.size[0], picture.size[1], row.seed,
                     row.nodes, seconds);
}

std::string row_on_page(std::string_view page, const std::string& name) {
  for (const std::string& line : split(page, '\n'))
    if (line.find("gallery/" + name + ".jpg") != line.npos) return line;
  return {};
}

std::string row_with_large(const std::string& row, const std::string& name) {
  constexpr std::string_view kBegin = "| ", kEnd = "width=\"200\">";
  std::size_t end = row.find(kEnd);
  if (row.find("gallery/large/") != row.npos || !row.starts_with(kBegin) || end == row.npos) return row;
  end += kEnd.size();
  return fmt::format("| <a href=\"gallery/large/{}.jpg\">{}</a>{}", name,
                     row.substr(kBegin.size(), end - kBegin.size()), row.substr(end));
}

std::string gallery_page(const std::vector<std::string>& rows) {
  std::string page =
      "# Gallery\n\nEvery picture is made by scripts/gallery.sh from the preset as it is, at the quality "
      "\"good\". "
      "Some lead to larger ones.\n\n"
      "| picture | preset | size | seed | nodes | seconds of processor |\n"
      "| --- | --- | --- | --- | --- | --- |\n";
  for (const std::string& row : rows) page += row + '\n';
  return page;
}

SceneIds read_scene_ids(std::string_view text) {
  SceneIds ids;
  for (const std::string& line : split(text, '\n'))
    if (std::vector<std::string> words = words_in(line); words.size() == 2 && !line.starts_with('#'))
      ids[words[0]] = words[1];
  return ids;
}

std::string scene_ids_text(const SceneIds& ids) {
  std::string text =
      "# Hashes of the scenes that the pictures here show, by `frond gallery`, whose --stale reads them.\n";
  for (const auto& [name, id] : ids) text += fmt::format("{} {}\n", name, id);
  return text;
}

ExampleScene read_example(std::string_view scene) {
  constexpr std::string_view kCall = "//   frond ", kRender = "// Then: ";
  ExampleScene example;
  for (const std::string& line : split(scene, '\n')) {
    if (line.starts_with(kCall)) example.calls.push_back(words_in(line.substr(kCall.size())));
    if (!line.starts_with(kRender)) continue;
    for (const std::string& word : words_in(line)) {
      if (word.starts_with("+W")) example.size[0] = counting_number(std::string_view(word).substr(2));
      if (word.starts_with("+H")) example.size[1] = counting_number(std::string_view(word).substr(2));
    }
  }
  return example;
}

std::string grammar_preset(std::string_view layout, std::string_view grammar) {
  constexpr std::array<std::string_view, 2> kOrgans[] = {
      // where each is placed, and what it is
      {"~b", R"({"symbol": "b", "shape": "bud", "size": 0.03, "colors": ["#b8622f"]})"},
      {"~L", R"({"symbol": "L", "shape": "leaf", "size": 0.06, "colors": ["#6f9a34"]})"}};
  std::string organs, preset;
  for (auto [place, organ] : kOrgans)
    if (grammar.find(place) != grammar.npos) organs += (organs.empty() ? "" : ", ") + std::string(organ);
  for (const std::string& line : split(layout, '\n')) {
    if (line == "@organs@")
      preset += organs.empty() ? "" : "\"organs\": [" + organs + "],\n";
    else if (line == "@grammar@")
      preset += grammar;
    else
      preset += line + '\n';
  }
  return preset;
}

}  // namespace frond
