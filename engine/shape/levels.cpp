#include "engine/shape/levels.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>
#include <utility>

namespace spineloft::shape {
namespace {

/// Shares of the size: no width, and least half width or depth of a section.
constexpr double kNoWidth = 1e-3, kLeastHalf = 2e-4;

constexpr int kPrimitivePoints = 256;

using ToLine = std::function<SectionPoint(PicturePoint)>;

bool isFinite(const geometry::Contours& lines) {
  return std::ranges::all_of(lines, [](const auto& line) {
    return std::ranges::all_of(line, [](PicturePoint p) { return spineloft::isFinite(p); });
  });
}

bool isUpright(const Axis& axis) {
  const PicturePoint way = axis.to - axis.from;
  return std::abs(way.y) >= std::abs(way.x);
}

/// `square`: the axis of the picture that is nearest instead of the drawn one.
AxisFrame frameOf(const Axis& axis, bool square) {
  PicturePoint along = normalized(axis.to - axis.from);
  if (square) {
    along = isUpright(axis) ? PicturePoint{0, along.y < 0 ? -1.0 : 1.0} : PicturePoint{along.x < 0 ? -1.0 : 1.0, 0};
  }
  return {axis.from, along, {-along.y, along.x}};
}

/// The primitive as seen from the front, picture pixels.
geometry::Contours primitiveOutline(const ShapeParams& params) {
  const AxisFrame frame = frameOf(params.axis, false);
  const double length = distance(params.axis.from, params.axis.to), endShare = std::min(0.5, params.width / 2 / length);
  geometry::Contours lines(2);
  for (int i = 0; i <= kPrimitivePoints; ++i) {
    const double share = (1 - std::cos(std::numbers::pi * i / kPrimitivePoints)) / 2;
    const double half = halfWidthOf(params.primitive, share, endShare) * params.width / 2;
    lines[0].push_back(frame.out({-half, share * length}));
    lines[1].push_back(frame.out({half, share * length}));
  }
  const bool closed = lines[0].front() == lines[1].front() && lines[0].back() == lines[1].back();
  if (closed) {
    lines[0].insert(lines[0].end(), lines[1].rbegin(), lines[1].rend());
    lines.pop_back();
  }
  return lines;
}

/// How a pixel of the outline's picture is put into x, y of its lines.
ToLine toLine(const AxisFrame& frame, const std::optional<geometry::View>& view, Role role) {
  if (!view) return [frame](PicturePoint p) { return frame.in(p); };
  return [frame, given = *view, role](PicturePoint p) -> SectionPoint {
    const ModelPoint at = geometry::inModel(given, p);
    const SectionPoint front = frame.in({at.x, -at.y});
    if (role == Role::Width) return front;
    return role == Role::Depth ? SectionPoint{at.z, front.y} : SectionPoint{front.x, at.z};
  };
}

Result<SideLines> read(const geometry::Contours& lines, const ToLine& to, const char* name) {
  std::vector<Line> out;
  for (const auto& line : lines) {
    Line& one = out.emplace_back();
    for (const PicturePoint p : line) one.push_back(to(p));
  }
  return sideLinesOf(std::move(out), name);
}

/// The closed outline as a section: as wide and as deep as the square.
struct DrawnSection {
  sections::SectionShape shape;
  double ratio = 1;
};
Result<DrawnSection> drawnSection(const SeenOutline& outline, const AxisFrame& frame) {
  if (outline.lines.size() != 1) {
    return Failure{Error::ShapeInvalid, "the outline that is seen along the shape must be one closed line"};
  }
  const ToLine to = toLine(frame, outline.view, Role::Section);
  std::vector<SectionPoint> points;
  for (const PicturePoint p : outline.lines.front()) points.push_back(to(p));
  const auto [left, right] = std::ranges::minmax(points, {}, &SectionPoint::x);
  const auto [back, front] = std::ranges::minmax(points, {}, &SectionPoint::y);
  const double width = right.x - left.x, depth = front.y - back.y;
  if (!(width > 1) || !(depth > 1)) return Error::RegionEmpty;
  for (SectionPoint& p : points) {
    p = {2 * (p.x - left.x) / width - 1, 2 * (p.y - back.y) / depth - 1};
  }
  DrawnSection section;
  section.shape.contours = {std::move(points)};
  section.ratio = depth / width;
  if (Status sound = sections::checkShape(section.shape); !sound.ok()) return sound.failure();
  return section;
}

/// Shares at which sections stand, from 0 to 1: after equal ways of the line that goes farthest meanwhile, so that a
/// round end has them as near to each other as it turns; the nearest ones on corners.
std::vector<double> sharesOf(std::span<const SideLine* const> lines, int count) {
  std::vector<double> places{0, 1}, corners;
  for (const SideLine* line : lines) {
    places.insert(places.end(), line->shares().begin(), line->shares().end());
    const std::vector<double> own = line->corners();
    corners.insert(corners.end(), own.begin(), own.end());
  }
  std::ranges::sort(places);
  places.erase(std::ranges::unique(places).begin(), places.end());
  std::vector<double> ways(places.size(), 0.0);
  for (std::size_t i = 1; i < places.size(); ++i) {
    double farthest = 0;
    for (const SideLine* line : lines) {
      farthest = std::max(farthest, distance(line->at(places[i - 1]), line->at(places[i])));
    }
    ways[i] = ways[i - 1] + farthest;
  }
  std::vector<double> shares{0};
  for (int i = 1; i < count; ++i) {
    const double way = ways.back() * i / count;
    const auto above = static_cast<std::size_t>(std::ranges::lower_bound(ways, way) - ways.begin());
    const double part = (way - ways[above - 1]) / (ways[above] - ways[above - 1]);
    shares.push_back(std::lerp(places[above - 1], places[above], part));
  }
  shares.push_back(1);
  for (const double corner : corners) {
    const auto nearest = std::ranges::min_element(shares, {}, [&](double s) { return std::abs(s - corner); });
    if (nearest != shares.begin() && nearest + 1 != shares.end()) *nearest = corner;
  }
  return shares;
}

/// Half the depth of a level where nothing is drawn of it.
double halfDepthOf(const ShapeParams& params, double ratio, double share, const Level& level) {
  if (params.depth.mode == DepthMode::Round) return ratio * level.halfWidth();
  const double length = distance(params.axis.from, params.axis.to);
  return ratio * params.width / 2 * halfWidthOf(params.primitive, share, std::min(0.5, params.width / 2 / length));
}

/// No section is thinner than a hair; none is turned inside out. Error: ShapeInvalid.
Status widen(Level& level, double size) {
  const double least = kLeastHalf * size;
  const auto apart = [&](SectionPoint& a, SectionPoint& b) {
    const double middle = (a.x + b.x) / 2, half = std::max(least, (b.x - a.x) / 2);
    a.x = middle - half;
    b.x = middle + half;
  };
  constexpr double kMostCrossing = 0.01;
  if (level.halfWidth() < -kMostCrossing * size || level.halfDepth() < -kMostCrossing * size) {
    return {Error::ShapeInvalid, "the two lines of an outline cross"};
  }
  apart(level.low, level.high);
  apart(level.back, level.front);
  return Done{};
}

/// The outlines by what they say.
struct Drawn {
  const SeenOutline *width = nullptr, *depth = nullptr, *section = nullptr;
};
Result<Drawn> sorted(const ShapeParams& params, std::span<const SeenOutline> outlines) {
  Drawn drawn;
  for (const SeenOutline& outline : outlines) {
    if (!isFinite(outline.lines)) return Error::StrokeNotFinite;
    if (outline.lines.empty() || outline.lines.size() > 2) {
      return Failure{Error::ShapeInvalid, "an outline is one closed line or two open ones"};
    }
    const Role role = roleOf(params.axis, outline.view);
    const SeenOutline*& place = role == Role::Width ? drawn.width : role == Role::Depth ? drawn.depth : drawn.section;
    if (place != nullptr) return Failure{Error::ShapeInvalid, "two outlines say the same of the shape: remove one"};
    place = &outline;
  }
  return drawn;
}

}  // namespace

Role roleOf(const Axis& axis, const std::optional<geometry::View>& view) {
  if (!view || view->from == geometry::ViewFrom::Back) return Role::Width;
  return isUpright(axis) == (view->from != geometry::ViewFrom::Top) ? Role::Depth : Role::Section;
}

Result<Levels> levelsOf(const ShapeParams& params, std::span<const SeenOutline> outlines) {
  const Result<Drawn> known = sorted(params, outlines);
  if (!known.ok()) return known.failure();
  const Drawn& drawn = known.value();
  Levels levels;
  levels.frame = frameOf(params.axis, drawn.depth != nullptr);
  const ToLine fromFront = toLine(levels.frame, std::nullopt, Role::Width);
  const Result<SideLines> width =
      drawn.width ? read(drawn.width->lines, toLine(levels.frame, drawn.width->view, Role::Width), "the outline")
                  : read(primitiveOutline(params), fromFront, "the shape");
  if (!width.ok()) return width.failure();
  std::optional<SideLines> depth;
  if (drawn.depth != nullptr) {
    Result<SideLines> side =
        read(drawn.depth->lines, toLine(levels.frame, drawn.depth->view, Role::Depth), "the side outline");
    if (!side.ok()) return side.failure();
    depth = std::move(side).value();
    if (Status fits = depth->stretchTo(width.value().start(), width.value().end()); !fits.ok()) return fits.failure();
  }
  levels.section = params.section.value_or(sections::SectionShape(sectionOf(params.primitive)));
  double ratio = params.depth.ratio;
  if (drawn.section != nullptr) {
    Result<DrawnSection> section = drawnSection(*drawn.section, levels.frame);
    if (!section.ok()) return section.failure();
    levels.section = std::move(section.value().shape);
    ratio = section.value().ratio;
  }
  levels.size = std::max(width.value().length(), width.value().widest());
  const SideLines& front = width.value();
  std::vector<const SideLine*> lines{&front.low, &front.high};
  if (depth) lines.insert(lines.end(), {&depth->low, &depth->high});
  for (const double share : sharesOf(lines, params.levels)) {
    Level level{front.low.at(share), front.high.at(share), {}, {}, std::lerp(front.start(), front.end(), share)};
    const double half = depth ? 0 : halfDepthOf(params, ratio, share, level);
    level.back = depth ? depth->low.at(share) : SectionPoint{-half, level.place};
    level.front = depth ? depth->high.at(share) : SectionPoint{half, level.place};
    levels.all.push_back(level);
  }
  const auto isTip = [&](const Level& level) {
    return std::max(level.halfWidth(), level.halfDepth()) < kNoWidth * levels.size;
  };
  levels.startTip = isTip(levels.all.front());
  levels.endTip = isTip(levels.all.back());
  for (Level& level : levels.all) {
    if (Status wide = widen(level, levels.size); !wide.ok()) return wide.failure();
  }
  return levels;
}

}  // namespace spineloft::shape
