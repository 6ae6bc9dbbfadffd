// Where pieces of a drawing lie over each other in the picture.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <unordered_map>
#include <vector>

#include "engine/descriptive/outlines.h"
#include "engine/geometry/region.h"

namespace spineloft::descriptive {

/// What a piece covers of the picture.
struct Sheet {
  geometry::Contours region;          ///< simple outlines (geometry::cleanRegion)
  std::vector<OutlinePath> outlines;  ///< as drawn
};

/// What the outlines of a piece enclose by even-odd, made simple, within the board; of kind Solid what its silhouette
/// does. `size`: sizeOf. Errors: those of pathOf, silhouetteOf and geometry::cleanRegion.
Result<Sheet> sheetOf(std::span<const MeasuredLine> lines, const Piece& piece, double size, image::Size board);

/// A place where two pieces overlap: cells at most one other cell away from each other.
struct Overlap {
  std::uint32_t a = 0, b = 0;        ///< pieces, a < b
  PicturePoint at;                   ///< its cell that is nearest to the middle of all its cells
  std::vector<std::uint32_t> cells;  ///< growing, ≥ 1
};

/// A grid of kOverlapCells cells along the longer side of the drawing, and who is in each cell's middle.
class Overlaps {
 public:
  /// `size`: of the drawing, pixels, > 0. What overlaps in no cell's middle does not overlap.
  Overlaps(std::span<const Sheet> sheets, double size);
  Overlaps() = default;

  /// In the order of pieces, then of cells.
  const std::vector<Overlap>& all() const { return overlaps_; }
  /// The overlap of two pieces at a place, or at the nearest cell at most `reach` cells away.
  std::optional<std::uint32_t> at(std::uint32_t one, std::uint32_t other, PicturePoint p, int reach) const;
  /// Of two pieces that is nearest to the place; none where they do not overlap.
  std::optional<std::uint32_t> nearest(std::uint32_t one, std::uint32_t other, PicturePoint p) const;
  /// Pieces in a cell's middle, growing.
  std::span<const std::uint32_t> in(std::uint32_t cell) const {
    return std::span(pieces_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }
  std::uint32_t cells() const { return across_ * down_; }
  PicturePoint middle(std::uint32_t cell) const {
    return {low_.x + (cell % across_ + 0.5) * step_, low_.y + (cell / across_ + 0.5) * step_};
  }
  double step() const { return step_; }
  /// Column and row of the cell of a place, also outside of the grid.
  std::array<int, 2> placeOf(PicturePoint p) const {
    return {static_cast<int>(std::floor((p.x - low_.x) / step_)), static_cast<int>(std::floor((p.y - low_.y) / step_))};
  }

 private:
  void fill(std::span<const Sheet> sheets);
  void connect();
  std::uint64_t keyOf(std::uint32_t a, std::uint32_t b, std::uint32_t cell) const {
    return (std::uint64_t{a} * count_ + b) * cells() + cell;
  }
  std::uint32_t count_ = 0, across_ = 0, down_ = 0;
  PicturePoint low_{};
  double step_ = 1;
  std::vector<std::uint32_t> first_, pieces_;
  std::vector<Overlap> overlaps_;
  std::unordered_map<std::uint64_t, std::uint32_t> labels_;
};

inline constexpr double kOverlapCells = 160;

}  // namespace spineloft::descriptive
