#include "web/edit/preview.h"

#include <algorithm>

#include "engine/base/hash.h"
#include "engine/mesh/self_crossing.h"

namespace spineloft::app {
namespace {

constexpr double kRestMs = 120;        // a hand that has not moved for so long rests
constexpr double kPreviewShare = 0.6;  // of the time may go into shapes under the pen

}  // namespace

Preview& beginPreview(UiState& ui) {
  static const document::LoftRecipe kNothingDrawn;
  Preview& preview = ui.preview.renew();
  preview.asLoft() = kNothingDrawn;
  preview.part = {};
  preview.pulls.clear();
  preview.relief.reset();
  preview.look = {};
  preview.fresh = false;
  preview.shape.reset();
  preview.revision = 0;
  preview.costMs = preview.nextMs = 0;
  preview.exactMs.reset();
  preview.guarded = false;
  preview.crossing.reset();
  preview.pressure.clear();
  return preview;
}

Preview& previewPart(UiState& ui, const document::Part& part) {
  if (ui.preview && ui.preview->part == part.id) return *ui.preview;
  Preview& preview = beginPreview(ui);
  preview.part = part.id;
  preview.recipe = part.recipe;
  preview.pulls = part.pulls;
  preview.relief = part.relief;
  preview.look = part.look;
  return preview;
}

Preview& previewNewPart(UiState& ui) {
  Preview& preview = beginPreview(ui);
  preview.asLoft().picture = ui.picture;
  preview.asLoft().loft.sections.front().shape = ui.section;
  preview.asLoft().loft.startCap = ui.startCap;
  preview.asLoft().loft.endCap = ui.endCap;
  preview.look = ui.look;
  return preview;
}

document::Region regionOfLine(PictureId picture, std::vector<PicturePoint> line, image::Size size) {
  constexpr double kOpen = 0.3;     // the gap's share of the way: an open line
  constexpr double kRibbon = 0.03;  // of the picture's longer side
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  const double gap = line.empty() ? 0 : distance(line.front(), line.back());
  document::Region region{picture, {}, 0};
  if (gap > kOpen * length) {
    region.ribbon =
        std::clamp(kRibbon * std::max(size.width, size.height), document::kLeastRibbon, document::kMostRibbon);
  }
  region.contours.push_back(std::move(line));
  return region;
}

void growPreview(UiState& ui, Studio& studio, const platform::Host& host) {
  if (!ui.preview || ui.preview->settled()) return;
  Preview& preview = *ui.preview;
  const double now = host.nowMs();
  const bool rests = preview.fresh;
  if (now < (rests ? *preview.exactMs : preview.nextMs)) return;
  preview.fresh = true;
  preview.exactMs.reset();
  pipeline::PartShape& shape = preview.shape.room();
  // Pulls under a moving hand go all their way: whether the part then goes through itself says the exact
  // shape alone.
  const bool exact = rests || (preview.guarded && !preview.pulls.empty());
  const pipeline::Worked worked{preview.pulls, preview.relief ? &*preview.relief : nullptr};
  const Status made =
      exact ? studio.preview(preview.recipe, worked, shape) : studio.previewLive(preview.recipe, worked, shape);
  if (made && preview.guarded) {
    const auto at = mesh::selfCrossing(smoothMesh(shape));
    preview.crossing = at ? std::optional(ModelPoint{(*at)[0], (*at)[1], (*at)[2]}) : std::nullopt;
    if (!at) preview.taken = preview.recipe;
  }
  preview.costMs = host.nowMs() - now;
  preview.nextMs = host.nowMs() + preview.costMs * (1 / kPreviewShare - 1);
  if (!made || preview.crossing) return;  // the last good one stays
  if (shape.quality == pipeline::TraceQuality::Live) preview.exactMs = host.nowMs() + kRestMs;
  preview.shape.renew();
  preview.revision = ++ui.previewShapes;
}

void growSolid(UiState& ui, Studio& studio, const platform::Host& host) {
  InHand& hand = ui.inHand;
  if (hand.pin) {
    const double now = host.nowMs();
    if (hand.pinShown || now < hand.pinNextMs) return;
    studio.previewPinned(*hand.pin);
    hand.pinShown = true;
    hand.pinNextMs = host.nowMs() + (host.nowMs() - now) * (1 / kPreviewShare - 1);
  } else if (!ui.placing.empty()) {
    studio.previewPlaced({ui.placing});
  } else if (!ui.preview || !ui.preview->part || !ui.preview->shape) {
    studio.endPreview();
  } else {
    const Preview& preview = *ui.preview;
    const ShapeKey key{Hasher().text("preview").number(preview.revision).value()};
    studio.previewSolid({preview.part, key, &preview.shape->mesh});
  }
}

void guardPreview(UiState& ui, const document::Document& document, const pipeline::Derived& derived) {
  if (!ui.preview || ui.preview->guarded) return;
  const document::Part* part = document::findPart(document, ui.preview->part);
  const auto now = std::ranges::find(derived.parts, ui.preview->part, &pipeline::DerivedPart::id);
  if (part == nullptr || now == derived.parts.end() || !now->shape || mesh::selfCrossing(smoothMesh(*now->shape)))
    return;
  ui.preview->guarded = true;
  ui.preview->taken = part->recipe;
}

const document::LoftRecipe* heldBack(const UiState& ui) {
  return ui.preview && ui.preview->crossing ? std::get_if<document::LoftRecipe>(&ui.preview->taken) : nullptr;
}

const Preview* previewOf(const UiState& ui, PartId part) {
  return part && ui.preview && ui.preview->part == part && ui.preview->shape ? &*ui.preview : nullptr;
}

}  // namespace spineloft::app
