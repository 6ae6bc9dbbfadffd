// The cases of a data folder made into rows of a benchmark: what the parts of their strokes are worth.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/base/result.h"
#include "engine/cli/bench_cases.h"
#include "engine/cli/score.h"
#include "engine/image/edge_map.h"
#include "engine/io/json_values.h"
#include "engine/pipeline/part_shape.h"

namespace spineloft::cli {

/// A case with all that does not depend on how its parts are made.
struct ReadyCase {
  LoadedCase loaded;
  Truth truth;
  image::EdgeMap edges;
  double edgesMs = 0;

  image::Size size() const { return {loaded.picture.width, loaded.picture.height}; }
  const std::vector<PicturePoint>& stroke(std::size_t i) const { return loaded.text.strokes[i].second; }
};
/// What is known of a case as the scorer wants it.
Truth truthOf(const LoadedCase& loaded);
/// Finds the edges of its picture. Errors: those of vision::detectEdges, with the case's id.
Result<ReadyCase> makeReady(LoadedCase loaded, Truth truth);

/// What the product makes of a stroke on the case's picture, but for the weights.
Result<pipeline::PartShape> makePart(const ReadyCase& one, const std::vector<PicturePoint>& stroke,
                                     const ribs::RibParams& params);

/// The row of one stroke and its part's silhouette, which is empty where there is no part.
struct ScoredStroke {
  io::BenchRow row;
  image::Mask part;
};
/// Scores what was made from the `i`-th stroke of the case. A part that cannot be made counts as empty.
ScoredStroke scoreStroke(const ReadyCase& one, std::size_t i, const Result<pipeline::PartShape>& made);
/// The rows of all strokes of a case, with how far their parts agree.
std::vector<io::BenchRow> rowsOf(const ReadyCase& one, std::vector<ScoredStroke> strokes);
/// Draws the ribs and the silhouette of the `i`-th stroke over the picture, into `folder`/CASE.STROKE.png.
Status writeOverlay(const std::string& folder, const ReadyCase& one, std::size_t i, const ribs::RibSet& ribs,
                    const image::Mask& part);

/// Does `work` for 0 … count − 1, on `jobs` threads.
void inParallel(int jobs, std::size_t count, const std::function<void(std::size_t)>& work);
/// The rows of all cases, on `jobs` threads. Error: the first failure in the order of the cases.
Result<std::vector<io::BenchRow>> allRows(
    std::span<const std::filesystem::path> folders, int jobs,
    const std::function<Result<std::vector<io::BenchRow>>(const std::filesystem::path&)>& rowsOfCase);

}  // namespace spineloft::cli
