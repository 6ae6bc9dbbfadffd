// The handles that place parts: where they are on the canvas, and what dragging one means. Constant
// size on the screen, each a finger wide where a finger is used.
#pragma once

#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/document/document.h"
#include "engine/document/placement.h"
#include "engine/pipeline/derive.h"
#include "web/ui/space.h"
#include "web/ui/ui_state.h"
#include "web/ui/views.h"

namespace spineloft::app {

/// Unit vector of the world's axis 0, 1, 2.
WorldPoint axisVector(int axis);
/// The axis of an arrow or a ring; −1 for other handles.
int axisOf(GizmoHandle handle);
/// "x", "y", "z", "turn-x", "turn-y", "turn-z", "plane", "depth", "scale": in the API.
std::string_view handleKey(GizmoHandle handle);
/// "Move left and right" …: what a press on it does, in plain words.
const char* handleWords(GizmoHandle handle);
/// The same in a word, to stand below its knob; empty for arrows, which say it themselves.
const char* handleBrief(GizmoHandle handle);

struct Gizmo {
  WorldPoint pivot;    ///< about what parts turn and grow
  WorldPoint centre;   ///< of the handles: the pivot, or as near to it as lets all of them be in sight
  ClientPoint at;      ///< the centre on the canvas
  double radius = 80;  ///< of the rings, CSS pixels
  double unit = 0;     ///< world units a CSS pixel at the centre's depth

  struct Knob {
    GizmoHandle handle = GizmoHandle::None;
    ClientPoint at;
  };
  std::vector<Knob> knobs;  ///< those that can be seen and pressed, the centre last
  /// Points of the ring about an axis on the canvas, closed.
  std::vector<ClientPoint> ring(const Camera& camera, const Rect& view, int axis) const;
};

/// CSS pixels round a knob that its drawing takes.
double knobRadius(const UiState& ui);

/// Round what reaches `reach` CSS pixels from its pivot, and beyond that where there is room, so that the parts are not
/// covered; all of it within ui.solidRoom. None when the pivot is behind the eye.
std::optional<Gizmo> gizmoAt(const UiState& ui, WorldPoint pivot, double reach = 0);
/// That of the parts in hand; none without one, or without the tool. Cost: O(their vertices).
std::optional<Gizmo> shownGizmo(const document::Document& document, const pipeline::Derived& derived,
                                const UiState& ui);

/// The handle under a point of the canvas.
GizmoHandle handleAt(const Gizmo& gizmo, ClientPoint p, bool touch);

/// A drag of a handle: where it began, and the camera it began with.
struct GizmoDrag {
  Gizmo gizmo;
  Camera camera;
  Rect view;
  GizmoHandle handle = GizmoHandle::None;
  ClientPoint from;
};
/// The motion of the parts when the pointer is at `to`; turns by whole 15 degrees with `steps`.
document::Motion motionOf(const GizmoDrag& drag, ClientPoint to, bool steps);

/// Two fingers: `by` CSS pixels in the plane of the view, turned by `angle` radians (clockwise on the
/// screen) and grown by `factor`, all about the gizmo's centre.
document::Motion pairMotion(const GizmoDrag& drag, ClientPoint by, double angle, double factor);

}  // namespace spineloft::app
