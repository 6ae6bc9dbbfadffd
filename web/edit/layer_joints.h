// How the layer on the sheet goes on to its neighbours: which curve becomes which, and how high forks are. The tool
// previews and commands act through the same functions.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "web/edit/layers.h"

namespace spineloft::app {

/// A curve of a layer and one of the next, which become each other, or might.
struct LayerLink {
  std::size_t plane = 0;           ///< of the first one
  std::uint32_t from = 0, to = 0;  ///< curves
  bool on = false;
  ModelPoint a, b;  ///< their middles
  ModelPoint mark;  ///< between them: what a tap changes
};

/// A curve that parts into several, or into which several join. Where both layers part into each other none is told.
struct LayerFork {
  std::size_t plane = 0;
  std::uint32_t curve = 0;
  bool up = true;
  double at = 0;           ///< share of the way from the one to the several
  ModelPoint stem, ahead;  ///< middles of the one, and of the several
  ModelPoint knob() const { return lerp(stem, ahead, at); }
};

struct LayerJoints {
  std::vector<LayerLink> links;
  std::vector<LayerFork> forks;
};

/// Those between the layer on the sheet and the ones before and after it, or between those that the sheet stands
/// between; as the part is shown. Layers of one curve each have none: there is nothing to choose.
LayerJoints jointsOf(const document::Document& document, const pipeline::Derived& derived, const UiState& ui,
                     const Sheet& sheet);

document::StackRecipe withLink(const document::StackRecipe& recipe, const LayerLink& link, bool on);
/// `at`: 0…1.
document::StackRecipe withFork(const document::StackRecipe& recipe, const LayerFork& fork, double at);

/// Takes a curve out of a layer, and what is said about its links.
void dropCurve(document::StackRecipe& recipe, std::size_t plane, std::size_t curve);
/// Forgets what is said about the links to a layer: another one follows, or is followed by it.
void dropLinksTo(document::StackRecipe& recipe, std::size_t plane);

}  // namespace spineloft::app
