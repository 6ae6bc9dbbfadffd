#include "web/ui/ui_state.h"

#include <algorithm>
#include <array>
#include <utility>

namespace spineloft::app {

std::string_view toolKey(ToolKind tool) {
  static constexpr std::array<std::string_view, static_cast<std::size_t>(ToolKind::kCount)> kKeys = {
      "draw",   "hand", "ribs", "shape",  "bone",   "ignore", "puff", "sheet", "pen",
      "eraser", "move", "spin", "layers", "shapes", "lines",  "pull", "bridge"};
  return tool < ToolKind::kCount ? kKeys[static_cast<std::size_t>(tool)] : std::string_view();
}

std::string_view controlKey(Control::Kind kind) {
  static constexpr std::array<std::string_view, 9> kKeys = {"button",  "row", "grip",  "field", "slider",
                                                            "section", "tab", "words", "rib"};
  return kKeys[static_cast<std::size_t>(kind)];
}

Camera CameraFlight::at(double share) const {
  const double eased = share * share * (3 - 2 * share);
  const double place = eased * static_cast<double>(by.size() + 1);
  const std::size_t leg = std::min(static_cast<std::size_t>(place), by.size());
  const Camera& start = leg == 0 ? from : by[leg - 1];
  return blend(start, leg == by.size() ? to : by[leg], place - static_cast<double>(leg));
}

void closeMenus(UiState& ui) {
  ui.barMenu = BarMenu::None;
  ui.pictureMenu = {};
  ui.sketching.menu = PenMenu::None;
}

void resetNextPart(UiState& ui) {
  const UiState fresh;
  ui.section = fresh.section;
  ui.startCap = fresh.startCap;
  ui.endCap = fresh.endCap;
  ui.look = fresh.look;
  ui.inflate = fresh.inflate;
  ui.extrude = fresh.extrude;
  ui.lathe = fresh.lathe;
  ui.primitive = fresh.primitive;
  ui.axisOf = {};
  ui.edit.hiddenPen = false;
  ui.layers = {};
  ui.secondColour = fresh.secondColour;
}

void featureAt(UiState& ui, PictureId picture) {
  if (ui.picture == picture) return;
  if (ui.picture) ui.seen.push_back({ui.picture, ui.pictureView});
  ui.picture = picture;
  ui.pictureView.fitted = true;
  const auto at = std::ranges::find(ui.seen, picture, &SeenPicture::picture);
  if (at == ui.seen.end()) return;
  ui.pictureView = at->view;
  ui.seen.erase(at);
}

}  // namespace spineloft::app
