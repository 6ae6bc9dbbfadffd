#include "web/page/gestures.h"

#include <algorithm>
#include <cmath>

#include "web/tools/pan_picture.h"
#include "web/tools/pick.h"
#include "web/tools/pinch.h"
#include "web/tools/section_tools.h"
#include "web/tools/sheet_tool.h"
#include "web/tools/tools.h"
#include "web/tools/turn_solid.h"

namespace spineloft::app {
namespace {

using platform::Device;
using platform::PointerEvent;
using platform::PointerKind;

constexpr double kWheelZoom = 0.0016;   // ln of the zoom per CSS pixel of a mouse wheel
constexpr double kPinchZoom = 0.011;    // the same for a trackpad pinch
constexpr double kWheelReach = 0.0004;  // reach per CSS pixel of a mouse wheel

ClientPoint pointOf(const PointerEvent& event) { return {event.x, event.y}; }

void turnReach(UiState& ui, double by) {
  if (ui.tool != ToolKind::Ribs && ui.tool != ToolKind::Spine) return;
  double& reach = ui.tool == ToolKind::Ribs ? ui.edit.ribReach : ui.edit.spineReach;
  reach = std::clamp(reach + by, 0.0, kMostReach);
}

/// A pen whose button is held: browsers report it as the right button of a mouse.
bool isBarrel(const PointerEvent& event) {
  constexpr int kRight = 2;
  return event.device == Device::Pen && (event.button == kRight || (event.buttons & kRight) != 0);
}

tools::ToolEvent toolEvent(const PointerEvent& event) {
  return {pointOf(event), event.pressure, event.timeMs, event.modifiers, event.device, isBarrel(event)};
}

}  // namespace

Gestures::Place Gestures::placeOf(const UiState& ui, ClientPoint at) const {
  if (tools::isForSections(ui, at)) return Place::Sections;
  for (const Rect& overlay : ui.overlays) {
    if (overlay.contains(at)) return Place::Panels;
  }
  const Layout& layout = ui.layout;
  if (layout.panel.contains(at)) return Place::Panels;
  Rect bar = layout.splitter;  // a little wider than it looks
  bar = layout.stacked ? Rect{bar.x, bar.y - 4, bar.width, bar.height + 8}
                       : Rect{bar.x - 4, bar.y, bar.width + 8, bar.height};
  if (bar.contains(at)) return Place::Splitter;
  if (layout.picture.contains(at)) return Place::Picture;
  return layout.solid.contains(at) ? Place::Solid : Place::Panels;
}

Gestures::Contact* Gestures::find(int id) {
  const auto at = std::ranges::find(contacts_, id, &Contact::id);
  return at == contacts_.end() ? nullptr : &*at;
}

Gestures::Target Gestures::pointer(const PointerEvent& event, const tools::ToolEnv& env) {
  env.ui.touch = event.device == Device::Touch;
  hover_ = pointOf(event);
  last_ = toolEvent(event);
  Contact* contact = find(event.id);
  const Place place = contact ? contact->place : placeOf(env.ui, hover_);
  switch (event.kind) {
    case PointerKind::Down:
      press(event, env);
      break;
    case PointerKind::Move:
      if (contact) move(event, *contact, env);
      break;
    case PointerKind::Up:
      release(event, env);
      break;
    case PointerKind::Cancel:
    case PointerKind::Leave:
      if (contact) {
        cancel(env);
        std::erase_if(contacts_, [&](const Contact& c) { return c.id == event.id; });
      }
      break;
  }
  if (!active()) hover(event, env);
  return place == Place::Panels ? Target::Panels : Target::Views;
}

void Gestures::hover(const PointerEvent& event, const tools::ToolEnv& env) {
  const bool gone =
      event.kind == PointerKind::Leave || event.kind == PointerKind::Cancel || event.device == Device::Touch;
  const Place place = gone ? Place::Panels : placeOf(env.ui, hover_);
  if (place == Place::Picture) {
    env.ui.hover = tools::pickInPicture(env, last_);
  } else if (place == Place::Solid) {
    env.ui.hover = tools::pickInSolid(env, last_);
  } else if (place == Place::Sections) {
    env.ui.hover = {};
    env.ui.hover.along = tools::placeInGraph(env.ui, hover_);
  } else {
    env.ui.hover = {};
  }
}

void Gestures::again(const tools::ToolEnv& env) {
  if (tool_) tool_->move(env, last_);
}

void Gestures::press(const PointerEvent& event, const tools::ToolEnv& env) {
  const Place place = placeOf(env.ui, hover_);
  if (Contact* held = find(event.id)) {
    // A second mouse button: the right one during a stroke takes it back.
    if (tool_ && toolContact_ == event.id) cancel(env);
    held->at = hover_;
    return;
  }
  const bool penDown = std::ranges::any_of(contacts_, [](const Contact& c) { return c.device == Device::Pen; });
  if (event.device == Device::Touch && penDown) return;  // a palm
  contacts_.push_back({event.id, event.device, place, hover_});
  if (event.device == Device::Pen) env.ui.penSeen = true;
  if (place == Place::Panels) return;
  env.ui.barMenu = BarMenu::None;
  if (event.device == Device::Touch && contacts_.size() >= 2) {
    startPinch(env);
    return;
  }
  if (place == Place::Splitter) {
    splitting_ = true;
    return;
  }
  if (place == Place::Solid) env.ui.focus = Focus::Solid;
  if (place == Place::Picture) env.ui.focus = Focus::Picture;
  if (event.button == 0 && !env.ui.spaceHeld) tool_ = tools::sectionTool(env, toolEvent(event));
  if (place == Place::Sections && !tool_) return;
  if (!tool_) tool_ = toolFor(event, place, env);
  toolContact_ = event.id;
  tool_->begin(env, toolEvent(event));
}

std::unique_ptr<tools::Tool> Gestures::toolFor(const PointerEvent& event, Place place,
                                               const tools::ToolEnv& env) const {
  const UiState& ui = env.ui;
  const bool shift = (event.modifiers & platform::kShift) != 0;
  const bool plain = event.button == 0 && !ui.spaceHeld;
  if (place == Place::Solid) {
    if (plain && !shift) return tools::solidTool(env, toolEvent(event));
    return std::make_unique<tools::TurnSolid>(tools::TurnSolid::Mode::Pan);
  }
  const bool finger = event.device == Device::Touch && ui.penSeen;
  const bool hidden = ui.tool == ToolKind::Lines && isBarrel(event) && !ui.spaceHeld;
  return tools::pictureTool(env, (plain || hidden) && !finger ? ui.tool : ToolKind::Hand);
}

void Gestures::startPinch(const tools::ToolEnv& env) {
  const bool joins = tool_ && tool_->takesPair() && contacts_.size() == 2;
  if (tool_ && !joins) {
    tool_->cancel(env);
    tool_.reset();
  }
  splitting_ = false;
  pinching_ = true;
  pinchPlace_ = contacts_.front().place;
}

void Gestures::move(const PointerEvent& event, Contact& contact, const tools::ToolEnv& env) {
  const ClientPoint before = contact.at;
  contact.at = pointOf(event);
  // Browsers report a second mouse button as a move that names it.
  if (event.device == Device::Mouse && event.button > 0) {
    if (tool_ && toolContact_ == event.id) cancel(env);
    return;
  }
  if (pinching_ && contacts_.size() >= 2) {
    const ClientPoint other = &contact == &contacts_[0] ? contacts_[1].at : contacts_[0].at;
    if (&contact != &contacts_[0] && &contact != &contacts_[1]) return;
    const bool first = &contact == &contacts_[0];
    const tools::FingerPair from = first ? tools::FingerPair{before, other} : tools::FingerPair{other, before};
    const tools::FingerPair to = first ? tools::FingerPair{contact.at, other} : tools::FingerPair{other, contact.at};
    if (tool_) {
      tool_->followPair(env, from, to);
    } else if (pinchPlace_ == Place::Picture) {
      tools::pinchPicture(env, from, to);
    } else if (pinchPlace_ == Place::Solid) {
      tools::pinchSolid(env, from, to);
    }
  } else if (splitting_) {
    env.ui.share = shareAt(env.ui.layout, contact.at);
  } else if (tool_ && toolContact_ == event.id) {
    tool_->move(env, toolEvent(event));
  }
}

void Gestures::release(const PointerEvent& event, const tools::ToolEnv& env) {
  Contact* contact = find(event.id);
  if (contact == nullptr) return;
  if (event.buttons != 0 && event.device == Device::Mouse) return;  // another button is still down
  if (tool_ && (toolContact_ == event.id || pinching_)) {
    // Of two fingers on one thing the first that lets go ends it.
    const std::unique_ptr<tools::Tool> tool = std::move(tool_);
    if (!pinching_) tool->move(env, toolEvent(event));
    tool->commit(env);
  }
  splitting_ = false;
  std::erase_if(contacts_, [&](const Contact& c) { return c.id == event.id; });
  if (contacts_.empty()) pinching_ = false;
}

void Gestures::cancel(const tools::ToolEnv& env) {
  if (tool_) tool_->cancel(env);
  tool_.reset();
  splitting_ = false;
  if (contacts_.empty()) pinching_ = false;
}

void Gestures::wheel(const platform::WheelEvent& event, const tools::ToolEnv& env) {
  const ClientPoint at{event.x, event.y};
  const Place place = placeOf(env.ui, at);
  const bool pinch = (event.modifiers & platform::kControl) != 0;
  const double factor = std::exp(-event.deltaY * (pinch ? kPinchZoom : kWheelZoom));
  // Sideways, by shift or on a trackpad, is a shift of the view.
  const bool shift = (event.modifiers & platform::kShift) != 0;
  const bool sideways = !pinch && std::abs(event.deltaX) > std::abs(event.deltaY);
  const ClientPoint by = shift && !sideways ? ClientPoint{-event.deltaY, 0} : ClientPoint{-event.deltaX, -event.deltaY};
  if (place == Place::Picture && tool_ && !pinch && !sideways) {
    // While a rib end or a spine point is held, the wheel says how far its neighbours follow.
    turnReach(env.ui, -event.deltaY * kWheelReach);
    again(env);
    return;
  }
  if (place == Place::Solid && !pinch && !sideways && !shift && tools::wheelSheet(env, at, event.deltaY)) return;
  if (place == Place::Picture) {
    if (shift || sideways) {
      app::panPicture(env.ui.pictureView, tools::shownPicture(env), env.ui.layout.picture, by);
    } else {
      zoomPicture(env.ui.pictureView, env.ui.layout.picture, at, factor);
    }
  } else if (place == Place::Solid) {
    env.ui.flight.reset();
    env.ui.cameraTouched = true;
    if (shift || sideways) {
      panCamera(env.ui.camera, env.ui.layout.solid, by);
    } else {
      zoomCamera(env.ui.camera, env.ui.layout.solid, at, factor);
    }
  }
}

const char* Gestures::cursor(const tools::ToolEnv& env) const {
  const UiState& ui = env.ui;
  const auto held = [&](std::string_view open) { return tool_ && open == "grab" ? "grabbing" : open.data(); };
  if (splitting_) return ui.layout.stacked ? "row-resize" : "col-resize";
  const Place place = placeOf(ui, hover_);
  if (place == Place::Sections || place == Place::Picture) {
    if (const char* css = tools::sectionCursor(env, hover_)) return css;
  }
  switch (place) {
    case Place::Sections:
      return "default";
    case Place::Splitter:
      return ui.layout.stacked ? "row-resize" : "col-resize";
    case Place::Picture:
      if (ui.spaceHeld) return tool_ ? "grabbing" : "grab";
      return held(tools::cursorFor(ui, Focus::Picture));
    case Place::Solid:
      return held(tools::cursorFor(ui, Focus::Solid));
    case Place::Panels:
      return "default";
  }
  return "default";
}

}  // namespace spineloft::app
