#include "web/panels/section_paint.h"

#include <algorithm>
#include <array>

namespace spineloft::panels {
namespace {

using Outlines = std::vector<std::vector<SectionPoint>>;
constexpr int kOutlinePoints = 40;
constexpr std::size_t kPresets = static_cast<std::size_t>(sections::SectionPreset::kCount);
constexpr float kLineStep = 1.5f;  // CSS pixels between the lines that fill

void fill(ImDrawList& list, const SectionFrame& frame, std::span<const std::vector<SectionPoint>> outlines,
          ImU32 colour) {
  float top = 1e9f, bottom = -1e9f;
  for (const auto& outline : outlines) {
    for (const SectionPoint p : outline) {
      top = std::min(top, frame.at(p).y);
      bottom = std::max(bottom, frame.at(p).y);
    }
  }
  std::vector<float> cuts;
  for (float y = top + kLineStep / 2; y < bottom; y += kLineStep) {
    cuts.clear();
    for (const auto& outline : outlines) {
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const ImVec2 a = frame.at(outline[i]), b = frame.at(outline[(i + 1) % outline.size()]);
        if ((a.y > y) != (b.y > y)) cuts.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
    }
    std::ranges::sort(cuts);
    for (std::size_t i = 0; i + 1 < cuts.size(); i += 2) {
      list.AddRectFilled({cuts[i], y - kLineStep / 2}, {cuts[i + 1], y + kLineStep / 2}, colour);
    }
  }
}

}  // namespace

const Outlines& outlinesOf(const sections::SectionShape& shape) {
  static const auto presets = [] {
    std::array<Outlines, kPresets> out;
    for (const sections::SectionName& name : sections::sectionNames()) {
      Result<sections::Section> section = sections::presetSection(name.preset, kOutlinePoints);
      if (section) out[static_cast<std::size_t>(name.preset)] = {section.value().points};
    }
    return out;
  }();
  return shape.drawn() ? shape.contours : presets[static_cast<std::size_t>(shape.preset)];
}

void paintOutlines(ImDrawList& list, const SectionFrame& frame, std::span<const std::vector<SectionPoint>> outlines,
                   const SectionPen& pen) {
  if (pen.fill != 0) fill(list, frame, outlines, pen.fill);
  for (const auto& outline : outlines) {
    for (const SectionPoint p : outline) list.PathLineTo(frame.at(p));
    list.PathStroke(pen.line, ImDrawFlags_Closed, pen.width);
  }
}

void paintSection(ImDrawList& list, const SectionFrame& frame, const sections::SectionShape& shape,
                  const SectionPen& pen) {
  paintOutlines(list, frame, outlinesOf(shape), pen);
}

void paintLine(ImDrawList& list, const SectionFrame& frame, std::span<const SectionPoint> line, const SectionPen& pen) {
  for (const SectionPoint p : line) list.PathLineTo(frame.at(p));
  list.PathStroke(pen.line, 0, pen.width);
}

}  // namespace spineloft::panels
