
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <span>

#include "core/bounds.h"
#include "core/plain_text.h"
#include "cpfg/shapes.h"
#include "cpfg/turtle.h"

namespace frond::cpfg {

namespace {

constexpr std::size_t kMostPatches = 2000;

int held_pieces(double n) { return std::clamp(static_cast<int>(n), 1, 10); }

/// The head of a `.s` file.
struct PatchHead {
  DVec3 contact{0}, end{0}, heading{0, 1, 0}, up{0, 0, 1};
  double size = 1;
  int along = 5, across = 5;  ///< pieces of each patch, down its rows and along them

  /// A point of the file at the turtle's axes.
  DVec3 placed(DVec3 point, double scale) const {
    DVec3 p = (point - contact) * (scale / size);
    DVec3 forward = unit(heading), left = unit(glm::cross(forward, up));
    return left * p.x + forward * p.y + glm::cross(left, forward) * p.z;
  }
};

bool is_number_line(std::string_view line) {
  return !line.empty() && std::string_view("0123456789+-.").find(line[0]) != line.npos;
}

/// Reads a line of the head; numbers after its label.
void read_head_line(std::string_view line, PatchHead& head) {
  std::vector<double> numbers = numbers_in(line);
  auto vector = [&] { return DVec3{numbers[0], numbers[1], numbers[2]}; };
  if (line.starts_with("PRECISION") && !numbers.empty())
    head.along = head.across = held_pieces(std::clamp(numbers[0], 0.0, 1e6));
  if (line.starts_with("SIZE") && !numbers.empty() && numbers[0] > 0) head.size = numbers[0];
  if (numbers.size() < 3) return;
  if (line.starts_with("CONTACT")) head.contact = vector();
  if (line.starts_with("END")) head.end = vector();
  if (line.starts_with("HEADING")) head.heading = vector();
  if (line.starts_with("UP")) head.up = vector();
}

/// Bernstein's polynomials of the third degree.
std::array<double, 4> bernstein(double t) {
  double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

DVec3 patch_point(std::span<const DVec3> control, double across, double along) {
  std::array<double, 4> a = bernstein(along), b = bernstein(across);
  DVec3 sum{0};
  for (std::size_t row = 0; row < 4; ++row)
    for (std::size_t i = 0; i < 4; ++i) sum += control[4 * row + i] * (a[row] * b[i]);
  return sum;
}

/// The vertices of a mesh, those at one place as one, so that its normals run across seams.
class Weld {
 public:
  explicit Weld(Surface& mesh) : mesh_(mesh) {}

  std::uint32_t add(DVec3 at) {
    Vec3 p(at);
    auto [found, fresh] =
        index_.try_emplace({p.x, p.y, p.z}, static_cast<std::uint32_t>(mesh_.position.size()));
    if (fresh) mesh_.position.push_back(p);
    return found->second;
  }
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
    if (a != b && b != c && a != c) mesh_.triangle.push_back({a, b, c});
  }

 private:
  Surface& mesh_;
  std::map<std::array<float, 3>, std::uint32_t> index_;
};

void add_patch(std::span<const DVec3> control, const PatchHead& head, Weld& weld) {
  std::vector<std::uint32_t> below, row;
  for (int i = 0; i <= head.along; ++i) {
    row.clear();
    for (int j = 0; j <= head.across; ++j)
      row.push_back(weld.add(
          patch_point(control, static_cast<double>(j) / head.across, static_cast<double>(i) / head.along)));
    for (std::size_t j = 0; i > 0 && j + 1 < row.size(); ++j) {
      weld.triangle(below[j], below[j + 1], row[j + 1]);
      weld.triangle(below[j], row[j + 1], row[j]);
    }
    std::swap(below, row);
  }
}

/// Normals, and `uv` along its height and across, as leaves have them.
Result<TurtleSurface> finished(TurtleSurface surface) {
  Surface& mesh = surface.mesh;
  if (mesh.triangle.empty()) return Error{"", "no patch and no triangle with an area"};
  for (const Vec3& p : mesh.position)
    if (!(std::abs(p.x) < 1e9f && std::abs(p.y) < 1e9f && std::abs(p.z) < 1e9f))
      return Error{"", "a point is farther than can be drawn"};
  set_normals(mesh);
  Bounds box;
  for (const Vec3& p : mesh.position) box.extend(p);
  Vec3 size = glm::max(box.size(), Vec3(1e-12f));
  for (const Vec3& p : mesh.position)
    mesh.uv.emplace_back((p.y - box.low.y) / size.y, (p.x - box.low.x) / size.x);
  return surface;
}

std::vector<std::string_view> filled_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    std::size_t end = std::min(text.find('\n'), text.size());
    if (std::string_view line = trim(text.substr(0, end)); !line.empty()) lines.push_back(line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

}  // namespace

Result<TurtleSurface> read_patches(std::string_view text, double scale, std::array<int, 2> pieces) {
  PatchHead head;
  std::vector<double> numbers;
  for (std::string_view line : filled_lines(text)) {
    if (!is_number_line(line)) {
      if (numbers.size() <= 6) read_head_line(line, head);
      continue;
    }
    std::vector<double> more = numbers_in(line);
    numbers.insert(numbers.end(), more.begin(), more.end());
  }
  // The first six are the bounds, then each patch has 16 points.
  if (numbers.size() < 54 || (numbers.size() - 6) % 48 != 0)
    return error_at("", "found {} numbers; expected 6 bounds, and 48 for each patch", numbers.size());
  std::size_t patches = (numbers.size() - 6) / 48;
  if (patches > kMostPatches) return Error{"", "more than 2,000 patches"};
  if (pieces[0] > 0) head.along = held_pieces(pieces[0]);
  if (pieces[1] > 0) head.across = held_pieces(pieces[1]);
  TurtleSurface surface;
  Weld weld(surface.mesh);
  for (std::size_t patch = 0; patch < patches; ++patch) {
    std::array<DVec3, 16> control;
    for (std::size_t i = 0; i < 16; ++i) {
      const double* at = &numbers[6 + patch * 48 + i * 3];
      control[i] = head.placed({at[0], at[1], at[2]}, scale);
    }
    add_patch(control, head, weld);
  }
  surface.end = head.placed(head.end, scale);
  return finished(std::move(surface));
}

Result<TurtleSurface> read_triangles(std::string_view text, double scale) {
  TurtleSurface surface;
  Weld weld(surface.mesh);
  std::vector<std::uint32_t> corners;
  for (std::string_view line : filled_lines(text)) {
    if (line.starts_with("triangle")) corners.clear();
    std::vector<double> numbers = is_number_line(line) ? numbers_in(line) : std::vector<double>();
    if (numbers.size() < 3) continue;
    corners.push_back(weld.add(DVec3{numbers[0], numbers[1], numbers[2]} * scale));
    if (corners.size() == 3) weld.triangle(corners[0], corners[1], corners[2]);
    if (surface.mesh.triangle.size() > 5'000'000) return Error{"", "more than 5,000,000 triangles"};
  }
  return finished(std::move(surface));
}

}  // namespace frond::cpfg
