// The icons of the page: their names as the shell and the icon font know them, and their places in
// the font (lucide 1.62, ISC licence). The font's codepoints never move within a release.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>

namespace spineloft::app {

struct Icon {
  std::string_view name;
  std::uint16_t code;
};

inline constexpr std::array kIcons = {
    Icon{"cloud", 57480},
    Icon{"puzzle", 58012},
    Icon{"lasso", 57806},
    Icon{"pencil", 57849},
    Icon{"hand", 57815},
    Icon{"plus", 57661},
    Icon{"undo-2", 58017},
    Icon{"redo-2", 58016},
    Icon{"trash-2", 57742},
    Icon{"image-plus", 57847},
    Icon{"image-off", 57792},
    Icon{"house", 57589},
    Icon{"maximize", 57618},
    Icon{"zoom-in", 57782},
    Icon{"zoom-out", 57783},
    Icon{"eye", 57530},
    Icon{"eye-off", 57531},
    Icon{"squares-unite", 58970},
    Icon{"squares-subtract", 58969},
    Icon{"squares-intersect", 58968},
    Icon{"cup-soda", 58065},
    Icon{"unlink", 57756},
    Icon{"circle-check", 57894},
    Icon{"circle-alert", 57463},
    Icon{"triangle-alert", 57747},
    Icon{"brush", 57811},
    Icon{"square-dashed", 57803},
    Icon{"highlighter", 57588},
    Icon{"footprints", 58297},
    Icon{"palette", 57821},
    Icon{"image", 57590},
    Icon{"download", 57522},
    Icon{"ruler", 57675},
    Icon{"spline", 58251},
    Icon{"pencil-line", 58608},
    Icon{"x", 57778},
    Icon{"shapes", 58547},
    Icon{"layers", 58665},
    Icon{"box", 57441},
    Icon{"arrow-right", 57417},
    Icon{"refresh-cw", 57669},
    Icon{"check", 57452},
    Icon{"circle-dot", 58181},
    Icon{"list", 57606},
    Icon{"scan", 57943},
    Icon{"slice", 58096},
    Icon{"sliders-horizontal", 58010},
    Icon{"chevron-right", 57455},
    Icon{"minus", 57628},
    Icon{"cylinder", 58661},
    Icon{"pen", 57647},
    Icon{"eraser", 57999},
    Icon{"square-pen", 57714},
    Icon{"images", 58820},
    Icon{"chevron-left", 57454},
    Icon{"ellipsis", 57526},
    Icon{"flip-horizontal-2", 58206},
    Icon{"flip-vertical-2", 58208},
    Icon{"rotate-ccw", 57672},
    Icon{"square", 57703},
    Icon{"circle", 57462},
    Icon{"mouse-pointer-2", 57795},
    Icon{"waypoints", 58690},
    Icon{"history", 57845},
    Icon{"bookmark", 57440},
    Icon{"bookmark-plus", 57917},
    Icon{"tornado", 57880},
    Icon{"chart-spline", 58893},
    Icon{"chart-line", 58021},
    Icon{"circle-plus", 57473},
    Icon{"move-horizontal", 57798},
    Icon{"flower", 58067},
    Icon{"diamond", 58066},
    Icon{"image-down", 58684},
    Icon{"signature", 58866},
    Icon{"crosshair", 57516},
    Icon{"move-3d", 58085},
    Icon{"move", 57633},
    Icon{"arrow-left-right", 57930},
    Icon{"anchor", 57407},
    Icon{"scan-search", 58679},
    Icon{"rotate-3d", 58090},
    Icon{"shell", 58615},
    Icon{"link", 57602},
    Icon{"fold-vertical", 58428},
    Icon{"unfold-vertical", 58430},
    Icon{"rows-2", 58425},
    Icon{"rows-4", 58763},
    Icon{"circle-minus", 57470},
    Icon{"lock", 57611},
    Icon{"ban", 57425},
    Icon{"paint-roller", 58782},
    Icon{"bone", 58200},
    Icon{"line-squiggle", 59002},
    Icon{"unfold-horizontal", 58429},
    Icon{"save", 57677},
    Icon{"save-all", 58383},
    Icon{"file-plus", 57545},
    Icon{"layout-grid", 57599},
    Icon{"folder-open", 57927},
    Icon{"copy", 57502},
    Icon{"scaling", 58092},
    Icon{"magnet", 58037},
    Icon{"group", 58468},
    Icon{"ungroup", 58471},
    Icon{"arrow-down-to-line", 58453},
    Icon{"arrow-down-from-line", 58452},
    Icon{"arrow-up-from-line", 58458},
    Icon{"scan-face", 58225},
    Icon{"square-stack", 58530},
    Icon{"chevron-up", 57456},
    Icon{"chevron-down", 57453},
};

/// 0 for a name that is not in the table.
constexpr std::uint16_t iconCode(std::string_view name) {
  for (const Icon& icon : kIcons) {
    if (icon.name == name) return icon.code;
  }
  return 0;
}

}  // namespace spineloft::app
