// Sections as small drawings.
#pragma once

#include <imgui.h>

#include <span>
#include <vector>

#include "engine/sections/section.h"

namespace spineloft::panels {

/// The outlines of a preset (few points) or of a drawn section.
const std::vector<std::vector<SectionPoint>>& outlinesOf(const sections::SectionShape& shape);

/// Where the square [−1, 1]² lies on the canvas: its middle and half its side.
struct SectionFrame {
  ImVec2 centre;
  float radius = 20;
  ImVec2 at(SectionPoint p) const {
    return {centre.x + static_cast<float>(p.x) * radius, centre.y - static_cast<float>(p.y) * radius};
  }
};
struct SectionPen {
  ImU32 line = 0, fill = 0;
  float width = 1.8f;
};
/// Closed curves; what lies in an odd number of them is filled.
void paintOutlines(ImDrawList& list, const SectionFrame& frame, std::span<const std::vector<SectionPoint>> outlines,
                   const SectionPen& pen);
void paintSection(ImDrawList& list, const SectionFrame& frame, const sections::SectionShape& shape,
                  const SectionPen& pen);
/// An open line.
void paintLine(ImDrawList& list, const SectionFrame& frame, std::span<const SectionPoint> line, const SectionPen& pen);

}  // namespace spineloft::panels
