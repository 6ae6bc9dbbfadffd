// ImGui's fonts: Inter in two weights with the letters of the visitor's language and the icons merged in, rasterised
// for the screen's density.
#pragma once

#include "web/platform/page.h"

struct ImFont;

namespace spineloft::app {

/// CSS pixels an em, as in the style sheet.
inline constexpr float kTextEm = 13.5f, kSmallEm = 12;

struct Fonts {
  ImFont* text = nullptr;   ///< kTextEm; ImGui's default
  ImFont* bold = nullptr;   ///< kTextEm, semibold
  ImFont* small = nullptr;  ///< kSmallEm
  ImFont* icons = nullptr;  ///< 18, icons alone
};

/// Rebuilds ImGui's atlas for `dpr`. Missing files are replaced by ImGui's own font.
Fonts buildFonts(const platform::FontFiles& files, double dpr);

}  // namespace spineloft::app
