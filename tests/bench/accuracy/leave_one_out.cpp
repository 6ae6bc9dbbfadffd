#include "tests/bench/accuracy/leave_one_out.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/cli/bench_rows.h"
#include "engine/cli/files.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/silhouette.h"
#include "tests/bench/accuracy/tables.h"

namespace spineloft::accuracy {
namespace {

using cli::ReadyCase;
using ribs::RibParams;

struct Weight {
  std::string_view name;
  double& (*of)(RibParams&);
};
constexpr std::array kWeights{Weight{"evidence", [](RibParams& p) -> double& { return p.evidence.weight; }},
                              Weight{"neighbour", [](RibParams& p) -> double& { return p.neighbourWeight; }},
                              Weight{"opposite", [](RibParams& p) -> double& { return p.oppositeWeight; }}};
// Shares of the defaults that are tried, where the search begins, and how often it goes round.
constexpr std::array kShares{0.5, 0.7, 1.0, 1.4, 2.0};
constexpr std::size_t kDefault = 2, kStart = 3;
constexpr int kRounds = 2;

/// For every weight which share of its default it has.
using Choice = std::array<std::size_t, kWeights.size()>;

Choice chosenHypothesis(std::size_t share) {
  Choice choice;
  choice.fill(share);
  return choice;
}

RibParams paramsOf(const Choice& choice) {
  RibParams params;
  for (std::size_t i = 0; i < kWeights.size(); ++i) kWeights[i].of(params) *= kShares[choice[i]];
  return params;
}

Result<std::unique_ptr<ReadyCase>> readCase(const std::filesystem::path& folder) {
  Result<cli::LoadedCase> loaded = cli::loadCase(folder);
  if (!loaded.ok()) return loaded.failure();
  cli::Truth truth = cli::truthOf(loaded.value());
  Result<ReadyCase> ready = cli::makeReady(std::move(loaded).value(), std::move(truth));
  if (!ready.ok()) return ready.failure();
  return std::make_unique<ReadyCase>(std::move(ready).value());
}

/// Mean iou_body of a case's strokes; a part that cannot be made counts as empty.
double scoreCase(const ReadyCase& one, const RibParams& params) {
  double sum = 0;
  for (const auto& [name, stroke] : one.loaded.text.strokes) {
    document::LoftRecipe recipe;
    recipe.stroke = stroke;
    recipe.ribs = params;
    const auto made = pipeline::shapePart(recipe, one.edges, one.size(), Progress(), {});
    image::Mask part;
    if (made.ok()) part = pipeline::rasteriseSilhouette(made.value().mesh, one.size());
    sum += cli::scorePart(one.truth, part, stroke, {}).iouBody;
  }
  return sum / static_cast<double>(std::max<std::size_t>(1, one.loaded.text.strokes.size()));
}

/// The cases and what has been measured on them; every choice is measured once.
class Cases {
 public:
  explicit Cases(int jobs) : jobs_(jobs) {}

  Status read(std::span<const std::filesystem::path> folders) {
    std::vector<Result<std::unique_ptr<ReadyCase>>> read;
    for (std::size_t i = 0; i < folders.size(); ++i) read.emplace_back(Error::Cancelled);
    cli::inParallel(jobs_, folders.size(), [&](std::size_t i) { read[i] = readCase(folders[i]); });
    for (auto& one : read) {
      if (!one.ok()) return one.failure();
      cases_.push_back(std::move(one).value());
    }
    return Done{};
  }

  std::vector<std::string> categories() const {
    std::vector<std::string> all;
    for (const auto& one : cases_) {
      if (std::ranges::find(all, one->loaded.text.category) == all.end()) all.push_back(one->loaded.text.category);
    }
    return all;
  }

  /// Mean over the cases of one category, or of all others.
  double mean(const Choice& choice, const std::string& category, bool inside) {
    const std::vector<double>& scores = scoresOf(choice);
    double sum = 0, count = 0;
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      if ((cases_[i]->loaded.text.category == category) != inside) continue;
      sum += scores[i];
      ++count;
    }
    return count > 0 ? sum / count : 0;
  }
  double countOf(const std::string& category) const {
    return static_cast<double>(
        std::ranges::count_if(cases_, [&](const auto& one) { return one->loaded.text.category == category; }));
  }

  /// The best weights that the search finds without a category; none is called "".
  Choice chooseWithout(const std::string& category) {
    Choice best = chosenHypothesis(kStart);
    double most = mean(best, category, false);
    for (int round = 0; round < kRounds; ++round) {
      for (std::size_t w = 0; w < kWeights.size(); ++w) {
        for (std::size_t share = 0; share < kShares.size(); ++share) {
          Choice trial = best;
          trial[w] = share;
          const double score = mean(trial, category, false);
          if (score <= most) continue;
          most = score;
          best = trial;
        }
      }
    }
    return best;
  }

 private:
  const std::vector<double>& scoresOf(const Choice& choice) {
    const auto known = scores_.find(choice);
    if (known != scores_.end()) return known->second;
    const RibParams params = paramsOf(choice);
    std::vector<double> scores(cases_.size());
    cli::inParallel(jobs_, cases_.size(), [&](std::size_t i) { scores[i] = scoreCase(*cases_[i], params); });
    return scores_.emplace(choice, std::move(scores)).first->second;
  }

  int jobs_;
  std::vector<std::unique_ptr<ReadyCase>> cases_;
  std::map<Choice, std::vector<double>> scores_;
};

void addWeights(const Choice& choice, io::NamedNumbers& line) {
  RibParams params = paramsOf(choice);
  for (const Weight& weight : kWeights) line.emplace_back(std::string(weight.name), weight.of(params));
}

}  // namespace

Status leaveOneOut(std::span<const std::filesystem::path> folders, int jobs, const std::string& markdown,
                   io::BenchReport& report) {
  Cases cases(jobs);
  if (Status status = cases.read(folders); !status.ok()) return status.failure();
  const Choice defaults = chosenHypothesis(kDefault), all = cases.chooseWithout("");
  io::NamedLines lines;
  double unseen = 0, seen = 0, chosen = 0, count = 0;
  for (const std::string& category : cases.categories()) {
    const Choice without = cases.chooseWithout(category);
    const double size = cases.countOf(category);
    io::NamedNumbers line{{"iou_body, never seen", cases.mean(without, category, true)},
                          {"chosen on all", cases.mean(all, category, true)},
                          {"as it is", cases.mean(defaults, category, true)}};
    unseen += size * line[0].second;
    chosen += size * line[1].second;
    seen += size * line[2].second;
    count += size;
    addWeights(without, line);
    lines.emplace_back(category, std::move(line));
  }
  count = std::max(1.0, count);
  io::NamedNumbers line{
      {"iou_body, never seen", unseen / count}, {"chosen on all", chosen / count}, {"as it is", seen / count}};
  addWeights(all, line);
  lines.emplace_back("all", std::move(line));
  const std::string text = markdownOf(lines);
  report.tables.emplace_back("leave_one_out", std::move(lines));
  return cli::writeAll({{markdown, cli::bytesOf(text)}});
}

}  // namespace spineloft::accuracy
