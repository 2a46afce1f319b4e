#include "passes/mesh_group.h"

#include <fmt/format.h>

#include <array>
#include <new>
#include <stdexcept>
#include <utility>

#include "core/cancellation.h"
#include "core/vec.h"

namespace frond {

namespace {

void throw_if(RTCError error) {
  if (error == RTC_ERROR_OUT_OF_MEMORY) throw std::bad_alloc();
  if (error != RTC_ERROR_NONE)
    throw std::runtime_error(fmt::format("Embree ended with error {}", static_cast<int>(error)));
}

using Device = std::unique_ptr<RTCDeviceTy, void (*)(RTCDevice)>;

Device new_device() {
  // A device that is to use fewer threads would hold all of TBB to as many, as long as it lives.
  Device device(rtcNewDevice(nullptr), rtcReleaseDevice);
  if (!device) throw_if(rtcGetDeviceError(nullptr));
  return device;
}

}  // namespace

RTCDevice embree_device() {
  static Device device = new_device();
  return device.get();
}

void check_embree() { throw_if(rtcGetDeviceError(embree_device())); }

void commit_scene(RTCScene scene) {
  isolated([&] { rtcCommitScene(scene); });
  check_embree();
}

void attach_mesh(RTCScene scene, const Surface& surface, unsigned number, bool shadows) {
  if (surface.triangle.empty()) return;
  GeometryPointer mesh(rtcNewGeometry(embree_device(), RTC_GEOMETRY_TYPE_TRIANGLE));
  fill_buffer<Vec3>(mesh.get(), RTC_BUFFER_TYPE_VERTEX, RTC_FORMAT_FLOAT3, surface.position);
  fill_buffer<std::array<std::uint32_t, 3>>(mesh.get(), RTC_BUFFER_TYPE_INDEX, RTC_FORMAT_UINT3,
                                            surface.triangle);
  if (!shadows)
    rtcSetGeometryOccludedFilterFunction(mesh.get(), [](const RTCFilterFunctionNArguments* ray) {
      for (unsigned i = 0; i < ray->N; ++i) ray->valid[i] = 0;
    });
  rtcCommitGeometry(mesh.get());
  rtcAttachGeometryByID(scene, mesh.get(), number);
}

MeshGroup::MeshGroup(std::vector<const Surface*> surfaces, Shadows shadows) : surfaces_(std::move(surfaces)) {
  build(shadows);
}

MeshGroup::MeshGroup(std::vector<Surface> surfaces, Shadows shadows) : owned_(std::move(surfaces)) {
  for (const Surface& surface : owned_) surfaces_.push_back(&surface);
  build(shadows);
}

void MeshGroup::build(Shadows shadows) {
  scene_.reset(rtcNewScene(embree_device()));
  rtcSetSceneFlags(scene_.get(), RTC_SCENE_FLAG_ROBUST);
  for (std::size_t part = 0; part < surfaces_.size(); ++part)
    attach_mesh(scene_.get(), *surfaces_[part], static_cast<unsigned>(part), shadows == Shadows::thrown);
  commit_scene(scene_.get());
}

}  // namespace frond
