#include "engine/image/sketch.h"

#include <algorithm>
#include <cmath>
#include <new>

namespace spineloft::image {
namespace {

// Everything below works on whole numbers, in 1/kInkUnit of a pixel: sums, products and divisions
// of integers come out alike on every processor, whatever a compiler does about fractions.
using Whole = std::int64_t;

constexpr std::array<std::uint8_t, 3> kPaper{255, 255, 255};
constexpr double kFarthest = 16384;  // pixels: squares of distances stay within 64 bits
constexpr Whole kThinnest = 90;      // a line thinner than this radius would fade into the paper
constexpr Whole kPressureSteps = 1024;
constexpr Whole kLightTouch = 256;           // of kPressureSteps: the share of the radius at no pressure
constexpr Whole kFlatness = 24;              // how far the line may be from the smooth curve
constexpr Whole kMostPieces = 48;            // of one bend
constexpr Whole kSharpReach = kInkUnit / 2;  // how far a sharp corner is rounded

Whole wholeOf(double pixels) { return std::llround(std::clamp(pixels, -kFarthest, kFarthest) * kInkUnit); }

/// Rounded division for a positive divisor.
Whole divide(Whole a, Whole b) { return (a >= 0 ? a + b / 2 : a - b / 2) / b; }

struct Node {
  Whole x = 0, y = 0, radius = 0;
  Node operator+(const Node& o) const { return {x + o.x, y + o.y, radius + o.radius}; }
  Node operator-(const Node& o) const { return {x - o.x, y - o.y, radius - o.radius}; }
  Node operator*(Whole s) const { return {x * s, y * s, radius * s}; }
};
Node divide(const Node& a, Whole b) { return {divide(a.x, b), divide(a.y, b), divide(a.radius, b)}; }
Whole dot(const Node& a, const Node& b) { return a.x * b.x + a.y * b.y; }

/// The points as drawn, without those that repeat the one before.
std::vector<Node> nodesOf(const SketchStroke& stroke) {
  const Whole full = wholeOf(stroke.radius);
  std::vector<Node> nodes;
  nodes.reserve(stroke.points.size());
  for (std::size_t i = 0; i < stroke.points.size(); ++i) {
    Whole radius = full;
    if (!stroke.pressure.empty()) {
      const Whole pressed = std::llround(double{stroke.pressure[i]} * kPressureSteps);
      const Whole share = kLightTouch * kPressureSteps + (kPressureSteps - kLightTouch) * pressed;
      radius = divide(full * share, kPressureSteps * kPressureSteps);
    }
    const Node node{wholeOf(stroke.points[i].x), wholeOf(stroke.points[i].y), std::max(radius, kThinnest)};
    if (!nodes.empty() && node.x == nodes.back().x && node.y == nodes.back().y) {
      nodes.back().radius = std::max(nodes.back().radius, node.radius);
    } else {
      nodes.push_back(node);
    }
  }
  return nodes;
}

/// A turn by more than 60° is meant as a corner.
bool isCorner(const Node& before, const Node& at, const Node& after) {
  const Node in = at - before, out = after - at;
  const Whole along = dot(in, out);
  if (along <= 0) return true;
  // cos² < ¼. The squares may exceed 64 bits: each product is rounded once, alike everywhere.
  const double cosine = static_cast<double>(2 * along);
  return cosine * cosine < static_cast<double>(dot(in, in)) * static_cast<double>(dot(out, out));
}

/// Half-way from the corner to its neighbour, or nearly at the corner where that is sharp.
Node cut(const Node& corner, const Node& neighbour, bool sharp) {
  const Node way = neighbour - corner;
  const Whole length = std::max(std::abs(way.x), std::abs(way.y));
  if (!sharp || length <= 2 * kSharpReach) return divide(corner + neighbour, 2);
  return corner + divide(way * kSharpReach, length);
}

void push(std::vector<InkPoint>& line, const Node& node) {
  const InkPoint point{static_cast<std::int32_t>(node.x), static_cast<std::int32_t>(node.y),
                       static_cast<std::int32_t>(node.radius)};
  if (line.empty() || !(line.back() == point)) line.push_back(point);
}

/// A quadratic curve from `a` towards `corner` to `b`, in straight pieces. `a` itself is in the line.
void bend(std::vector<InkPoint>& line, const Node& a, const Node& corner, const Node& b) {
  const Node off = a + b - corner * 2;
  const Whole sag = std::max(std::abs(off.x), std::abs(off.y)) / 4;  // of one straight piece
  Whole pieces = 1;
  while (pieces < kMostPieces && sag > kFlatness * pieces * pieces) ++pieces;
  for (Whole k = 1; k <= pieces; ++k) {
    const Whole rest = pieces - k;
    push(line, divide(a * (rest * rest) + corner * (2 * k * rest) + b * (k * k), pieces * pieces));
  }
}

/// How much of each pixel of a box the stroke covers, 0…255. Picture pixels.
struct Cover {
  int left = 0, top = 0, right = 0, bottom = 0;  ///< right and bottom are beyond the last
  std::vector<std::uint8_t> share;
  bool empty() const { return left >= right || top >= bottom; }
  int width() const { return right - left; }
};

int pixelBelow(Whole at) { return static_cast<int>(at >> 8); }
static_assert(kInkUnit == 1 << 8);

Cover coverOf(Size size, std::span<const InkPoint> line) {
  Cover box{size.width, size.height, 0, 0, {}};
  for (const InkPoint& p : line) {
    const Whole reach = p.radius + kInkUnit;
    box.left = std::min(box.left, pixelBelow(p.x - reach));
    box.right = std::max(box.right, pixelBelow(p.x + reach) + 2);
    box.top = std::min(box.top, pixelBelow(p.y - reach));
    box.bottom = std::max(box.bottom, pixelBelow(p.y + reach) + 2);
  }
  box.left = std::max(box.left, 0);
  box.top = std::max(box.top, 0);
  box.right = std::min(box.right, size.width);
  box.bottom = std::min(box.bottom, size.height);
  if (!box.empty()) {
    box.share.assign(static_cast<std::size_t>(box.width()) * static_cast<std::size_t>(box.bottom - box.top), 0);
  }
  return box;
}

/// A straight piece of the line, round at both ends.
class Piece {
 public:
  Piece(const InkPoint& a, const InkPoint& b)
      : a_(a),
        dx_(Whole{b.x} - a.x),
        dy_(Whole{b.y} - a.y),
        widening_(Whole{b.radius} - a.radius),
        square_(dx_ * dx_ + dy_ * dy_),
        reach_(std::max(a.radius, b.radius) + kInkUnit / 2) {}

  void paint(Cover& cover) const {
    const Whole low = std::min<Whole>(a_.y, a_.y + dy_) - reach_;
    const Whole high = std::max<Whole>(a_.y, a_.y + dy_) + reach_;
    const int top = std::max(cover.top, pixelBelow(low));
    const int bottom = std::min(cover.bottom, pixelBelow(high) + 2);
    for (int y = top; y < bottom; ++y) paintRow(cover, y);
  }

 private:
  void paintRow(Cover& cover, int row) const {
    const Whole y = Whole{row} * kInkUnit;
    // The stretch of the piece that is near enough to this row, and what it reaches sideways.
    Whole x0 = a_.x, x1 = a_.x + dx_;
    if (dy_ != 0) {
      const auto at = [&](Whole height) {
        const Whole along = std::clamp<Whole>(dy_ > 0 ? height - a_.y : a_.y - height, 0, std::abs(dy_));
        return a_.x + divide(dx_ * along, std::abs(dy_));
      };
      x0 = at(y - reach_);
      x1 = at(y + reach_);
    }
    const int left = std::max(cover.left, pixelBelow(std::min(x0, x1) - reach_));
    const int right = std::min(cover.right, pixelBelow(std::max(x0, x1) + reach_) + 2);
    std::uint8_t* share =
        cover.share.data() + static_cast<std::ptrdiff_t>(row - cover.top) * static_cast<std::ptrdiff_t>(cover.width());
    for (int x = left; x < right; ++x) {
      std::uint8_t& known = share[x - cover.left];
      if (known < 255) known = std::max(known, covered(Whole{x} * kInkUnit, y));
    }
  }

  /// Share of the pixel round (x, y): by how far its centre is inside, from −½ to ½ pixel.
  std::uint8_t covered(Whole x, Whole y) const {
    constexpr Whole kAlong = 1 << 14;
    Whole px = x - a_.x, py = y - a_.y, radius = a_.radius;
    if (square_ > 0) {
      const Whole along = std::clamp<Whole>(px * dx_ + py * dy_, 0, square_);
      const Whole t = along == square_ ? kAlong : along * kAlong / square_;
      px -= (dx_ * t) / kAlong;
      py -= (dy_ * t) / kAlong;
      radius += widening_ * t / kAlong;
    }
    const Whole square = px * px + py * py;
    const Whole outside = radius + kInkUnit / 2, inside = radius - kInkUnit / 2;
    if (square >= outside * outside) return 0;
    if (inside > 0 && square <= inside * inside) return 255;
    // The root of a whole number below 2^53 is rounded correctly, so its floor is the same anywhere.
    const Whole distance = static_cast<Whole>(std::sqrt(static_cast<double>(square)));
    return static_cast<std::uint8_t>(std::clamp<Whole>(outside - distance, 0, 255));
  }

  InkPoint a_;
  Whole dx_, dy_, widening_, square_, reach_;
};

void blend(Image& paper, const Cover& cover, std::array<std::uint8_t, 3> colour) {
  for (int y = cover.top; y < cover.bottom; ++y) {
    const std::size_t row = static_cast<std::size_t>(y - cover.top) * static_cast<std::size_t>(cover.width());
    const std::uint8_t* share = cover.share.data() + row;
    std::uint8_t* pixel =
        paper.pixels.data() + 4 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(paper.width) +
                                   static_cast<std::size_t>(cover.left));
    for (int i = 0; i < cover.width(); ++i, pixel += 4) {
      const int ink = share[i];
      if (ink == 0) continue;
      for (std::size_t k = 0; k < 3; ++k) {
        pixel[k] = static_cast<std::uint8_t>((pixel[k] * (255 - ink) + colour[k] * ink + 127) / 255);
      }
    }
  }
}

void draw(Image& paper, const SketchStroke& stroke) {
  const std::vector<InkPoint> line = inkLine(stroke);
  Cover cover = coverOf({paper.width, paper.height}, line);
  if (cover.empty()) return;
  for (std::size_t i = 0; i + 1 < line.size(); ++i) Piece(line[i], line[i + 1]).paint(cover);
  if (line.size() == 1) Piece(line[0], line[0]).paint(cover);
  blend(paper, cover, stroke.erase ? kPaper : stroke.colour);
}

bool isPaperSide(int side) { return side >= kLeastSketchSide && side <= kMostSketchSide; }

}  // namespace

bool isValid(const SketchStroke& stroke) {
  const auto sound = [](float p) { return p >= 0 && p <= 1; };
  return !stroke.points.empty() && stroke.points.size() <= kMostSketchPoints &&
         (stroke.pressure.empty() || stroke.pressure.size() == stroke.points.size()) &&
         std::ranges::all_of(stroke.pressure, sound) && stroke.radius >= 0.5 && stroke.radius <= 100 &&
         std::ranges::all_of(stroke.points, [](PicturePoint p) { return isFinite(p); });
}

std::vector<InkPoint> inkLine(const SketchStroke& stroke) {
  std::vector<InkPoint> line;
  if (!isValid(stroke)) return line;
  const std::vector<Node> nodes = nodesOf(stroke);
  push(line, nodes.front());
  for (std::size_t i = 1; i + 1 < nodes.size(); ++i) {
    const Node &before = nodes[i - 1], &at = nodes[i], &after = nodes[i + 1];
    const bool sharp = isCorner(before, at, after);
    const Node from = cut(at, before, sharp), to = cut(at, after, sharp);
    push(line, from);
    bend(line, from, at, to);
  }
  push(line, nodes.back());
  return line;
}

Result<Picture> drawSketch(Size size, std::span<const Box<SketchStroke>> strokes) {
  if (!isPaperSide(size.width) || !isPaperSide(size.height)) {
    return Failure{Error::ValueOutOfRange, "paper size"};
  }
  try {
    Picture paper;
    paper.width = paper.working.width = size.width;
    paper.height = paper.working.height = size.height;
    paper.working.pixels.assign(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height), 255);
    return drawMore(std::move(paper), strokes);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<Picture> drawMore(Picture sketch, std::span<const Box<SketchStroke>> strokes) {
  if (strokes.size() > kMostSketchStrokes ||
      !std::ranges::all_of(strokes, [](const SketchStroke& stroke) { return isValid(stroke); })) {
    return Failure{Error::ValueOutOfRange, "pen stroke"};
  }
  try {
    for (const SketchStroke& stroke : strokes) draw(sketch.working, stroke);
    return sketch;
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::image
