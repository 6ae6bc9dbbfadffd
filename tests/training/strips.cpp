// spineloft_strips: what the network is trained on, made by the code that the product runs. Every stroke of every case
// below a folder becomes one record: the channels of its strip, and the labels at which its rows leave the true part.
#include <CLI/CLI.hpp>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <string>
#include <thread>
#include <vector>

#include "engine/cli/bench_cases.h"
#include "engine/ribs/learned/channels.h"
#include "engine/ribs/search/rib_search.h"
#include "engine/vision/edges.h"
#include "tests/bench/accuracy/redrawn_strokes.h"
#include "tests/bench/accuracy/true_exit.h"

namespace {

using namespace spineloft;

using accuracy::kUnknown;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

struct Arguments {
  std::string folder, output;
  int jobs = 1;
  int redraws = 0;
  int levels = ribs::RibParams{}.levels;
};

struct Record {
  std::string name;
  std::vector<std::int8_t> planes;  ///< side × row × level × channel, 127 for 1
  std::vector<float> exits;         ///< side × row: label, or kUnknown
};

/// Between two curves: their mean where they leave at about the same label, else the nearer one's.
float exitOfRow(const ribs::StripRow& row, const std::vector<float>& exits) {
  constexpr float kSame = 3;
  const float a = exits[static_cast<std::size_t>(row.first)], b = exits[static_cast<std::size_t>(row.second)];
  const float nearer = row.share < 0.5f ? a : b;
  if (a == kUnknown || b == kUnknown || std::abs(a - b) > kSame) return nearer;
  return a + row.share * (b - a);
}

/// What records are made of.
struct Source {
  const cli::LoadedCase& one;
  const image::EdgeMap& edges;
  int levels;
};

bool makeRecord(const Source& source, std::size_t stroke, ribs::Search& s, Record& record) {
  const auto& [one, edges, levels] = source;
  const image::Size size{one.picture.width, one.picture.height};
  const auto& [name, points] = one.text.strokes[stroke];
  const Result<ribs::Spine> spine = ribs::cleanSpine(points, size, {});
  if (!spine.ok()) return false;
  const ribs::PictureEvidence picture{edges, size};
  if (!ribs::beginSearch(spine.value(), picture, {.levels = levels}, s).ok()) return false;
  ribs::unwrapImage(s.curves, edges, nullptr, s.strip);
  ribs::BoundaryScratch& scratch = s.boundary.scratch;
  ribs::sortColours(s.curves, s.strip, scratch.colours);
  ribs::fillChannels(s.curves, s.strip, scratch.colours, scratch.logOdds, scratch.channels, scratch.strip);
  const ribs::StripChannels& channels = scratch.strip;
  std::vector<float> exits;
  for (int c = 0; c < s.curves.layout.total(); ++c) exits.push_back(accuracy::trueExit(s.curves, c, one.mask));
  record.name = one.text.id + ' ' + one.text.category + ' ' + name;
  record.planes.clear();
  record.exits.clear();
  for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
    const ribs::Plane& plane = channels.planes[side];
    for (int r = 0; r < plane.rows; ++r) {
      for (std::size_t i = 0; i < index(plane.columns * plane.channels); ++i)
        record.planes.push_back(static_cast<std::int8_t>(std::lround(127 * plane.unit * plane.at(r, 0)[i])));
    }
    for (const ribs::StripRow& row : channels.sources[side]) record.exits.push_back(exitOfRow(row, exits));
  }
  return true;
}

bool writeRecords(const std::vector<Record>& records, const std::string& output) {
  std::ofstream planes(output + ".planes", std::ios::binary), exits(output + ".exits", std::ios::binary),
      names(output + ".txt");
  for (const Record& record : records) {
    planes.write(reinterpret_cast<const char*>(record.planes.data()),
                 static_cast<std::streamsize>(record.planes.size()));
    exits.write(reinterpret_cast<const char*>(record.exits.data()),
                static_cast<std::streamsize>(record.exits.size() * sizeof(float)));
    names << record.name << '\n';
  }
  return planes.good() && exits.good() && names.good();
}

/// Of the case's own strokes, and of three others for every time that they are drawn anew.
std::vector<Record> recordsOf(const std::filesystem::path& folder, const Arguments& arguments, ribs::Search& search) {
  std::vector<Record> records;
  Result<cli::LoadedCase> loaded = cli::loadCase(folder);
  if (!loaded.ok()) {
    std::cerr << folder.string() << ": " << loaded.failure().detail << '\n';
    return records;
  }
  const Result<image::EdgeMap> edges = vision::detectEdges(loaded.value().picture, {}, Progress());
  if (!edges.ok()) return records;
  for (int redraw = 0; redraw <= arguments.redraws; ++redraw) {
    auto& strokes = loaded.value().text.strokes;
    if (redraw > 0) {
      std::erase_if(strokes, [](const auto& s) { return s.first == "short" || s.first == "over"; });
      accuracy::redrawStrokes(loaded.value().text, static_cast<std::uint64_t>(redraw));
    }
    for (std::size_t i = 0; i < strokes.size(); ++i) {
      Record record;
      if (makeRecord({loaded.value(), edges.value(), arguments.levels}, i, search, record))
        records.push_back(std::move(record));
    }
  }
  return records;
}

int run(const Arguments& arguments) {
  const std::vector<std::filesystem::path> folders = cli::caseFolders(arguments.folder);
  std::vector<std::vector<Record>> found(folders.size());
  std::atomic<std::size_t> next = 0;
  const auto work = [&] {
    ribs::RibWorkspace memory;
    for (std::size_t i = next++; i < folders.size(); i = next++)
      found[i] = recordsOf(folders[i], arguments, memory.search());
  };
  std::vector<std::jthread> threads;
  for (int i = 1; i < arguments.jobs; ++i) threads.emplace_back(work);
  work();
  threads.clear();
  std::vector<Record> all;
  for (std::vector<Record>& records : found) std::move(records.begin(), records.end(), std::back_inserter(all));
  if (!writeRecords(all, arguments.output)) {
    std::cerr << "spineloft_strips: " << arguments.output << " cannot be written\n";
    return 1;
  }
  std::cout << all.size() << " strips of " << folders.size() << " cases\n";
  return 0;
}

}  // namespace

int main(int count, char** words) {
  CLI::App app{"Strips and true labels of all strokes below a folder of cases"};
  Arguments arguments;
  app.add_option("DATA_DIR", arguments.folder, "the folder with the cases")->required();
  app.add_option("OUTPUT", arguments.output, "writes OUTPUT.planes, .exits and .txt")->required();
  app.add_option("--jobs", arguments.jobs, "threads")->check(CLI::Range(1, 64));
  app.add_option("--redraw", arguments.redraws, "times that strokes are drawn anew")->check(CLI::Range(0, 100));
  app.add_option("--levels", arguments.levels, "labels of a curve")->check(CLI::Range(16, 512));
  CLI11_PARSE(app, count, words);
  return run(arguments);
}
