// Numbers on a grid of cells.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/base/vec.h"

namespace spineloft::relief {

inline constexpr int kMostCells = 256;  ///< on a side

/// Cells over a rectangle of a picture, rows top to bottom. The middle of cell (x, y) is at corner + cell · (x, y).
struct Grid {
  int width = 0, height = 0;
  PicturePoint corner;  ///< picture pixels: the middle of the first cell
  double cell = 1;      ///< picture pixels that a cell is wide and high
  std::size_t size() const { return static_cast<std::size_t>(width) * static_cast<std::size_t>(height); }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x);
  }
  PicturePoint middle(int x, int y) const { return corner + cell * PicturePoint{double(x), double(y)}; }
  /// The longer side, cells.
  int side() const { return width > height ? width : height; }
};

using Values = std::vector<float>;        ///< one a cell
using Cells = std::vector<std::uint8_t>;  ///< 1: counts; one a cell

/// The mean of what counts round every cell that counts, weighted by a Gaussian of `sigma` cells; 0 elsewhere.
Values blurred(const Grid& grid, const Values& values, const Cells& counts, double sigma);

/// The largest value that counts within `reach` cells to each side; 0 where none does.
Values largestNear(const Grid& grid, const Values& values, const Cells& counts, int reach);

/// How far every cell is from the nearest one that does not count, or from beyond the grid, in cells (3-4 chamfer
/// distance: within 8 %).
Values depthWithin(const Grid& grid, const Cells& counts);

/// Between the middles of cells, linearly; the nearest cell's beyond them. `x`, `y`: cells.
double sample(const Grid& grid, std::span<const float> values, double x, double y);

}  // namespace spineloft::relief
