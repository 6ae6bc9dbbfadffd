#include "tests/bench/rib_stages.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>

#include "engine/base/rng.h"
#include "engine/ribs/evidence/evidence.h"
#include "engine/ribs/field/curves.h"
#include "engine/ribs/labels/rib_lengths.h"
#include "engine/ribs/learned/likelihood.h"
#include "engine/ribs/search/ribs.h"
#include "tests/bench/accuracy/d2_grid.h"
#include "tests/bench/scene.h"

namespace spineloft::bench {
namespace {

ribs::Spine spineOf(image::Size size, int count) {
  ribs::SpineParams params;
  params.ribs = count;
  Result<ribs::Spine> spine = ribs::cleanSpine(tubeStroke(size, 400), size, params);
  if (!spine.ok()) std::exit(1);
  return std::move(spine).value();
}

void trace(const ribs::Spine& spine, const image::EdgeMap& edges, image::Size size, const ribs::RibParams& params) {
  if (!ribs::traceRibs(spine, edges, size, params, Progress()).ok()) std::exit(1);
}

// Costs like a picture's: boundaries that follow a wave, clutter, gaps on either side.
void fillSide(ribs::SideCosts& side, int ribCount, int levels, Rng& rng) {
  const double step = 128.0 / levels;
  for (int i = 0; i < ribCount; ++i) {
    const double truth = 60 + 20 * std::sin(0.09 * i);
    const bool gap = i / 9 % 4 == 0;
    for (int k = 0; k < levels; ++k) {
      const double near = gap ? 0 : std::max(0.0, 1 - std::abs(k * step - truth) / 4);
      const double clutter = rng.uniform() < 0.06 ? 0.5 : 0;
      const double cost = 0.35 - std::max(near, clutter) * rng.uniform(0.6, 1);
      side.unary.push_back(k == 0 ? ribs::kUnreachable : static_cast<float>(cost));
      side.place.push_back(static_cast<float>(k * step + 0.3 * step * std::sin(i)));
    }
    if (i > 0) side.spacing.push_back(7);
  }
}

ribs::LengthProblem pairProblem(int ribCount, int levels) {
  Rng rng(20261122);
  ribs::LengthProblem p;
  p.ribs = ribCount;
  p.levels = levels;
  fillSide(p.left, ribCount, levels, rng);
  fillSide(p.right, ribCount, levels, rng);
  const ribs::RibParams defaults;
  p.neighbourWeight = static_cast<float>(defaults.neighbourWeight);
  p.neighbourFreedom = static_cast<float>(defaults.neighbourFreedom);
  p.neighbourCap = static_cast<float>(defaults.neighbourCap);
  p.medialOffset = 0.1f;
  p.medialOffsetScale.assign(static_cast<std::size_t>(ribCount), 0.02f);
  return p;
}

void reportPairSearch(int levels, Report& report) {
  const ribs::LengthProblem problem = pairProblem(100, levels);
  ribs::LengthWorkspace workspace;
  ribs::LengthLabels labels;
  const std::string name = "pair search of 100 ribs, " + std::to_string(levels) + " labels";
  report.stage(name, 41,
               [&](int) { ribs::findLabels(problem, std::numeric_limits<double>::infinity(), workspace, labels); });
  report.value(name + ": share of pairs visited", workspace.bounds.cells() / (100.0 * levels * levels));
}

}  // namespace

void reportRibStages(const image::EdgeMap& edges, image::Size size, Report& report) {
  for (const int count : {25, 50, 100, 200, 400, 800}) {
    const ribs::Spine spine = spineOf(size, count);
    report.stage("ribs " + std::to_string(count), count > 200 ? 11 : 21, [&](int) { trace(spine, edges, size, {}); });
  }
  const ribs::Spine spine = spineOf(size, 100);
  for (const int levels : {32, 64, 128, 256, 512}) {
    ribs::RibParams params;
    params.levels = levels;
    report.stage("labels " + std::to_string(levels), 21, [&](int) { trace(spine, edges, size, params); });
  }
  const ribs::D2Field field(spine.points);
  const ribs::Levels levels = ribs::makeLevels(128, 1, 0.5 * size.height, field.length());
  ribs::GradientCurves curves;
  report.stage("curves of 100 ribs and fans", 41,
               [&](int) { ribs::traceCurves(spine, field, levels, 11, size, curves); });
  report.value("curves of 100 ribs and fans: steps a curve", static_cast<double>(curves.steps) / curves.layout.total());
  ribs::UnwrappedImage strip;
  ribs::Boundary boundary;
  report.stage("evidence of 100 ribs", 41, [&](int) {
    ribs::unwrapImage(curves, edges, nullptr, strip);
    ribs::findBoundary(curves, strip, ribs::builtInNetwork(), {}, boundary);
  });
  for (const int count : {128, 256}) reportPairSearch(count, report);
}

void reportInvariance(const image::EdgeMap& edges, image::Size size, Report& report) {
  const auto ribsOf = [&](std::vector<PicturePoint> stroke, bool backwards) {
    if (backwards) std::ranges::reverse(stroke);
    const Result<ribs::Spine> spine = ribs::cleanSpine(stroke, size, {});
    if (!spine.ok()) std::exit(1);
    Result<ribs::RibSet> found = ribs::traceRibs(spine.value(), edges, size, {}, Progress());
    if (!found.ok()) std::exit(1);
    std::vector<ribs::Rib> all = std::move(found.value().ribs);
    if (backwards) {
      std::ranges::reverse(all);
      for (ribs::Rib& rib : all) std::swap(rib.left, rib.right);
    }
    return all;
  };
  const std::vector<ribs::Rib> usual = ribsOf(tubeStroke(size, 400), false);
  const auto apart = [&](const std::vector<ribs::Rib>& other) {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(usual.size(), other.size()); ++i) {
      const double width = std::max(1.0, distance(usual[i].left, usual[i].right));
      sum += distance(usual[i].left, other[i].left) / width + distance(usual[i].right, other[i].right) / width;
    }
    return sum / (2 * static_cast<double>(usual.size()));
  };
  report.value("rib ends, 30 samples: share of the width", apart(ribsOf(tubeStroke(size, 30), false)));
  report.value("rib ends, 3000 samples: share of the width", apart(ribsOf(tubeStroke(size, 3000), false)));
  report.value("rib ends, drawn backwards: share of the width", apart(ribsOf(tubeStroke(size, 400), true)));
}

void reportFieldStages(Report& report) {
  std::vector<PicturePoint> line;
  for (int i = 0; i < 2000; ++i) {
    const double turn = 3.2 * std::numbers::pi * i / 1999, radius = 40 + 8 * turn + 6 * std::sin(9 * turn);
    line.push_back({150 + radius * std::cos(turn), 150 + radius * std::sin(turn)});
  }
  const accuracy::GridPlan plan{{0, 0}, 1, 300, 300};
  std::vector<float> exact, quick;
  report.stage("d2, 2000 segments on 300x300, exact", 5, [&](int) { accuracy::d2OnGrid(line, plan, exact); });
  report.stage("d2, 2000 segments on 300x300, hierarchical", 41,
               [&](int) { accuracy::quickD2OnGrid(line, plan, quick); });
  double worst = 0;
  for (std::size_t i = 0; i < exact.size(); ++i)
    worst = std::max(worst, std::abs(static_cast<double>(quick[i] / exact[i]) - 1));
  report.value("d2, hierarchical: largest relative error", worst);
}

}  // namespace spineloft::bench
