// Heights from a picture (method-relief.md).
#pragma once

#include <cstddef>
#include <memory>

#include "engine/relief/front.h"

namespace spineloft::relief {

/// What a relief finds in its picture, before it is made smooth and high.
struct Heights {
  Front front;
  Cells counts;           ///< where the relief is to be, one a cell
  Values values;          ///< −1 … 1 towards the viewer, one a cell; 0 where it does not count
  Mode mode = Mode::Ink;  ///< ink where light and shadow were asked for and show nothing
  double explained = 0;   ///< of light and shadow: the share of the brightness that the light on the part explains
  bool found() const { return !values.empty(); }
};

/// Below it light and shadow say nothing of a shape.
inline constexpr double kLeastExplained = 0.2;

/// Finds heights in steps of at most about 50 ms, on any thread: it holds what it is made from. Not found: nothing of
/// the part is seen, or less than kLeastSide of it.
class HeightSteps {
 public:
  /// `pixels`: of the picture that gives the relief. Cost: that of frontOf.
  HeightSteps(const Surface& surface, const Relief& relief, std::shared_ptr<const image::Picture> pixels);
  ~HeightSteps();
  HeightSteps(const HeightSteps&) = delete;
  HeightSteps& operator=(const HeightSteps&) = delete;
  /// The next one. False: it was the last.
  bool step();
  /// After the last, once.
  Heights take();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

/// All steps.
Heights heightsOf(const Surface& surface, const Relief& relief, std::shared_ptr<const image::Picture> pixels);

/// Without the finest detail, and 0 at the border of what counts: what a relief of height 1 is, one a cell.
Values finished(const Heights& heights, double smooth);

std::size_t bytesOf(const Heights& heights);

}  // namespace spineloft::relief
