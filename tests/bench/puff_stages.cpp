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
#include "tests/bench/must.h"
#include "tests/support/named_shapes.h"

namespace spineloft::bench {
namespace {

constexpr image::Size kPicture{500, 500};

double pointsOf(const document::InflateRecipe& recipe) {
  return static_cast<double>(must(pipeline::regionStage(recipe, kPicture)).mesh.positions.size());
}

/// Stages of a puff with a slice beside a soft one of the same recipe, and of one that comes out with as many points.
/// `what` is empty, or begins with a space.
void reportShape(const geometry::Contours& contours, const std::string& what, Report& report) {
  const document::Region region{PictureId{1}, contours, 0};
  struct Size {
    int points, runs;
    std::string softStage;
  };
  for (const Size& size : {Size{4000, 21, "puff" + (what.empty() ? " of 400 px" : what) + ", 4000 points"},
                           Size{900, 51, "puff" + what + " under the pen, 900 points"}}) {
    const document::InflateRecipe soft{region, {1, inflate::InflateSides::Both, size.points}, {}};
    document::InflateRecipe round = soft, asMany = soft;
    round.inflate.profile.slices = {{sections::SectionPreset::Circle}};
    asMany.inflate.points = static_cast<int>(std::lround(size.points * pointsOf(round) / pointsOf(soft)));
    const std::string end = ", " + std::to_string(size.points) + " points";
    const auto stage = [&](const std::string& name, const std::function<void(int)>& work) {
      return report.stage(name, size.runs, work);
    };
    const double softTime = stage(size.softStage, [&](int) { must(pipeline::regionStage(soft, kPicture)); });
    const double asManyTime = stage("puff" + what + " of as many points as with a slice" + end,
                                    [&](int) { must(pipeline::regionStage(asMany, kPicture)); });
    const auto ratios = [&](const std::string& name, const std::function<void(int)>& work) {
      const double time = stage(name, work);
      report.value(name + ", ratio to a soft puff", time / softTime);
      report.value(name + ", ratio to a soft puff of as many points", time / asManyTime);
    };
    ratios("puff" + what + " with a slice" + end, [&](int) { must(pipeline::regionStage(round, kPicture)); });
    pipeline::KnownInterior interior;
    must(pipeline::regionStage(round, kPicture, interior));
    ratios("slice of a puff" + what + " dragged" + end,
           [&](int) { must(pipeline::regionStage(round, kPicture, interior)); });
    if (size.points == 4000) {
      const geometry::Contours clean = must(geometry::cleanRegion(contours, 0, {500, 500}));
      ratios("bones of a puff" + what, [&](int) { must(inflate::editedSkeleton(clean, {})); });
    }
  }
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
