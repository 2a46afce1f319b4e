#include "cpfg/shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

constexpr std::size_t kColors = 256;
/// What is drawn where a model has no colours.
constexpr Color kLeafGreen{0.33f, 0.5f, 0.17f};

/// Reads the lines of a view that name what is drawn.
class ShapeReader {
 public:
  ShapeReader(ModelFolder& folder, Shapes& shapes) : folder_(folder), shapes_(shapes) {}

  void read(const CpfgViewLine& line) {
    words_ = words_in(line.value);
    std::vector<double> numbers = numbers_in(line.value);
    auto sides = [&](double n) { shapes_.sides = static_cast<int>(std::clamp(n, 3.0, 256.0)); };
    if (line.key == "surface") return add(line, read_patches);
    if (line.key == "tsurface")
      return add(line, [](std::string_view text, double scale, std::array<int, 2>) {
        return read_triangles(text, scale);
      });
    if (line.key == "contour") return add_contour(line);
    if (line.key == "tapered lines") shapes_.tapered = !words_.empty() && words_[0] == "on";
    if (line.key == "twist of cylinders") shapes_.twisted = line.value.starts_with("on");
    if (line.key == "line style" && !words_.empty()) shapes_.lines = style_of(words_[0]);
    if (line.key == "initial line width" && !words_.empty())
      shapes_.lines = words_.size() > 1 ? style_of(words_[1]) : LineStyle::polygon;
    if (numbers.empty()) return;
    if (line.key == "contour sides") sides(numbers[0]);
    if (line.key == "polygonization level") sides(std::exp2(numbers[0] + 1));
  }

 private:
  static LineStyle style_of(const std::string& word) {
    std::string_view first(word.data(), 1);
    if (word.starts_with("po")) return LineStyle::polygon;
    return first == "p" || first == "1"                   ? LineStyle::pixel
           : first == "s" || first == "c" || first == "3" ? LineStyle::cylinder
                                                          : LineStyle::polygon;
  }

  /// Ten a span, with both ends.
  static int samples_of_contour(const ContourFile& contour) {
    auto points = static_cast<int>(contour.points.size());
    return 10 * std::max(contour.closed ? points : points - 3, 1) + 1;
  }

  void fail(const CpfgViewLine& line, std::string what) {
    if (!shapes_.missing) shapes_.missing = Error{line.where, std::move(what)};
  }

  /// The file that a line names.
  Result<std::string> file() {
    return words_.size() < 2 ? Error{"", "expected a name and a file"} : folder_.read(words_[1]);
  }

  /// The first surface of a symbol counts.
  void add(const CpfgViewLine& line,
           Result<TurtleSurface> (*read_file)(std::string_view, double, std::array<int, 2>)) {
    Result<std::string> text = file();
    if (!text) {
      std::string what = text.errors()[0].what;
      if (!what.starts_with("there is no file")) return fail(line, std::move(what));
      shapes_.notes.push_back(
          fmt::format("{}: {}; ~{} draws nothing, as in cpfg", line.where, what, words_[0][0]));
      return;
    }
    if (shapes_.surfaces.contains(words_[0][0])) return;
    double scale = words_.size() > 2 ? leading_number(words_[2]) : 1;
    std::array<int, 2> pieces{};
    if (words_.size() > 4) pieces = {leading_whole(words_[3]), leading_whole(words_[4])};
    Result<TurtleSurface> surface = read_file(*text, std::isfinite(scale) && scale > 0 ? scale : 1, pieces);
    if (!surface) return fail(line, fmt::format("{}: {}", words_[1], surface.errors()[0].what));
    shapes_.surfaces[words_[0][0]] = std::move(*surface);
  }

  void add_contour(const CpfgViewLine& line) {
    Result<std::string> text = file();
    if (!text) return fail(line, text.errors()[0].what);
    Result<ContourFile> contour = read_contour(*text, true);
    if (!contour) return fail(line, fmt::format("{}: {}", words_[1], contour.errors()[0].what));
    if (int number = leading_whole(words_[0]); number != 0)
      shapes_.contours[number] = measure(*contour, samples_of_contour(*contour));
  }

  ModelFolder& folder_;
  Shapes& shapes_;
  std::vector<std::string> words_;
};

/// A `.map`: 256 colours of three bytes.
Result<std::vector<Color>> read_color_map(std::string_view bytes) {
  if (bytes.size() < 3 * kColors)
    return error_at("", "found {} bytes; expected a colour map of {}", bytes.size(), 3 * kColors);
  auto part = [&](std::size_t at) { return static_cast<float>(static_cast<unsigned char>(bytes[at])) / 255; };
  std::vector<Color> colors;
  for (std::size_t i = 0; i < kColors; ++i) colors.push_back({part(3 * i), part(3 * i + 1), part(3 * i + 2)});
  return colors;
}

/// A `.mat`: records of 15 bytes. Gives what each reflects and emits.
Result<std::vector<Color>> read_materials(std::string_view bytes) {
  constexpr std::size_t kRecord = 15, kDiffuse = 5, kEmission = 8;
  if (bytes.size() < kRecord)
    return error_at("", "found {} bytes; expected materials of {} each", bytes.size(), kRecord);
  std::vector<Color> colors(kColors, kLeafGreen);
  for (std::size_t record = 0; record + kRecord <= bytes.size(); record += kRecord) {
    auto part = [&](std::size_t at) { return static_cast<unsigned char>(bytes[record + at]); };
    auto sum = [&](std::size_t i) {
      return static_cast<float>(std::min(part(kDiffuse + i) + part(kEmission + i), 255)) / 255;
    };
    colors[part(0)] = {sum(0), sum(1), sum(2)};
  }
  return colors;
}

std::vector<Color> read_colors(ModelFolder& folder, const std::vector<std::filesystem::path>& files,
                               std::optional<Error>& missing) {
  std::vector<Color> colors;
  for (const std::filesystem::path& file : files) {
    bool materials = file.extension() == ".mat";
    std::error_code error;
    Result<std::string> bytes = folder.read(std::filesystem::relative(file, folder.path(), error).string());
    auto read = [&] { return materials ? read_materials(*bytes) : read_color_map(*bytes); };
    Result<std::vector<Color>> some = bytes ? read() : Result<std::vector<Color>>(bytes.errors());
    if (!some) {
      if (!missing) missing = Error{file.string(), some.errors()[0].what};
      continue;
    }
    bool both_maps = !materials && files.front().extension() == ".map";
    if (!both_maps) colors.clear();  // the later kind counts
    colors.insert(colors.end(), some->begin(), some->end());
  }
  if (colors.empty()) colors.assign(kColors, kLeafGreen);
  return colors;
}

}  // namespace

Shapes read_shapes(ModelFolder& folder, const std::vector<CpfgViewLine>& view,
                   const std::vector<std::filesystem::path>& colors) {
  Shapes shapes;
  ShapeReader reader(folder, shapes);
  for (const CpfgViewLine& line : view) reader.read(line);
  shapes.colors = read_colors(folder, colors, shapes.missing);
  return shapes;
}

}  // namespace frond::cpfg

namespace frond {

const std::vector<Color>& colors_of(const CpfgModel& model) { return model.shapes->colors; }

std::map<char, Surface> surfaces_of(const CpfgModel& model) {
  std::map<char, Surface> surfaces;
  for (const auto& [name, surface] : model.shapes->surfaces) surfaces[name] = surface.mesh;
  return surfaces;
}

std::optional<Error> missing_shapes(const CpfgModel& model) { return model.shapes->missing; }

}  // namespace frond
