#include "web/ui/fonts.h"

#include <imgui.h>

#include <algorithm>
#include <cstdint>
#include <string_view>
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

/// The height of a line, from the top of ascenders to the foot of descenders, in em; 1 for a file that has none.
float lineInEm(const std::vector<std::uint8_t>& file) {
  const auto at = [&](std::size_t place) {
    return place + 1 < file.size() ? static_cast<std::int16_t>(file[place] << 8 | file[place + 1]) : std::int16_t{0};
  };
  int line = 0, em = 0;
  for (int i = 0; i < at(4); ++i) {
    const std::size_t entry = 12 + 16 * static_cast<std::size_t>(i);
    if (entry + 16 > file.size()) break;
    const std::string_view tag(reinterpret_cast<const char*>(file.data() + entry), 4);
    const std::size_t start = static_cast<std::size_t>(static_cast<std::uint16_t>(at(entry + 8))) << 16 |
                              static_cast<std::uint16_t>(at(entry + 10));
    if (tag == "hhea") line = at(start + 4) - at(start + 6);
    if (tag == "head") em = at(start + 18);
  }
  return line > 0 && em > 0 ? static_cast<float>(line) / static_cast<float>(em) : 1;
}

/// Arabic with its joined forms; kana, kanji, and the signs that stand between them.
const ImWchar kScriptRanges[] = {0x600,  0x6ff,  0x2000, 0x206f, 0x3000, 0x30ff, 0x4e00, 0x9fff,
                                 0xfb50, 0xfdff, 0xfe70, 0xfefc, 0xff00, 0xffef, 0};

ImFont* addText(const platform::FontFiles& files, bool bold, float em) {
  const std::vector<std::uint8_t>& file = bold ? files.bold : files.text;
  const float pixels = em * lineInEm(file);
  const std::vector<std::uint8_t>& script = bold ? files.scriptBold : files.scriptText;
  ImFontConfig config;
  config.OversampleH = 2;
  config.OversampleV = 1;
  config.PixelSnapH = false;
  ImFont* font = add(file, pixels, kTextRanges, config);
  config.MergeMode = true;
  // ImGui's size is the height of a line; letters of one em stand beside each other.
  add(script, pixels * lineInEm(script) / lineInEm(file), kScriptRanges, config);
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
  fonts.text = addText(files, false, kTextEm * scale);
  fonts.bold = addText(files, true, kTextEm * scale);
  fonts.small = addText(files, false, kSmallEm * scale);
  fonts.icons = add(files.icons, 18.f * scale, iconRanges(), {});
  io.Fonts->Build();
  io.FontDefault = fonts.text;
  io.FontGlobalScale = 1 / scale;
  return fonts;
}

}  // namespace spineloft::app
