#include "export/look.h"

namespace frond {

std::string plain_name(const std::string& name, std::string_view otherwise) {
  std::string text;
  for (char c : name) {
    bool fine = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-';
    text += fine ? c : '_';
  }
  return text.empty() ? std::string(otherwise) : text;
}

bool is_leaf(Tissue tissue) {
  return tissue == Tissue::leaf || tissue == Tissue::petal || tissue == Tissue::ivy;
}

}  // namespace frond
