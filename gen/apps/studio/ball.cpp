#include <fmt/format.h>

#include "emit/pov.h"
#include "export/materials.h"
#include "organisms/grower.h"
#include "studio/scenes.h"

namespace frond {

namespace {

constexpr int kBallPixels = 160;
constexpr int kCoatPixels = 384;

/// A coat is a picture, which is wound round the ball twice, as high as its aspect asks for.
Result<Swatch> coat_swatch(const BarkCoat& coat, SmallScene& scene) {
  Result<BakedPictures> pictures = coat_pictures(coat, kCoatPixels);
  if (!pictures) return pictures.errors();
  scene.files = {{"coat.png", pictures->colors}};
  Swatch swatch;
  swatch.texture = fmt::format(
      "texture{{uv_mapping pigment{{image_map{{png \"coat.png\" interpolate 2}} scale<.5,{0},1>}} "
      "normal{{bump_map{{png \"coat.png\" bump_size {1} interpolate 2}} scale<.5,{0},1>}} "
      "finish{{ambient 0 diffuse .8}}}}",
      coat.aspect / 2, 4 * coat.relief);
  return swatch;
}

Result<Swatch> swatch_of(const Organism& organism, SmallScene& scene) {
  BranchLook branches = organism.grower->appearance().look.branches;
  if (branches.coat) return coat_swatch(*branches.coat, scene);
  if (branches.patterned()) return skin_swatch(branches, 0, kBallPixels);
  Result<Model> grown = organism.grower->grow_copy(organism, Seed{1});
  if (!grown) return grown.errors();
  const std::vector<Solid>& bodies = grown->solids.shapes;
  if (bodies.empty() || row_of(bodies[0].material.matter).widths <= 0)
    return Error{organism.name, "is of no material of its own"};
  return body_swatch(bodies[0].material, kBallPixels);
}

/// On a grey floor: a large lamp on the left, and light from all around.
std::string ball_text(const Swatch& swatch, const PovSpace& space) {
  double radius = swatch.wide * space.unit / 2;
  Vec3 at = static_cast<float>(space.unit) * swatch.corner;
  at.x += static_cast<float>(radius);
  std::string text = fmt::format(
      "#version 3.7;\nglobal_settings{{assumed_gamma 1 max_trace_level 3}}\n#declare Frond_Unit={};\n",
      space.unit);
  for (std::string_view name : swatch.includes) text += fmt::format("#include \"frond_{}.inc\"\n", name);
  return text + swatch.before +
         fmt::format(
             "\n#declare At=<{:.6g},{:.6g},{:.6g}>;\n#declare R={:.6g};\n"
             "camera{{location At+R*<0,.9,-6.2> right x up y angle 24 look_at At}}\nbackground{{rgb .6}}\n"
             "#macro Lamp(Way,Light)light_source{{At+100*R*Way rgb Light parallel point_at At #end\n"
             "Lamp(<-.9,1.1,-1.2>,<1.25,1.2,1.15>)area_light x*30*R z*30*R 3 3 jitter}}\n"
             "Lamp(<.8,.3,-.9>,<.25,.27,.31>)shadowless}}\nLamp(<0,-.9,-.4>,<.13,.11,.1>)shadowless}}\n"
             "plane{{y,At.y-R pigment{{rgb .5}} finish{{ambient 0 diffuse .7}}}}\nsphere{{At,R {}}}\n",
             at.x, at.y, -at.z, radius, swatch.texture);
}

/// What an organism is made of, on a ball, as a PNG: the bark or skin of its branches, or the material of its
/// first body, which is grown for this. An error where it has neither, or POV-Ray fails.
Result<std::string> material_ball(const Organism& organism, const BakeOptions& options) {
  SmallScene scene;
  scene.pixels = {kBallPixels, kBallPixels};
  Result<Swatch> swatch = swatch_of(organism, scene);
  if (!swatch) return swatch.errors();
  scene.text = ball_text(*swatch, {});
  return small_picture(scene, options);
}

}  // namespace

Result<std::string> Scenes::ball(const Doc& doc, std::size_t entry) const {
  Result<Preset> preset = documents_.preset(doc);
  if (!preset) return preset.errors();
  if (entry >= preset->organisms.size()) return Error{"entry", "there is no such organism"};
  return material_ball(preset->organisms[entry], bake_);
}

}  // namespace frond
