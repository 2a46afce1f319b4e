#include "emit/solid.h"

#include <gtest/gtest.h>

#include "emit/setting.h"
#include "emit/texts.h"
#include "settings/settings.h"

namespace frond {
namespace {

Scene with_copies(int count) {
  Scene scene;
  scene.setup.setting = row_of("studio");
  Specimen& b = scene.specimens.emplace_back();
  b.name = "pebbles";
  Solid solid;
  solid.surface.position = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 1, 0)};
  solid.surface.triangle = {{0, 1, 2}};
  set_normals(solid.surface);
  std::uint16_t shape = b.model.solids.add_shape(solid);
  for (int i = 0; i < count; ++i) b.model.solids.place(shape, Vec3(static_cast<float>(i), 0, 2));
  return scene;
}

TEST(SolidText, HoldsAShapeOnceAndPlacesItOften) {
  std::string text = solids_text({}, with_copies(3)).text;
  EXPECT_EQ(count(text, "mesh2{"), 1u);
  EXPECT_EQ(count(text, "object{Solid0_0"), 3u);
  EXPECT_EQ(count(text, " texture{Matter_Plain(srgb<"), 3u);
  EXPECT_TRUE(text.find(",20,0,-20>") != text.npos) << text;  // the third: 2 m right, 2 m toward us
}

TEST(SolidText, ManyPlacementsShareOneTexture) {
  std::string text = solids_text({}, with_copies(100)).text;
  EXPECT_EQ(count(text, "object{Solid0_0"), 100u);
  EXPECT_EQ(count(text, "texture{"), 1u);
}

TEST(SolidText, AsksForItsMaterialsAndNothingElse) {
  EXPECT_EQ(includes_text(with_copies(1)), "#include \"frond_studio.inc\"\n#include \"frond_matter.inc\"");
}

TEST(SolidText, PaintsBandsOverTheTexture) {
  Scene scene = with_copies(1);
  Material& material = scene.specimens[0].model.solids.shapes[0].material;
  material.matter = Matter::ceramic;
  material.bands = {{0.5, 0.1, {0, 0, 1}, Motif::meander, 12}, {}};
  std::string text = solids_text({}, scene).text;
  EXPECT_EQ(count(text, "texture{Vessel_Ceramic("), 1u);
  EXPECT_EQ(count(text, "texture{Vessel_Band("), 2u);
  EXPECT_NE(text.find("texture{Vessel_Band(srgb<0,0,1>,0.5,0.1,0.1,4,12)}"), text.npos) << text;
}

TEST(SolidText, GlassHasAnInside) {
  Scene scene = with_copies(1);
  scene.specimens[0].model.solids.shapes[0].material.matter = Matter::glass;
  EXPECT_EQ(count(solids_text({}, scene).text, "interior{Vessel_Glass_Inside("), 1u);
}

TEST(SolidText, TurnedBodiesAreLathes) {
  Scene scene = with_copies(1);
  Solid& solid = scene.specimens[0].model.solids.shapes[0];
  solid.turned = {{{{0, 0}, {0.1, 0}, {0.2, 0.1}, {0.2, 0.3}}}};
  std::string text = solids_text({}, scene).text;
  EXPECT_EQ(count(text, "mesh2{"), 0u);
  EXPECT_NE(text.find("lathe{bezier_spline 4,<0,0>,<1,0>,<2,1>,<2,3> sturm}"), text.npos) << text;
}

TEST(SolidText, WritesAnIsosurfaceInPlaceOfItsTriangles) {
  Scene scene = with_copies(2);
  Solid& solid = scene.specimens[0].model.solids.shapes[0];
  Blobs blobs{{{DVec3(1, 2, 0.5), DVec3(0.25, 0, -1)}, {DVec3(1), DVec3(0)}}, Falloff::cubic, 0.5};
  solid.native = Isosurface{blobs, {DVec3(-1, -2, -3), DVec3(4, 5, 6)}, 7, DVec3(0.5, -2, 1), 0.1};
  std::string text = solids_text({}, scene).text;
  EXPECT_EQ(count(text, "mesh2{"), 0u);
  EXPECT_EQ(count(text, "isosurface{"), 1u);
  EXPECT_EQ(count(text, "object{Solid0_0"), 2u);
  EXPECT_NE(text.find("-F(pow(x/1-(0.25),2)+pow(y/2-(0),2)+pow(-z/0.5-(-1),2),2)"), text.npos) << text;
  EXPECT_NE(text.find("function{0.5\n"), text.npos) << text;
  // Mirrored: z runs from -6 to 3.
  EXPECT_NE(text.find("box{<-1,-2,-6>,<4,5,3>}} max_gradient 7"), text.npos) << text;
  EXPECT_NE(text.find("translate<-0.5,2,1> scale 1}"), text.npos) << text;
}

}  // namespace
}  // namespace frond
