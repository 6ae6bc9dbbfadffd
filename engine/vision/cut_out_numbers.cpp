#include "engine/vision/cut_out_numbers.h"

#include <cstddef>
#include <string>
#include <utility>

namespace spineloft::vision {
namespace {

void add(std::vector<double>& numbers, std::span<const PicturePoint> line) {
  numbers.push_back(static_cast<double>(line.size()));
  for (const PicturePoint p : line) numbers.insert(numbers.end(), {p.x, p.y});
}

/// Takes numbers off the front of a list. What is not there, or is no count, makes the list unsound; it gives zeros.
class Numbers {
 public:
  explicit Numbers(std::span<const double> left) : left_(left) {}

  double take() {
    if (left_.empty()) {
      sound_ = false;
      return 0;
    }
    const double value = left_.front();
    left_ = left_.subspan(1);
    return value;
  }
  /// Of items with at least `each` numbers.
  std::size_t takeCount(std::size_t each) {
    const double value = take();
    const double most = static_cast<double>(left_.size() / each);
    if (value >= 0 && value <= most && value == static_cast<double>(static_cast<std::size_t>(value))) {
      return static_cast<std::size_t>(value);
    }
    sound_ = false;
    return 0;
  }
  bool takeFlag() { return takeOneOf(2) == 1; }
  /// A whole number below `end`.
  int takeOneOf(int end) {
    const double value = take();
    for (int i = 0; i < end; ++i) {
      if (value == i) return i;
    }
    sound_ = false;
    return 0;
  }
  PicturePoint takePoint() {
    const double x = take();
    return {x, take()};
  }
  std::vector<PicturePoint> takeLine() {
    std::vector<PicturePoint> line(takeCount(2));
    for (PicturePoint& p : line) p = takePoint();
    return line;
  }
  bool hasMore() const { return sound_ && !left_.empty(); }
  /// Every number was there, and none is left.
  bool soundToTheEnd() const { return sound_ && left_.empty(); }

 private:
  std::span<const double> left_;
  bool sound_ = true;
};

}  // namespace

std::vector<double> numbersOf(const CutHints& hints) {
  const auto& [inside, outside, box, marks] = hints;
  std::vector<double> numbers;
  add(numbers, inside);
  add(numbers, outside);
  numbers.push_back(box ? 1 : 0);
  if (box) numbers.insert(numbers.end(), {box->low.x, box->low.y, box->high.x, box->high.y});
  numbers.push_back(static_cast<double>(marks.size()));
  for (const auto& [line, radius, within] : marks) {
    add(numbers, line);
    numbers.insert(numbers.end(), {radius, within ? 1.0 : 0.0});
  }
  return numbers;
}

std::optional<CutHints> hintsFrom(std::span<const double> numbers) {
  constexpr std::size_t kLeastOfMark = 3;  // of one without points
  Numbers from(numbers);
  CutHints hints;
  hints.inside = from.takeLine();
  hints.outside = from.takeLine();
  if (from.takeFlag()) {
    const PicturePoint low = from.takePoint();
    hints.box = {low, from.takePoint()};
  }
  hints.marks.resize(from.takeCount(kLeastOfMark));
  for (CutMark& mark : hints.marks) {
    mark.line = from.takeLine();
    mark.radius = from.take();
    mark.inside = from.takeFlag();
  }
  if (!from.soundToTheEnd()) return std::nullopt;
  return hints;
}

std::vector<double> numbersOf(const Result<CutContours>& found) {
  std::vector<double> numbers;
  if (!found) {
    const auto& [error, detail] = found.failure();
    numbers.push_back(1 + static_cast<int>(error));
    for (const char c : detail) numbers.push_back(static_cast<unsigned char>(c));
    return numbers;
  }
  numbers.push_back(0);
  for (const std::vector<PicturePoint>& contour : found.value()) add(numbers, contour);
  return numbers;
}

std::optional<Result<CutContours>> foundFrom(std::span<const double> numbers) {
  Numbers from(numbers);
  if (const int kind = from.takeOneOf(1 + static_cast<int>(Error::kCount)); kind > 0) {
    Failure failure{static_cast<Error>(kind - 1), {}};
    for (std::size_t i = 1; i < numbers.size(); ++i) failure.detail += static_cast<char>(from.takeOneOf(256));
    if (!from.soundToTheEnd()) return std::nullopt;
    return failure;
  }
  CutContours contours;
  while (from.hasMore()) contours.push_back(from.takeLine());
  if (!from.soundToTheEnd()) return std::nullopt;
  return contours;
}

}  // namespace spineloft::vision
