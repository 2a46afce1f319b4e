#include "bake/bake.h"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "bake/photometry.h"
#include "core/files.h"
#include "core/linear.h"
#include "core/parallel.h"
#include "emit/branch_materials.h"
#include "emit/solid.h"
#include "traced_scene.h"

namespace frond {
namespace {

namespace fs = std::filesystem;

constexpr int kPixels = 48;
const BakeOptions kHere{.home = FROND_ROOT};

struct Sample {
  std::string name;
  Swatch swatch;
};

/// Every matter and skin that has a pattern; of matter, a piece as wide as exports draw.
std::vector<Sample> samples() {
  std::vector<Sample> made;
  auto add = [&](std::string name, std::string_view include, std::string before, std::string texture,
                 double wide) {
    Swatch swatch;
    swatch.includes = {include};
    swatch.before = std::move(before), swatch.texture = std::move(texture);
    swatch.pixels = {kPixels, kPixels}, swatch.wide = wide, swatch.corner = {0.3f, 1.07f, 0.21f};
    made.push_back({std::move(name), std::move(swatch)});
  };
  for (Matter matter :
       {Matter::brick, Matter::mortar, Matter::limestone, Matter::plaster, Matter::paint, Matter::timber,
        Matter::ashlar, Matter::bed, Matter::ceramic, Matter::terracotta, Matter::soil, Matter::granite,
        Matter::karst, Matter::basalt, Matter::polyps, Matter::meander, Matter::sponge, Matter::reef}) {
    Material material{.matter = matter, .moss = 0.3};
    add(fmt::format("matter {}", static_cast<int>(matter)), material_include(material), "",
        material_text(material), row_of(matter).widths * material.scale);
  }
  auto add_branches = [&](const char* name, const BranchLook& look, double wide) {
    std::string before = "#declare Skin=array[1];#declare Skin_Pigment=array[1][2];";
    append_skin_declarations(before, look, 1, 0, false, "");
    add(name, include_of(look), before, "texture{Skin[0]}", wide);
  };
  for (SkinKind kind : {SkinKind::stony, SkinKind::fan, SkinKind::soft}) {
    Skin skin;
    skin.kind = kind;
    add_branches("skin", {.skin = skin}, 0.1);
  }
  for (BarkKind kind : {BarkKind::bark, BarkKind::birch, BarkKind::palm}) {
    Bark bark;
    bark.kind = kind;
    add_branches("bark", {.bark = bark}, 0.3);
  }
  return made;
}

/// A square of a material as a film would show it, seen from the front in this light.
std::string scene_of(const Swatch& swatch, const std::string& light) {
  std::string includes;
  for (std::string_view name : swatch.includes) includes += fmt::format("#include \"frond_{}.inc\"\n", name);
  double unit = 10, x = swatch.corner.x * unit, y = swatch.corner.y * unit, z = swatch.corner.z * unit,
         wide = swatch.wide * unit;
  return fmt::format(
      "#version 3.7;\nglobal_settings{{assumed_gamma 1 max_trace_level 1}}\n#declare "
      "Frond_Unit=10;\n{}\n{}{}\n"
      "camera{{orthographic location<{},{},{}> direction z right x*{} up y*{}}}\n"
      "mesh2{{vertex_vectors{{3,<{},{},{}>,<{},{},{}>,<{},{},{}>}} uv_vectors{{3,<1,0>,<1,0>,<1,0>}} "
      "face_indices{{1,<0,1,2>}} uv_indices{{1,<0,1,2>}} {}}}\n",
      light, includes, swatch.before, x + wide / 2, y + wide / 2, z - 5, wide, wide, x - 9 * wide,
      y - 9 * wide, z, x + 9 * wide, y - 9 * wide, z, x, y + 19 * wide, z, swatch.texture);
}

double light_at(const LinearRaster& raster, std::size_t i) { return raster.data[i] / 65535.0; }

/// The mean difference of a picture's colours, of 255, from what POV-Ray shows where it is not blended.
double difference_from(const LinearRaster& own, const Raster& colors) {
  double sum = 0;
  int count = 0;
  for (int y = kPixels / 8; y < kPixels * 7 / 8; ++y)
    for (int x = kPixels / 8; x < kPixels * 7 / 8; ++x)
      for (int c = 0; c < 3; ++c, ++count)
        sum += std::abs(colors.at(x, y, c) - to_byte(encoded(light_at(own, colors.index(x, y, c)))));
  return sum / count;
}

/// How much more it changes over its edges than from one of its columns or rows to the next.
double unevenness_of_edges(const Raster& colors) {
  auto change = [&](int from, int to) {
    double sum = 0;
    for (int i = 0; i < kPixels; ++i)
      for (int c = 0; c < 3; ++c)
        sum += std::abs(colors.at(from, i, c) - colors.at(to, i, c)) +
               std::abs(colors.at(i, from, c) - colors.at(i, to, c));
    return sum / kPixels;
  };
  double within = 0;
  for (int k = 1; k < kPixels; ++k) within += change(k - 1, k) / (kPixels - 1);
  return change(kPixels - 1, 0) / (within + 3);
}

TEST(Bake, shows_what_the_macro_does_in_even_light_and_goes_on_over_its_edges) {
  std::vector<Sample> all = samples();
  std::vector<Result<BakedPictures>> baked(all.size(), BakedPictures{});
  std::vector<LinearRaster> own(all.size());
  parallel_for(all.size(), [&](std::size_t i) {
    all[i].swatch.relief = false;
    baked[i] = bake(all[i].swatch, 0.5, kHere);
    own[i] = traced_scene(scene_of(all[i].swatch, "#declare Frond_Ambient=1;"), {kPixels, kPixels});
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    ASSERT_TRUE(baked[i]) << all[i].name << baked[i].errors()[0].text();
    Raster colors = *read_png(baked[i]->colors);
    ASSERT_EQ(colors.width, kPixels) << all[i].name;
    EXPECT_LT(difference_from(own[i], colors), 4) << all[i].name;
    EXPECT_LT(unevenness_of_edges(colors), 2.5) << all[i].name;
  }
}

TEST(Bake, normals_light_as_the_relief_itself_does) {
  // From where none of the lamps stands that it was drawn by.
  Vec3 towards = glm::normalize(Vec3(-0.4f, 0.1f, 0.8f));
  Swatch swatch;
  swatch.repeats = false;
  swatch.texture =
      "texture{pigment{checker rgb<.9,.2,.1> rgb<.3,.5,.8> scale .8} normal{bumps .8 scale .6} "
      "finish{ambient "
      "Frond_Ambient diffuse .8}}";
  swatch.pixels = {kPixels, kPixels}, swatch.wide = 0.6, swatch.corner = {0.3f, 1.07f, 0.21f};
  Result<BakedPictures> baked = bake(swatch, 0.5, kHere);
  ASSERT_TRUE(baked);
  Raster colors = *read_png(baked->colors), normals = *read_png(baked->normals);
  ASSERT_EQ(normals.width, kPixels / 2);
  Vec3 at = 1e6f * towards;
  LinearRaster lit =
      traced_scene(scene_of(swatch, fmt::format("#declare Frond_Ambient=0; light_source{{<{},{},{}> rgb 1 "
                                                "parallel point_at 0 shadowless}}",
                                                at.x, at.y, -at.z)),
                   {kPixels, kPixels});
  double difference = 0, steepest = 1;
  for (int y = 0; y < kPixels / 2; ++y)
    for (int x = 0; x < kPixels / 2; ++x) {
      Vec3 n;
      for (int c = 0; c < 3; ++c) n[c] = static_cast<float>(normals.at(x, y, c)) / 127.5f - 1;
      steepest = std::min(steepest, static_cast<double>(n.z));
      std::size_t i = colors.index(2 * x, 2 * y, 1);
      double drawn = 0.8 * linear(colors.at(2 * x, 2 * y, 1) / 255.0) * std::max(0.0f, glm::dot(n, towards));
      difference += std::abs(255 * encoded(drawn) - 255 * encoded(light_at(lit, i)));
    }
  EXPECT_LT(difference / (kPixels * kPixels / 4), 4);
  EXPECT_LT(steepest, 0.95);  // there is a relief
}

TEST(Bake, what_is_even_has_even_normals_and_is_as_rough_as_it_says) {
  Swatch swatch;
  swatch.texture = "texture{pigment{granite scale 2} finish{ambient Frond_Ambient diffuse .7}}";
  swatch.pixels = {32, 32};
  Result<BakedPictures> baked = bake(swatch, 0.5, kHere);
  ASSERT_TRUE(baked);
  Raster normals = *read_png(baked->normals), roughness = *read_png(baked->roughness);
  for (std::size_t i = 0; i < normals.data.size(); i += 3) {
    EXPECT_NEAR(normals.data[i], 127, 2);
    EXPECT_NEAR(normals.data[i + 2], 255, 1);
  }
  for (std::size_t i = 1; i < roughness.data.size(); i += 3) EXPECT_NEAR(roughness.data[i], 127, 12);
}

TEST(Bake, is_kept_by_what_it_is_made_of) {
  fs::path folder = fs::temp_directory_path() / fmt::format("frond_bake_cache_{}", getpid());
  BakeOptions kept{.home = FROND_ROOT, .cache = folder};
  Swatch swatch;
  swatch.texture = "texture{pigment{granite} finish{ambient Frond_Ambient}}";
  swatch.pixels = {16, 16};
  Result<BakedPictures> first = bake(swatch, 0.5, kept);
  ASSERT_TRUE(first);
  EXPECT_EQ(files_in(folder).size(), 3u);
  kept.povray = "/no/such/program";
  Result<BakedPictures> again = bake(swatch, 0.5, kept);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->colors, first->colors);
  EXPECT_EQ(again->roughness, first->roughness);
  EXPECT_EQ(again->mean->red, first->mean->red);
  swatch.wide = 2;
  Result<BakedPictures> other = bake(swatch, 0.5, kept);
  ASSERT_FALSE(other);
  EXPECT_NE(other.errors()[0].what.find("no such program"), std::string::npos);
  fs::remove_all(folder);
}

TEST(Bake, unrolls_a_body_as_its_places_say) {
  // A square whose left half is red and whose right half is green, laid on the picture the other way round.
  Swatch swatch;
  swatch.body.position = {{-1, 0, 0}, {1, 0, 0}, {1, 1, 0}, {-1, 1, 0}};
  swatch.body.normal.assign(4, Vec3(0, 0, 1));
  swatch.body.uv = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  swatch.body.triangle = {{0, 1, 2}, {0, 2, 3}};
  swatch.place = {{1, 0}, {0, 0}, {0, 1}, {1, 1}};
  swatch.texture =
      "texture{pigment{gradient x color_map{[.5 rgb x][.5 rgb y]} scale 40 translate -20*x} "
      "finish{ambient Frond_Ambient}}";
  swatch.pixels = {32, 16};
  Result<BakedPictures> baked = bake(swatch, 0.5, kHere);
  ASSERT_TRUE(baked) << baked.errors()[0].text();
  EXPECT_TRUE(baked->normals.empty());
  Raster colors = *read_png(baked->colors);
  EXPECT_GT(colors.at(8, 8, 1), 250);
  EXPECT_LT(colors.at(8, 8, 0), 5);
  EXPECT_GT(colors.at(24, 8, 0), 250);
}

}  // namespace
}  // namespace frond
