#include "tests/bench/pull_stages.h"

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
}

}  // namespace spineloft::bench
