#include "core/content.h"

#include <fmt/format.h>
#define XXH_INLINE_ALL
#include <xxhash.h>

namespace frond {

extern const char* const kCodeId;  // a hash of the sources, made by core/code_id.cmake

std::string content_id(std::string_view content) {
  return fmt::format("{:016x}", XXH3_64bits(content.data(), content.size()));
}

std::string made_id(std::string_view content) {
  std::string all(kCodeId);
  all += '\n';
  all += content;
  return content_id(all);
}

}  // namespace frond
