// The bridge in hand, apart from how bridges are made: it is asked for in every frame.
#include <algorithm>

#include "web/edit/bridging.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"

namespace spineloft::app {

ShownBridge bridgeInHand(const document::Document& document, const pipeline::Derived& derived, const UiState& ui) {
  if (ui.tool != ToolKind::Bridge) return {};
  const document::Part* part = document::findPart(document, ui.selection);
  const auto made = std::ranges::find(derived.parts, ui.selection, &pipeline::DerivedPart::id);
  if (part == nullptr || !document::bridgeOf(*part) || made == derived.parts.end()) return {};
  const document::PictureEntry* entry = document::findPicture(document, document::pictureOf(*part));
  if (entry == nullptr || !pipeline::isVisible(document, *part)) return {};
  ShownBridge bridge{part, made->shape.get(), shownCopies(ui, *part, entry->size)};
  if (const Preview* preview = previewOf(ui, part->id)) bridge.shape = &*preview->shape;
  if (bridge.shape != nullptr && bridge.shape->rims.size() != 2) return {};
  return bridge;
}

std::optional<ClientPoint> rimKnob(const ShownBridge& bridge, const UiState& ui, int end) {
  const bridge::Rim& rim = bridge.shape->rims[static_cast<std::size_t>(end)];
  return pointOnCanvas(ui.camera, ui.layout.solid, (*bridge.copies.begin())(rim.centre));
}

bool rimFaces(const ShownBridge& bridge, const UiState& ui, int end) {
  const bridge::Rim& rim = bridge.shape->rims[static_cast<std::size_t>(end)];
  const pipeline::ToWorld& toWorld = *bridge.copies.begin();
  return dot(toWorld.along(rim.out), ui.camera.eye() - toWorld(rim.centre)) > 0;
}

int rimKnobAt(const ShownBridge& bridge, const UiState& ui, ClientPoint at, double reach) {
  int found = -1;
  for (int end = 0; bridge && end < 2; ++end) {
    const auto knob = rimKnob(bridge, ui, end);
    if (!knob || !rimFaces(bridge, ui, end) || distance(*knob, at) > reach) continue;
    reach = distance(*knob, at);
    found = end;
  }
  return found;
}

}  // namespace spineloft::app
