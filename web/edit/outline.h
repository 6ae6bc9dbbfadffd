// A part as seen in the picture: its outline, and which part lies under a point or a ray.
#pragma once

#include <span>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

namespace spineloft::app {

/// The closed outline of ribs in picture pixels: left ends, round the end, right ends
/// back, round the start. Round caps follow the end fans. Appended to `out`, which is cleared
/// first.
void outlineOf(const ribs::RibSet& set, const loft::LoftParams& params, std::vector<PicturePoint>& out);

/// The visible part of `picture` under the point: the one that was moved farthest to the front, of several the last
/// one of the list; none elsewhere. A spine
/// nearer than `reach` picture pixels counts as well.
PartId partAt(const document::Document& document, const pipeline::Derived& derived, PictureId picture, PicturePoint p,
              double reach);

struct Ray {
  WorldPoint eye, direction;
};

}  // namespace spineloft::app
