#include <algorithm>
#include <cmath>

#include "core/polyline.h"
#include "creeping/tip.h"

namespace frond {

namespace {

constexpr double kPiece = 0.25;        // of the width: the longest piece of a curve that is laid on a host
constexpr std::size_t kWindow = 12;    // pieces that a strand may go on in a step, or fall back
constexpr double kMostPieces = 10000;  // of one piece as it is drawn

Start start_at(const std::vector<DVec3>& curve, double far, std::int32_t number) {
  PolylinePoint<DVec3> point = polyline_point(std::span<const DVec3>(curve), far);
  return {point.at, point.along, number};
}

}  // namespace

std::vector<Start> starts_on_guides(const std::vector<CrawlGuide>& guides, int count) {
  std::vector<std::vector<DVec3>> curves;
  for (const CrawlGuide& guide : guides)
    for (std::vector<DVec3>& curve : guide.curves()) curves.push_back(std::move(curve));
  std::vector<Start> starts;
  double all = 0;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    starts.push_back(start_at(curves[c], 0, static_cast<std::int32_t>(c)));
    all += polyline_length(std::span<const DVec3>(curves[c]));
  }
  int more = count - static_cast<int>(starts.size());
  double apart = all / std::max(more + 1, 1), next = apart;
  for (std::size_t c = 0; c < curves.size(); ++c) {
    double length = polyline_length(std::span<const DVec3>(curves[c]));
    for (; more > 0 && next < length; next += apart, --more)
      starts.push_back(start_at(curves[c], next, static_cast<std::int32_t>(c)));
    next -= length;
  }
  return starts;
}

Guides::Guides(const TriangleSurface& host, const std::vector<CrawlGuide>& guides) {
  for (const CrawlGuide& guide : guides)
    for (const std::vector<DVec3>& drawn : guide.curves()) {
      Curve curve{{}, guide.width, guide.pull};
      for (std::size_t i = 0; i + 1 < drawn.size(); ++i) {
        double parts = std::ceil(glm::distance(drawn[i], drawn[i + 1]) / (kPiece * guide.width));
        auto pieces = static_cast<int>(std::clamp(parts, 1.0, kMostPieces));
        for (int k = i == 0 ? 0 : 1; k <= pieces; ++k) {
          DVec3 at = host.closest(glm::mix(drawn[i], drawn[i + 1], static_cast<double>(k) / pieces))->point;
          if (curve.at.empty() || glm::distance(curve.at.back(), at) > 1e-9) curve.at.push_back(at);
        }
      }
      curves_.push_back(std::move(curve));
    }
}

Guides::View Guides::view(const Curve& curve, std::size_t piece, const DVec3& place) const {
  DVec3 from = curve.at[piece], way = curve.at[piece + 1] - from;
  double share = glm::dot(place - from, way) / glm::dot(way, way);
  DVec3 toward = from + way * std::clamp(share, 0.0, 1.0) - place;
  return {glm::normalize(way), toward,     glm::length(toward),
          curve.width,         curve.pull, share >= 1 && piece + 2 == curve.at.size()};
}

Guides::Lead Guides::find(const DVec3& place, std::int32_t only) const {
  Lead lead;
  double nearest = 1;  // of the width
  for (std::size_t c = 0; c < curves_.size(); ++c) {
    if (only >= 0 && static_cast<std::size_t>(only) != c) continue;
    for (std::size_t piece = 0; piece + 1 < curves_[c].at.size(); ++piece) {
      double share = view(curves_[c], piece, place).distance / curves_[c].width;
      if (share < nearest) nearest = share, lead = {static_cast<std::int32_t>(c), piece};
    }
  }
  return lead;
}

Guides::View Guides::follow(const DVec3& place, Lead& lead) const {
  const Curve& curve = curves_[static_cast<std::size_t>(lead.curve)];
  std::size_t first = lead.piece - std::min(lead.piece, kWindow);
  std::size_t last = std::min(lead.piece + kWindow, curve.at.size() - 2);
  View best = view(curve, lead.piece, place);
  for (std::size_t piece = first; piece <= last; ++piece)
    if (View there = view(curve, piece, place); there.distance < best.distance)
      best = there, lead.piece = piece;
  return best;
}

}  // namespace frond
