// Stage times on made-up inputs, as JSON on standard output: native, and as wasm under Node. --photo: the
// memory that a large photo takes, which only a fresh process can tell.
// Nothing is asserted about times; a run that cannot make its part ends with 1.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/document/document.h"
#include "engine/document/update.h"
#include "engine/io/json_values.h"
#include "engine/io/picture_file.h"
#include "engine/loft/loft.h"
#include "engine/mesh/self_crossing.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/silhouette.h"
#include "engine/vision/edges.h"
#include "tests/bench/bridge_stages.h"
#include "tests/bench/drawing_stages.h"
#include "tests/bench/layer_stages.h"
#include "tests/bench/must.h"
#include "tests/bench/pen_stages.h"
#include "tests/bench/puff_stages.h"
#include "tests/bench/pull_stages.h"
#include "tests/bench/relief_stages.h"
#include "tests/bench/report.h"
#include "tests/bench/rib_stages.h"
#include "tests/bench/scene.h"
#include "tests/support/random_programs.h"

using namespace spineloft;

namespace {

std::string fileText(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// One line of JSON a stroke.
void printRibs(const std::string& folder) {
  const io::BenchCase one = bench::must(io::readBenchCase(fileText(folder + "/case.json")));
  const std::string text = fileText(folder + "/" + one.image);
  const io::Bytes bytes(text.begin(), text.end());
  const image::Picture picture = bench::must(io::decodePicture(bytes, Progress()));
  const image::EdgeMap edges = bench::must(vision::detectEdges(picture, {}, Progress()));
  for (const auto& [name, stroke] : one.strokes) {
    document::LoftRecipe recipe;
    recipe.stroke = stroke;
    const image::Size size{picture.width, picture.height};
    std::cout << io::writeRibs(bench::must(pipeline::shapePart(recipe, edges, size, Progress())).ribs);
  }
}

// Eight parts of 60 ribs, one of whose rib ends is dragged softly: the preview of each move, and
// the whole document at pen-up.
void timeRibDrag(bench::Report& report, const image::Picture& picture, const image::EdgeMap& edges,
                 const std::vector<PicturePoint>& stroke) {
  using namespace document;
  const auto shared = std::make_shared<const image::Picture>(picture);
  Document model = bench::must(update({}, AddPicture{"tube", shared}));
  for (std::uint32_t part = 1; part <= 8; ++part) {
    model = bench::must(update(model, DrawSpine{PictureId{1}, stroke}));
    model = bench::must(update(model, SetParameter{PartId{part}, "ribs", 60}));
  }
  pipeline::Cache cache;
  cache.keepEdges(model.pictures[0]->contentHash, std::make_shared<const image::EdgeMap>(edges));
  pipeline::derive(model, cache);
  constexpr int kMoves = 101;
  const auto dragged = [&](int move) {
    return ribs::RibEdits{{{.at = 0.5, .out = 40.0 + 0.3 * move, .reach = 0.1}}, {}, {}};
  };
  report.stage("rib drag to mesh", kMoves, [&](int move) {
    LoftRecipe recipe = *document::loftOf(*model.parts[3]);
    recipe.edits = dragged(move);
    bench::must(pipeline::previewShape(model, recipe, cache));
  });
  report.stage("rib edit of 8 parts", kMoves, [&](int move) {
    model = bench::must(update(model, EditRibs{PartId{4}, dragged(move)}));
    pipeline::derive(model, cache);
  });
}

/// Other parts made of a region.
void reportRegionStages(bench::Report& report) {
  const document::Region region{PictureId{1}, bench::blob(), 0};
  const document::ExtrudeRecipe extrude{region, {}};
  const document::LatheRecipe spun{region, {{40, 0}, {40, 499}}};
  report.stage("flat piece of 400 px", 51, [&](int) { bench::must(pipeline::regionStage(extrude, {500, 500})); });
  report.stage("spun ring of 400 px", 51, [&](int) { bench::must(pipeline::regionStage(spun, {500, 500})); });
}

void printStageTimes() {
  const image::Size size{1024, 768}, photo{2304, 1728};
  const image::Picture picture = bench::tubePicture(size), large = bench::tubePicture(photo);
  const Progress progress;
  const image::EdgeMap edges = bench::must(vision::detectEdges(picture, {}, progress));

  bench::Report report;
  report.stage("edges 1024x768", 15, [&](int) { bench::must(vision::detectEdges(picture, {}, progress)); });
  const std::pair<const char*, image::Size> sizes[] = {
      {"quarter", {576, 432}}, {"1", {1152, 864}}, {"2", {1632, 1224}}};
  for (const auto& [megapixels, of] : sizes) {
    const image::Picture one = bench::tubePicture(of);
    report.stage(std::string("edges of a ") + megapixels + "-megapixel picture", 15,
                 [&](int) { bench::must(vision::detectEdges(one, {}, progress)); });
  }
  report.stage("edges of a 4-megapixel picture", 15,
               [&](int) { bench::must(vision::detectEdges(large, {}, progress)); });
  document::LoftRecipe recipe;
  recipe.stroke = bench::tubeStroke(size, 200);
  bench::reportRibStages(edges, size, report);
  bench::reportInvariance(edges, size, report);
  bench::reportFieldStages(report);
  recipe.spine.ribs = 100;
  const pipeline::PartShape shape = bench::must(pipeline::shapePart(recipe, edges, size, progress));
  loft::LoftParams params;
  params.sectionPoints = 64;
  // As under the pen: in memory that is there, and often enough that a browser has compiled it for good.
  const loft::PosedSpine atRest = bench::must(loft::poseSpine(shape.spine, {}));
  loft::LoftWorkspace memory;
  mesh::TriMesh mesh;
  report.stage("loft 100x64", 501, [&](int) {
    if (!loft::loftRibs({shape.ribs, size, params}, atRest, memory, mesh).ok()) std::exit(1);
  });
  report.stage("whether a loft goes through itself", 101, [&](int) {
    if (mesh::selfCrossing(shape.mesh)) std::exit(1);
  });
  report.stage("silhouette", 21, [&](int) {
    if (pipeline::rasteriseSilhouette(shape.mesh, size).pixels.empty()) std::exit(1);
  });
  bench::reportPuffStages(report);
  reportRegionStages(report);
  bench::reportDrawingStages(report);
  bench::reportLayerStages(report);
  bench::reportPullStages(report);
  bench::reportBridgeStages(report);
  bench::reportReliefStages(report);
  bench::reportPenStages(picture, edges, report);
  timeRibDrag(report, picture, edges, recipe.stroke);
  bench::reportTwoWorkers(picture, report);
}

std::vector<std::vector<double>> rowsOf(const Eigen::MatrixXd& matrix) {
  std::vector<std::vector<double>> out;
  for (const auto& row : matrix.rowwise()) out.emplace_back(row.begin(), row.end());
  return out;
}

/// One line of JSON a random quadratic program: it, and its optimum.
void printPrograms(std::uint64_t count) {
  for (std::uint64_t seed = 1; seed <= count; ++seed) {
    const testing::RandomProgram program = testing::randomProgram(seed);
    nlohmann::json rows = nlohmann::json::array();
    for (const geometry::QpRow& row : program.qp.rows) {
      std::vector<double> dense(program.qp.unknowns);
      for (const geometry::QpTerm& term : row.terms) dense[term.unknown] = term.value;
      rows.push_back({{"row", dense}, {"least", row.least}});
    }
    const nlohmann::json line{{"energy", rowsOf(program.energy)},
                              {"linear", program.qp.linear},
                              {"rows", rows},
                              {"z", bench::must(geometry::solveQp(program.qp)).z}};
    std::cout << line.dump() << '\n';
  }
}

/// What can be measured alone.
struct Stages {
  std::string_view word;
  void (*measure)(bench::Report&);
};
constexpr Stages kStages[] = {
    {"--photo", bench::reportPhoto},
    {"--pen",
     [](bench::Report& report) {
       const image::Picture picture = bench::tubePicture({1024, 768});
       bench::reportPenStages(picture, bench::must(vision::detectEdges(picture, {}, Progress())), report);
     }},
    {"--puffs",
     [](bench::Report& report) {
       bench::tubePicture({2304, 1728});  // as after other work: what is freed stays with the process
       bench::reportPuffStages(report);
     }},
    {"--drawings", bench::reportDrawingStages},
    {"--layers", bench::reportLayerStages},
    {"--pulls", bench::reportPullStages},
    {"--bridges", bench::reportBridgeStages},
    {"--reliefs", bench::reportReliefStages},
    {"--workers", [](bench::Report& report) { bench::reportTwoWorkers(bench::tubePicture({1024, 768}), report); }},
};

int explain() {
  std::cerr << "spineloft_bench: no words, --programs and a number, --ribs and a case folder, or one of";
  for (const Stages& stages : kStages) std::cerr << ' ' << stages.word;
  std::cerr << '\n';
  return 2;
}

}  // namespace

int main(int count, char** words) {
  if (count == 3 && std::string(words[1]) == "--ribs") {
    printRibs(words[2]);
  } else if (count == 3 && std::string(words[1]) == "--programs") {
    printPrograms(std::strtoull(words[2], nullptr, 10));
  } else if (count == 2) {
    const auto asked = std::ranges::find(kStages, std::string_view(words[1]), &Stages::word);
    if (asked == std::ranges::end(kStages)) return explain();
    bench::Report report;
    asked->measure(report);
  } else if (count == 1) {
    printStageTimes();
  } else {
    return explain();
  }
  return 0;
}
