#include "tests/bench/accuracy/end_states.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/cli/bench_cases.h"
#include "engine/cli/bench_rows.h"
#include "engine/cli/files.h"
#include "engine/ribs/search/rib_search.h"
#include "engine/vision/edges.h"
#include "tests/bench/accuracy/tables.h"
#include "tests/bench/accuracy/true_exit.h"

namespace spineloft::accuracy {
namespace {

constexpr double kRightLabels = 2.5, kRightShare = 0.1, kRightPixels = 1.5;
constexpr std::size_t kTenths = 10;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Count {
  double all = 0, said = 0, right = 0;
  void add(const Count& other) {
    all += other.all;
    said += other.said;
    right += other.right;
  }
};

struct EndStates {
  std::array<Count, kTenths> tenths;
  std::array<Count, 3> states;  ///< Edge, Bridged, Guessed
  void add(const EndStates& other) {
    for (std::size_t i = 0; i < tenths.size(); ++i) tenths[i].add(other.tenths[i]);
    for (std::size_t i = 0; i < states.size(); ++i) states[i].add(other.states[i]);
  }
};

void addEnd(const ribs::Search& s, int rib, bool leftSide, ribs::RibState state, const image::Mask& mask,
            EndStates& to) {
  const int curve = s.curves.layout.sideOf(rib, leftSide);
  const float exit = trueExit(s.curves, curve, mask);
  const auto shown = static_cast<std::size_t>(state);
  if (exit == kUnknown || shown >= to.states.size()) return;
  const int label = (leftSide ? s.labels.left : s.labels.right)[index(rib)];
  const std::size_t at = s.curves.at(curve, label);
  const auto support = static_cast<double>(s.boundary.support[at]);
  const bool close = std::abs(static_cast<double>(exit) - label) <= kRightLabels;
  Count& tenth = to.tenths[std::min(kTenths - 1, static_cast<std::size_t>(kTenths * support))];
  tenth.add({1, support, close ? 1.0 : 0.0});
  const double found = static_cast<double>(s.curves.along[at]),
               length = static_cast<double>(s.curves.along[s.curves.at(curve, static_cast<int>(exit))]);
  to.states[shown].add({1, 0, std::abs(found - length) <= kRightShare * length + kRightPixels ? 1.0 : 0.0});
}

Result<EndStates> statesOf(const std::filesystem::path& folder, const ribs::RibParams& params) {
  const Result<cli::LoadedCase> loaded = cli::loadCase(folder);
  if (!loaded.ok()) return loaded.failure();
  const cli::LoadedCase& one = loaded.value();
  const image::Size size{one.picture.width, one.picture.height};
  const Result<image::EdgeMap> edges = vision::detectEdges(one.picture, {}, Progress());
  if (!edges.ok()) return edges.failure();
  EndStates states;
  ribs::RibWorkspace memory;
  for (const auto& [name, stroke] : one.text.strokes) {
    const Result<ribs::Spine> spine = ribs::cleanSpine(stroke, size, {});
    ribs::Search& search = memory.search();
    ribs::RibSet set;
    if (!spine.ok() || !ribs::searchRibs(spine.value(), {edges.value(), size}, params, {}, search, set).ok()) continue;
    for (int i = 0; i < search.problem.ribs; ++i) {
      addEnd(search, i, true, set.ribs[index(i)].leftState, one.mask, states);
      addEnd(search, i, false, set.ribs[index(i)].rightState, one.mask, states);
    }
  }
  return states;
}

io::NamedNumbers lineOf(const Count& count, double all, bool said) {
  const double own = std::max(1.0, count.all);
  return {{"share of the ends", count.all / all}, {"said", said ? count.said / own : 0}, {"is", count.right / own}};
}

io::NamedLines linesOf(const EndStates& states) {
  io::NamedLines lines;
  double all = 0, error = 0;
  for (const Count& tenth : states.tenths) all += tenth.all;
  all = std::max(1.0, all);
  for (std::size_t i = 0; i < kTenths; ++i) {
    const Count& tenth = states.tenths[i];
    lines.emplace_back("support from 0." + std::to_string(i), lineOf(tenth, all, true));
    error += std::abs(tenth.said - tenth.right) / all;
  }
  for (std::size_t i = 0; i < states.states.size(); ++i) {
    constexpr std::array kNames{"on an edge", "bridged", "guessed"};
    lines.emplace_back(kNames[i], lineOf(states.states[i], all, false));
  }
  lines.emplace_back("expected calibration error",
                     io::NamedNumbers{{"share of the ends", 1}, {"said", 0}, {"is", error}});
  return lines;
}

}  // namespace

Status scoreEndStates(std::span<const std::filesystem::path> folders, int jobs, const ribs::RibParams& params,
                      const std::string& markdown, io::BenchReport& report) {
  std::vector<Result<EndStates>> found(folders.size(), Result<EndStates>(Error::Cancelled));
  cli::inParallel(jobs, folders.size(), [&](std::size_t i) { found[i] = statesOf(folders[i], params); });
  EndStates states;
  for (const Result<EndStates>& one : found) {
    if (!one.ok()) return one.failure();
    states.add(one.value());
  }
  io::NamedLines lines = linesOf(states);
  const std::string text = markdownOf(lines);
  report.tables.emplace_back("end_states", std::move(lines));
  return cli::writeAll({{markdown, cli::bytesOf(text)}});
}

}  // namespace spineloft::accuracy
