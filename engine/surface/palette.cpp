#include "engine/surface/palette.h"

namespace spineloft::surface {
namespace {

constexpr std::size_t kBits = 5, kSide = std::size_t{1} << kBits;

std::size_t cellOf(const std::uint8_t* pixel) {
  std::size_t cell = 0;
  for (int c = 0; c < 3; ++c) cell = cell << kBits | static_cast<std::size_t>(pixel[c] >> (8 - kBits));
  return cell;
}

/// (1, 2, 1) / 4 along every line of cells that are `step` apart; what would leave stays at the
/// end.
void smooth(std::vector<float>& cells, std::size_t step) {
  for (std::size_t first = 0; first < cells.size(); ++first) {
    if (first / step % kSide != 0) continue;
    float before = cells[first];
    for (std::size_t i = 0; i < kSide; ++i) {
      float& here = cells[first + i * step];
      const float after = i + 1 < kSide ? cells[first + (i + 1) * step] : here;
      const float mixed = (before + 2 * here + after) / 4;
      before = here;
      here = mixed;
    }
  }
}

}  // namespace

Palette::Palette() : cells_(kSide * kSide * kSide, 0.0f) {}

void Palette::add(const std::uint8_t* pixel) {
  cells_[cellOf(pixel)] += 1;
  count_ += 1;
}

void Palette::close() {
  for (const std::size_t step : {std::size_t{1}, kSide, kSide * kSide}) smooth(cells_, step);
}

double Palette::share(const std::uint8_t* pixel) const {
  return count_ > 0 ? static_cast<double>(cells_[cellOf(pixel)]) / count_ : 0;
}

}  // namespace spineloft::surface
