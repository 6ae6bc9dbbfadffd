#include "engine/descriptive/overlaps.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

#include "engine/descriptive/wireframe.h"

namespace spineloft::descriptive {
namespace {

/// From corner to corner: ends of lines that are drawn past a corner, or not as far, are at it.
OutlinePath straightPath(std::span<const MeasuredLine> lines, const Outline& outline, double size) {
  OutlinePath path;
  const auto add = [&](PicturePoint p, bool hidden) {
    path.points.push_back(p);
    path.hidden.push_back(hidden);
  };
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Run &before = outline[(i + outline.size() - 1) % outline.size()], &run = outline[i];
    const PicturePoint arrival = lines[before.line].at(before.to), start = lines[run.line].at(run.from);
    const bool isHidden = lines[run.line].isHidden((run.from + run.to) / 2);
    if (distance(arrival, start) <= 2 * kSameCorner * size) {
      add((arrival + start) / 2, isHidden);
    } else {
      // An edge whose line is gone.
      add(arrival, false);
      add(start, isHidden);
    }
  }
  return path;
}

}  // namespace

Result<Sheet> sheetOf(std::span<const MeasuredLine> lines, const Piece& piece, double size, image::Size board) {
  Sheet sheet;
  geometry::Contours drawn;
  std::vector<Outline> outlines = piece.outlines;
  if (piece.kind == PieceKind::Solid) {
    Result<Outline> silhouette = silhouetteOf(lines, piece.outlines, size);
    if (!silhouette) return silhouette.failure();
    outlines = {std::move(silhouette).value()};
  }
  for (const Outline& outline : outlines) {
    Result<OutlinePath> path =
        piece.kind == PieceKind::Solid ? straightPath(lines, outline, size) : pathOf(lines, outline);
    if (!path) return path.failure();
    drawn.push_back(path.value().points);
    sheet.outlines.push_back(std::move(path).value());
  }
  Result<geometry::Contours> region =
      geometry::cleanRegion(drawn, 0, {static_cast<double>(board.width), static_cast<double>(board.height)});
  if (!region) return region.failure();
  sheet.region = std::move(region).value();
  return sheet;
}

Overlaps::Overlaps(std::span<const Sheet> sheets, double size) : count_(static_cast<std::uint32_t>(sheets.size())) {
  PicturePoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  for (const Sheet& sheet : sheets) {
    for (const auto& contour : sheet.region) {
      for (const PicturePoint p : contour) {
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
        high = {std::max(high.x, p.x), std::max(high.y, p.y)};
      }
    }
  }
  if (!(high.x > low.x) || !(high.y > low.y) || !(size > 0)) {
    first_.assign(1, 0);
    return;
  }
  step_ = std::max(size, std::max(high.x - low.x, high.y - low.y)) / kOverlapCells;
  low_ = low;
  across_ = static_cast<std::uint32_t>(std::ceil((high.x - low.x) / step_));
  down_ = static_cast<std::uint32_t>(std::ceil((high.y - low.y) / step_));
  fill(sheets);
  connect();
}

void Overlaps::fill(std::span<const Sheet> sheets) {
  std::vector<std::vector<std::uint32_t>> lists(cells());
  std::vector<double> cuts;
  for (std::uint32_t piece = 0; piece < sheets.size(); ++piece) {
    for (std::uint32_t row = 0; row < down_; ++row) {
      const double y = low_.y + (row + 0.5) * step_;
      cuts.clear();
      for (const auto& contour : sheets[piece].region) {
        for (std::size_t i = 0, j = contour.size() - 1; i < contour.size(); j = i++) {
          const PicturePoint a = contour[i], b = contour[j];
          if ((a.y > y) != (b.y > y)) cuts.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
        }
      }
      std::ranges::sort(cuts);
      for (std::size_t k = 0; k + 1 < cuts.size(); k += 2) {
        const double from = std::max(0.0, std::ceil((cuts[k] - low_.x) / step_ - 0.5));
        for (double x = from; x < across_ && low_.x + (x + 0.5) * step_ < cuts[k + 1]; ++x) {
          lists[row * across_ + static_cast<std::uint32_t>(x)].push_back(piece);
        }
      }
    }
  }
  first_.assign(1, 0);
  for (const auto& list : lists) {
    pieces_.insert(pieces_.end(), list.begin(), list.end());
    first_.push_back(static_cast<std::uint32_t>(pieces_.size()));
  }
}

void Overlaps::connect() {
  std::map<std::array<std::uint32_t, 2>, std::vector<std::uint32_t>> pairs;
  for (std::uint32_t cell = 0; cell < cells(); ++cell) {
    const auto list = in(cell);
    for (std::size_t i = 0; i < list.size(); ++i) {
      for (std::size_t k = i + 1; k < list.size(); ++k) pairs[{list[i], list[k]}].push_back(cell);
    }
  }
  constexpr std::uint32_t kNew = 0xffffffffu;
  for (const auto& [pair, shared] : pairs) {
    for (const std::uint32_t cell : shared) labels_[keyOf(pair[0], pair[1], cell)] = kNew;
    for (const std::uint32_t start : shared) {
      if (labels_[keyOf(pair[0], pair[1], start)] != kNew) continue;
      const auto label = static_cast<std::uint32_t>(overlaps_.size());
      Overlap overlap{pair[0], pair[1], {}, {start}};
      labels_[keyOf(pair[0], pair[1], start)] = label;
      for (std::size_t i = 0; i < overlap.cells.size(); ++i) {
        const int x = static_cast<int>(overlap.cells[i] % across_), y = static_cast<int>(overlap.cells[i] / across_);
        for (int k = 0; k < 25; ++k) {
          const int nx = x + k % 5 - 2, ny = y + k / 5 - 2;
          if (nx < 0 || ny < 0 || nx >= static_cast<int>(across_) || ny >= static_cast<int>(down_)) continue;
          const std::uint32_t next = static_cast<std::uint32_t>(ny) * across_ + static_cast<std::uint32_t>(nx);
          const auto found = labels_.find(keyOf(pair[0], pair[1], next));
          if (found == labels_.end() || found->second != kNew) continue;
          found->second = label;
          overlap.cells.push_back(next);
        }
      }
      std::ranges::sort(overlap.cells);
      PicturePoint mean{};
      for (const std::uint32_t cell : overlap.cells) mean += middle(cell) / static_cast<double>(overlap.cells.size());
      overlap.at = middle(*std::ranges::min_element(overlap.cells, {},
                                                    [&](std::uint32_t cell) { return distance(middle(cell), mean); }));
      overlaps_.push_back(std::move(overlap));
    }
  }
}

std::optional<std::uint32_t> Overlaps::at(std::uint32_t one, std::uint32_t other, PicturePoint p, int reach) const {
  if (one > other) std::swap(one, other);
  const auto [x, y] = placeOf(p);
  std::optional<std::uint32_t> found;
  // The middle of its own cell is the nearest.
  if (x >= 0 && y >= 0 && x < static_cast<int>(across_) && y < static_cast<int>(down_)) {
    const std::uint32_t own = static_cast<std::uint32_t>(y) * across_ + static_cast<std::uint32_t>(x);
    if (const auto label = labels_.find(keyOf(one, other, own)); label != labels_.end()) return label->second;
  }
  double nearest = std::numeric_limits<double>::infinity();
  for (int dy = -reach; dy <= reach; ++dy) {
    for (int dx = -reach; dx <= reach; ++dx) {
      const int nx = x + dx, ny = y + dy;
      if (nx < 0 || ny < 0 || nx >= static_cast<int>(across_) || ny >= static_cast<int>(down_)) continue;
      const std::uint32_t cell = static_cast<std::uint32_t>(ny) * across_ + static_cast<std::uint32_t>(nx);
      const auto label = labels_.find(keyOf(one, other, cell));
      const double away = distance(middle(cell), p);
      if (label == labels_.end() || away >= nearest) continue;
      nearest = away;
      found = label->second;
    }
  }
  return found;
}

std::optional<std::uint32_t> Overlaps::nearest(std::uint32_t one, std::uint32_t other, PicturePoint p) const {
  if (one > other) std::swap(one, other);
  std::optional<std::uint32_t> found;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::uint32_t k = 0; k < overlaps_.size(); ++k) {
    if (overlaps_[k].a != one || overlaps_[k].b != other) continue;
    for (const std::uint32_t cell : overlaps_[k].cells) {
      const double away = distance(middle(cell), p);
      if (away >= nearest) continue;
      nearest = away;
      found = k;
    }
  }
  return found;
}

}  // namespace spineloft::descriptive
