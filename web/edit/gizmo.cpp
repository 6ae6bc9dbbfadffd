#include "web/edit/gizmo.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/mesh/laws.h"
#include "web/edit/placing.h"

namespace spineloft::app {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kArrow = 0.78;     // length of an arrow, in radii: within the rings
constexpr double kShortest = 0.3;   // of an arrow that can be pressed, in radii
constexpr double kCorner = 0.95;    // of the knobs for scale and depth, in radii each way
constexpr double kFacing = 0.35;    // a ring seen flatter than this is turned by its tangent
constexpr double kStep = kPi / 12;  // 15 degrees
constexpr int kRingPoints = 64;
constexpr double kAround = 1.1;                       // of the rings beyond the parts
constexpr double kSmallest = 40;                      // radius of rings whose knobs a finger tells apart, CSS pixels
constexpr double kBriefRoom = 16;                     // of the word below a knob, CSS pixels
constexpr double kMouseReach = 13, kTouchReach = 24;  // CSS pixels round a knob

/// A direction of the screen in the world.
WorldPoint onScreen(const Camera& camera, ClientPoint way) { return camera.right() * way.x - camera.up() * way.y; }

/// Where the knob of a ring stands: on the ring's outermost point on the screen, on the side where the
/// arrows are not.
WorldPoint knobWay(const Camera& camera, int axis) {
  static constexpr std::array<ClientPoint, 3> kPreferred = {ClientPoint{0, 1}, ClientPoint{-1, 0},
                                                            ClientPoint{-0.7, -0.7}};
  const WorldPoint a = axisVector(axis);
  const WorldPoint wanted = onScreen(camera, kPreferred[static_cast<std::size_t>(axis)]);
  WorldPoint way = cross(a, camera.back());
  if (norm(way) < 0.2) way = wanted - a * dot(a, wanted);
  way = normalized(way);
  return dot(way, wanted) < 0 ? -way : way;
}

/// Where the pointer's ray meets the plane through `point`; none when it runs along it.
std::optional<WorldPoint> onPlane(const GizmoDrag& drag, ClientPoint p, WorldPoint point, WorldPoint normal) {
  const WorldPoint way = rayThrough(drag.camera, drag.view, p);
  const double fall = dot(way, normal);
  if (std::abs(fall) < 1e-6) return std::nullopt;
  const double far = dot(point - drag.camera.eye(), normal) / fall;
  if (far <= 0) return std::nullopt;
  return drag.camera.eye() + way * far;
}

double alongAxis(const GizmoDrag& drag, ClientPoint to, int axis) {
  // On the screen, along the arrow as it is drawn.
  const Gizmo& gizmo = drag.gizmo;
  const auto tip = pointOnCanvas(drag.camera, drag.view, gizmo.centre + axisVector(axis) * (gizmo.unit * gizmo.radius));
  if (!tip) return 0;
  const ClientPoint way = *tip - gizmo.at;
  const double length2 = dot(way, way);
  return length2 > 1 ? dot(to - drag.from, way) / length2 * gizmo.unit * gizmo.radius : 0;
}

double turnBy(const GizmoDrag& drag, ClientPoint to, int axis) {
  const WorldPoint a = axisVector(axis), centre = drag.gizmo.centre;
  if (std::abs(dot(a, drag.camera.back())) > kFacing) {
    const auto from = onPlane(drag, drag.from, centre, a), at = onPlane(drag, to, centre, a);
    if (from && at) {
      const WorldPoint u = *from - centre, v = *at - centre;
      return std::atan2(dot(cross(u, v), a), dot(u, v));
    }
  }
  // Nearly edge on: along the tangent at the knob.
  const WorldPoint knob = knobWay(drag.camera, axis), tangent = cross(a, knob);
  ClientPoint way{dot(tangent, drag.camera.right()), -dot(tangent, drag.camera.up())};
  if (norm(way) < 0.1) {
    // The knob is at the ring's edge: its tangent points at the eye. Dragging along the ring's axis
    // square on the screen turns it instead.
    const ClientPoint flat{dot(a, drag.camera.right()), -dot(a, drag.camera.up())};
    way = {-flat.y, flat.x};
  }
  const double length = norm(way);
  return length > 0 ? dot(to - drag.from, way) / (length * drag.gizmo.radius) : 0;
}

}  // namespace

WorldPoint axisVector(int axis) { return {axis == 0 ? 1.0 : 0.0, axis == 1 ? 1.0 : 0.0, axis == 2 ? 1.0 : 0.0}; }

int axisOf(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::MoveX:
    case GizmoHandle::TurnX:
      return 0;
    case GizmoHandle::MoveY:
    case GizmoHandle::TurnY:
      return 1;
    case GizmoHandle::MoveZ:
    case GizmoHandle::TurnZ:
      return 2;
    default:
      return -1;
  }
}

std::string_view handleKey(GizmoHandle handle) {
  static constexpr std::array<std::string_view, 10> kKeys = {"none",   "x",      "y",     "z",     "turn-x",
                                                             "turn-y", "turn-z", "plane", "depth", "scale"};
  return kKeys[static_cast<std::size_t>(handle)];
}

const char* handleWords(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::None:
      return "";
    case GizmoHandle::MoveX:
      return "Move left and right";
    case GizmoHandle::MoveY:
      return "Move up and down";
    case GizmoHandle::MoveZ:
      return "Move to the front and back";
    case GizmoHandle::TurnX:
      return "Tip over";
    case GizmoHandle::TurnY:
      return "Turn round";
    case GizmoHandle::TurnZ:
      return "Lean left and right";
    case GizmoHandle::Plane:
      return "Move";
    case GizmoHandle::Depth:
      return "Nearer and farther";
    case GizmoHandle::Scale:
      return "Larger and smaller";
  }
  return "";
}

const char* handleBrief(GizmoHandle handle) {
  switch (handle) {
    case GizmoHandle::TurnX:
      return "Tip";
    case GizmoHandle::TurnY:
      return "Turn";
    case GizmoHandle::TurnZ:
      return "Lean";
    case GizmoHandle::Depth:
      return "Nearer";
    case GizmoHandle::Scale:
      return "Larger";
    default:
      return "";
  }
}

double knobRadius(const UiState& ui) { return ui.touch ? 16 : 11; }

std::vector<ClientPoint> Gizmo::ring(const Camera& camera, const Rect& view, int axis) const {
  const WorldPoint u = axisVector((axis + 1) % 3), v = axisVector((axis + 2) % 3);
  std::vector<ClientPoint> points;
  for (int i = 0; i < kRingPoints; ++i) {
    const double angle = 2 * kPi * i / kRingPoints;
    const auto p = pointOnCanvas(camera, view, centre + (u * std::cos(angle) + v * std::sin(angle)) * (unit * radius));
    if (p) points.push_back(*p);
  }
  return points;
}

std::optional<Gizmo> gizmoAt(const UiState& ui, WorldPoint pivot, double reach) {
  const Rect& view = ui.layout.solid;
  const auto from = pointOnCanvas(ui.camera, view, pivot);
  if (!from) return std::nullopt;
  const double margin = knobRadius(ui) + 4 + (ui.touch ? kBriefRoom : 0);
  const Rect room = (ui.solidRoom.width > 0 ? ui.solidRoom : view).inset(margin);
  Gizmo gizmo;
  const double most = std::max(kSmallest, std::min(room.width, room.height) / 2);
  const double usual = std::clamp(0.25 * std::min(view.width, view.height), 60.0, ui.touch ? 116.0 : 96.0);
  gizmo.radius = std::min(most, std::max(usual, kAround * reach + knobRadius(ui)));
  const auto within = [&](double at, double low, double length) {
    const double half = std::min(gizmo.radius, length / 2);
    return std::clamp(at, low + half, low + length - half);
  };
  gizmo.at = {within(from->x, room.x, room.width), within(from->y, room.y, room.height)};
  const double away = -dot(pivot - ui.camera.eye(), ui.camera.back());
  gizmo.unit = 2 * kHalfHeight * away / std::max(1.0, view.height);
  gizmo.pivot = pivot;
  gizmo.centre = pivot + onScreen(ui.camera, gizmo.at - *from) * gizmo.unit;
  // Perspective may draw a ring beyond its radius.
  const auto add = [&](GizmoHandle handle, ClientPoint p) {
    p = {std::clamp(p.x, room.x, std::max(room.x, room.right())),
         std::clamp(p.y, room.y, std::max(room.y, room.bottom()))};
    gizmo.knobs.push_back({handle, p});
  };
  constexpr std::array kMoves = {GizmoHandle::MoveX, GizmoHandle::MoveY, GizmoHandle::MoveZ};
  constexpr std::array kTurns = {GizmoHandle::TurnX, GizmoHandle::TurnY, GizmoHandle::TurnZ};
  const double length = gizmo.unit * gizmo.radius;
  for (int axis = 0; axis < 3; ++axis) {
    const auto k = static_cast<std::size_t>(axis);
    const auto tip = pointOnCanvas(ui.camera, view, gizmo.centre + axisVector(axis) * (length * kArrow));
    if (tip && distance(*tip, gizmo.at) > kShortest * gizmo.radius) add(kMoves[k], *tip);
    const auto knob = pointOnCanvas(ui.camera, view, gizmo.centre + knobWay(ui.camera, axis) * length);
    if (knob) add(kTurns[k], *knob);
  }
  const double corner = kCorner * gizmo.radius;
  add(GizmoHandle::Scale, gizmo.at + ClientPoint{corner, corner});
  add(GizmoHandle::Depth, gizmo.at + ClientPoint{-corner, corner});
  add(GizmoHandle::Plane, gizmo.at);
  return gizmo;
}

std::optional<Gizmo> shownGizmo(const document::Document& document, const pipeline::Derived& derived,
                                const UiState& ui) {
  if (ui.tool != ToolKind::Place || ui.solids.hollow) return std::nullopt;  // a tap says where it is to open
  const std::vector<PartId> parts = selectedParts(document, ui);
  const std::optional<WorldPoint> pivot = centreOf(document, derived, ui, parts);
  const auto middle = pivot ? pointOnCanvas(ui.camera, ui.layout.solid, *pivot) : std::nullopt;
  if (!middle) return std::nullopt;
  double reach = 0;
  for (std::size_t i = 0; i < std::min(document.parts.size(), derived.parts.size()); ++i) {
    const document::Part& part = document.parts[i];
    const document::PictureEntry* entry = findPicture(document, document::pictureOf(part));
    const auto& shape = derived.parts[i].shape;
    if (!shape || entry == nullptr || std::ranges::find(parts, part.id) == parts.end()) continue;
    const mesh::Bounds box = mesh::boundsOf(shape->mesh);
    const pipeline::Copies copies = shownCopies(ui, part, entry->size);
    for (int corner = 0; corner < 8; ++corner) {
      const auto side = [&](int axis) {
        const auto k = static_cast<std::size_t>(axis);
        return (corner >> axis & 1) != 0 ? box.high[k] : box.low[k];
      };
      const auto at =
          pointOnCanvas(ui.camera, ui.layout.solid, (*copies.begin())(ModelPoint{side(0), side(1), side(2)}));
      if (at) reach = std::max({reach, std::abs(at->x - middle->x), std::abs(at->y - middle->y)});
    }
  }
  return gizmoAt(ui, *pivot, reach);
}

GizmoHandle handleAt(const Gizmo& gizmo, ClientPoint p, bool touch) {
  double nearest = touch ? kTouchReach : kMouseReach;
  GizmoHandle found = GizmoHandle::None;
  for (const Gizmo::Knob& knob : gizmo.knobs) {
    const double away = distance(knob.at, p);
    if (away >= nearest) continue;
    nearest = away;
    found = knob.handle;
  }
  return found;
}

document::Motion motionOf(const GizmoDrag& drag, ClientPoint to, bool steps) {
  const Gizmo& gizmo = drag.gizmo;
  document::Motion motion;
  motion.centre = gizmo.pivot;
  switch (drag.handle) {
    case GizmoHandle::MoveX:
    case GizmoHandle::MoveY:
    case GizmoHandle::MoveZ: {
      const int axis = axisOf(drag.handle);
      motion.move = axisVector(axis) * alongAxis(drag, to, axis);
      break;
    }
    case GizmoHandle::TurnX:
    case GizmoHandle::TurnY:
    case GizmoHandle::TurnZ: {
      const int axis = axisOf(drag.handle);
      double angle = turnBy(drag, to, axis);
      if (steps) angle = std::round(angle / kStep) * kStep;
      if (angle != 0) motion.turn = geometry::turnAbout(axisVector(axis), angle);
      break;
    }
    case GizmoHandle::Scale: {
      const double from = std::max(8.0, distance(drag.from, gizmo.at));
      motion.scale = std::clamp(distance(to, gizmo.at) / from, 0.05, 20.0);
      break;
    }
    case GizmoHandle::Depth:  // down is nearer, as on a table
      motion.move = drag.camera.back() * ((to.y - drag.from.y) * gizmo.unit);
      break;
    case GizmoHandle::Plane:
    case GizmoHandle::None:
      motion.move = onScreen(drag.camera, to - drag.from) * gizmo.unit;
      break;
  }
  return motion;
}

document::Motion pairMotion(const GizmoDrag& drag, ClientPoint by, double angle, double factor) {
  document::Motion motion;
  motion.centre = drag.gizmo.pivot;
  motion.move = onScreen(drag.camera, by) * drag.gizmo.unit;
  if (angle != 0) motion.turn = geometry::turnAbout(drag.camera.back(), -angle);
  motion.scale = std::clamp(factor, 0.05, 20.0);
  return motion;
}

}  // namespace spineloft::app
