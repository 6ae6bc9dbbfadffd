// The two views: how picture pixels and the world come to the canvas.
#pragma once

#include <optional>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "engine/publish/publish.h"
#include "web/gl/mat4.h"
#include "web/ui/space.h"

namespace spineloft::app {

/// The picture view. While `fitted`, it follows the size of its rectangle.
struct PictureView {
  PicturePoint centre;  ///< in the middle of the view
  double zoom = 1;      ///< CSS pixels per picture pixel
  bool fitted = true;
  bool operator==(const PictureView&) const = default;

  ClientPoint toClient(PicturePoint p, const Rect& view) const {
    const ClientPoint middle = view.centre();
    return {middle.x + (p.x - centre.x) * zoom, middle.y + (p.y - centre.y) * zoom};
  }
  PicturePoint toPicture(ClientPoint p, const Rect& view) const {
    const ClientPoint middle = view.centre();
    return {centre.x + (p.x - middle.x) / zoom, centre.y + (p.y - middle.y) / zoom};
  }
};

/// Where a view has its buttons: in a column at its right side when it is low and wide, else in a
/// row at its foot.
bool buttonsAtSide(const Rect& view);

/// The whole picture in the middle of the view with a small margin, clear of the buttons and of a bar that
/// takes `head` CSS pixels at the head, and of a row that takes `foot` (but never smaller than a third of the view for
/// their sake).
PictureView fitPicture(image::Size picture, const Rect& view, double head = 0, double left = 0, double foot = 0);
/// Where the picture's outer edge lies.
Rect pictureRect(const PictureView& view, image::Size picture, const Rect& at);
/// Scales by `factor` (clamped to sensible zooms) so that what lies under `anchor` stays there.
void zoomPicture(PictureView& view, const Rect& at, ClientPoint anchor, double factor);
/// Moves the picture by CSS pixels; some of it always stays in sight.
void panPicture(PictureView& view, image::Size picture, const Rect& at, ClientPoint by);

/// A turntable: the eye circles round `target`; up is always up.
struct Camera {
  WorldPoint target;
  double yaw = 0;       ///< radians; 0 looks at the front (along −z), positive shows the right side
  double pitch = 0;     ///< radians, ± kMaxPitch; positive looks down
  double distance = 2;  ///< from target to eye
  bool operator==(const Camera&) const = default;

  WorldPoint back() const;   ///< unit, from target to eye
  WorldPoint right() const;  ///< unit
  WorldPoint up() const;     ///< unit
  WorldPoint eye() const { return target + back() * distance; }
};

inline constexpr double kMaxPitch = 1.5;
inline constexpr double kHalfHeight = 0.2867;  ///< tangent of half the 32° field of view
inline constexpr double kMinDistance = 0.02, kMaxDistance = 60;

/// Sees all of `bounds` from a little to the right and above.
Camera homeCamera(const publish::WorldBounds& bounds, const Rect& view);
/// Keeps the direction and frames `bounds`.
Camera framed(const Camera& camera, const publish::WorldBounds& bounds, const Rect& view);
/// Drag by CSS pixels.
void orbit(Camera& camera, const Rect& view, ClientPoint by);
void panCamera(Camera& camera, const Rect& view, ClientPoint by);
/// Nearer by `factor` > 1, towards what lies under `anchor`.
void zoomCamera(Camera& camera, const Rect& view, ClientPoint anchor, double factor);
/// Between two cameras, t in 0…1.
Camera blend(const Camera& a, const Camera& b, double t);

gl::Mat4 viewOf(const Camera& camera);
gl::Mat4 projectionOf(const Camera& camera, const Rect& view);
/// Where a point of the world is on the canvas; none behind the eye.
std::optional<ClientPoint> pointOnCanvas(const Camera& camera, const Rect& view, WorldPoint p);
/// Whether all of the box is within the view.
bool isInSight(const Camera& camera, const Rect& view, const publish::WorldBounds& bounds);
/// Unit direction from the eye through a point of the canvas.
WorldPoint rayThrough(const Camera& camera, const Rect& view, ClientPoint at);

}  // namespace spineloft::app
