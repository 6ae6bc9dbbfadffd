// Cutting a thing out of a picture, from a hint or two where it is.
#pragma once

#include <memory>
#include <optional>
#include <vector>

#include "engine/base/result.h"
#include "engine/base/vec.h"
#include "engine/image/image.h"

namespace spineloft::vision {

/// A scribble: what it covers certainly is, or certainly is not, the thing.
struct CutMark {
  std::vector<PicturePoint> line;  ///< original picture pixels; a single point is a dot
  double radius = 0;               ///< of the brush, the same; at least kLeastMark of the picture's longer side
  bool inside = true;
  bool operator==(const CutMark&) const = default;
};
inline constexpr double kLeastMark = 0.006;

/// Hints in original picture pixels; at least one point inside, a box, or a mark inside.
struct CutHints {
  std::vector<PicturePoint> inside;   ///< points that certainly lie on the thing
  std::vector<PicturePoint> outside;  ///< points that certainly do not
  struct Box {
    PicturePoint low, high;
    bool operator==(const Box&) const = default;
  };
  std::optional<Box> box;      ///< around the thing; nothing of it lies beyond, but for marks
  std::vector<CutMark> marks;  ///< where they overlap the later one counts
  bool operator==(const CutHints&) const = default;
};

using CutContours = std::vector<std::vector<PicturePoint>>;

/// Cutting a thing out, in rounds that each take a part of a second, so that it can be shown and cancelled in between.
/// The same hints always give the same outlines. GrabCut (Rother, Kolmogorov and Blake 2004) on a copy of at most
/// kCutSide pixels of the picture, or of the box and what is round it; of what it finds the pieces that hold a point or
/// a mark inside, or the largest one. In a line drawing it is what the lines enclose, in one round.
class CutOutSearch {
 public:
  /// Errors: PictureEmpty, ValueOutOfRange (no hint, or not on the picture), NothingCutOut (no ground, or
  /// nothing else), OutOfMemory.
  static Result<CutOutSearch> begin(const image::Picture& picture, const CutHints& hints);
  CutOutSearch(CutOutSearch&&) noexcept;
  CutOutSearch& operator=(CutOutSearch&&) noexcept;
  ~CutOutSearch();

  /// One round. False when it was the last one, or there is none left.
  bool step();
  /// 0…1 of the rounds; less than before when a box needs a second attempt.
  double done() const;
  /// Outlines of the thing (original pixels; holes within outer ones, by even-odd), smoothed to less than
  /// a pixel of the copy. The middle of every mark inside is within them, of every mark outside is not,
  /// unless a later mark covers it. Errors: NothingCutOut, OutOfMemory.
  Result<CutContours> outlines() const;

 private:
  struct State;
  explicit CutOutSearch(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

/// All rounds at once. Errors: those of both.
Result<CutContours> cutOut(const image::Picture& picture, const CutHints& hints);

inline constexpr int kCutSide = 288;

}  // namespace spineloft::vision
