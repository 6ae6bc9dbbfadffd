#include "tests/bench/bridge_stages.h"

#include <cmath>
#include <numbers>
#include <vector>

#include "engine/bridge/bridge.h"
#include "engine/document/update.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/derive.h"
#include "tests/bench/must.h"

namespace spineloft::bench {
namespace {

document::DrawShape ball(PicturePoint middle, double size) {
  shape::ShapeParams params;
  params.axis = {{middle.x, middle.y + size / 2}, {middle.x, middle.y - size / 2}};
  params.width = size;
  return {PictureId{1}, params};
}

/// A circle on a ball whose middle lies in the picture's plane, round the place where a direction leaves it.
std::vector<ModelPoint> rim(PicturePoint middle, double size, ModelPoint out, double radius) {
  out = normalized(out);
  const ModelPoint up = normalized(cross(ModelPoint{0, 0, 1}, out)), side = cross(out, up);
  const ModelPoint centre = ModelPoint{middle.x, -middle.y, 0} + out * std::sqrt(size * size / 4 - radius * radius);
  std::vector<ModelPoint> points;
  for (int i = 0; i < 16; ++i) {
    const double a = 2 * std::numbers::pi * i / 16;
    points.push_back(centre + up * (radius * std::cos(a)) + side * (radius * std::sin(a)));
  }
  return points;
}

}  // namespace

void reportBridgeStages(Report& report) {
  document::Document document = must(document::update({}, document::AddSketch{"Paper", {800, 600}}));
  document = must(document::update(document, ball({200, 300}, 240)));
  document = must(document::update(document, ball({600, 280}, 200)));
  pipeline::Cache cache;
  const pipeline::Derived derived = must(pipeline::deriveWithEdges(document, cache, Progress()));
  const mesh::TriMesh &one = derived.parts[0].shape->mesh, &two = derived.parts[1].shape->mesh;
  const auto from = rim({200, 300}, 240, {1, 0.1, 0}, 50), to = rim({600, 280}, 200, {-1, -0.1, 0}, 50);
  const auto up = rim({200, 300}, 240, {-1, 0.6, 0}, 20), down = rim({200, 300}, 240, {-1, -0.6, 0}, 20);
  bridge::Bridge made;
  report.value("triangles of both hosts", static_cast<double>(one.triangles.size() + two.triangles.size()));
  report.stage("bridge", 51, [&](int) { made = must(bridge::makeBridge({one, from}, {two, to}, {}, {800, 600})); });
  report.value("triangles of the bridge", static_cast<double>(made.mesh.triangles.size()));
  report.stage("test for what goes through itself", 51, [&](int) { mesh::selfCrossing(made.mesh); });
  report.stage("handle", 51, [&](int) { made = must(bridge::makeBridge({one, up}, {one, down}, {}, {800, 600})); });
  report.value("triangles of the handle", static_cast<double>(made.mesh.triangles.size()));
}

}  // namespace spineloft::bench
