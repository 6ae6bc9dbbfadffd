#include "engine/cli/bench_rows.h"

#include <array>
#include <atomic>
#include <thread>
#include <utility>

#include "engine/cli/agreement.h"
#include "engine/cli/files.h"
#include "engine/cli/overlay.h"
#include "engine/cli/program.h"
#include "engine/io/picture_file.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/silhouette.h"
#include "engine/ribs/search/overshoot.h"
#include "engine/vision/edges.h"

namespace spineloft::cli {

namespace fs = std::filesystem;

namespace {

void addScore(const Score& score, io::NamedNumbers& numbers) {
  numbers.insert(
      numbers.end(),
      {{"iou", score.iou}, {"iou_body", score.iouBody}, {"precision", score.precision}, {"recall", score.recall}});
  if (!score.ribs) return;
  numbers.insert(numbers.end(), {{"rib_mean_pct", score.ribs->meanPct},
                                 {"rib_p95_pct", score.ribs->p95Pct},
                                 {"rib_mean_px", score.ribs->meanPx},
                                 {"rib_within_tol", score.ribs->withinTolerance},
                                 {"rib_ends_judged", 1.0 * score.ribs->count}});
}

std::vector<PicturePoint> endsOf(const ribs::RibSet& ribs) {
  std::vector<PicturePoint> ends;
  for (const ribs::Rib& rib : ribs.ribs) ends.insert(ends.end(), {rib.left, rib.right});
  return ends;
}

void addStates(const ribs::RibSet& ribs, io::NamedNumbers& numbers) {
  std::array<double, 3> counts{};
  for (const ribs::Rib& rib : ribs.ribs) {
    ++counts[static_cast<std::size_t>(rib.leftState)];
    ++counts[static_cast<std::size_t>(rib.rightState)];
  }
  for (const ribs::RibState state : {ribs::RibState::Edge, ribs::RibState::Bridged, ribs::RibState::Guessed}) {
    numbers.emplace_back("ends_" + std::string(ribs::ribStateKey(state)), counts[static_cast<std::size_t>(state)]);
  }
}

}  // namespace

Truth truthOf(const LoadedCase& loaded) {
  return Truth({loaded.mask, loaded.text.axis, loaded.text.boundaryTolerance});
}

Result<ReadyCase> makeReady(LoadedCase loaded, Truth truth) {
  const double started = nowMs();
  Result<image::EdgeMap> edges = vision::detectEdges(loaded.picture, {}, Progress());
  const double ms = nowMs() - started;
  if (!edges.ok()) return {edges.error(), loaded.text.id};
  return ReadyCase{std::move(loaded), std::move(truth), std::move(edges).value(), ms};
}

Result<pipeline::PartShape> makePart(const ReadyCase& one, const std::vector<PicturePoint>& stroke,
                                     const ribs::RibParams& params) {
  document::LoftRecipe recipe;
  recipe.stroke = ribs::strokeOnThing(stroke, {one.edges, one.size()}, recipe.spine, params);
  recipe.ribs = params;
  return pipeline::shapePart(recipe, one.edges, one.size(), Progress(), nowMs);
}

ScoredStroke scoreStroke(const ReadyCase& one, std::size_t i, const Result<pipeline::PartShape>& made) {
  const io::BenchCase& text = one.loaded.text;
  const std::vector<PicturePoint>& stroke = one.stroke(i);
  ScoredStroke out{{text.id, text.category, text.strokes[i].first, {}, {}, difficultyNames(text.difficulty)}, {}};
  io::NamedNumbers& numbers = out.row.numbers;
  numbers.emplace_back("edges_ms", one.edgesMs);
  if (!made.ok()) {
    out.row.failure = errorName(made.error());
    addScore(scorePart(one.truth, {}, stroke, {}), numbers);
    return out;
  }
  const pipeline::PartShape& shape = made.value();
  out.part = pipeline::rasteriseSilhouette(shape.mesh, one.size());
  const mesh::MeshReport laws = mesh::inspect(shape.mesh);
  numbers.insert(numbers.end(), {{"ribs_ms", shape.ms.ribs},
                                 {"loft_ms", shape.ms.loft},
                                 {"ribs", static_cast<double>(shape.ribs.ribs.size())},
                                 {"mesh_lawful", laws.valid() ? 1.0 : 0.0}});
  addScore(scorePart(one.truth, out.part, stroke, endsOf(shape.ribs)), numbers);
  addStates(shape.ribs, numbers);
  return out;
}

std::vector<io::BenchRow> rowsOf(const ReadyCase& one, std::vector<ScoredStroke> strokes) {
  std::vector<io::BenchRow> rows;
  std::vector<image::Mask> parts;
  for (ScoredStroke& stroke : strokes) {
    rows.push_back(std::move(stroke.row));
    parts.push_back(std::move(stroke.part));
  }
  const Agreement agreement = agreementOf(one.truth, parts, one.loaded.text.strokes);
  for (io::BenchRow& row : rows) {
    row.numbers.insert(row.numbers.end(),
                       {{"iou_between_strokes", agreement.whole}, {"iou_body_between_strokes", agreement.body}});
  }
  return rows;
}

Status writeOverlay(const std::string& folder, const ReadyCase& one, std::size_t i, const ribs::RibSet& ribs,
                    const image::Mask& part) {
  const image::Image overlay = drawOverlay({one.loaded.picture, ribs, part, one.loaded.mask, one.stroke(i)});
  Result<Bytes> png = io::encodePng(overlay);
  if (!png.ok()) return png.failure();
  const fs::path file = fs::path(folder) / (one.loaded.text.id + "." + one.loaded.text.strokes[i].first + ".png");
  return writeAll({{file.string(), std::move(png).value()}});
}

void inParallel(int jobs, std::size_t count, const std::function<void(std::size_t)>& work) {
  std::atomic<std::size_t> next{0};
  const auto run = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < jobs; ++i) threads.emplace_back(run);
  run();
  for (std::thread& thread : threads) thread.join();
}

Result<std::vector<io::BenchRow>> allRows(
    std::span<const fs::path> folders, int jobs,
    const std::function<Result<std::vector<io::BenchRow>>(const fs::path&)>& rowsOfCase) {
  std::vector<Result<std::vector<io::BenchRow>>> results(folders.size(), Error::Cancelled);
  inParallel(jobs, folders.size(), [&](std::size_t i) { results[i] = rowsOfCase(folders[i]); });
  std::vector<io::BenchRow> rows;
  for (const auto& result : results) {
    if (!result.ok()) return result.failure();
    rows.insert(rows.end(), result.value().begin(), result.value().end());
  }
  return rows;
}

}  // namespace spineloft::cli
