#include "bake/bake.h"

#include <fmt/format.h>

#include <algorithm>

#include "bake/photometry.h"
#include "core/content.h"
#include "core/files.h"
#include "core/linear.h"
#include "core/text.h"
#include "core/work_folder.h"
#include "emit/pov.h"
#include "emit/solid.h"
#include "render/process.h"

namespace frond {

namespace fs = std::filesystem;

namespace {

constexpr double kLevel = 0.35;  // of ambient light and lamps: what is brighter than white is not cut off
constexpr int kBlend = 16;       // half a picture's size by the width of the edge that is blended
constexpr std::uintmax_t kMostKept = 300'000'000;  // bytes
constexpr const char* kKinds[] = {"normal", "roughness", "color"};

const PovSpace kSpace;

/// How many pixels are drawn for so many that are wanted.
int larger(const Swatch& swatch, int pixels) {
  return swatch.repeats ? pixels + 2 * std::max(1, pixels / 2 / kBlend) : pixels;
}

/// A square of one unit with the texture coordinates of a swatch.
std::string square_text(const Swatch& swatch) {
  std::string at;
  for (Vec2 corner : {Vec2(0, 0), Vec2(1, 0), Vec2(1, 1), Vec2(0, 1)}) {
    Vec2 uv = swatch.spread ? corner : swatch.uv;
    at += ",<";
    append_list(at, 5, uv.x, uv.y);
    at += '>';
  }
  return "mesh2{vertex_vectors{4,<0,0,0>,<1,0,0>,<1,1,0>,<0,1,0>} uv_vectors{4" + at +
         "} face_indices{2,<0,1,2>,<0,2,3>} uv_indices{2,<0,1,2>,<0,2,3>}}";
}

/// Copies of the flat piece: in ambient light, of the whole size; on its right, where there is a relief, four
/// of half that, three of which are lit. The scene's units are pixels.
std::string flat_text(const Swatch& swatch) {
  int wide = larger(swatch, swatch.pixels[0]), high = larger(swatch, swatch.pixels[1]);
  double unit = kSpace.unit,
         each = swatch.wide * unit / swatch.pixels[0];  // POV units in the texture, a pixel
  Vec3 corner = static_cast<float>(unit) * swatch.corner;
  corner.y -= static_cast<float>(each * (high - swatch.pixels[1]));  // what is blended in comes from below
  std::string text = fmt::format(
      "camera{{orthographic location<{},{},-1000> direction z right x*{} up y*{}}}\n#declare Square={}\n"
      "#macro Piece(X,Y,Part) object{{Square scale<{:.9g},{:.9g},1> translate<{:.6g},{:.6g},{:.6g}> {} "
      "translate<{:.6g},{:.6g},{:.6g}> scale Part/{:.9g} translate<X,Y,0>}} #end\nPiece(0,0,1)\n",
      swatch.relief ? wide : wide / 2.0, high / 2.0, swatch.relief ? 2 * wide : wide, high,
      square_text(swatch), each * wide, each * high, corner.x, corner.y, corner.z, swatch.texture, -corner.x,
      -corner.y, -corner.z, each);
  if (!swatch.relief) return text;
  text += fmt::format("Piece({},0,.5)\n", wide);
  std::array<Vec3, 3> towards = lamps();
  for (int k = 0; k < 3; ++k) {
    Vec3 at = 1e6f * towards[static_cast<std::size_t>(k)];
    text += fmt::format(
        "light_group{{light_source{{<{:.1f},{:.1f},{:.1f}> rgb {} parallel point_at 0 shadowless}} "
        "Piece({},{},.5)}}\n",
        at.x, at.y, -at.z, kLevel, wide + (k == 1 ? 0 : wide / 2), k == 0 ? 0 : high / 2);
  }
  return text;
}

/// A body as its picture unrolls it: a camera looks at each place from just above it.
std::string body_text(const Swatch& swatch) {
  Surface unrolled = swatch.body;
  if (!swatch.place.empty()) unrolled.uv = swatch.place;
  std::string text = "#declare Unrolled=";
  append_mesh(text, kSpace, unrolled);
  text += "\ncamera{mesh_camera{1 3 mesh{Unrolled}} location<0,0,.001> direction<0,0,-1>}\nobject{";
  append_mesh(text, kSpace, swatch.body);
  return text + swatch.texture + "}\n";
}

/// What POV-Ray makes of a scene.
Result<LinearRaster> drawn(const SmallScene& scene, const BakeOptions& options) {
  auto failed = [&](const std::string& why) {
    return Error{options.povray, "no material could be drawn: " + why};
  };
  std::optional<fs::path> program = find_program(options.povray);
  if (!program) return failed("no such program; without pictures: --texture 0");
  if (options.home.empty())
    return failed("the folder of Frond is not known, set FROND_HOME to it; without pictures: --texture 0");
  WorkFolder folder;
  if (auto error = write_new(folder.path() / "swatch.pov", scene.text)) return failed(reason_of(error));
  for (const auto& [name, bytes] : scene.files)
    if (auto error = write_new(folder.path() / name, bytes)) return failed(reason_of(error));
  // POV-Ray parses its options by itself and stumbles over quotes in a path.
  std::error_code error;
  fs::create_directory_symlink(fs::absolute(options.home) / "povinc", folder.path() / "povinc", error);
  OutputCapture said;
  Command command;
  command.folder = folder.path();
  command.out = command.err = said.descriptor();
  command.environment = {"POVINI=" + (fs::absolute(options.home) / "scripts/povray.ini").string()};
  command.words = {program->string(), "+Iswatch.pov", "+Oswatch.png", "+FN16", "File_Gamma=1.0", "-D"};
  command.add({scene.smooth ? "+A0.1" : "-A", "+WT1", fmt::format("+W{}", scene.pixels[0]),
               fmt::format("+H{}", scene.pixels[1]), "+Lpovinc"});
  if (scene.rows > 0) command.add({fmt::format("+ER{}", scene.rows)});
  Result<int> status = run(command);
  if (!status) return failed(status.errors()[0].text());
  Result<std::string> bytes = read_file(folder.path() / "swatch.png");
  std::string words = said.text();
  if (*status != 0 || !bytes)
    return failed(words.substr(words.size() - std::min<std::size_t>(words.size(), 600)));
  return read_linear_png(*bytes);
}

/// The mean of a picture's colours.
Color mean_color(const Raster& colors) {
  Vec3 sum(0);
  std::size_t channels = static_cast<std::size_t>(colors.channels), count = colors.data.size() / channels;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint8_t* pixel = &colors.data[channels * i];
    sum += linear(Color{pixel[0] / 255.0f, pixel[1] / 255.0f, pixel[2] / 255.0f});
  }
  sum /= static_cast<float>(std::max<std::size_t>(count, 1));
  return srgb(sum);
}

Result<BakedPictures> render(const Swatch& swatch, double rough, const std::string& scene,
                             const BakeOptions& options) {
  auto [columns, rows] = swatch.pixels;
  bool flat = swatch.body.triangle.empty(), relief = flat && swatch.relief;
  int wide = flat ? larger(swatch, columns) : columns, high = flat ? larger(swatch, rows) : rows;
  Result<LinearRaster> raster = drawn({scene, {relief ? 2 * wide : wide, high}, false}, options);
  if (!raster) return raster.errors();
  auto fitted = [&](VecGrid part, int share) {
    return flat && swatch.repeats ? seamless(part, columns / share, rows / share) : part;
  };
  VecGrid light = fitted(part_of(*raster, kLevel, 0, 0, wide, high), 1);
  if (!flat) fill_black(light);
  for (Vec3& v : light.data) v *= swatch.light;
  Raster colors = color_raster(light), normals;
  if (relief) {
    auto quarter = [&](int right, int down) {
      return part_of(*raster, kLevel, wide + right * wide / 2, down * high / 2, wide / 2, high / 2);
    };
    normals =
        normal_raster(fitted(normals_of(quarter(0, 1), {quarter(1, 1), quarter(0, 0), quarter(1, 0)}), 2));
  }
  Result<BakedPictures> made = picture_files(colors, normals, rough);
  if (made) made->mean = mean_color(colors);
  return made;
}

/// Removes what was made longest ago until so little is left.
void trim(const fs::path& folder) {
  std::error_code error;
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::uintmax_t bytes = 0;
  for (const fs::path& file : files_in(folder)) {
    files.emplace_back(fs::last_write_time(file, error), file);
    bytes += fs::file_size(file, error);
  }
  std::sort(files.begin(), files.end());
  for (std::size_t i = 0; i < files.size() && bytes > kMostKept; ++i) {
    bytes -= std::min(bytes, fs::file_size(files[i].second, error));
    fs::remove(files[i].second, error);
  }
}

}  // namespace

Result<BakedPictures> picture_files(const Raster& colors, const Raster& normals, double rough) {
  Raster roughness = normals.data.empty() ? Raster() : roughness_of(normals, rough);
  BakedPictures made;
  for (auto [raster, file] : {std::pair(&colors, &made.colors),
                              {&normals, &made.normals},
                              {static_cast<const Raster*>(&roughness), &made.roughness}}) {
    if (raster->data.empty()) continue;
    Result<std::string> text = png_text(*raster);
    if (!text) return text.errors();
    *file = std::move(*text);
  }
  return made;
}

Swatch body_swatch(const Material& material, int pixels) {
  constexpr float kAboveGround = 1.07f;  // metres: where walls are drawn, as what is below is damp
  Swatch swatch;
  swatch.includes = {material_include(material)};
  Material alive = material;  // what has died of it lies in places of one body
  alive.dead.clear();
  swatch.texture = material_text(alive);
  swatch.pixels = {pixels, pixels};
  swatch.wide = row_of(material.matter).widths * material.scale;
  auto half = static_cast<float>(swatch.wide / 2);
  // Off the planes where noise is even; wood's rings go round the x axis.
  bool wood = material.matter == Matter::timber;
  swatch.corner = {-half, wood ? -half : kAboveGround, wood ? 0.02f : 0.137f * half};
  if (material.matter == Matter::meander) swatch.uv = {1, 1};  // on a ridge, in full light
  return swatch;
}

Result<std::string> small_picture(const SmallScene& scene, const BakeOptions& options) {
  Result<LinearRaster> raster = drawn(scene, options);
  if (!raster) return raster.errors();
  VecGrid light = part_of(*raster, 1, 0, 0, scene.pixels[0], scene.rows > 0 ? scene.rows : scene.pixels[1]);
  return png_text(color_raster(light));
}

std::string swatch_scene(const Swatch& swatch) {
  std::string text = fmt::format(
      "#version 3.7;\nglobal_settings{{assumed_gamma 1 max_trace_level 1 ambient_light rgb {}}}\n"
      "#declare Frond_Unit={};\n#declare Frond_Ambient=1;\n",
      kLevel, kSpace.unit);
  for (std::string_view name : swatch.includes) text += fmt::format("#include \"frond_{}.inc\"\n", name);
  text += swatch.before + '\n';
  return text + (swatch.body.triangle.empty() ? flat_text(swatch) : body_text(swatch));
}

Result<BakedPictures> bake(const Swatch& swatch, double rough, const BakeOptions& options) {
  std::string scene = swatch_scene(swatch);
  if (options.cache.empty()) return render(swatch, rough, scene, options);
  std::string all = fmt::format("{} {} {} {} {} {} {} ", swatch.pixels[0], swatch.pixels[1], swatch.light.x,
                                swatch.light.y, swatch.light.z, swatch.repeats, rough) +
                    scene;
  for (const fs::path& file : files_in(options.home / "povinc"))
    if (Result<std::string> bytes = read_file(file)) all += content_id(*bytes);
  BakedPictures made;
  std::string* const texts[] = {&made.normals, &made.roughness, &made.colors};
  auto path = [&, id = made_id(all)](std::size_t k) {
    return options.cache / fmt::format("{}_{}.png", id, kKinds[k]);
  };
  bool kept = true;
  for (std::size_t k = 0; k < 3; ++k) {
    Result<std::string> bytes = read_file(path(k));
    if (kept = kept && bytes; kept) *texts[k] = std::move(*bytes);
  }
  if (kept)
    if (Result<Raster> colors = read_png(made.colors)) return made.mean = mean_color(*colors), made;
  Result<BakedPictures> fresh = render(swatch, rough, scene, options);
  if (!fresh) return fresh;
  made = *fresh;
  // The colours, which stand for all, come last. Where there is no room for it nothing is kept.
  for (std::size_t k = 0; k < 3; ++k)
    if (!write_file(path(k), *texts[k])) break;
  trim(options.cache);
  return made;
}

}  // namespace frond
