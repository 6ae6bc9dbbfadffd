// The ink of outlines, which is no part of any surface.
#pragma once

#include <span>
#include <vector>

#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "engine/ribs/base/rib_set.h"

namespace spineloft::pipeline {

/// The stretches of the pen's strokes on paper that run along the outline of the part, as marks that cover: whoever
/// draws the outline of a thing draws where it ends, and the thing is not black there. Strokes, and what of them leads
/// into the part or away from it, stay. None on a photo. Picture pixels; O(points of the strokes × of the outline).
std::vector<ribs::IgnoreMark> outlineInk(const PartShape& shape, const document::PictureEntry& entry);

/// The ink along the outlines of those parts of the picture that at most half of the line runs within, as marks that do
/// not cover: it is known what ends there, so that it is no edge of a part along the line. `derived` is of `document`.
/// Picture pixels; O(points of the line × of the outlines).
std::vector<ribs::IgnoreMark> inkOfOthers(const document::Document& document, const Derived& derived, PictureId picture,
                                          std::span<const PicturePoint> line);

/// Adds those of the marks, of another part's outline or its own, that reach the stretch of a picture of that size
/// which the part shows. O(vertices + points of the marks).
void addInkUpon(const PartShape& shape, image::Size picture, std::span<const ribs::IgnoreMark> ink,
                std::vector<ribs::IgnoreMark>& out);

}  // namespace spineloft::pipeline
