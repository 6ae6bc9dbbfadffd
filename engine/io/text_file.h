// Bytes of a text file as they grow. Internal to io/.
#pragma once

#include <charconv>
#include <cstddef>
#include <string_view>
#include <utility>

#include "engine/io/decimal.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

class TextFile {
 public:
  explicit TextFile(std::size_t expected = 0) { bytes_.reserve(expected); }
  TextFile& add(std::string_view text) {
    bytes_.insert(bytes_.end(), text.begin(), text.end());
    return *this;
  }
  /// As a float, in plain decimals (decimal.h). Finite.
  TextFile& add(double value) { return add(Decimal(static_cast<float>(value)).text()); }
  TextFile& add(std::size_t value) {
    char digits[24];
    const auto end = std::to_chars(digits, digits + sizeof digits, value);
    return add(std::string_view(digits, static_cast<std::size_t>(end.ptr - digits)));
  }
  Bytes take() { return std::move(bytes_); }

 private:
  Bytes bytes_;
};

}  // namespace spineloft::io
