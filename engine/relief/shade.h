// Heights from the shading of a picture, over a coarse shape that is known.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

namespace spineloft::relief {

/// What a picture shows on a grid of cells, and the shape that it is shown of.
struct Shading {
  int width = 0, height = 0;                     ///< cells, rows top to bottom, each 2 … 256
  std::span<const std::array<float, 3>> colour;  ///< linear RGB 0…1, one a cell; anything where `inside` is 0
  std::span<const std::uint8_t> inside;          ///< 1: the part is seen there, one a cell
  /// Coarse height towards the viewer in cells, one a cell, smooth where inside; empty: none is known, and one that is
  /// round over `inside` is taken (half as high as a half ball would be).
  std::span<const float> z;
};

struct Shaded {
  std::vector<float> height;  ///< cells, towards the viewer, one a cell; 0 outside and where it fades out
  /// Share of the variance of brightness that the light on the coarse shape explains, 0 … 1.
  double explained = 0;
};

/// The heights in steps, so that a page without threads stays alive, and a worker can be stopped.
class ShadeSteps {
 public:
  /// Copies what it needs of the spans.
  explicit ShadeSteps(const Shading& input);
  ~ShadeSteps();
  ShadeSteps(ShadeSteps&&) noexcept;
  ShadeSteps& operator=(ShadeSteps&&) noexcept;
  /// The next step, at most about 50 ms at 256 × 256; false: all are done.
  bool step();
  /// What came out, once; all 0 before the last step.
  Shaded take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All steps.
Shaded shade(const Shading& input);

}  // namespace spineloft::relief
