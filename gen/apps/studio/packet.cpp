#include "studio/packet.h"

#include <bit>
#include <cmath>
#include <cstring>

#include "core/content.h"
#include "core/parallel.h"

namespace frond {

static_assert(std::endian::native == std::endian::little, "the wire is little endian");

namespace {

template <class T>
void add_array(DrawnPart& part, std::string place, std::string_view type, std::span<const T> values) {
  std::string bytes(values.size_bytes(), '\0');
  if (!values.empty()) std::memcpy(bytes.data(), values.data(), values.size_bytes());
  part.arrays.push_back(
      {std::move(place), type, values.size(), std::make_shared<const std::string>(std::move(bytes))});
}

std::string padded(std::string text, char with) {
  text.resize((text.size() + 7) / 8 * 8, with);
  return text;
}

}  // namespace

void DrawnPart::add(std::string place, std::span<const float> values) {
  add_array(*this, std::move(place), "f32", values);
}
void DrawnPart::add(std::string place, std::span<const std::uint32_t> values) {
  add_array(*this, std::move(place), "u32", values);
}
void DrawnPart::add(std::string place, std::span<const std::uint8_t> values) {
  add_array(*this, std::move(place), "u8", values);
}
void DrawnPart::add(std::string place, std::span<const std::int8_t> values) {
  add_array(*this, std::move(place), "i8", values);
}

void DrawnPart::add_surface(const std::string& below, const Surface& surface) {
  static_assert(sizeof(Vec3) == 3 * sizeof(float) && sizeof(Vec2) == 2 * sizeof(float));
  add(below + "/position", {&surface.position.data()->x, 3 * surface.position.size()});
  std::vector<std::int8_t> normals;
  normals.reserve(4 * surface.normal.size());
  for (Vec3 n : surface.normal)
    for (float x : {n.x, n.y, n.z, 0.0f}) normals.push_back(static_cast<std::int8_t>(std::lround(127 * x)));
  add(below + "/normal", normals);
  add(below + "/index", {surface.triangle.data()->data(), 3 * surface.triangle.size()});
  if (!surface.uv.empty()) add(below + "/uv", {&surface.uv.data()->x, 2 * surface.uv.size()});
}

std::size_t DrawnPart::bytes() const {
  constexpr std::size_t kHead = 2000;  // of JSON, besides what stands for each array
  std::size_t sum = kHead;
  for (const WireArray& array : arrays) sum += array.bytes->size() + 2 * sizeof(WireArray);
  return sum;
}

void DrawnPart::set_id() {
  std::string all = head.dump();
  for (const WireArray& array : arrays) all += array.place + content_id(*array.bytes);
  id = content_id(all);
}

Json json_of(const Color& c) { return Json::array({c.red, c.green, c.blue}); }
Json json_of(Vec3 v) { return Json::array({v.x, v.y, v.z}); }

std::string packet_of(Json header, std::vector<DrawnPart> parts, const std::set<std::string>& kept) {
  parallel_for(parts.size(), [&](std::size_t i) {
    if (parts[i].id.empty()) parts[i].set_id();
  });
  std::size_t at = 0;
  Json list = Json::array();
  for (DrawnPart& part : parts) {
    part.head["id"] = part.id;
    if (kept.contains(part.id)) part.arrays.clear();
    for (const WireArray& array : part.arrays) {
      part.head[Json::json_pointer(array.place)] = {{"at", at}, {"n", array.count}, {"t", array.type}};
      at += (array.bytes->size() + 7) / 8 * 8;
    }
    list.push_back(std::move(part.head));
  }
  header["parts"] = std::move(list);
  std::string head = padded(header.dump(), ' ');
  std::string text = "FRN1";
  text.reserve(8 + head.size() + at);
  auto length = static_cast<std::uint32_t>(head.size());
  text.append(reinterpret_cast<const char*>(&length), sizeof length);
  text += head;
  for (const DrawnPart& part : parts)
    for (const WireArray& array : part.arrays) {
      text += *array.bytes;
      text.append((8 - array.bytes->size() % 8) % 8, '\0');
    }
  return text;
}

}  // namespace frond
