#include "tests/bench/puff_stages.h"

#include <cmath>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "engine/document/document.h"
#include "engine/geometry/region.h"
#include "engine/inflate/bone_edits.h"
#include "engine/pipeline/derive.h"
#include "tests/support/named_shapes.h"

namespace spineloft::bench {
namespace {

constexpr image::Size kPicture{500, 500};

template <class T>
T must(Result<T> result) {
  if (!result.ok()) std::exit(1);
  return std::move(result).value();
}

/// `what` is empty, or begins with a space.
void reportShape(const geometry::Contours& contours, const std::string& what, Report& report) {
  const document::Region region{PictureId{1}, contours, 0};
  const document::InflateRecipe inflate{region, {1, inflate::InflateSides::Both, 4000}, {}};
  const document::InflateRecipe moving{region, {1, inflate::InflateSides::Both, 900}, {}};
  document::InflateRecipe round = inflate, movingRound = moving;
  round.inflate.profile.slices = movingRound.inflate.profile.slices = {{sections::SectionPreset::Circle}};
  const auto stage = [&](const std::string& name, int runs, const std::function<void(int)>& work) {
    return report.stage(name, runs, work);
  };
  const double soft = stage("puff" + (what.empty() ? " of 400 px" : what) + ", 4000 points", 21,
                            [&](int) { must(pipeline::regionStage(inflate, kPicture)); });
  const double softMoving = stage("puff" + what + " under the pen, 900 points", 51,
                                  [&](int) { must(pipeline::regionStage(moving, kPicture)); });
  const auto ratio = [&](const std::string& name, int runs, double of, const std::function<void(int)>& work) {
    report.value(name + ", ratio to a soft puff", stage(name, runs, work) / of);
  };
  ratio("puff" + what + " with a slice, 4000 points", 21, soft,
        [&](int) { must(pipeline::regionStage(round, kPicture)); });
  ratio("puff" + what + " with a slice, 900 points", 51, softMoving,
        [&](int) { must(pipeline::regionStage(movingRound, kPicture)); });
  pipeline::KnownInterior interior;
  must(pipeline::regionStage(round, kPicture, interior));
  ratio("slice of a puff" + what + " dragged, 4000 points", 21, soft,
        [&](int) { must(pipeline::regionStage(round, kPicture, interior)); });
  ratio("slice of a puff" + what + " dragged, 900 points", 51, softMoving,
        [&](int) { must(pipeline::regionStage(movingRound, kPicture, interior)); });
  const geometry::Contours clean = must(geometry::cleanRegion(contours, 0, {500, 500}));
  ratio("bones of a puff" + what, 51, soft, [&](int) { must(inflate::editedSkeleton(clean, {})); });
}

}  // namespace

geometry::Contours blob() {
  geometry::Contours contours{{}};
  for (int i = 0; i < 300; ++i) {
    const double a = 2 * std::numbers::pi * i / 300, r = 180 + 14 * std::sin(3 * a) + 9 * std::sin(5 * a + 1);
    contours[0].push_back({250 + r * std::cos(a), 250 + r * std::sin(a)});
  }
  return contours;
}

void reportPuffStages(Report& report) {
  reportShape(blob(), "", report);
  for (const char* name : {"hand", "star"}) {
    reportShape(testing::namedShape(name).contours, std::string(" of a ") + name, report);
  }
}

}  // namespace spineloft::bench
