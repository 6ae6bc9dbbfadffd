// Bridges between parts: where they can stand, how they begin, and the one in hand as the solid view shows it.
#pragma once

#include <array>
#include <optional>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/edit/outline.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// A place of a part on which a bridge can stand.
struct BridgePlace {
  PartId part;
  ModelPoint at, normal;  ///< in the space of the part; `normal`: unit
  double room = 0;        ///< radius of the largest circle round it that lies on one side of the part, there
  double scale = 1;       ///< WorldSpace units a ModelSpace unit of the part
  WorldPoint inWorld, out;
};
/// The place of a part nearest to one in its space. None: the part is hidden, a bridge, or has no shape.
std::optional<BridgePlace> bridgePlaceOn(const document::Document& document, const pipeline::Derived& derived,
                                         PartId part, ModelPoint near);
/// What lies first under a place of the canvas, CSS pixels: of the parts as they are without solids, whose surface has
/// no hole where a bridge stands. Bridges are seen through. None as well on the twin of a part.
std::optional<BridgePlace> bridgePlaceUnder(const document::Document& document, const pipeline::Derived& derived,
                                            const UiState& ui, ClientPoint at);
/// The places of two parts that are nearest to each other.
struct FacingPlaces {
  BridgePlace from, to;
  double gap = 0;  ///< between them, as a share of the smaller part
};
std::optional<FacingPlaces> facingPlaces(const document::Document& document, const pipeline::Derived& derived,
                                         PartId from, PartId to);

/// A bridge between two places with round rims, `width` times as wide as usual.
document::BridgeRecipe usualBridge(const document::Document& document, const BridgePlace& from, const BridgePlace& to,
                                   double width);
/// Whether a drag from one to the other means a bridge: two places of one part are not almost the same.
bool areApart(const BridgePlace& from, const BridgePlace& to);
/// How it looks: as the part that it begins on, in the mean colour of its picture where it has that on.
document::Look bridgeLook(const document::Document& document, const pipeline::Derived& derived, PartId from);
/// Its rims are larger about their middles.
void widenBridge(document::BridgeRecipe& recipe, double factor);
/// The rim of an end, carried to another place, as large as it is in the world. None: its part is not there.
std::optional<document::BridgeEnd> carriedEnd(const document::Document& document, const pipeline::Derived& derived,
                                              const document::BridgeEnd& end, const BridgePlace& to);

/// The selected bridge with the tool for bridges in hand, as it is shown now.
struct ShownBridge {
  const document::Part* part = nullptr;
  const pipeline::PartShape* shape = nullptr;  ///< with two rims
  pipeline::Copies copies;
  explicit operator bool() const { return shape != nullptr; }
};
ShownBridge bridgeInHand(const document::Document& document, const pipeline::Derived& derived, const UiState& ui);
/// Where an end of it is held, 0 or 1, CSS pixels of the canvas. None: behind the eye.
std::optional<ClientPoint> rimKnob(const ShownBridge& bridge, const UiState& ui, int end);
/// Whether the surface under an end is turned to the eye.
bool rimFaces(const ShownBridge& bridge, const UiState& ui, int end);
/// The nearest one within reach that is turned to the eye; −1: none.
int rimKnobAt(const ShownBridge& bridge, const UiState& ui, ClientPoint at, double reach);

}  // namespace spineloft::app
