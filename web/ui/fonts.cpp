#include "web/ui/fonts.h"

#include <imgui.h>

#include <algorithm>
#include <vector>

#include "web/ui/icons.h"

namespace spineloft::app {
namespace {

/// Latin with accents, Greek, Cyrillic, punctuation, currency, arrows.
const ImWchar kTextRanges[] = {0x20,   0x17f,  0x192,  0x192,  0x218,  0x21b,  0x384,  0x3ce,  0x400,  0x45f, 0x1e9e,
                               0x1e9e, 0x2010, 0x2026, 0x20ac, 0x20ac, 0x2190, 0x2193, 0x2713, 0x2713, 0};

const ImWchar* iconRanges() {
  static const std::vector<ImWchar> ranges = [] {
    std::vector<ImWchar> out;
    for (const Icon& icon : kIcons) out.insert(out.end(), {icon.code, icon.code});
    out.push_back(0);
    return out;
  }();
  return ranges.data();
}

ImFont* add(const std::vector<std::uint8_t>& file, float pixels, const ImWchar* ranges, ImFontConfig config) {
  ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
  if (file.empty()) {
    if (config.MergeMode) return nullptr;
    config = {};
    config.SizePixels = pixels;
    return atlas.AddFontDefault(&config);
  }
  config.FontDataOwnedByAtlas = false;  // our copy outlives every atlas
  return atlas.AddFontFromMemoryTTF(const_cast<std::uint8_t*>(file.data()), static_cast<int>(file.size()), pixels,
                                    &config, ranges);
}

/// Arabic with its joined forms; kana, kanji, and the signs that stand between them.
const ImWchar kScriptRanges[] = {0x600,  0x6ff,  0x2000, 0x206f, 0x3000, 0x30ff, 0x4e00, 0x9fff,
                                 0xfb50, 0xfdff, 0xfe70, 0xfefc, 0xff00, 0xffef, 0};

ImFont* addText(const platform::FontFiles& files, bool bold, float pixels) {
  const std::vector<std::uint8_t>& file = bold ? files.bold : files.text;
  const std::vector<std::uint8_t>& script = bold ? files.scriptBold : files.scriptText;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  ImFont* font = add(file, pixels, kTextRanges, config);
  config.MergeMode = true;
  add(script, pixels, kScriptRanges, config);
  config.GlyphMinAdvanceX = pixels * 1.15f;
  config.GlyphOffset.y = pixels * 0.16f;
  add(files.icons, pixels * 1.12f, iconRanges(), config);
  return font;
}

}  // namespace

Fonts buildFonts(const platform::FontFiles& files, double dpr) {
  ImGuiIO& io = ImGui::GetIO();
  const float scale = static_cast<float>(std::max(1.0, dpr));
  io.Fonts->Clear();
  Fonts fonts;
  fonts.text = addText(files, false, 14.5f * scale);
  fonts.bold = addText(files, true, 14.5f * scale);
  fonts.small = addText(files, false, 12.5f * scale);
  fonts.icons = add(files.icons, 18.f * scale, iconRanges(), {});
  io.Fonts->Build();
  io.FontDefault = fonts.text;
  io.FontGlobalScale = 1 / scale;
  return fonts;
}

}  // namespace spineloft::app
