#include "engine/sections/ends.h"

#include <array>

namespace spineloft::sections {
namespace {

constexpr std::array kCapNames = {
    CapName{CapStyle::Flat, "flat", "Flat"},
    CapName{CapStyle::Round, "round", "Round"},
    CapName{CapStyle::Pointed, "pointed", "Pointed"},
    CapName{CapStyle::Open, "open", "Open"},
};
static_assert(kCapNames.size() == static_cast<std::size_t>(CapStyle::kCount));

}  // namespace

std::span<const CapName> capNames() { return kCapNames; }

std::optional<CapStyle> capFromKey(std::string_view key) {
  for (const CapName& name : kCapNames) {
    if (name.key == key) return name.style;
  }
  return std::nullopt;
}

std::string_view capKey(CapStyle style) {
  for (const CapName& name : kCapNames) {
    if (name.style == style) return name.key;
  }
  return {};
}

}  // namespace spineloft::sections
