// The sections along one spine on a common set of points. Internal to loft/.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/loft/section_key.h"

namespace spineloft::loft {

/// What stands at each place along the spine: the same closed curves everywhere, each with the same
/// number of points everywhere. Outer curves run counter-clockwise, holes clockwise. Where the section
/// changes, points that belong together lie in the same direction from the middles of their curves
/// when those see their whole curves (then no section between crosses itself); else at the same share
/// of the curve's length, turned so that their distances are least in sum (cross-sections-hughes
/// 4.1.1). Sections that would still cross themselves or each other are replaced by the nearest
/// sound one on the way.
class SectionTrack {
 public:
  /// One section everywhere: simple, counter-clockwise.
  static SectionTrack fixed(std::vector<SectionPoint> points);
  /// The sections of keys that pass checkSectionKeys, with about `points` points around. `closed`: after
  /// the last key the section goes on to the first again. Errors: SectionInvalid.
  static Result<SectionTrack> along(std::span<const SectionKey> keys, int points, bool closed);

  std::span<const std::size_t> sizes() const { return sizes_; }
  std::size_t count() const { return count_; }  ///< points of all curves
  bool varies() const { return keys_.size() > 1; }
  /// The points of all curves, and as the last point the hub: a point that sees the whole curve when
  /// there is one alone and it has such a point. Touches x = ±1. Appends count() + 1 points.
  void appendShape(double share, std::vector<SectionPoint>& out) const;
  /// How far the section has changed up to here, in steps of about equal sight.
  double progress(double share) const;
  double shortestEdge() const { return shortestEdge_; }  ///< at the keys, section units
  /// The hubs of all keys see their curves: an inner wall lies inside the outer one.
  bool hollow() const { return hollow_; }

 private:
  struct Key {
    double at = 0;
    sections::Blend blend;
    std::vector<SectionPoint> points;
    bool starShaped = false;  ///< one curve that its middle sees
    /// Where sections flow: how its points move on, by share of the spine, and how much of that counts from here to
    /// the next key.
    std::vector<SectionPoint> slopes = {};
    double pull = 1;
  };
  struct Place {
    std::size_t from = 0, to = 0;
    double f = 0;
  };
  double spanAfter(std::size_t key) const;
  void findSlopes();
  Place placeAt(double share) const;
  void blended(const Place& place, std::vector<SectionPoint>& out) const;
  bool isSound(const Place& place) const;
  double soundBlend(Place place) const;
  void finish();

  std::vector<Key> keys_;
  std::vector<std::size_t> sizes_;
  std::size_t count_ = 0;
  double shortestEdge_ = 0;
  bool closed_ = false, hollow_ = false;
};

}  // namespace spineloft::loft
