#include "emit/pov.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "shapes.h"

namespace frond {
namespace {

std::string sweep_of(const Skeleton& s, const Pose& pose) {
  std::string text;
  ChunkOptions whole;
  whole.young_length = 0;
  for (const Chunk& chunk : cut_chunks(s, pose, whole)) append_sweep(text, {}, s, pose, chunk);
  return text;
}

TEST(Point, IsMirroredAndScaled) {
  std::string text;
  append_point(text, {10}, Vec3(1, 2, 3));
  append_direction(text, Vec3(0, 0, 1));
  EXPECT_EQ(text, "<10,20,-30><0,0,-1>");
}

TEST(Matrix, DoesInPovSpaceWhatItDoesInTheWorld) {
  // A quarter turn about x: y goes to z. Mirrored: y goes to -z.
  glm::mat3 turn = glm::mat3_cast(glm::angleAxis(radians(90.0f), Vec3(1, 0, 0)));
  std::string text;
  EXPECT_TRUE(append_matrix(text, {10}, turn, Vec3(0, 1, 2)));
  EXPECT_EQ(text, "matrix<1,0,0,0,0,-1,0,1,0,0,10,-20>");
}

TEST(Matrix, IsNotWrittenWherePovRayWouldFindItSingular) {
  glm::mat3 leaning = glm::mat3_cast(glm::angleAxis(0.7f, glm::normalize(Vec3(1, 2, 3))));
  glm::mat3 flat(Vec3(1, 0, 1), Vec3(0, 1, 0), Vec3(2, 0, 2));
  for (const glm::mat3& m : {glm::mat3(0), leaning * 1e-10f, flat, 1e4f * flat, leaning * std::nanf("")}) {
    std::string text = "object{";
    EXPECT_FALSE(append_matrix(text, {10}, m, Vec3(1)));
    EXPECT_EQ(text, "object{");
  }
  std::string text;
  EXPECT_TRUE(append_matrix(text, {10}, glm::mat3(2e4f), Vec3(0)));
  EXPECT_TRUE(append_matrix(text, {10}, glm::mat3(2e-5f), Vec3(0)));
  EXPECT_TRUE(append_matrix(text, {10}, glm::mat3(2e-6f), Vec3(0))) << "with more decimals";
  EXPECT_EQ(text,
            "matrix<20000,0,0,0,20000,0,0,0,20000,0,0,0>matrix<0.00002,0,0,0,0.00002,0,0,0,0.00002,0,0,0>"
            "matrix<0.000002,0,0,0,0.000002,0,0,0,0.000002,0,0,0>");
}

TEST(Comment, StaysOneLine) {
  std::string text;
  append_comment(text, "a\n#declare x=1;\r b");
  EXPECT_EQ(text, "// a #declare x=1;  b\n");
}

TEST(SpaceFor, KeepsThinBranchesThickEnough) {
  EXPECT_EQ(space_for(0.01).unit, 10);
  EXPECT_EQ(space_for(0.00015).unit, 100);
  EXPECT_EQ(space_for(1e-9).unit, 1000);
}

TEST(Numbers, AreAsLongAsAPixelAsks) {
  EXPECT_EQ(decimals_for({10}, 0), kDecimals);
  EXPECT_EQ(decimals_for({10}, 1e-6), kDecimals);
  EXPECT_EQ(decimals_for({10}, 0.02), 2) << "a twentieth of a pixel is 0.01 units";
  EXPECT_EQ(matrix_text_for({10}, 0.1, 0.02).decimals, 2);
  EXPECT_EQ(matrix_text_for({10}, 0.1, 0).decimals, 5);
  std::string text;
  EXPECT_TRUE(append_matrix(text, {10}, glm::mat3(0.123456f), Vec3(0.123456f), {2, 1}));
  EXPECT_EQ(text, "matrix<0.12,0,0,0,0.12,0,0,0,0.12,1.2,1.2,-1.2>");
  text.clear();
  EXPECT_TRUE(append_matrix(text, {10}, glm::mat3(0.001f), Vec3(0), {2, 1}));
  EXPECT_EQ(text, "matrix<0.001,0,0,0,0.001,0,0,0,0.001,0,0,0>") << "too small for two decimals";
}

TEST(Sweep, LeavesOutPointsOnALine) {
  Skeleton s = trunk(9);
  Pose pose{s.position, s.radius, {}};
  pose.turn.assign(s.size(), Quat(1, 0, 0, 0));
  pose.front = 2;
  Chunk all{1, 8};
  std::string text;
  EXPECT_TRUE(append_sweep(text, {10}, s, pose, all, 0.001, 1));
  EXPECT_EQ(text, "sphere_sweep{linear_spline 2,<0,0,0>,0.5,<0,10,0>,0.5");
  pose.position[4].x += 0.1f;
  text.clear();
  EXPECT_TRUE(append_sweep(text, {10}, s, pose, all, 0.001, 1));
  EXPECT_NE(text.find("<1,5,0>"), text.npos) << text;
}

TEST(Sweep, IsWritten) {
  Skeleton s = trunk(3);
  Pose pose;
  pose_skeleton(s, Motion{}, 0, pose);
  EXPECT_EQ(sweep_of(s, pose), "sphere_sweep{linear_spline 3,<0,0,0>,0.5,<0,5,0>,0.5,<0,10,0>,0.5");
}

TEST(Sweep, OfAPointIsNotWritten) {
  Skeleton s;
  s.add(Vec3(0), 0.1f, Skeleton::kRoot, 0);
  s.add(Vec3(0), 0.1f, 0, 0);
  Pose pose;
  pose_skeleton(s, Motion{}, 0, pose);
  EXPECT_EQ(sweep_of(s, pose), "");
}

TEST(Sweep, NeverHoldsASphereInAnother) {
  Skeleton s = trunk(4);
  s.radius = {0.5f, 0.01f, 0.4f, 0.4f};
  Pose pose;
  pose_skeleton(s, Motion{}, 0, pose);
  std::string text = sweep_of(s, pose);
  EXPECT_NE(text.find("<0,0,0>,5,<0,3.3333,0>,2,"), text.npos) << text;
}

TEST(Mesh, LeavesOutTrianglesThatArePoints) {
  Surface surface;
  surface.position = {Vec3(0), Vec3(1, 0, 0), Vec3(0, 0, -1), Vec3(0, 0, -1)};
  surface.triangle = {{0, 1, 2}, {0, 2, 3}};
  set_normals(surface);
  std::string text;
  append_mesh(text, {1}, surface);
  EXPECT_NE(text.find("face_indices{1"), text.npos);
  EXPECT_NE(text.find("<0,2,1>"), text.npos);
}

}  // namespace
}  // namespace frond
