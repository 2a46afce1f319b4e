#pragma once

#include <memory>
#include <string>
#include <string_view>

#include "preset/faults.h"

namespace frond {

/// Judges texts by the schema of reef::Preset with a library of others.
class SchemaJudge {
 public:
  SchemaJudge();
  ~SchemaJudge();

  bool accepts(std::string_view json);
  /// Of the last refusal.
  const std::string& reason() const { return reason_; }

 private:
  struct Library;
  std::unique_ptr<Library> library_;
  std::string reason_;
};

}  // namespace frond
