#include "engine/pipeline/outline_match.h"

#include <doctest/doctest.h>

#include "engine/shape/shape.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/outlines.h"

using namespace spineloft;
using namespace spineloft::pipeline;

TEST_CASE("silhouettes are compared with outlines in the view that they are seen in") {
  shape::ShapeParams params;
  params.primitive = shape::Primitive::Box;
  params.axis = {{100, 300}, {100, 100}};
  params.width = 100;
  params.depth.ratio = 0.5;
  const mesh::TriMesh box = shape::makeShape(params, {}, {400, 400}).value().mesh;
  testing::requireLawful(box);
  const geometry::View side{geometry::ViewFrom::Right, 80, 2, 0};
  const auto front = matchOutline(box, std::nullopt, {testing::rectangle(50, 100, 150, 300)});
  CHECK(front.iou >= 0.999);
  CHECK(front.largest <= 1e-3);
  // Half as deep as wide, on a picture half as large.
  CHECK(matchOutline(box, side, {testing::rectangle(67.5, 50, 92.5, 150)}).iou >= 0.998);
  // Moved by a fifth of its width: 80 of 120; and by a tenth of its longer side.
  const auto moved = matchOutline(box, std::nullopt, {testing::rectangle(70, 100, 170, 300)});
  CHECK(moved.iou == doctest::Approx(80.0 / 120).epsilon(2e-3));
  CHECK(moved.largest == doctest::Approx(0.1).epsilon(1e-2));
  CHECK(moved.mean < moved.largest);
  // Two lines are joined at their ends.
  const geometry::Contours lines{{{50, 100}, {50, 300}}, {{150, 100}, {150, 300}}};
  CHECK(matchOutline(box, std::nullopt, lines).iou >= 0.999);
  CHECK(matchOutline(box, std::nullopt, {}).iou == 0);
}
