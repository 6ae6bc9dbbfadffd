#include "tests/bench/drawing_stages.h"

#include <cmath>
#include <cstdlib>
#include <utility>
#include <vector>

#include "engine/descriptive/model.h"
#include "tests/bench/must.h"
#include "tests/unit/descriptive/drawings.h"

namespace spineloft::bench {
namespace {

using namespace descriptive;

/// `count` discs on a spiral, each over the one before it.
Drawing chain(std::uint32_t count) {
  std::vector<std::vector<PicturePoint>> discs;
  double turn = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    const double away = 130 + 11.0 * i;
    discs.push_back(testing::ellipse({500 + away * std::cos(turn), 500 + away * std::sin(turn)}, 48, 40, 120));
    turn += 62 / away;
  }
  return testing::drawn(
      discs, [](std::uint32_t upper, std::uint32_t lower, PicturePoint) { return upper > lower; }, PieceKind::Round);
}

/// What solveDepths is given.
struct Scene {
  std::vector<Sheet> sheets;
  std::vector<Patch> patches;
  Orders orders;
  DepthScale scale;
  double size = 0;

  explicit Scene(const Drawing& drawing) : sheets(testing::sheetsOf(drawing)), size(sizeOf(drawing.lines)) {
    scale = {{500, 500}, size};
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      patches.push_back(must(Patch::make(sheets[i], drawing.pieces[i], {}, scale, ModelOptions{}.points)));
    }
    orders = ordersOf(sheets, {}, size);
  }
  Depths solve(const Drawing& drawing) const {
    return must(solveDepths({sheets, drawing.pieces, patches, orders, {}, {}, scale}));
  }
};

}  // namespace

void reportDrawingStages(Report& report) {
  const Drawing sixteen = chain(16), chained = chain(22), mat = testing::wovenMat(4, PieceKind::Round);
  const std::vector<Sheet> sheets = testing::sheetsOf(sixteen);
  const double size = sizeOf(sixteen.lines);
  report.value("overlaps of 16 pieces", static_cast<double>(ordersOf(sheets, {}, size).orders.size()));
  report.stage("orders of 16 pieces", 21, [&](int) {
    if (!ordersOf(sheets, {}, size).contradictions.empty()) std::exit(1);
  });
  for (const auto& [name, drawing] : {std::pair{"22 round pieces", &chained}, {"a woven mat", &mat}}) {
    const Scene scene(*drawing);
    const Depths depths = scene.solve(*drawing);
    const std::string of = name;
    report.value("unknowns of " + of, static_cast<double>(depths.stats.unknowns));
    report.value("rows of " + of, static_cast<double>(depths.stats.rows));
    report.stage("depths of " + of, 21, [&](int) { scene.solve(*drawing); });
  }
  const Drawing eight = chain(8);
  report.stage("8 pieces, lines to solids", 21, [&](int) { must(modelOf(eight)); });
  for (const std::uint32_t count : {4u, 16u, 32u}) {
    const Drawing drawing = chain(count);
    report.stage(std::to_string(count) + " pieces, lines to solids", 5, [&](int) { must(modelOf(drawing)); });
  }
}

}  // namespace spineloft::bench
