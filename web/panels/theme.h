// The palette and shapes of the page, shared with the shell's style sheet.
#pragma once

#include <imgui.h>

#include "web/ui/ui_state.h"

namespace spineloft::panels {

constexpr ImU32 rgb(unsigned hex, unsigned alpha = 255) {
  return IM_COL32((hex >> 16) & 255u, (hex >> 8) & 255u, hex & 255u, alpha);
}

namespace detail {
inline platform::Palette inUse;
}

/// Those in use; applyTheme changes them, between two frames.
inline const ImU32 &kInk = detail::inUse.ink, &kMuted = detail::inUse.muted, &kDisabled = detail::inUse.disabled,
                   &kPaper = detail::inUse.paper, &kSurface = detail::inUse.surface, &kLine = detail::inUse.line,
                   &kAccent = detail::inUse.accent, &kOnAccent = detail::inUse.onAccent,
                   &kAccentSoft = detail::inUse.accentSoft, &kHover = detail::inUse.hover, &kTile = detail::inUse.tile,
                   &kTrough = detail::inUse.trough, &kHandle = detail::inUse.handle, &kWarning = detail::inUse.warning,
                   &kGood = detail::inUse.good, &kBubble = detail::inUse.bubble, &kOnBubble = detail::inUse.onBubble;
/// What lies over a picture or a solid: the same in every theme.
inline constexpr ImU32 kHalo = rgb(0xffffff), kDark = rgb(0x1f2430), kSpine = rgb(0x2457d6), kEdgeRib = rgb(0x12876f),
                       kBridgedRib = rgb(0xd98a00), kGuessedRib = rgb(0x8b5fbf), kGlow = rgb(0xffd166),
                       kEditedRib = rgb(0xc2257a), kFailure = rgb(0xb3261e);

/// The same colour with another opacity, 0…255.
constexpr ImU32 faded(ImU32 colour, unsigned alpha) {
  return (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
}

inline constexpr float kRadius = 10;

/// No pale ground tells what is on, as where the system sets the colours: a frame does.
inline bool tellsByFrames() { return kAccentSoft == kSurface; }

/// The colour that a tool has wherever it shows.
ImU32 toolColour(app::ToolKind tool);

/// Sets the palette, and ImGui's colours, rounding and padding.
void applyTheme(const platform::Palette& palette);

}  // namespace spineloft::panels
