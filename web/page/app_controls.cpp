// The controls of the panels without a pointer: told to the shell, which shows them to screen readers, and worked by
// it.
#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <utility>

#include "web/commands/state_json.h"
#include "web/edit/editing.h"
#include "web/page/app.h"

namespace spineloft::app {

/// What is out of sight is brought into sight first: Dear ImGui leaves it out until then.
void App::workAsked() {
  std::optional<AskedControl>& asked = ui_.asked;
  if (!asked) return;
  const auto at = std::ranges::find(ui_.controls, asked->id, &Control::id);
  if (at == ui_.controls.end() || !at->enabled || asked->frames-- <= 0) return asked.reset();
  ui_.wantedInSight = at->inSight ? 0 : asked->id;
  framesWanted_ = std::max(framesWanted_, 3);
  if (!at->inSight || asked->value) return;
  ImGui::ActivateItemByID(asked->id);
  asked.reset();
}

void App::workControl(std::uint32_t id, std::optional<double> value) {
  ui_.asked = AskedControl{id, value};
  touch(4);
}

void App::showControl(std::uint32_t id) {
  ui_.wantedInSight = id;
  touch(3);
}

/// Tells the shell what the panels show, when they are at rest and it is not what was told last; with the ends of the
/// ribs, while they are in hand.
void App::announceControls() {
  if (moving() || gestures_.active() || framesWanted_ > 0) return;
  std::vector<Control> shown = ui_.controls;
  const Subject subject = subjectOf(studio_.document(), studio_.derived(), ui_.selection);
  if (subject && ui_.tool == ToolKind::Ribs) addRibs(subject.shape->ribs, shown);
  if (shown == toldControls_) return;
  toldControls_ = std::move(shown);
  sendControls(host_, toldControls_);
}

void App::addRibs(const ribs::RibSet& set, std::vector<Control>& controls) const {
  constexpr double kSide = 24;
  for (std::size_t rib = 0; rib < set.ribs.size(); ++rib) {
    for (const ribs::Side side : {ribs::Side::Left, ribs::Side::Right}) {
      const ribs::EndRef end{rib, side};
      const ClientPoint at = ui_.pictureView.toClient(endPoint(set.ribs[rib], side), ui_.layout.picture);
      Control control;
      control.kind = Control::Kind::Rib;
      control.words = ribSentence(set, end);
      control.at = {at.x - kSide / 2, at.y - kSide / 2, kSide, kSide};
      control.on = ui_.chosen.end == end;
      control.id = static_cast<std::uint32_t>(2 * rib) + (side == ribs::Side::Left ? 0 : 1);
      controls.push_back(std::move(control));
    }
  }
}

}  // namespace spineloft::app
