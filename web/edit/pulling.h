// Pulls of the part in hand, as the solid view shows them.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/world.h"
#include "web/edit/outline.h"
#include "web/ui/ui_state.h"

namespace spineloft::app {

/// The part in hand of the tool Pull, as it is shown now: with the gesture in hand.
struct PulledPart {
  const document::Part* part = nullptr;
  const pipeline::PartShape* shape = nullptr;
  std::span<const pull::Pull> pulls;  ///< at most as many as shape->pulled
  pipeline::Copies copies;
  const pipeline::ToWorld& toWorld() const { return *copies.begin(); }  ///< its first copy
  explicit operator bool() const { return shape != nullptr; }
};
/// Any visible part with a shape; none without the tool or the part.
PulledPart pulledPart(const document::Document& document, const pipeline::Derived& derived, const UiState& ui);
/// The same of a part that is named, whatever tool is in hand.
PulledPart pulledPartOf(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                        PartId part);

/// The knob of a pull: in the middle of its line.
struct PullKnob {
  ClientPoint at;       ///< CSS pixels of the canvas
  ClientPoint unit;     ///< where a picture pixel more height takes it; where that is seen end on, upwards
  bool facing = false;  ///< the surface there is turned to the eye
};
/// None behind the eye.
std::optional<PullKnob> pullKnob(const PulledPart& part, const UiState& ui, std::size_t number);
/// The number of the nearest knob within reach, CSS pixels: one that faces the eye, or the chosen one. −1: none.
int pullKnobAt(const PulledPart& part, const UiState& ui, ClientPoint at, double reach);

/// A place on a copy of a part, in ModelSpace.
struct SurfacePlace {
  ModelPoint at;
  std::size_t copy = 0;  ///< of the part, which was hit
};
/// Where a ray meets the surface of any copy first.
std::optional<SurfacePlace> surfaceUnder(const PulledPart& part, const Ray& ray);

/// The diagonal of its bounds, picture pixels.
double sizeOf(const pipeline::PartShape& shape);
/// A pull along a line on the surface, of the width and sharpness that the tool is set to, out by half of its radius.
/// A line that is short beside the radius is a place. `line` ≥ 1 point.
pull::Pull usualPull(const PulledPart& part, const EditOptions& options, const std::vector<ModelPoint>& line);
/// How far out it goes: its height, or that of the middle of where its line goes.
double heightOf(const pull::Pull& pull, const pipeline::PulledLine& shown);
/// With another height: of one with a line to go to all of that is moved on, of a bump with profiles their middles most
/// and their ends not.
pull::Pull raised(const pull::Pull& pull, const pipeline::PulledLine& shown, double by);
/// Between two that differ in nothing but where they go: `share` of the way from one to the other. None: they differ in
/// more.
std::optional<pull::Pull> between(const pull::Pull& from, const pull::Pull& to, double share);

}  // namespace spineloft::app
