#include "geometry/bends.h"

#include <algorithm>
#include <cmath>

#include "core/vec.h"

namespace frond {

void mark_bends(std::span<const glm::vec4> chain, float within, std::span<char> marks) {
  marks.front() = marks.back() = 1;
  if (chain.size() < 3) return;
  Vec3 start(chain.front()), offset = Vec3(chain.back()) - start;
  float length = glm::length(offset), worst = within;
  std::size_t at = 0;
  for (std::size_t i = 1; i + 1 < chain.size(); ++i) {
    float along =
        length > 0 ? std::clamp(glm::dot(Vec3(chain[i]) - start, offset) / (length * length), 0.0f, 1.0f) : 0;
    float off = glm::distance(Vec3(chain[i]), start + offset * along);
    off += std::abs(chain[i].w - glm::mix(chain.front().w, chain.back().w, along));
    if (off > worst) worst = off, at = i;
  }
  if (at == 0) return;
  mark_bends(chain.first(at + 1), within, marks.first(at + 1));
  mark_bends(chain.subspan(at), within, marks.subspan(at));
}

}  // namespace frond
