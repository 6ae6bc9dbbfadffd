// What is between two curves of which one becomes the other. Internal to stack/.
#pragma once

#include <cstddef>
#include <vector>

#include "engine/stack/network.h"

namespace spineloft::stack {

/// The outer curve and the holes that go with it, from one sheet to the next.
class Passage {
 public:
  Passage(const Sheets& sheets, const Network& network, const Link& link);

  /// Its curves at both ends, the outer one first.
  const std::vector<std::size_t>& from() const { return from_; }
  const std::vector<std::size_t>& to() const { return to_; }
  const std::vector<std::size_t>& sizes() const { return sizes_; }  ///< points of each curve
  std::size_t count() const { return start_.size(); }               ///< of all
  double length() const { return length_; }
  /// Where the rows are between which straight ways are as good: shares t of the way, rising, in (0, 1], the last 1;
  /// at most `most` and two more. `least`: at least so many where the way is even.
  std::vector<double> rows(int most, int least) const;
  /// A section at t, 0 < t < 1.
  struct Section {
    std::vector<SectionPoint> figure;  ///< count() points about the outer curve's centre
    ModelPoint centre, x, y;           ///< where it stands
    ModelPoint bend;                   ///< of the rail there (geometry/bend.h); 0: none
    ModelPoint at(SectionPoint p) const;
  };
  Section section(double t) const;

 private:
  int stepsTo(double end) const;
  void figure(double t, double g, std::vector<SectionPoint>& out) const;
  bool isSound(const std::vector<SectionPoint>& figure) const;
  double soundBlend(double t, double g, std::vector<SectionPoint>& out) const;
  void addFlow(const Network& network, const Link& link);

  const Sheets& sheets_;
  sections::Blend blend_;
  std::vector<std::size_t> from_, to_, sizes_;
  double length_ = 0, turn_ = 0;
  double fromAt_ = 0, toAt_ = 0;  ///< places on the rail
  Carried a_, b_;
  std::vector<SectionPoint> start_, end_;  ///< the curves on the first sheet, the second ones turned back to it
  /// Where it flows: derivatives by t at both ends.
  struct Flow {
    std::vector<SectionPoint> figure;
    ModelPoint centre, normal;
    double turn = 0;
  };
  Flow leave_, arrive_;
  bool flows_ = false;
  double pull_ = 1;  ///< how much of the flow of the figure counts
};

}  // namespace spineloft::stack
