#pragma once

#include <cstdint>
#include <memory>
#include <nlohmann/json.hpp>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/vec.h"
#include "model/surface.h"

namespace frond {

using Json = nlohmann::ordered_json;

/// An array of a part, as it goes over the wire.
struct WireArray {
  std::string place;      ///< JSON pointer within the part: "/position", "/levels/0/parts/1/index"
  std::string_view type;  ///< of one element: f32, u32, i8 or u8
  std::size_t count = 0;  ///< of elements
  std::shared_ptr<const std::string> bytes;  ///< little endian; shared, as models are kept
};

/// What is drawn in one go: a head of JSON and its arrays.
struct DrawnPart {
  Json head = Json::object();
  std::vector<WireArray> arrays;
  std::string id;  ///< stands for all of it; empty: not known yet

  std::size_t bytes() const;
  void set_id();

  void add(std::string place, std::span<const float> values);
  void add(std::string place, std::span<const std::uint32_t> values);
  void add(std::string place, std::span<const std::uint8_t> values);
  void add(std::string place, std::span<const std::int8_t> values);
  /// Positions, normals in bytes, triangles and, where it has them, places on the texture.
  void add_surface(const std::string& below, const Surface& surface);
};

/// `[r, g, b]` of a colour, `[x, y, z]` of a vector.
Json json_of(const Color& color);
Json json_of(Vec3 vector);

/// An answer with arrays: "FRN1", the length of the header, the header padded to 8 bytes, the arrays, each
/// padded so. Parts whose ids are in `kept` come without arrays. Each part's id stands for its content.
std::string packet_of(Json header, std::vector<DrawnPart> parts, const std::set<std::string>& kept);

}  // namespace frond
