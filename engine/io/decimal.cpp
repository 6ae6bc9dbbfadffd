#include "engine/io/decimal.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

namespace spineloft::io {

Decimal::Decimal(float value) {
  if (value == 0) {
    add("0");
    return;
  }
  if (value < 0) add("-");
  std::array<char, 16> buffer{};
  int count = 0, exponent = 0;
  nlohmann::detail::dtoa_impl::grisu2(buffer.data(), count, exponent, std::abs(value));
  const std::string_view digits(buffer.data(), static_cast<std::size_t>(count));
  const int whole = count + exponent;  // digits before the point
  if (exponent >= 0) {
    add(digits);
    addZeros(exponent);
  } else if (whole > 0) {
    add(digits.substr(0, static_cast<std::size_t>(whole)));
    add(".");
    add(digits.substr(static_cast<std::size_t>(whole)));
  } else {
    add("0.");
    addZeros(-whole);
    add(digits);
  }
}

void Decimal::add(std::string_view more) {
  std::ranges::copy(more, text_.begin() + static_cast<std::ptrdiff_t>(size_));
  size_ += more.size();
}

void Decimal::addZeros(int count) {
  std::fill_n(text_.begin() + static_cast<std::ptrdiff_t>(size_), count, '0');
  size_ += static_cast<std::size_t>(count);
}

}  // namespace spineloft::io
