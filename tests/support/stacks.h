// Stacks for tests: simple curves, planes and rails, and what becomes of them.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/stack/stack.h"

namespace spineloft::testing {

inline constexpr image::Size kStackPaper{400, 400};

/// Straight lines through these, closed.
inline stack::Curve polygonCurve(std::vector<SectionPoint> corners) { return {std::move(corners), {true, {}}}; }

inline stack::Curve rectangle(double width, double height) {
  return polygonCurve({{0, 0}, {width, 0}, {width, height}, {0, height}});
}

inline stack::Curve circleCurve(double radius, SectionPoint centre = {}) {
  stack::Curve curve;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * std::numbers::pi * i / 8;
    curve.through.push_back(centre + SectionPoint{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return curve;
}

inline stack::Curve ribbon(std::vector<SectionPoint> line, double width, bool corners = true) {
  stack::Curve curve{std::move(line), {corners, {}}};
  curve.open = true;
  curve.as = stack::CurveUse::Ribbon;
  curve.width = width;
  return curve;
}

inline stack::Curve ground(std::vector<SectionPoint> line, double base, bool corners = true) {
  stack::Curve curve{std::move(line), {corners, {}}};
  curve.open = true;
  curve.as = stack::CurveUse::Ground;
  curve.base = base;
  return curve;
}

inline stack::Plane railPlane(double at, std::vector<stack::Curve> curves,
                              sections::BlendKind blend = sections::BlendKind::Linear) {
  stack::Plane plane;
  plane.at = at;
  plane.curves = std::move(curves);
  plane.blend = {blend, {}};
  return plane;
}

/// Away from the viewer: x and y of the planes are those of space.
inline stack::Rail railAhead(double length) { return {{{100, -100, 0}, {100, -100, -length}}, false}; }

inline mesh::TriMesh stacked(const std::vector<stack::Plane>& planes, const stack::Rail& rail,
                             const stack::StackParams& params = {}) {
  const Result<stack::Stacked> made = stack::stackPlanes({planes, rail, params}, kStackPaper);
  REQUIRE_MESSAGE(made.ok(), failureSentence(made.ok() ? Failure{} : made.failure()));
  return made.value().mesh;
}

/// That it makes no solid, and says so with these words.
inline void requireRefused(const std::vector<stack::Plane>& planes, const stack::Rail& rail,
                           const stack::StackParams& params, const std::string& words) {
  const Result<stack::Stacked> made = stack::stackPlanes({planes, rail, params}, kStackPaper);
  REQUIRE_MESSAGE(!made.ok(), words);
  const std::string sentence = failureSentence(made.failure());
  CHECK_MESSAGE(sentence.find(words) != std::string::npos, sentence);
}

}  // namespace spineloft::testing
