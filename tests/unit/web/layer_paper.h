// A page with a sheet of paper and the tool Layers in hand.
#pragma once

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>

#include "tests/unit/web/rig.h"

namespace spineloft::test {

inline document::StackRecipe layersOf(Rig& rig) {
  const document::Document document = rig.shared();
  REQUIRE_FALSE(document.parts.empty());
  REQUIRE(document::stackOf(*document.parts.back()) != nullptr);
  return *document::stackOf(*document.parts.back());
}

/// A page with a sheet of paper and the tool in hand.
struct Paper : Rig {
  explicit Paper(platform::CanvasSize size = {1200, 700, 1}) : Rig(size) {
    REQUIRE(works("new-sketch", R"({"width": 400, "height": 300})"));
    REQUIRE(works("layers"));
  }

  app::Json sheet() { return *state().find("sheet"); }
  /// A point of the sheet on the canvas, from what state() says of it.
  app::ClientPoint onCanvas(double x, double y) {
    const app::Json now = sheet();
    const auto corner = [&](std::size_t i) {
      const app::Json::Array& p = *(*now.find("corners")->array())[i].array();
      return app::ClientPoint{*p[0].number(), *p[1].number()};
    };
    // Projective: the sheet's corners are the images of those of the square [-1, 1]².
    const app::ClientPoint a = corner(0), b = corner(1), c = corner(2), d = corner(3);
    const app::ClientPoint e = a - b + c - d, f = b - c, g = d - c;
    const double det = f.x * g.y - g.x * f.y;
    const double p = (e.x * g.y - g.x * e.y) / det, q = (f.x * e.y - e.x * f.y) / det;
    const double u = (x + 1) / 2, v = (y + 1) / 2, w = p * u + q * v + 1;
    return (a + (b - a + b * p) * u + (d - a + d * q) * v) / w;
  }
  /// A round line on the sheet, in shares of its half side.
  void circle(double x, double y, double radius, platform::Device device = {}) {
    using platform::PointerKind;
    for (int i = 0; i <= 60; ++i) {
      const double angle = 2 * std::numbers::pi * i / 60;
      const app::ClientPoint at = onCanvas(x + radius * std::cos(angle), y + radius * std::sin(angle));
      pointer(i == 0 ? PointerKind::Down : PointerKind::Move, at.x, at.y, device);
      lastX = at.x;
      lastY = at.y;
      if (i % 20 == 1) settle();  // frames are drawn meanwhile
    }
    lift(device);
    settle();
  }
  double sheetAt() { return *sheet().number("at"); }
};

}  // namespace spineloft::test
