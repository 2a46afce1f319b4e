#include "world/obstacles.h"

#include <dlfcn.h>
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include "solids.h"

namespace {

enum class Lack { nothing, device, memory };
Lack lack = Lack::nothing;

template <class Function>
Function* of_embree(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

// These stand before Embree's own, which they call unless they are to fail.
RTC_API RTCDevice rtcNewDevice(const char* config) {
  return lack == Lack::device ? nullptr : of_embree<RTCDevice(const char*)>("rtcNewDevice")(config);
}
RTC_API RTCError rtcGetDeviceError(RTCDevice device) {
  if (lack == Lack::memory) return RTC_ERROR_OUT_OF_MEMORY;
  return of_embree<RTCError(RTCDevice)>("rtcGetDeviceError")(device);
}

namespace frond {
namespace {

/// A wall before which limbs grow toward -z, its face at z = 0.
Obstacles wall() {
  Surface body = box(Vec3(-2, 0, -0.3f), Vec3(2, 2, 0));
  return *Obstacles::build({&body, 1});
}

TEST(Obstacles, BodiesWithoutAnAreaAreNone) {
  Surface line;
  line.position = {Vec3(0), Vec3(1, 0, 0), Vec3(2, 0, 0)};
  line.triangle = {{0, 1, 2}};
  Result<Obstacles> none = Obstacles::build({&line, 1});
  ASSERT_TRUE(none) << "it is no fault that one can do anything about";
  EXPECT_EQ(none->way(Vec3(0, -1, 0), Vec3(0, 1, 0), 1), Vec3(0, 1, 0));
  EXPECT_TRUE(Obstacles::build({}));
}

TEST(Obstacles, TellWhereEmbreeFails) {
  Surface body = box(Vec3(-1), Vec3(1));
  for (Lack what : {Lack::device, Lack::memory}) {
    lack = what;
    Result<Obstacles> none = Obstacles::build({&body, 1});
    lack = Lack::nothing;
    ASSERT_FALSE(none) << "limbs would grow through what stands there";
    EXPECT_EQ(none.errors()[0].text(),
              "the bodies that branches bend round: Embree could not build its tree");
  }
  EXPECT_TRUE(Obstacles::build({&body, 1})) << "it is over";
}

TEST(Obstacles, LeaveAloneWhatIsFarFromThem) {
  Vec3 to(0.1f, 1.1f, 0.3f);
  EXPECT_EQ(wall().way(Vec3(0, 1, 0.4f), to, 0.1f), to);
  EXPECT_EQ(Obstacles().way(Vec3(0), to, 1), to);
  EXPECT_FALSE(wall().near({Vec3(3, 0, 0), Vec3(4, 1, 1)}));
  EXPECT_TRUE(wall().near({Vec3(1, 1, -1), Vec3(4, 1, 1)}));
}

TEST(Obstacles, BendLimbsAlongTheirSurfaceAsLongAsTheyWere) {
  Vec3 from(0, 1, 0.1f), to(0.2f, 1, -0.1f);
  std::optional<Vec3> way = wall().way(from, to, 0.05f);
  ASSERT_TRUE(way);
  EXPECT_NEAR(glm::distance(from, *way), glm::distance(from, to), 1e-4);
  EXPECT_GE(way->z, 0.05f - 1e-4f);
  EXPECT_GT(way->x, 0.2f) << "the way that it went";
}

TEST(Obstacles, TurnUpwardWhatMeetsThemHeadOn) {
  std::optional<Vec3> way = wall().way(Vec3(0, 1, 0.1f), Vec3(0, 1, -0.2f), 0.05f);
  ASSERT_TRUE(way);
  EXPECT_GT(way->y, 1.2f);
}

TEST(Obstacles, HoldWhatGrowsUpUnderARoof) {
  Surface roof = box(Vec3(-2, 1, -2), Vec3(2, 1.2f, 2));
  EXPECT_FALSE(Obstacles::build({&roof, 1})->way(Vec3(0, 0.9f, 0), Vec3(0, 1.3f, 0), 0.02f));
}

TEST(Obstacles, PushOffWhatThickensBesideThemByNoMoreThanHalfItsLength) {
  std::optional<Vec3> way = wall().way(Vec3(0, 0, 0.1f), Vec3(0, 0.1f, 0.1f), 0.4f);
  ASSERT_TRUE(way);
  EXPECT_NEAR(way->z, 0.15f, 1e-3);
}

TEST(Obstacles, LetOutWhatBeginsInside) {
  Vec3 to(0, 1, 0.2f);
  EXPECT_EQ(wall().way(Vec3(0, 1, -0.1f), to, 0.05f), to);
  EXPECT_FALSE(wall().way(Vec3(0, 1, -0.1f), Vec3(0, 1, -0.1f), 0));
}

}  // namespace
}  // namespace frond
