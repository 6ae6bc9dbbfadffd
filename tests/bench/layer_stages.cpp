#include "tests/bench/layer_stages.h"

#include <cmath>
#include <cstdlib>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/loft/loft.h"
#include "engine/pipeline/derive.h"
#include "engine/stack/stack.h"
#include "engine/vision/edges.h"
#include "tests/bench/must.h"
#include "tests/bench/scene.h"

namespace spineloft::bench {
namespace {

constexpr image::Size kPicture{800, 800};

stack::Curve circle(double radius, SectionPoint centre = {}) {
  stack::Curve curve;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * std::numbers::pi * i / 8;
    curve.through.push_back(centre + SectionPoint{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return curve;
}

stack::Plane level(double height, std::vector<stack::Curve> curves) {
  stack::Plane plane;
  plane.origin = ModelPoint{0, 0, height};
  plane.curves = std::move(curves);
  return plane;
}

std::vector<stack::Plane> vase() {
  std::vector<stack::Plane> planes;
  for (int i = 0; i < 9; ++i) planes.push_back(level(40.0 * i, {circle(70 + 30 * std::sin(0.9 * i))}));
  return planes;
}
std::vector<stack::Plane> fork() {
  return {level(0, {circle(100)}), level(300, {circle(70, {-120, 0}), circle(70, {120, 0})})};
}
std::vector<stack::Plane> hand() {
  std::vector<stack::Curve> fingers, tips;
  for (int i = 0; i < 5; ++i) {
    fingers.push_back(circle(19, {-100.0 + 50 * i, 0}));
    tips.push_back(circle(14, {-126.0 + 63 * i, 5}));
  }
  stack::Curve palm;
  palm.through = {{135, 0}, {90, 38}, {-90, 38}, {-135, 0}, {-90, -38}, {90, -38}};
  return {level(0, {circle(60)}), level(150, {palm}), level(260, fingers), level(400, tips)};
}

/// What a triangle of a loft of 100 ribs takes, ms.
double loftTriangle(Report& report) {
  constexpr image::Size kSize{512, 384};
  const Progress progress;
  const image::EdgeMap edges = must(vision::detectEdges(tubePicture(kSize), {}, progress));
  document::LoftRecipe recipe;
  recipe.stroke = tubeStroke(kSize, 200);
  recipe.spine.ribs = 100;
  const pipeline::PartShape shape = must(pipeline::shapePart(recipe, edges, kSize, progress));
  const loft::PosedSpine atRest = must(loft::poseSpine(shape.spine, {}));
  loft::LoftParams params;
  params.sectionPoints = 64;
  loft::LoftWorkspace memory;
  mesh::TriMesh mesh;
  const double time = report.stage("loft beside layers", 201, [&](int) {
    if (!loft::loftRibs({shape.ribs, kSize, params}, atRest, memory, mesh).ok()) std::exit(1);
  });
  return time / static_cast<double>(mesh.triangles.size());
}

}  // namespace

void reportLayerStages(Report& report) {
  const double triangle = loftTriangle(report);
  const auto stage = [&](const std::string& name, const std::vector<stack::Plane>& planes, double melt) {
    stack::StackParams params;
    params.melt = melt;
    const auto made = [&] { return must(stack::stackPlanes({planes, {}, params}, kPicture)); };
    const auto triangles = static_cast<double>(made().mesh.triangles.size());
    const double time = report.stage(name, 21, [&](int) { made(); });
    report.value(name + ", ratio to a loft of as many triangles", time / (triangle * triangles));
  };
  stage("vase of layers", vase(), 0);
  for (const auto& [melt, words] : {std::pair{0.0, ""}, {0.5, ", rounded"}}) {
    stage(std::string("fork") + words, fork(), melt);
    stage(std::string("hand of layers") + words, hand(), melt);
  }
  const document::LatheRecipe spun{{PictureId{1}, {{{40, 100}, {200, 120}, {240, 400}, {40, 420}}}, 0},
                                   {{20, 0}, {20, 499}}};
  const auto turned = [&] { return must(pipeline::regionStage(spun, kPicture)); };
  const auto triangles = static_cast<double>(turned().mesh.triangles.size());
  const double time = report.stage("spun bowl", 51, [&](int) { turned(); });
  report.value("spun bowl, ratio to a loft of as many triangles", time / (triangle * triangles));
}

}  // namespace spineloft::bench
