// How a plain surface takes the light.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

namespace spineloft::surface {

enum class Paint : std::uint8_t {
  Plain,    ///< one colour
  TwoTone,  ///< one above, another below the middle of the part's height
  Clay,     ///< soft and dull
  Glaze,    ///< smooth and shiny
  Metal,
  kCount
};

/// What a paint is called, and what it is in files with physical materials (glTF's metallic-roughness).
struct Finish {
  Paint paint;
  std::string_view key, label;
  double roughness, metallic;  ///< 0…1
};

/// All of them, in the order of Paint.
std::span<const Finish> finishes();
const Finish& finishOf(Paint paint);
/// By its key: "plain", "two-tone", "clay", "glaze" or "metal".
std::optional<Paint> paintFromKey(std::string_view key);

}  // namespace spineloft::surface
