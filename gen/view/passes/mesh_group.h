#pragma once

#include <embree3/rtcore.h>

#include <memory>
#include <span>
#include <vector>

#include "model/surface.h"

namespace frond {

/// The device that all scenes of this process are made by.
RTCDevice embree_device();

/// Throws where that device has met an error in this thread since the last call: std::bad_alloc where memory
/// ran out, else std::runtime_error. Errors of a build are those of the thread that waits for it.
void check_embree();

/// Builds a scene's tree. Embree's tasks run in the pool of all others; no thread takes up one of those
/// meanwhile. Throws as check_embree(), also of what was attached before.
void commit_scene(RTCScene scene);

/// An Embree scene, released with its owner.
struct ReleaseScene {
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using ScenePointer = std::unique_ptr<RTCSceneTy, ReleaseScene>;

/// A geometry, released with its owner; scenes that it was attached to keep it.
struct ReleaseGeometry {
  void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using GeometryPointer = std::unique_ptr<RTCGeometryTy, ReleaseGeometry>;

/// Meshes that are placed together, as one scene; the number of a mesh is that of its geometry.
class MeshGroup {
 public:
  enum class Shadows { thrown, none };
  /// Refers to the surfaces.
  explicit MeshGroup(std::vector<const Surface*> surfaces, Shadows shadows = Shadows::thrown);
  /// Owns them.
  explicit MeshGroup(std::vector<Surface> surfaces, Shadows shadows = Shadows::thrown);

  RTCScene scene() const { return scene_.get(); }
  std::size_t size() const { return surfaces_.size(); }
  const Surface& surface(std::size_t part) const { return *surfaces_[part]; }

 private:
  void build(Shadows shadows);

  std::vector<Surface> owned_;
  std::vector<const Surface*> surfaces_;
  ScenePointer scene_;
};

/// Copies items into a new buffer of a geometry, padded as Embree reads it. Throws as check_embree().
template <class Item>
void fill_buffer(RTCGeometry geometry, RTCBufferType type, RTCFormat format, std::span<const Item> items) {
  void* to = rtcSetNewGeometryBuffer(geometry, type, 0, format, sizeof(Item), items.size());
  check_embree();
  std::copy(items.begin(), items.end(), static_cast<Item*>(to));
}

/// Attaches a mesh to a scene, with that number; nothing where it has no triangles.
void attach_mesh(RTCScene scene, const Surface& surface, unsigned number, bool shadows = true);

}  // namespace frond
