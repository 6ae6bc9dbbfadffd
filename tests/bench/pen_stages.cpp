#include "tests/bench/pen_stages.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/lanes.h"
#include "engine/base/worker_pool.h"
#include "engine/document/document.h"
#include "engine/document/update.h"
#include "engine/pipeline/derive.h"
#include "engine/vision/edges.h"
#include "tests/bench/accuracy/d2_grid.h"
#include "tests/bench/must.h"
#include "tests/bench/scene.h"

#ifdef __EMSCRIPTEN__
#include <emscripten/heap.h>
#else
#include <malloc.h>
#include <sys/resource.h>
#endif

namespace spineloft::bench {
namespace {

// Megabytes in use; of WebAssembly all that it ever took, for that never shrinks.
double heapMegabytes() {
#ifdef __EMSCRIPTEN__
  return static_cast<double>(emscripten_get_heap_size()) / 1048576;
#else
  const struct mallinfo2 info = mallinfo2();
  return static_cast<double>(info.uordblks + info.hblkhd) / 1048576;
#endif
}

// The most that was ever in use.
double peakMegabytes() {
#ifdef __EMSCRIPTEN__
  return heapMegabytes();
#else
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024;
#endif
}

// A picture with its edges, as the page holds them while a stroke is drawn.
struct Desk {
  document::Document model;
  pipeline::Cache cache;
  std::vector<PicturePoint> stroke;
  document::Recipe recipe;
  pipeline::PartShape shape;
  Desk(const image::Picture& picture, const image::EdgeMap& edges)
      : stroke(tubeStroke({picture.width, picture.height}, 200)) {
    model = must(document::update({}, document::AddPicture{"tube", std::make_shared<const image::Picture>(picture)}));
    cache.keepEdges(model.pictures[0]->contentHash, std::make_shared<const image::EdgeMap>(edges));
  }
  // The stroke's beginning; `wobble` makes it another stroke, which no cache knows.
  void draw(double share, int ribs, int wobble) {
    document::LoftRecipe& loft = std::get<document::LoftRecipe>(recipe);
    loft.picture = PictureId{1};
    loft.spine.ribs = ribs;
    const auto count = static_cast<std::size_t>(std::max(2.0, share * static_cast<double>(stroke.size())));
    loft.stroke.assign(stroke.begin(), stroke.begin() + static_cast<std::ptrdiff_t>(count));
    for (PicturePoint& p : loft.stroke) p.y += 0.01 * wobble;
    must(pipeline::liveShape(model, recipe, cache, shape));
  }
  // The whole stroke becomes a part, shown before its texture is made.
  struct Lifted {
    document::Document model;
    pipeline::Derived derived;
  };
  Lifted lift(int ribs, int wobble) {
    std::vector<PicturePoint> line = stroke;
    for (PicturePoint& p : line) p.y += 0.01 * wobble;
    document::Document drawn = must(document::update(model, document::DrawSpine{PictureId{1}, std::move(line)}));
    drawn = must(document::update(drawn, document::SetParameter{PartId{1}, "ribs", static_cast<double>(ribs)}));
    pipeline::Derived derived = pipeline::derive(drawn, cache, {}, pipeline::Finish::Later);
    if (!derived.parts[0].shape) std::exit(1);
    return {std::move(drawn), std::move(derived)};
  }
  // The steps in which it gets its texture after that.
  std::shared_ptr<pipeline::TextureJob> assignTextures(int wobble) {
    const Lifted lifted = lift(100, wobble);
    return pipeline::makeTexture(lifted.model, pipeline::derive(lifted.model, cache), PartId{1});
  }
};

double secondsOf(const std::function<void()>& work) {
  const auto started = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count();
}

// Sums that need nothing but a core's arithmetic: no memory, nothing that waits. Two processors that are threads of one
// core share that, so no two workers can gain more by work of this kind than this does.
void fillCore() {
  constexpr int kRounds = 1'500'000, kChains = 12;
  Float4 sums[kChains];
  for (int c = 0; c < kChains; ++c) sums[c] = all4(0.1f + static_cast<float>(c));
  for (int i = 0; i < kRounds; ++i) {
    for (Float4& sum : sums) sum = sum * 0.9999f + 0.1f;
  }
  volatile float kept = 0;
  for (const Float4& sum : sums) kept = kept + sum[0];
}

// Two jobs one after the other, and on two workers: the least time of each so far.
struct TwoJobs {
  const char* name;
  std::function<void(int)> job;
  double alone = 1e9, together = 1e9;

  void run(WorkerPool& pool) {
    alone = std::min(alone, secondsOf([&] {
                       job(0);
                       job(1);
                     }));
    together = std::min(together, secondsOf([&] {
                          int left = 2;
                          for (int i = 0; i < 2; ++i) {
                            pool.submit(
                                "half",
                                [this, i](const Progress&) {
                                  job(i);
                                  return i;
                                },
                                [&left](int) { --left; });
                          }
                          // A page looks after every frame. To look far more often takes time from the workers.
                          while (left > 0) {
                            if (pool.pump() == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
                          }
                        }));
  }
};

}  // namespace

void reportPenStages(const image::Picture& picture, const image::EdgeMap& edges, Report& report) {
  constexpr int kMoves = 200;
  Desk desk(picture, edges);
  int wobble = 0;
  for (const int ribs : {100, 200}) {
    const auto move = [&](int i) { desk.draw(0.2 + 0.8 * (i + 1) / kMoves, ribs, ++wobble); };
    for (int i = 0; i < kMoves; i += 10) move(i);
    report.stage(ribs == 100 ? "pen move to mesh" : "pen move to mesh, 200 ribs", kMoves, move);
    report.stage(ribs == 100 ? "pen up to mesh" : "pen up to mesh, 200 ribs", 21,
                 [&](int) { desk.lift(ribs, ++wobble); });
  }
  // How long a page without workers stands still for a texture, and how long the whole takes.
  int steps = 0;
  const std::shared_ptr<pipeline::TextureJob> counted = desk.assignTextures(++wobble);
  for (bool more = true; more; ++steps) more = counted->step();
  for (int step = 0; step < steps; ++step) {
    std::vector<std::shared_ptr<pipeline::TextureJob>> begun;
    for (int i = 0; i < 13; ++i) {
      begun.push_back(desk.assignTextures(++wobble));
      for (int k = 0; k < step; ++k) begun.back()->step();
    }
    std::size_t next = 0;
    report.stage("texture, step " + std::to_string(step + 1) + " of " + std::to_string(steps), 11,
                 [&](int) { begun[next++]->step(); });
  }
  constexpr int kStrokes = 1000, kFirst = 10;
  double first = 0;
  for (int i = 0; i < kStrokes; ++i) {
    desk.draw(1, 40, ++wobble);
    if (i == kFirst) first = heapMegabytes();
  }
  report.value("heap, MB more after a thousand strokes", heapMegabytes() - first);
}

void reportPhoto(Report& report) {
  const image::Size size{6000, 4000};
  image::Picture picture;
  {
    // As a browser decodes it: all pixels, which go as soon as the picture is made.
    std::vector<std::uint8_t> pixels(4 * static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height),
                                     255);
    const std::vector<PicturePoint> middle = tubeStroke(size, size.width);
    std::size_t at = 0;
    for (int y = 0; y < size.height; ++y) {
      for (int x = 0; x < size.width; ++x, at += 4) {
        const bool inside = std::abs(y - middle[static_cast<std::size_t>(x)].y) < 400 && x > 700 && x < 5300;
        const auto value = static_cast<std::uint8_t>((inside ? 80 : 160) + (x * 7 + y * 13) % 23);
        pixels[at] = pixels[at + 1] = pixels[at + 2] = value;
      }
    }
    picture = image::makePicture(image::ImageView{size.width, size.height, pixels}, 1);
  }
  const image::EdgeMap edges = must(vision::detectEdges(picture, {}, Progress()));
  Desk desk(picture, edges);
  desk.draw(1, 100, 0);
  report.value("heap at its largest with a photo of 24 megapixels, MB", peakMegabytes());
}

void reportTwoWorkers(const image::Picture& picture, Report& report) {
  constexpr int kRounds = 15;
  WorkerPool pool(2);
  if (pool.threads() < 2) return;
  const std::vector<PicturePoint> line = tubeStroke({300, 300}, 1000);
  std::vector<float> halves[2];
  TwoJobs all[] = {
      {"edges", [&](int) { must(vision::detectEdges(picture, {}, Progress())); }},
      {"field", [&](int half) { accuracy::d2OnGrid(line, {{0, 150.0 * half}, 1, 300, 150}, halves[half]); }},
      {"arithmetic alone", [](int) { fillCore(); }}};
  // In turn: what a machine gives changes by the second.
  for (int round = 0; round < kRounds; ++round) {
    for (TwoJobs& jobs : all) jobs.run(pool);
  }
  for (const TwoJobs& jobs : all)
    report.value(std::string("two workers against one, ") + jobs.name, jobs.alone / jobs.together);
}

}  // namespace spineloft::bench
