#include "web/ui/views.h"

#include <algorithm>
#include <cmath>

namespace spineloft::app {
namespace {

constexpr double kButtonRoom = 64;  // CSS pixels at the side of the view that buttons take
/// At its foot: of every row, with words and for fingers too, so that nothing moves under the first finger.
constexpr double kRowRoom = 78;
constexpr double kTopRoom = 54;    // CSS pixels at the head of a tall view that buttons take
constexpr double kTallView = 440;  // CSS pixels
constexpr double kLowView = 290;   // CSS pixels
constexpr double kFitMargin = 28;  // CSS pixels round a fitted picture
constexpr double kMinZoom = 0.01, kMaxZoom = 64;
constexpr double kInSight = 48;  // CSS pixels of the picture that cannot be pushed out
constexpr double kHomeYaw = 0.55, kHomePitch = 0.22;
constexpr double kPi = 3.14159265358979323846;

double radiusOf(const publish::WorldBounds& bounds) { return std::max(0.02, distance(bounds.low, bounds.high) / 2); }

double distanceFor(double radius, const Rect& view) {
  const double aspect = view.height > 0 ? view.width / view.height : 1;
  const double half = std::atan(kHalfHeight * std::min(1.0, aspect));
  return std::clamp(radius / std::sin(half) * 1.02, kMinDistance, kMaxDistance);
}

}  // namespace

bool buttonsAtSide(const Rect& view) { return view.height < kLowView && view.width > 1.1 * view.height; }

PictureView fitPicture(image::Size picture, const Rect& view, double head, double left, double foot) {
  PictureView out;
  out.centre = {(picture.width - 1) / 2.0, (picture.height - 1) / 2.0};
  const double margin = std::min(kFitMargin, 0.045 * std::min(view.width, view.height));
  Rect inner = view.inset(margin);
  // The options of the tools stand at the head of a tall view.
  head = std::max(view.height >= kTallView ? kTopRoom - margin : 0.0, head);
  const double row = std::max(kRowRoom, foot) - margin;
  foot = 0;
  if (buttonsAtSide(view)) {
    left = std::clamp(left - margin, 0.0, inner.width / 3);
    inner.x += left;
    inner.width = std::max(0.0, inner.width - left - (kButtonRoom - margin));
  } else if (inner.height > 2 * kButtonRoom) {
    foot = row;
  }
  const double most = std::max(0.0, inner.height - view.height / 3);
  if (head + foot > most) {
    head *= most / (head + foot);
    foot = most - head;
  }
  inner.y += head;
  inner.height -= head + foot;
  if (picture.width > 0 && picture.height > 0 && inner.width > 0 && inner.height > 0) {
    out.zoom = std::clamp(std::min(inner.width / picture.width, inner.height / picture.height), kMinZoom, kMaxZoom);
  }
  const ClientPoint off = view.centre() - inner.centre();
  out.centre += PicturePoint{off.x, off.y} / out.zoom;
  return out;
}

Rect pictureRect(const PictureView& view, image::Size picture, const Rect& at) {
  const ClientPoint corner = view.toClient({-0.5, -0.5}, at);
  return {corner.x, corner.y, picture.width * view.zoom, picture.height * view.zoom};
}

void zoomPicture(PictureView& view, const Rect& at, ClientPoint anchor, double factor) {
  if (!(factor > 0)) return;
  const PicturePoint under = view.toPicture(anchor, at);
  view.zoom = std::clamp(view.zoom * factor, kMinZoom, kMaxZoom);
  const PicturePoint now = view.toPicture(anchor, at);
  view.centre += under - now;
  view.fitted = false;
}

void panPicture(PictureView& view, image::Size picture, const Rect& at, ClientPoint by) {
  view.centre += PicturePoint{-by.x / view.zoom, -by.y / view.zoom};
  const double reachX = std::max(0.0, at.width / 2 - kInSight) / view.zoom;
  const double reachY = std::max(0.0, at.height / 2 - kInSight) / view.zoom;
  view.centre.x = std::clamp(view.centre.x, -reachX, picture.width + reachX);
  view.centre.y = std::clamp(view.centre.y, -reachY, picture.height + reachY);
  view.fitted = false;
}

WorldPoint Camera::back() const {
  return {std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch)};
}
WorldPoint Camera::right() const { return {std::cos(yaw), 0, -std::sin(yaw)}; }
WorldPoint Camera::up() const { return cross(back(), right()); }

Camera homeCamera(const publish::WorldBounds& bounds, const Rect& view) {
  Camera camera;
  camera.yaw = kHomeYaw;
  camera.pitch = kHomePitch;
  return framed(camera, bounds, view);
}

Camera framed(const Camera& camera, const publish::WorldBounds& bounds, const Rect& view) {
  Camera out = camera;
  out.target = (bounds.low + bounds.high) / 2;
  out.distance = distanceFor(radiusOf(bounds), view);
  return out;
}

void orbit(Camera& camera, const Rect& view, ClientPoint by) {
  const double turn = kPi / std::max(200.0, std::min(view.width, view.height));
  camera.yaw = std::remainder(camera.yaw - by.x * turn, 2 * kPi);
  camera.pitch = std::clamp(camera.pitch + by.y * turn, -kMaxPitch, kMaxPitch);
}

void panCamera(Camera& camera, const Rect& view, ClientPoint by) {
  const double scale = 2 * kHalfHeight * camera.distance / std::max(1.0, view.height);
  camera.target += camera.right() * (-by.x * scale) + camera.up() * (by.y * scale);
}

void zoomCamera(Camera& camera, const Rect& view, ClientPoint anchor, double factor) {
  if (!(factor > 0)) return;
  const double before = camera.distance;
  camera.distance = std::clamp(before / factor, kMinDistance, kMaxDistance);
  // What lies under the anchor at the target's depth stays under it.
  const ClientPoint off = anchor - view.centre();
  const double scale = 2 * kHalfHeight / std::max(1.0, view.height) * (before - camera.distance);
  camera.target += camera.right() * (off.x * scale) - camera.up() * (off.y * scale);
}

Camera blend(const Camera& a, const Camera& b, double t) {
  Camera out;
  out.target = lerp(a.target, b.target, t);
  out.yaw = a.yaw + std::remainder(b.yaw - a.yaw, 2 * kPi) * t;
  out.pitch = a.pitch + (b.pitch - a.pitch) * t;
  out.distance = a.distance * std::pow(b.distance / a.distance, t);
  return out;
}

gl::Mat4 viewOf(const Camera& camera) {
  return gl::viewMatrix(camera.eye(), camera.right(), camera.up(), camera.back());
}

gl::Mat4 projectionOf(const Camera& camera, const Rect& view) {
  const double aspect = view.height > 0 ? view.width / view.height : 1;
  return gl::perspective(kHalfHeight, aspect, std::max(0.002, camera.distance * 0.02), camera.distance + 20);
}

std::optional<ClientPoint> pointOnCanvas(const Camera& camera, const Rect& view, WorldPoint p) {
  const WorldPoint from = p - camera.eye();
  const double away = -dot(from, camera.back());
  if (away < 1e-6) return std::nullopt;
  const double scale = std::max(1.0, view.height) / (2 * kHalfHeight * away);
  return view.centre() + ClientPoint{dot(from, camera.right()), -dot(from, camera.up())} * scale;
}

bool isInSight(const Camera& camera, const Rect& view, const publish::WorldBounds& bounds) {
  for (int corner = 0; corner < 8; ++corner) {
    const WorldPoint p{(corner & 1) != 0 ? bounds.high.x : bounds.low.x,
                       (corner & 2) != 0 ? bounds.high.y : bounds.low.y,
                       (corner & 4) != 0 ? bounds.high.z : bounds.low.z};
    const std::optional<ClientPoint> at = pointOnCanvas(camera, view, p);
    if (!at || !view.contains(*at)) return false;
  }
  return true;
}

WorldPoint rayThrough(const Camera& camera, const Rect& view, ClientPoint at) {
  const double scale = 2 * kHalfHeight / std::max(1.0, view.height);
  const ClientPoint off = at - view.centre();
  return normalized(camera.right() * (off.x * scale) - camera.up() * (off.y * scale) - camera.back());
}

}  // namespace spineloft::app
