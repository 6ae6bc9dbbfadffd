#include "tests/bench/pull_stages.h"

#include <cmath>
#include <numbers>
#include <string>

#include "engine/pipeline/part_shape.h"
#include "engine/pull/pull.h"
#include "tests/bench/must.h"

namespace spineloft::bench {

void reportPullStages(Report& report) {
  document::InflateRecipe puff;
  puff.region = {PictureId{1}, {{{150, 150}, {650, 150}, {650, 650}, {150, 650}}}};
  const pipeline::PartShape shape = must(pipeline::regionStage(puff, {800, 800}));
  pull::Pull pull{{{340, -400, 200}, {460, -400, 200}}, 40, {}, 60, false};
  pull::Reach reach;
  report.stage("pull, pen down", 51, [&](int) { reach = must(pull::reachOf(shape.mesh, pull)); });
  report.value("vertices that follow the pull", static_cast<double>(reach.moved.size()));
  report.value("triangles of the part", static_cast<double>(reach.mesh.triangles.size()));
  mesh::TriMesh out;
  report.stage("pull, move", 201, [&](int i) {
    pull.height = 40 + 0.1 * i;
    pull::moveMesh(reach, pull, out);
  });
  report.stage("pull, pen up", 21, [&](int) { pull::pullMesh(reach, pull, out); });
  for (const bool corner : {false, true}) {
    pull::Pull bump{{{400, -400, 200}}, 40, {}, 60, corner};
    for (int i = 0; i < 48; ++i) {
      const double a = 2 * std::numbers::pi * i / 48;
      bump.ring.push_back({400 + 60 * std::cos(a), -400 + 60 * std::sin(a), 200});
    }
    const std::string name = corner ? "bump with a corner" : "smooth bump";
    report.stage(name + ", pen down", 21, [&](int) { reach = must(pull::reachOf(shape.mesh, bump)); });
    report.value("vertices that follow a " + name, static_cast<double>(reach.moved.size()));
    report.stage(name + ", pen up", 21, [&](int) { pull::pullMesh(reach, bump, out); });
  }
}

}  // namespace spineloft::bench
