#include "tests/bench/accuracy/accuracy.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <ostream>
#include <utility>
#include <vector>

#include "engine/cli/bench_report.h"
#include "engine/cli/bench_rows.h"
#include "engine/cli/files.h"
#include "tests/bench/accuracy/end_states.h"
#include "tests/bench/accuracy/erased_outline.h"
#include "tests/bench/accuracy/leave_one_out.h"
#include "tests/bench/accuracy/live_score.h"
#include "tests/bench/accuracy/overshot_stroke.h"
#include "tests/bench/accuracy/redrawn_strokes.h"
#include "tests/bench/accuracy/tables.h"
#include "tests/bench/accuracy/variations.h"

namespace spineloft::accuracy {
namespace {

namespace fs = std::filesystem;
using Rows = std::vector<io::BenchRow>;

Result<pipeline::PartShape> makePart(const cli::ReadyCase& one, const std::vector<PicturePoint>& stroke,
                                     const Variation& variation) {
  if (variation.variant == TraceVariant{}) return cli::makePart(one, stroke, variation.params);
  document::LoftRecipe recipe;
  recipe.stroke = stroke;
  recipe.ribs = variation.params;
  Result<ribs::Spine> spine = ribs::cleanSpine(stroke, one.size(), recipe.spine);
  if (!spine.ok()) return spine.failure();
  Result<ribs::RibSet> found = variantRibs(spine.value(), {one.edges, one.size()}, recipe.ribs, variation.variant);
  if (!found.ok()) return found.failure();
  pipeline::ShapeMemory memory;
  return pipeline::shapeStage(recipe, {std::move(spine).value(), std::move(found).value()}, one.size(), memory,
                              cli::nowMs);
}

void addLive(const cli::ReadyCase& one, std::size_t i, const Variation& variation, int moves, io::BenchRow& row) {
  const LiveScore live = scoreLive(one.stroke(i), one.edges, one.size(), variation.params, moves);
  row.numbers.insert(row.numbers.end(), {{"live_up_pct", live.upPct},
                                         {"live_mean_pct", live.meanPct},
                                         {"live_jumps", live.jumps},
                                         {"live_followed", live.followed}});
}

Result<cli::ReadyCase> readCase(const AccuracyArguments& arguments, const fs::path& folder) {
  Result<cli::LoadedCase> read = cli::loadCase(folder);
  if (!read.ok()) return read.failure();
  cli::LoadedCase loaded = std::move(read).value();
  if (arguments.redraw > 0) redrawStrokes(loaded.text, static_cast<std::uint64_t>(arguments.redraw));
  cli::Truth truth = cli::truthOf(loaded);
  const bool sketch = loaded.text.category == "sketch";
  if (const Status done = eraseOutline(truth, arguments.erase, sketch, loaded.picture.working); !done.ok())
    return done.failure();
  return cli::makeReady(std::move(loaded), std::move(truth));
}

/// One row a stroke.
Result<Rows> rowsOfCase(const AccuracyArguments& arguments, const Variation& variation, const fs::path& folder) {
  const Result<cli::ReadyCase> ready = readCase(arguments, folder);
  if (!ready.ok()) return ready.failure();
  const cli::ReadyCase& one = ready.value();
  std::vector<cli::ScoredStroke> scored;
  for (std::size_t i = 0; i < one.loaded.text.strokes.size(); ++i) {
    const auto made = makePart(one, overshot(one.truth, one.stroke(i), arguments.overshoot), variation);
    scored.push_back(cli::scoreStroke(one, i, made));
    if (!made.ok()) continue;
    if (arguments.live > 0) addLive(one, i, variation, arguments.live, scored.back().row);
    if (arguments.overlays.empty()) continue;
    const Status drawn = cli::writeOverlay(arguments.overlays, one, i, made.value().ribs, scored.back().part);
    if (!drawn.ok()) return drawn.failure();
  }
  return cli::rowsOf(one, std::move(scored));
}

Result<Rows> rowsOf(const AccuracyArguments& arguments, const Variation& variation,
                    const std::vector<fs::path>& folders) {
  return cli::allRows(folders, arguments.jobs,
                      [&](const fs::path& folder) { return rowsOfCase(arguments, variation, folder); });
}

/// The means of a group of rows that have live numbers.
void addLiveMeans(const cli::RowGroup& rows, io::NamedNumbers& means) {
  for (const char* name : {"live_up_pct", "live_mean_pct", "live_jumps", "live_followed"}) {
    const std::vector<double> values = cli::column(rows, name);
    if (!values.empty()) means.emplace_back(name, cli::mean(values));
  }
  const std::vector<double> up = cli::column(rows, "live_up_pct");
  if (!up.empty()) means.emplace_back("p95_live_up_pct", cli::percentile(up, 0.95));
}

/// Means of one variation over all cases, by stroke: "iou_body careful", …
io::NamedNumbers ablationLine(const Rows& rows) {
  io::NamedNumbers out;
  std::vector<double> p95;
  double least = 1;
  for (const char* stroke : {"careful", "sloppy", "offcentre"}) {
    cli::RowGroup members;
    for (const io::BenchRow& row : rows) {
      if (row.stroke == stroke) members.push_back(&row);
    }
    if (members.empty()) continue;
    for (const char* name : {"iou_body", "iou"}) {
      out.emplace_back(std::string(name) + ' ' + stroke, cli::mean(cli::column(members, name)));
    }
    for (const double value : cli::column(members, "rib_p95_pct")) p95.push_back(value);
    for (const double value : cli::column(members, "iou_body")) least = std::min(least, value);
  }
  out.emplace_back("median rib p95 %", p95.empty() ? 0 : cli::percentile(p95, 0.5));
  out.emplace_back("least iou_body", least);
  return out;
}

/// Every variation over all cases: into the report, and as a table in Markdown.
Status ablate(const AccuracyArguments& arguments, const std::vector<fs::path>& folders, io::BenchReport& report) {
  AccuracyArguments plain = arguments;
  plain.overlays.clear();
  plain.live = 0;
  io::NamedLines lines;
  for (const Variation& variation : variations()) {
    const Result<Rows> rows = rowsOf(plain, variation, folders);
    if (!rows.ok()) return rows.failure();
    lines.emplace_back(std::string(variation.title), ablationLine(rows.value()));
  }
  const std::string text = markdownOf(lines);
  report.tables.emplace_back("ablation", std::move(lines));
  return cli::writeAll({{arguments.ablation, cli::bytesOf(text)}});
}

}  // namespace

Status runAccuracy(const AccuracyArguments& arguments, std::ostream& out) {
  const std::vector<fs::path> folders = cli::caseFolders(arguments.folder);
  if (folders.empty()) return {Error::FileUnreadable, "no case.json below " + arguments.folder};
  const std::array files{arguments.json, arguments.ablation, arguments.leaveOneOut, arguments.states};
  if (Status status = cli::prepareOutputs(files, arguments.overlays); !status.ok()) return status;
  Variation variation = *variationFromKey(arguments.variation);
  for (const std::string& one : arguments.set) {
    if (!setNumber(one, variation)) return {Error::ValueOutOfRange, "--set " + one};
  }
  Result<Rows> rows = rowsOf(arguments, variation, folders);
  if (!rows.ok()) return rows.failure();
  io::BenchReport report{{}, std::move(rows).value(), {}};
  const cli::RowGroups groups = cli::groupsOf(report.rows);
  report.summary = cli::summaries(groups);
  for (std::size_t i = 0; i < groups.size(); ++i) addLiveMeans(groups[i].second, report.summary[i].second);
  if (!arguments.ablation.empty()) {
    if (Status status = ablate(arguments, folders, report); !status.ok()) return status;
  }
  if (!arguments.leaveOneOut.empty()) {
    if (Status status = leaveOneOut(folders, arguments.jobs, arguments.leaveOneOut, report); !status.ok())
      return status;
  }
  if (!arguments.states.empty()) {
    const Status scored = scoreEndStates(folders, arguments.jobs, variation.params, arguments.states, report);
    if (!scored.ok()) return scored;
  }
  cli::printReport(out, report);
  if (arguments.json.empty()) return Done{};
  return cli::writeAll({{arguments.json, cli::bytesOf(io::writeBench(report))}});
}

}  // namespace spineloft::accuracy
