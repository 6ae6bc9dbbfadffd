// spineloft bench: accuracy and stage times of every case of a data folder.
#include <ostream>
#include <utility>

#include "engine/cli/bench_report.h"
#include "engine/cli/bench_rows.h"
#include "engine/cli/files.h"
#include "engine/cli/program.h"

namespace spineloft::cli {
namespace {

namespace fs = std::filesystem;

/// One row a stroke.
Result<std::vector<io::BenchRow>> rowsOfCase(const BenchArguments& arguments, const fs::path& folder) {
  Result<LoadedCase> loaded = loadCase(folder);
  if (!loaded.ok()) return loaded.failure();
  Truth truth = truthOf(loaded.value());
  Result<ReadyCase> ready = makeReady(std::move(loaded).value(), std::move(truth));
  if (!ready.ok()) return ready.failure();
  const ReadyCase& one = ready.value();
  std::vector<ScoredStroke> scored;
  for (std::size_t i = 0; i < one.loaded.text.strokes.size(); ++i) {
    const Result<pipeline::PartShape> made = makePart(one, one.stroke(i), {});
    scored.push_back(scoreStroke(one, i, made));
    if (arguments.overlays.empty() || !made.ok()) continue;
    const Status drawn = writeOverlay(arguments.overlays, one, i, made.value().ribs, scored.back().part);
    if (!drawn.ok()) return drawn.failure();
  }
  return rowsOf(one, std::move(scored));
}

}  // namespace

Status runBench(const BenchArguments& arguments, std::ostream& out) {
  const std::vector<fs::path> folders = caseFolders(arguments.folder);
  if (folders.empty()) return {Error::FileUnreadable, "no case.json below " + arguments.folder};
  if (Status status = prepareOutputs({&arguments.json, 1}, arguments.overlays); !status.ok()) return status;
  Result<std::vector<io::BenchRow>> rows =
      allRows(folders, arguments.jobs, [&](const fs::path& folder) { return rowsOfCase(arguments, folder); });
  if (!rows.ok()) return rows.failure();
  const io::BenchReport report{summaries(groupsOf(rows.value())), std::move(rows).value(), {}};
  printReport(out, report);
  if (arguments.json.empty()) return Done{};
  return writeAll({{arguments.json, bytesOf(io::writeBench(report))}});
}

}  // namespace spineloft::cli
