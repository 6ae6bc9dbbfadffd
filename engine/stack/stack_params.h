// What a person draws for a stack: curves of true size on planes in space, and the rail that planes stand on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/geometry/turn.h"
#include "engine/sections/blend.h"
#include "engine/sections/drawing.h"
#include "engine/sections/ends.h"

namespace spineloft::stack {

/// Which points of a curve are corners: the curve turns sharply there, and is straight between two of them.
struct Corners {
  bool all = false;
  std::vector<std::uint32_t> at;  ///< else: indices of points
  bool operator==(const Corners&) const = default;
};

/// What becomes of a curve: it is closed; or it ends and is drawn with a pen of some width, whose ends are straight; or
/// it ends and is filled down to a line. Values are saved in files: only ever append.
enum class CurveUse : std::uint8_t { Closed, Ribbon, Ground, kCount };
struct CurveUseName {
  CurveUse use;
  std::string_view key;
};
/// "closed", "ribbon", "ground": in files.
std::span<const CurveUseName> curveUseNames();

/// A curve through a few points, as sections::DrawnCurve has it, of true size: plane coordinates in picture pixels.
/// What is within others on a plane is a hole (even-odd). Open curves end at their last point (sections::openStretchOf)
/// and are a ribbon or ground (cross-sections-hughes 5.1); closed ones are neither.
struct Curve {
  std::vector<SectionPoint> through;
  Corners corners;
  bool open = false;
  CurveUse as = CurveUse::Closed;
  double width = 0;  ///< of a ribbon, picture pixels, > 0
  double base = 0;   ///< of ground: the y of the line down to which it is filled
  /// Where it parts into several curves of the next plane, and where several of the plane before join into it: share of
  /// the way from it to them, 0…1; none: chosen.
  std::optional<double> forkAt = {}, joinAt = {};
  bool operator==(const Curve&) const = default;
};

/// A person's word on whether a curve becomes one of the next plane that has curves. On a closed rail the first plane
/// follows the last one.
struct CurveLink {
  std::uint32_t from = 0, to = 0;  ///< curves of the plane and of the next, from 0
  bool on = true;                  ///< false: it does not
  bool operator==(const CurveLink&) const = default;
};

/// A plane in space with the curves on it. On the rail its origin is the rail's point, x runs to the right of the way
/// along the rail as seen from the viewer, y to the viewer, and `turn` turns it from there. Off the rail its origin is
/// `origin`, x, y and the normal are those of ModelSpace, turned.
struct Plane {
  double at = 0;                     ///< on the rail: share of its length, 0…1
  std::optional<ModelPoint> origin;  ///< off the rail
  geometry::Turn turn;
  std::vector<Curve> curves;
  sections::Blend blend{sections::BlendKind::Flow, {}};  ///< from here to the next plane
  std::vector<CurveLink> links;  ///< where they differ from what is chosen (stackPlanes), each once; at most kMostLinks
  bool operator==(const Plane&) const = default;
};

/// The line that planes stand on: cubic arcs through its points, a circle where they lie on one. Without points there
/// is none.
struct Rail {
  std::vector<ModelPoint> points;
  bool closed = false;
  bool operator==(const Rail&) const = default;
};

/// A run of planes on the rail that stands there several times (cross-sections-hughes 6.1). The k-th copy, from 0,
/// stands k × spacing farther along; planes after the run stay where they are.
struct Pattern {
  std::uint32_t first = 0, last = 0;  ///< of the planes, from 0
  std::uint32_t times = 1;            ///< how often it stands there in all, 1…kMostTimes
  double spacing = 0;                 ///< from one copy to the next, share of the rail, 0…1
  bool operator==(const Pattern&) const = default;
};

/// How uneven the surface is: every ring is moved in its plane, square to itself, by smooth noise
/// (geometry/value_noise.h) at its places in space.
struct Rough {
  double amount = 0;       ///< farthest, picture pixels, 0…kMostRough; 0: smooth
  double size = 32;        ///< from bump to bump, about, picture pixels, kLeastBump…kFarOut
  std::uint32_t seed = 0;  ///< another one gives other bumps
  bool keepDrawn = false;  ///< curves that were drawn stay as they are; it fades within `size` of them
  bool operator==(const Rough&) const = default;
};

struct StackParams {
  sections::CapStyle startCap = sections::CapStyle::Flat, endCap = sections::CapStyle::Flat;
  int sides = 128;                ///< points round a curve, kLeastSides…kMostSides
  int capRings = 6;               ///< of round ends
  std::vector<Pattern> patterns;  ///< at most kMostPatterns, of different planes
  Rough rough;
  double melt = 0;  ///< how far about the creases of forks the surface is rounded: in mean radii of their curves, 0…1
  bool operator==(const StackParams&) const = default;
};

inline constexpr std::size_t kMostPlanes = 64, kMostCurves = sections::kMostContours,
                             kMostThrough = sections::kMostDrawnPoints, kMostRailPoints = 256,
                             kMostPoints = 50000,  ///< of all curves, patterns written out
    kMostStanding = 256;                           ///< curves, where patterns are written out
inline constexpr std::size_t kMostPatterns = 16, kMostLinks = kMostCurves * kMostCurves;
inline constexpr std::uint32_t kMostTimes = 1000;
inline constexpr double kFarOut = 1e5;  ///< of any coordinate, picture pixels
inline constexpr double kMostRough = 1000, kLeastBump = 1;
inline constexpr int kLeastSides = 12, kMostSides = 256, kMostCapRings = 32;

/// In range.
bool isValid(const StackParams& params);
bool isValid(const Rail& rail);
bool isValid(const Curve& curve);
/// Numbers finite and in range, not too many; whether the curves make sections is only known when they are stacked.
bool isValid(const Plane& plane);
/// Whether every pattern repeats planes that there are, each at most once, on the rail and within it, and does not make
/// too many curves. Errors: StackInvalid, which names pattern and sheet as a person counts them and says what to do.
Status checkPatterns(const std::vector<Plane>& planes, const std::vector<Pattern>& patterns);
/// The plane that follows one of them, with curves; none behind the last.
std::optional<std::size_t> nextDrawn(const std::vector<Plane>& planes, bool closed, std::size_t plane);
/// Whether the links of a plane are of curves that it and the next one have, each once. Errors: StackInvalid, which
/// names sheet and curves.
Status checkLinks(const std::vector<Plane>& planes, bool closed, std::size_t plane);
/// At least one plane with a curve, numbers in range, links between curves that there are, patterns as above. Errors:
/// ValueOutOfRange, StackInvalid, with what is missing or wrong.
Status checkPlanes(const std::vector<Plane>& planes, const Rail& rail, const std::vector<Pattern>& patterns);

}  // namespace spineloft::stack
