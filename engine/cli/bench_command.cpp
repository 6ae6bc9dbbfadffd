// spineloft bench: accuracy and stage times of every case of a data folder.
#include <algorithm>
#include <array>
#include <atomic>
#include <filesystem>
#include <functional>
#include <iomanip>
#include <optional>
#include <ostream>
#include <span>
#include <sstream>
#include <string>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

#include "engine/cli/agreement.h"
#include "engine/cli/bench_cases.h"
#include "engine/cli/erased_outline.h"
#include "engine/cli/files.h"
#include "engine/cli/leave_one_out.h"
#include "engine/cli/live_score.h"
#include "engine/cli/overlay.h"
#include "engine/cli/overshot_stroke.h"
#include "engine/cli/program.h"
#include "engine/cli/redrawn_strokes.h"
#include "engine/cli/score.h"
#include "engine/cli/variations.h"
#include "engine/io/json_values.h"
#include "engine/io/picture_file.h"
#include "engine/mesh/laws.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/silhouette.h"
#include "engine/ribs/search/ensemble.h"
#include "engine/ribs/search/overshoot.h"
#include "engine/vision/edges.h"

namespace spineloft::cli {
namespace {

namespace fs = std::filesystem;

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

/// Runs the cases; made for use from several threads, one case at a time each.
class Bench {
 public:
  Bench(const BenchArguments& arguments, const Variation& variation) : arguments_(arguments), variation_(variation) {}

  /// One row a stroke. A part that cannot be made counts as empty.
  Result<std::vector<io::BenchRow>> runCase(const fs::path& folder) const {
    Result<LoadedCase> loaded = loadCase(folder);
    if (!loaded.ok()) return loaded.failure();
    LoadedCase& one = loaded.value();
    if (arguments_.redraw > 0) redrawStrokes(one.text, static_cast<std::uint64_t>(arguments_.redraw));
    const Truth truth({one.mask, one.text.axis, one.text.boundaryTolerance});
    const bool sketch = one.text.category == "sketch";
    if (const Status done = eraseOutline(truth, arguments_.erase, sketch, one.picture.working); !done.ok())
      return done.failure();
    const double started = nowMs();
    const Result<image::EdgeMap> edges = vision::detectEdges(one.picture, {}, Progress());
    const double edgesMs = nowMs() - started;
    if (!edges.ok()) return {edges.error(), folder.string()};
    std::vector<io::BenchRow> rows;
    std::vector<image::Mask> parts;
    for (const auto& [name, stroke] : one.text.strokes) {
      io::BenchRow row{one.text.id, one.text.category, name, {}, {}, difficultyNames(one.text.difficulty)};
      row.numbers.emplace_back("edges_ms", edgesMs);
      Result<image::Mask> part = runStroke(one, edges.value(), truth, stroke, row);
      if (!part.ok()) return part.failure();
      parts.push_back(std::move(part).value());
      rows.push_back(std::move(row));
    }
    const Agreement agreement = agreementOf(truth, parts, one.text.strokes);
    for (io::BenchRow& row : rows) {
      row.numbers.insert(row.numbers.end(),
                         {{"iou_between_strokes", agreement.whole}, {"iou_body_between_strokes", agreement.body}});
    }
    return rows;
  }

 private:
  /// The part's silhouette, empty where there is no part; the numbers go to the row.
  Result<image::Mask> runStroke(const LoadedCase& one, const image::EdgeMap& edges, const Truth& truth,
                                const std::vector<PicturePoint>& stroke, io::BenchRow& row) const {
    const image::Size size{one.picture.width, one.picture.height};
    const Result<pipeline::PartShape> made = makePart(overshot(truth, stroke, arguments_.overshoot), edges, size);
    if (!made.ok()) {
      row.failure = errorName(made.error());
      addScore(scorePart(truth, {}, stroke, {}), row.numbers);
      return image::Mask{};
    }
    const pipeline::PartShape& shape = made.value();
    image::Mask part = pipeline::rasteriseSilhouette(shape.mesh, size);
    const mesh::MeshReport laws = mesh::inspect(shape.mesh);
    row.numbers.insert(row.numbers.end(), {{"ribs_ms", shape.ms.ribs},
                                           {"loft_ms", shape.ms.loft},
                                           {"ribs", static_cast<double>(shape.ribs.ribs.size())},
                                           {"mesh_lawful", laws.valid() ? 1.0 : 0.0}});
    addScore(scorePart(truth, part, stroke, endsOf(shape.ribs)), row.numbers);
    addStates(shape.ribs, row.numbers);
    if (arguments_.live > 0) {
      const LiveScore live = scoreLive(stroke, edges, size, variation_.params, arguments_.live);
      row.numbers.insert(row.numbers.end(), {{"live_up_pct", live.upPct},
                                             {"live_mean_pct", live.meanPct},
                                             {"live_jumps", live.jumps},
                                             {"live_followed", live.followed}});
    }
    if (arguments_.overlays.empty()) return part;
    const image::Image overlay = drawOverlay({one.picture, shape.ribs, part, one.mask, stroke});
    Result<Bytes> png = io::encodePng(overlay);
    if (!png.ok()) return png.failure();
    const fs::path file = fs::path(arguments_.overlays) / (row.name + "." + row.stroke + ".png");
    const Status written = writeAll({{file.string(), std::move(png).value()}});
    if (!written.ok()) return written.failure();
    return part;
  }

  Result<pipeline::PartShape> makePart(const std::vector<PicturePoint>& stroke, const image::EdgeMap& edges,
                                       image::Size size) const {
    document::LoftRecipe recipe;
    recipe.stroke = stroke;
    recipe.ribs = variation_.params;
    if (variation_.variant == ribs::TraceVariant{}) {
      recipe.stroke = ribs::strokeOnThing(stroke, {edges, size}, recipe.spine, recipe.ribs);
      return pipeline::shapePart(recipe, edges, size, Progress(), nowMs);
    }
    Result<ribs::Spine> spine = ribs::cleanSpine(stroke, size, recipe.spine);
    if (!spine.ok()) return spine.failure();
    ribs::RibWorkspace memory;
    Result<ribs::RibSet> found =
        ribs::ensembleRibs(spine.value(), {edges, size}, recipe.ribs, Progress(), variation_.variant, memory);
    if (!found.ok()) return found.failure();
    pipeline::ShapeMemory shapeMemory;
    return pipeline::shapeStage(recipe, {std::move(spine).value(), std::move(found).value()}, size, shapeMemory, nowMs);
  }

  const BenchArguments& arguments_;
  const Variation& variation_;
};

/// Value of a row's number, if it has it.
std::optional<double> numberIn(const io::BenchRow& row, std::string_view name) {
  for (const auto& [key, value] : row.numbers) {
    if (key == name) return value;
  }
  return std::nullopt;
}

std::vector<double> column(const std::vector<const io::BenchRow*>& rows, std::string_view name) {
  std::vector<double> values;
  for (const io::BenchRow* row : rows) {
    if (const auto value = numberIn(*row, name)) values.push_back(*value);
  }
  return values;
}

double mean(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value;
  return values.empty() ? 0 : sum / static_cast<double>(values.size());
}

double shareOf(const std::vector<double>& values, const std::function<bool(double)>& test) {
  const auto count = std::count_if(values.begin(), values.end(), test);
  return values.empty() ? 0 : static_cast<double>(count) / static_cast<double>(values.size());
}

io::NamedNumbers summarise(const std::vector<const io::BenchRow*>& rows) {
  io::NamedNumbers out{{"cases", static_cast<double>(rows.size())}};
  for (const char* name : {"iou", "iou_body", "rib_mean_pct", "rib_p95_pct", "rib_within_tol", "iou_between_strokes",
                           "iou_body_between_strokes"}) {
    out.emplace_back(name, mean(column(rows, name)));
  }
  for (const char* name : {"live_up_pct", "live_mean_pct", "live_jumps", "live_followed"}) {
    const std::vector<double> values = column(rows, name);
    if (!values.empty()) out.emplace_back(name, mean(values));
  }
  const std::vector<double> up = column(rows, "live_up_pct");
  if (!up.empty()) out.emplace_back("p95_live_up_pct", percentile(up, 0.95));
  const std::vector<double> p95 = column(rows, "rib_p95_pct");
  out.emplace_back("median_rib_p95_pct", p95.empty() ? 0 : percentile(p95, 0.5));
  const std::vector<double> body = column(rows, "iou_body");
  out.emplace_back("least_iou_body", body.empty() ? 0 : *std::ranges::min_element(body));
  out.emplace_back("share_iou_body_0.9", shareOf(body, [](double v) { return v >= 0.9; }));
  out.emplace_back("share_iou_body_0.8", shareOf(body, [](double v) { return v >= 0.8; }));
  out.emplace_back("share_iou_body_below_0.5", shareOf(body, [](double v) { return v < 0.5; }));
  for (const char* name : {"edges_ms", "ribs_ms", "loft_ms"}) {
    const std::vector<double> values = column(rows, name);
    out.emplace_back(std::string("median_") + name, values.empty() ? 0 : percentile(values, 0.5));
  }
  double ends = 0;
  for (const char* name : {"ends_edge", "ends_bridged", "ends_guessed"}) {
    for (const double value : column(rows, name)) ends += value;
  }
  for (const char* name : {"ends_edge", "ends_bridged", "ends_guessed"}) {
    double sum = 0;
    for (const double value : column(rows, name)) sum += value;
    out.emplace_back(std::string("share_") + name, ends > 0 ? sum / ends : 0);
  }
  const auto failed = std::count_if(rows.begin(), rows.end(), [](const auto* row) { return !row->failure.empty(); });
  out.emplace_back("failed", static_cast<double>(failed));
  return out;
}

/// Every stroke over all cases, then over each category, then over all that are hard in one way; categories and
/// strokes in order of first appearance.
std::vector<std::pair<std::string, io::NamedNumbers>> summaries(const std::vector<io::BenchRow>& rows) {
  std::vector<std::pair<std::string, std::vector<const io::BenchRow*>>> groups;
  const auto add = [&](const std::string& name, const io::BenchRow& row) {
    const auto at = std::find_if(groups.begin(), groups.end(), [&](const auto& group) { return group.first == name; });
    if (at == groups.end()) {
      groups.push_back({name, {&row}});
    } else {
      at->second.push_back(&row);
    }
  };
  for (const io::BenchRow& row : rows) add("all " + row.stroke, row);
  for (const io::BenchRow& row : rows) add(row.category + ' ' + row.stroke, row);
  for (const std::string_view name : difficultyOrder()) {
    for (const io::BenchRow& row : rows) {
      if (std::ranges::find(row.difficulty, name) != row.difficulty.end())
        add(std::string(name) + ", " + row.stroke, row);
    }
  }
  std::vector<std::pair<std::string, io::NamedNumbers>> out;
  for (const auto& [name, members] : groups) out.emplace_back(name, summarise(members));
  return out;
}

struct Column {
  const char* title;
  const char* key;
  int decimals;
};

void printTable(std::ostream& out, std::span<const Column> columns,
                const std::vector<std::pair<std::string, io::NamedNumbers>>& lines) {
  std::size_t longest = 0;
  for (const auto& line : lines) longest = std::max(longest, line.first.size());
  const int nameWidth = static_cast<int>(longest) + 2;
  out << std::left << std::setw(nameWidth) << "" << std::right;
  for (const Column& column : columns) out << std::setw(9) << column.title;
  out << '\n';
  for (const auto& [name, numbers] : lines) {
    out << std::left << std::setw(nameWidth) << name << std::right << std::fixed;
    for (const Column& column : columns) {
      const auto at =
          std::find_if(numbers.begin(), numbers.end(), [&](const auto& number) { return number.first == column.key; });
      if (at == numbers.end()) {
        out << std::setw(9) << '-';
      } else {
        out << std::setw(9) << std::setprecision(column.decimals) << at->second;
      }
    }
    out << '\n';
  }
}

constexpr std::array kRowColumns{Column{"iou", "iou", 3},
                                 Column{"body", "iou_body", 3},
                                 Column{"rib %", "rib_mean_pct", 1},
                                 Column{"p95 %", "rib_p95_pct", 1},
                                 Column{"in tol", "rib_within_tol", 2},
                                 Column{"edge", "ends_edge", 0},
                                 Column{"bridged", "ends_bridged", 0},
                                 Column{"guessed", "ends_guessed", 0},
                                 Column{"edges ms", "edges_ms", 1},
                                 Column{"ribs ms", "ribs_ms", 1},
                                 Column{"loft ms", "loft_ms", 1}};
constexpr std::array kSummaryColumns{Column{"cases", "cases", 0},
                                     Column{"iou", "iou", 3},
                                     Column{"body", "iou_body", 3},
                                     Column{">=0.9", "share_iou_body_0.9", 2},
                                     Column{">=0.8", "share_iou_body_0.8", 2},
                                     Column{"<0.5", "share_iou_body_below_0.5", 2},
                                     Column{"rib %", "rib_mean_pct", 1},
                                     Column{"p95 %", "rib_p95_pct", 1},
                                     Column{"in tol", "rib_within_tol", 2},
                                     Column{"agree", "iou_between_strokes", 3},
                                     Column{"agr.body", "iou_body_between_strokes", 3},
                                     Column{"edges ms", "median_edges_ms", 1},
                                     Column{"ribs ms", "median_ribs_ms", 1},
                                     Column{"loft ms", "median_loft_ms", 1},
                                     Column{"failed", "failed", 0}};

/// Runs all cases on `jobs` threads; the first failure in order of the cases wins.
Result<std::vector<io::BenchRow>> runAll(const BenchArguments& arguments, const std::vector<fs::path>& folders,
                                         const Variation& variation) {
  const Bench bench(arguments, variation);
  std::vector<Result<std::vector<io::BenchRow>>> results(folders.size(), Error::Cancelled);
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < folders.size(); i = next++) results[i] = bench.runCase(folders[i]);
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < arguments.jobs; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  std::vector<io::BenchRow> rows;
  for (const auto& result : results) {
    if (!result.ok()) return result.failure();
    rows.insert(rows.end(), result.value().begin(), result.value().end());
  }
  return rows;
}

/// Means of one variation over all cases, by stroke: "iou_body careful", …
io::NamedNumbers ablationRow(const std::vector<io::BenchRow>& rows) {
  io::NamedNumbers out;
  std::vector<double> p95;
  double least = 1;
  for (const char* stroke : {"careful", "sloppy", "offcentre"}) {
    std::vector<const io::BenchRow*> members;
    for (const io::BenchRow& row : rows) {
      if (row.stroke == stroke) members.push_back(&row);
    }
    if (members.empty()) continue;
    for (const char* name : {"iou_body", "iou"}) {
      out.emplace_back(std::string(name) + ' ' + stroke, mean(column(members, name)));
    }
    for (const double value : column(members, "rib_p95_pct")) p95.push_back(value);
    for (const double value : column(members, "iou_body")) least = std::min(least, value);
  }
  out.emplace_back("median rib p95 %", p95.empty() ? 0 : percentile(p95, 0.5));
  out.emplace_back("least iou_body", least);
  return out;
}

/// Every variation over all cases: into the report, and as a table in Markdown.
Status ablate(const BenchArguments& arguments, const std::vector<fs::path>& folders, io::BenchReport& report) {
  BenchArguments plain = arguments;
  plain.overlays.clear();
  plain.live = 0;
  for (const Variation& variation : variations()) {
    const Result<std::vector<io::BenchRow>> rows = runAll(plain, folders, variation);
    if (!rows.ok()) return rows.failure();
    report.ablation.emplace_back(std::string(variation.title), ablationRow(rows.value()));
  }
  const std::string text = markdownOf(report.ablation);
  return writeAll({{arguments.ablation, Bytes(text.begin(), text.end())}});
}

}  // namespace

Status runBench(const BenchArguments& arguments, std::ostream& out) {
  const std::vector<fs::path> folders = caseFolders(arguments.folder);
  if (folders.empty()) return {Error::FileUnreadable, "no case.json below " + arguments.folder};
  // Before minutes of work, not after them.
  for (const std::string& file : {arguments.json, arguments.ablation, arguments.leaveOneOut}) {
    const fs::path parent = fs::path(file).parent_path();
    std::error_code problem;
    if (!parent.empty() && !fs::is_directory(parent, problem)) return {Error::FileUnwritable, file};
  }
  if (!arguments.overlays.empty()) {
    std::error_code problem;
    fs::create_directories(arguments.overlays, problem);
    if (problem) return {Error::FileUnwritable, arguments.overlays};
  }
  Result<std::vector<io::BenchRow>> rows = runAll(arguments, folders, *variationFromKey(arguments.variation));
  if (!rows.ok()) return rows.failure();
  io::BenchReport report{summaries(rows.value()), std::move(rows).value(), {}, {}};
  if (!arguments.ablation.empty()) {
    if (Status status = ablate(arguments, folders, report); !status.ok()) return status.failure();
  }

  if (!arguments.leaveOneOut.empty()) {
    if (Status status = leaveOneOut(arguments, folders, report); !status.ok()) return status.failure();
  }

  std::vector<std::pair<std::string, io::NamedNumbers>> lines;
  for (const io::BenchRow& row : report.rows) {
    const std::string note = row.failure.empty() ? "" : " (" + row.failure + ")";
    lines.emplace_back(row.name + ' ' + row.stroke + note, row.numbers);
  }
  printTable(out, kRowColumns, lines);
  out << '\n';
  printTable(out, kSummaryColumns, report.summary);
  if (arguments.json.empty()) return Done{};
  const std::string text = io::writeBench(report);
  return writeAll({{arguments.json, Bytes(text.begin(), text.end())}});
}

}  // namespace spineloft::cli
