#include "engine/surface/finish.h"

#include <algorithm>
#include <array>

namespace spineloft::surface {
namespace {

constexpr std::array<Finish, static_cast<std::size_t>(Paint::kCount)> kFinishes = {{
    {Paint::Plain, "plain", "Plain", 0.8, 0},
    {Paint::TwoTone, "two-tone", "Two colours", 0.8, 0},
    {Paint::Clay, "clay", "Clay", 1, 0},
    {Paint::Glaze, "glaze", "Glaze", 0.15, 0},
    {Paint::Metal, "metal", "Metal", 0.3, 1},
}};

}  // namespace

std::span<const Finish> finishes() { return kFinishes; }

const Finish& finishOf(Paint paint) {
  const auto index = static_cast<std::size_t>(paint);
  return kFinishes[index < kFinishes.size() ? index : 0];
}

std::optional<Paint> paintFromKey(std::string_view key) {
  const auto at = std::ranges::find(kFinishes, key, &Finish::key);
  if (at == kFinishes.end()) return std::nullopt;
  return at->paint;
}

}  // namespace spineloft::surface
