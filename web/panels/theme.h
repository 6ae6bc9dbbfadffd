// The palette and shapes of the page, shared with the shell's style sheet.
#pragma once

#include <imgui.h>

#include "web/ui/ui_state.h"

namespace spineloft::panels {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, alpha);
}

inline constexpr ImU32 kInk = rgb(0x1f2430), kMuted = rgb(0x5c6474), kPaper = rgb(0xf7f5f0), kSurface = rgb(0xffffff),
                       kLine = rgb(0xe3dfd6), kAccent = rgb(0xc8431d), kAccentSoft = rgb(0xfdeee8),
                       kHover = rgb(0xf4f1ea), kSpine = rgb(0x2457d6), kEdgeRib = rgb(0x12876f),
                       kBridgedRib = rgb(0xd98a00), kGuessedRib = rgb(0x8b5fbf), kGlow = rgb(0xffd166),
                       kEditedRib = rgb(0xc2257a), kFailure = rgb(0xb3261e), kWarning = rgb(0xa8500a);
inline constexpr float kRadius = 10;

/// The colour that a tool has wherever it shows.
ImU32 toolColour(app::ToolKind tool);

/// Sets ImGui's colours, rounding and padding.
void applyTheme();

}  // namespace spineloft::panels
