// Points and vectors whose space is part of their type, so that picture pixels are never added to
// world coordinates by accident.
#pragma once

#include <cmath>

namespace spineloft {

/// Tags of the spaces that cross a public header.
/// - PictureSpace: pixels of the *original* picture, x right, y down, pixel centres at integers.
/// - SectionSpace: the square [-1, 1]² in which cross-sections are drawn (x right, y to the viewer).
/// - ModelSpace: picture pixels with y up (y = −picture y) and z towards the viewer; right-handed.
///   Parts are lofted here.
/// - WorldSpace: y up, +z to the viewer, right-handed; the longer side of a picture spans 1 and its
///   centre is the origin.
struct PictureSpace;
struct SectionSpace;
struct ModelSpace;
struct WorldSpace;

template <class Space>
struct Vec2 {
  double x = 0, y = 0;
  bool operator==(const Vec2&) const = default;
  friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
  friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
  friend constexpr Vec2 operator-(Vec2 a) { return {-a.x, -a.y}; }
  friend constexpr Vec2 operator*(Vec2 a, double s) { return {a.x * s, a.y * s}; }
  friend constexpr Vec2 operator*(double s, Vec2 a) { return a * s; }
  friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
  Vec2& operator+=(Vec2 b) { return *this = *this + b; }
};

template <class Space>
struct Vec3 {
  double x = 0, y = 0, z = 0;
  bool operator==(const Vec3&) const = default;
  friend constexpr Vec3 operator+(Vec3 a, Vec3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
  friend constexpr Vec3 operator-(Vec3 a, Vec3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
  friend constexpr Vec3 operator-(Vec3 a) { return {-a.x, -a.y, -a.z}; }
  friend constexpr Vec3 operator*(Vec3 a, double s) { return {a.x * s, a.y * s, a.z * s}; }
  friend constexpr Vec3 operator*(double s, Vec3 a) { return a * s; }
  friend constexpr Vec3 operator/(Vec3 a, double s) { return {a.x / s, a.y / s, a.z / s}; }
  Vec3& operator+=(Vec3 b) { return *this = *this + b; }
};

template <class S>
constexpr double dot(Vec2<S> a, Vec2<S> b) {
  return a.x * b.x + a.y * b.y;
}
/// z of the 3D cross product: positive when b lies clockwise of a on the screen if y is down.
template <class S>
constexpr double cross(Vec2<S> a, Vec2<S> b) {
  return a.x * b.y - a.y * b.x;
}
template <class S>
constexpr double dot(Vec3<S> a, Vec3<S> b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
template <class S>
constexpr Vec3<S> cross(Vec3<S> a, Vec3<S> b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class V>
double norm(V v) {
  return std::sqrt(dot(v, v));
}
template <class V>
double distance(V a, V b) {
  return norm(a - b);
}
/// Unit vector along v; the zero vector stays zero.
template <class V>
V normalized(V v) {
  const double n = norm(v);
  return n > 0 ? v / n : V{};
}
template <class V>
constexpr V lerp(V a, V b, double t) {
  return a + (b - a) * t;
}
template <class S>
bool isFinite(Vec2<S> v) {
  return std::isfinite(v.x) && std::isfinite(v.y);
}
template <class S>
bool isFinite(Vec3<S> v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

using PicturePoint = Vec2<PictureSpace>;
using SectionPoint = Vec2<SectionSpace>;
using ModelPoint = Vec3<ModelSpace>;
using WorldPoint = Vec3<WorldSpace>;

}  // namespace spineloft
