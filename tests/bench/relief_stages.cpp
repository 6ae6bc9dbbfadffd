#include "tests/bench/relief_stages.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <tuple>

#include "engine/document/update.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/derive.h"
#include "engine/relief/heights.h"
#include "engine/relief/raise.h"
#include "tests/bench/must.h"

namespace spineloft::bench {
namespace {

constexpr int kSide = 600;

/// A ball of clay with scratches, lit from the upper left.
std::shared_ptr<const image::Picture> clay() {
  image::Image image{kSide, kSide, std::vector<std::uint8_t>(std::size_t{4} * kSide * kSide, 255)};
  for (int y = 0; y < kSide; ++y) {
    for (int x = 0; x < kSide; ++x) {
      const double u = (x - 299.5) / 280, v = (299.5 - y) / 280, r2 = u * u + v * v;
      if (r2 >= 1) continue;
      const double w = std::sqrt(1 - r2), bump = 0.4 * std::cos(20 * u) * std::sin(20 * v);
      const double light = std::max(0.0, (-0.5 * (u + bump) + 0.5 * (v - bump) + 0.7 * w) / std::sqrt(1 + bump * bump));
      for (int c = 0; c < 3; ++c) {
        image.pixels[std::size_t{4} * (y * kSide + x) + c] = static_cast<std::uint8_t>(40 + 190 * std::sqrt(light));
      }
    }
  }
  return std::make_shared<const image::Picture>(image::makePicture(std::move(image)));
}

/// A ball over it, so large that it has that many cells.
mesh::TriMesh ballOf(double cells) {
  document::Document document = must(document::update({}, document::AddSketch{"Paper", {kSide, kSide}}));
  shape::ShapeParams params;
  params.axis = {{300, 300 + cells / 2}, {300, 300 - cells / 2}};
  params.width = cells;
  document = must(document::update(document, document::DrawShape{PictureId{1}, params}));
  pipeline::Cache cache;
  return must(pipeline::deriveWithEdges(document, cache, Progress())).parts[0].shape->mesh;
}

}  // namespace

void reportReliefStages(Report& report) {
  constexpr mesh::PictureSize kPaper{kSide, kSide};
  const auto picture = clay();
  for (const int cells : {128, 256}) {
    const std::string size = ", " + std::to_string(cells) + " cells";
    const mesh::TriMesh ball = ballOf(cells - 3);
    relief::Heights heights;
    for (const auto& [name, mode, runs] :
         {std::tuple{"ink", relief::Mode::Ink, 21}, std::tuple{"brightness", relief::Mode::Bright, 21},
          std::tuple{"light and shadow", relief::Mode::Shade, 5}}) {
      const relief::Relief relief{mode, 0.02, 0.2, {}, {}};
      report.stage("heights from " + std::string(name) + size, runs,
                   [&](int) { heights = relief::heightsOf({ball, kPaper}, relief, picture); });
    }
    relief::Raised raised;
    report.stage("mesh made finer" + size, 11, [&](int) {
      raised = relief::raisedBy({ball, kPaper}, heights.front, relief::finished(heights, 0.2));
    });
    mesh::TriMesh out;
    report.value("triangles" + size, static_cast<double>(raised.mesh.triangles.size()));
    report.stage("mesh raised under a moving hand" + size, 51, [&](int) { relief::moveMesh(raised, 0.02, out); });
    report.stage("mesh raised and tested" + size, 11, [&](int) { relief::raiseMesh(raised, 0.02, out); });
  }
}

}  // namespace spineloft::bench
