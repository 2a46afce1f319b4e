#pragma once

#include <bit>
#include <cstring>
#include <optional>
#include <string_view>

namespace frond {

/// Numbers of a binary file, one after the other; none where the file ends before.
class ByteReader {
 public:
  explicit ByteReader(std::string_view bytes, bool big_endian = false)
      : rest_(bytes), turned_(big_endian != (std::endian::native == std::endian::big)) {}

  std::size_t left() const { return rest_.size(); }

  bool skip(std::size_t count) {
    if (count > rest_.size()) return false;
    rest_.remove_prefix(count);
    return true;
  }

  template <class T>
  std::optional<T> read() {
    if (rest_.size() < sizeof(T)) return std::nullopt;
    char bytes[sizeof(T)];
    for (std::size_t i = 0; i < sizeof(T); ++i) bytes[turned_ ? sizeof(T) - 1 - i : i] = rest_[i];
    rest_.remove_prefix(sizeof(T));
    T value;
    std::memcpy(&value, bytes, sizeof(T));
    return value;
  }

 private:
  std::string_view rest_;
  bool turned_;
};

}  // namespace frond
