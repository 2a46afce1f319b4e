#include "creeping/gather.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.h"

namespace frond {

namespace {

constexpr std::int32_t kLeast = 3;  // nodes of a strand that is crowded out

/// The strands that have a segment, renumbered, and where their nodes begin. Returns the new number of each.
std::vector<std::int32_t> keep_strands(const Nodes& nodes, const std::vector<Strand>& strands, Strands& out) {
  std::vector<std::int32_t> count(strands.size(), 0), number(strands.size(), -1);
  assert(nodes.strand.size() == nodes.laid.size() && nodes.below.size() == nodes.laid.size());
  for (std::int32_t s : nodes.strand) ++count[s];
  std::vector<std::uint8_t> bears(strands.size(), 0);
  for (const Strand& s : strands)
    if (s.parent >= 0) bears[s.parent] = 1;
  std::int32_t first = 0;
  for (std::size_t s = 0; s < strands.size(); ++s) {
    std::int32_t parent = strands[s].parent;
    assert(parent < static_cast<std::int32_t>(s) && "a strand begins after the one that it leaves");
    // Stubs that found no room at once, and branches of what is not there.
    bool stub = count[s] < kLeast && !bears[s] && strands[s].end == End::crowded;
    if (count[s] < (parent < 0 ? 2 : 1) || stub || (parent >= 0 && number[parent] < 0)) continue;
    number[s] = static_cast<std::int32_t>(out.strands.size());
    out.strands.push_back({first, count[s], parent < 0 ? -1 : number[parent], strands[s].end});
    first += count[s];
  }
  return number;
}

/// The order of the nodes strand by strand.
std::vector<std::int32_t> order_by_strand(const Nodes& nodes, const std::vector<std::int32_t>& number,
                                          const Strands& out) {
  std::size_t n = out.strands.empty() ? 0 : out.strands.back().first + out.strands.back().count;
  std::vector<std::int32_t> order(n), next;
  for (const Strand& s : out.strands) next.push_back(s.first);
  for (std::size_t i = 0; i < nodes.laid.size(); ++i)
    if (std::int32_t s = number[nodes.strand[i]]; s >= 0) order[next[s]++] = static_cast<std::int32_t>(i);
  return order;
}

/// Radii by age, times what the tips that a stem carries ask for.
std::vector<float> radii(const Strands& out, const std::vector<std::int32_t>& parent, const Crawl& crawl) {
  assert(out.age.size() == parent.size() && crawl.radius > 0);
  constexpr double kYoungest = 0.1;  // of the radius: that of the youngest node, as lift_of() has it
  std::size_t n = parent.size();
  std::vector<float> radius(n);
  std::vector<std::int32_t> carried(n, 0);
  for (std::size_t i = n; i-- > 0;) {
    carried[i] = std::max(carried[i], 1);
    if (parent[i] >= 0) carried[parent[i]] += carried[i];
    double young = std::clamp(out.age[i] * crawl.ripening, kYoungest, 1.0);
    double stem = crawl.pipe > 0 ? std::min(std::pow(carried[i], 1 / crawl.pipe), crawl.thickest) : 1.0;
    radius[i] = static_cast<float>(crawl.radius * young * stem);
  }
  return radius;
}

/// The place of a node above the surface; in a cleft that is narrower than the stem, half-way across.
DVec3 lifted(const TriangleSurface& host, const Tread& t, double radius) {
  DVec3 place = t.contact + t.normal * radius;
  DVec3 offset = place - t.place;
  if (glm::dot(offset, t.normal) <= 0) return place;
  if (std::optional<Crossing> wall = host.crossing(t.place, place))
    place = t.place + offset * (0.5 * wall->share);
  return place;
}

/// The places of all nodes. What hangs moves along as the node that holds it is lifted, if there is room.
std::vector<DVec3> places(const TriangleSurface& host, const GroundHeight& ground, const Nodes& nodes,
                          const std::vector<std::int32_t>& order, const std::vector<std::int32_t>& parent,
                          const std::vector<float>& radius) {
  std::size_t n = order.size();
  std::vector<DVec3> place(n);
  auto laid = [&](std::size_t i) -> const Laid& { return nodes.laid[order[i]]; };
  auto height = [&](const DVec3& p) { return ground ? p.y - ground(p.x, p.z) : 1; };
  parallel_for((n + 255) / 256, [&](std::size_t block) {
    for (std::size_t i = block * 256; i < std::min(n, (block + 1) * 256); ++i)
      place[i] = laid(i).hanging ? laid(i).tread.place : lifted(host, laid(i).tread, radius[i]);
  });
  for (std::size_t i = 0; i < n;) {
    std::size_t end = i + 1;
    if (laid(i).hanging && parent[i] >= 0) {
      while (end < n && laid(end).hanging && parent[end] == static_cast<std::int32_t>(end) - 1) ++end;
      DVec3 root = place[parent[i]], shift = root - laid(parent[i]).tread.place;
      bool free = true;
      for (std::size_t k = i; k < end && free; ++k) {
        free = height(place[k] + shift) > 0 && !host.crossing(root, place[k] + shift) &&
               !host.crossing(place[k], place[k] + shift);
        root = place[k] + shift;
      }
      // The next one holds again.
      if (free && end < n && parent[end] == static_cast<std::int32_t>(end) - 1)
        free = !host.crossing(root, place[end]);
      for (std::size_t k = i; k < end && free; ++k) place[k] += shift;
    }
    i = end;
  }
  return place;
}

}  // namespace

Strands gather(const TriangleSurface& host, const GroundHeight& ground, const Nodes& nodes,
               const std::vector<Strand>& strands, const std::vector<int>& depths, const Crawl& crawl) {
  Strands out;
  std::vector<std::int32_t> number = keep_strands(nodes, strands, out);
  std::vector<std::int32_t> order = order_by_strand(nodes, number, out);
  std::size_t n = order.size();
  std::vector<std::int32_t> index(nodes.laid.size(), -1), parent(n);
  for (std::size_t i = 0; i < n; ++i) index[order[i]] = static_cast<std::int32_t>(i);
  double end = 0;
  for (const Laid& laid : nodes.laid) end = std::max(end, laid.time);
  out.age.resize(n);
  out.normal.resize(n);
  out.contact.resize(n);
  out.room.resize(n);
  for (std::size_t i = 0; i < n; ++i) {
    std::int32_t below = nodes.below[order[i]];
    parent[i] = below < 0 ? -1 : index[below];
    assert(below < 0 || (parent[i] >= 0 && parent[i] < static_cast<std::int32_t>(i)));
    out.age[i] = static_cast<float>(end - nodes.laid[order[i]].time);
  }
  std::vector<float> radius = radii(out, parent, crawl);
  std::vector<DVec3> place = places(host, ground, nodes, order, parent, radius);
  parallel_for((n + 255) / 256, [&](std::size_t block) {
    for (std::size_t i = block * 256; i < std::min(n, (block + 1) * 256); ++i) {
      const Laid& laid = nodes.laid[order[i]];
      out.normal[i] = Vec3(laid.tread.normal);
      out.contact[i] = Vec3(laid.hanging ? place[i] : laid.tread.contact);
      if (!laid.hanging) continue;
      double far = 2 * crawl.hang_most;
      std::optional<Contact> near = host.closest(place[i], far);
      double room = near ? near->distance : far;
      if (ground) room = std::min(room, 0.5 * (place[i].y - ground(place[i].x, place[i].z)));
      out.room[i] = std::max(static_cast<float>(room) - radius[i], 0.0f);
    }
  });
  out.skeleton.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Laid& laid = nodes.laid[order[i]];
    std::int32_t s = nodes.strand[order[i]];
    out.skeleton.add(Vec3(place[i]), radius[i], parent[i], static_cast<std::uint16_t>(depths[s]));
    out.skeleton.birth.back() = end > 0 ? static_cast<float>(laid.time / end) : 0;
    out.hanging.push_back(laid.hanging);
    out.of.push_back(number[s]);
    if (crawl.mask && crawl.mask->scaling("leaves"))
      out.mask.push_back(laid.hanging ? 1.0f : static_cast<float>(mask_at(crawl, host, laid.tread)));
  }
  set_tip_distances(out.skeleton);
  return out;
}

}  // namespace frond
