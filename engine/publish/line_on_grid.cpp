#include "engine/publish/line_on_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>

#include "engine/io/foretold.h"

namespace spineloft::publish {
namespace {

/// Lines that are followed.
constexpr std::size_t kBeam = 16;
/// Places are looked at as far as this from where the fit is, in tolerances, and so many steps at the most.
constexpr double kReach = 3;
constexpr std::int64_t kMostSteps = 5;
/// The number of a point that follows from the length of the step is looked for so many steps about that.
constexpr std::int64_t kSide = 1;
/// What a point of the spine counts that is off by the tolerance, and each square of more: quarters of a bit.
constexpr double kOff = 1, kTooFar = 4;

/// More than any line takes.
constexpr double kNoLine = 1e18;

/// Points of the spine.
struct Rows {
  std::size_t from = 0;   ///< before these all is settled
  std::size_t fixed = 0;  ///< before these no later point changes much
  std::size_t to = 0;     ///< up to here they are looked at
};

/// A line up to some point.
struct Begun {
  io::EvenLine even;              ///< in steps
  std::vector<PicturePoint> off;  ///< of the spine, as if the points to come were those of the fit
  double cost = 0;                ///< of the numbers and of the settled points of the spine, quarters of a bit
};

/// One more point of one of them.
struct Next {
  std::size_t line;
  std::int64_t x, y;
  double cost, all;  ///< without and with the points of the spine that are not settled
};

class Search {
 public:
  Search(const LineFit& fit, const LineGrid& grid, std::int64_t bend) : fit_(fit), grid_(grid) {
    lines_.push_back({{stepLength(), bend}, fit.off, 0});
  }
  /// Whether the i-th point has a place. They come in order.
  bool place(std::size_t i);
  GridLine best() const;

 private:
  /// The mean step of the fit, as a text tells it.
  std::int64_t stepLength() const {
    double sum = 0;
    for (std::size_t i = 1; i < fit_.points.size(); ++i) sum += distance(fit_.points[i - 1], fit_.points[i]);
    return std::llround(sum / static_cast<double>(fit_.points.size() - 1) / grid_.step * io::EvenLine::kLengthParts);
  }
  Rows rowsOf(std::size_t i) const;
  PicturePoint moved(std::size_t i, PicturePoint by, std::size_t row) const {
    return fit_.moves[2 * i][row] * by.x + fit_.moves[2 * i + 1][row] * by.y;
  }
  PicturePoint fromFit(std::size_t i, std::int64_t x, std::int64_t y) const {
    return PicturePoint{static_cast<double>(x), static_cast<double>(y)} * grid_.step - fit_.points[i];
  }
  double rowCost(PicturePoint off, PicturePoint before) const {
    const double far = dot(off, off) / (grid_.tolerance * grid_.tolerance);
    const PicturePoint step = off - before;
    return kOff * far + kTooFar * std::max(0.0, far - 1) + dot(step, step) / (grid_.rough * grid_.rough);
  }
  void lookAround(std::size_t i, const Rows& rows, std::size_t line);
  /// Of the rows where the line goes on so; `most` or more where it leaves the tolerance or takes as much.
  double costOf(const Begun& line, std::size_t i, PicturePoint by, const Rows& rows, double most) const;
  void keep(const Next& next);

  const LineFit& fit_;
  const LineGrid& grid_;
  std::vector<Begun> lines_;
  std::vector<Next> next_;  ///< the cheapest ones, as a heap
  double least_ = 0;
};

Rows Search::rowsOf(std::size_t i) const {
  const std::size_t points = fit_.points.size(), rows = fit_.off.size();
  const auto rowAt = [&](double point) {
    const double row = point * static_cast<double>(rows - 1) / static_cast<double>(points - 1);
    return std::min(rows, static_cast<std::size_t>(std::max(0.0, std::floor(row) + 1)));
  };
  const auto at = static_cast<double>(i);
  if (i + 1 == points) return {rowAt(at - 3), rows, rows};
  return {rowAt(at - 3), rowAt(at - 1), rowAt(at + 0.5)};
}

double Search::costOf(const Begun& line, std::size_t i, PicturePoint by, const Rows& rows, double most) const {
  double cost = 0;
  PicturePoint before;
  for (std::size_t row = rows.from; row < rows.to && cost < most; ++row) {
    const PicturePoint off = line.off[row] + moved(i, by, row);
    if (row < rows.fixed && dot(off, off) > grid_.tolerance * grid_.tolerance) return most;
    cost += rowCost(off, row == rows.from ? off : before);
    before = off;
  }
  return cost;
}

void Search::keep(const Next& next) {
  if (next_.size() == kBeam) {
    std::ranges::pop_heap(next_, {}, &Next::all);
    next_.pop_back();
  }
  next_.push_back(next);
  std::ranges::push_heap(next_, {}, &Next::all);
}

void Search::lookAround(std::size_t i, const Rows& rows, std::size_t line) {
  const Begun& begun = lines_[line];
  const io::EvenLine& even = begun.even;
  const std::int64_t reach =
      std::min<std::int64_t>(kMostSteps, std::llround(std::ceil(kReach * grid_.tolerance / grid_.step)));
  const std::array<std::int64_t, 2> middle{std::llround(fit_.points[i].x / grid_.step),
                                           std::llround(fit_.points[i].y / grid_.step)};
  const auto bits = [&](std::int64_t off) { return i == 0 ? 0.0 : static_cast<double>(io::offCost(off)); };
  const std::size_t axis = even.axis();
  // The first points say where the line begins and leads to, and the last one where it ends: in both directions.
  const bool free = i < 2 || i + 1 == fit_.points.size();
  for (std::int64_t first = middle[axis] - reach; first <= middle[axis] + reach; ++first) {
    const double withFirst = begun.cost + bits(first - even.expected());
    const std::int64_t expected = even.expectedAfter(first);
    const std::int64_t side = free ? reach : kSide, about = free ? middle[1 - axis] : expected;
    for (std::int64_t second = about - side; second <= about + side; ++second) {
      const double cost = withFirst + bits(second - expected);
      const double most = (next_.size() < kBeam ? kNoLine : next_.front().all) - cost;
      if (!(most > 0)) continue;
      const std::int64_t x = axis == 0 ? first : second, y = axis == 0 ? second : first;
      const double besides = costOf(begun, i, fromFit(i, x, y), rows, most);
      if (besides < most) keep({line, x, y, cost, cost + besides});
    }
  }
}

bool Search::place(std::size_t i) {
  const Rows rows = rowsOf(i);
  next_.clear();
  for (std::size_t line = 0; line < lines_.size(); ++line) lookAround(i, rows, line);
  std::ranges::sort_heap(next_, {}, &Next::all);
  const std::size_t settled = i + 1 < fit_.points.size() ? rowsOf(i + 1).from : rows.from;
  std::vector<Begun> lines;
  for (const Next& next : next_) {
    Begun line = lines_[next.line];
    line.even.takePoint(next.x, next.y);
    line.cost = next.cost;
    const PicturePoint by = fromFit(i, next.x, next.y);
    for (std::size_t row = 0; row < line.off.size(); ++row) line.off[row] += moved(i, by, row);
    for (std::size_t row = rows.from; row < settled; ++row)
      line.cost += rowCost(line.off[row], line.off[row == 0 ? 0 : row - 1]);
    lines.push_back(std::move(line));
  }
  lines_ = std::move(lines);
  if (!next_.empty()) least_ = next_.front().all;
  return !lines_.empty();
}

GridLine Search::best() const {
  GridLine line{{}, least_};
  const std::span<const std::int64_t> numbers = lines_.front().even.numbers();
  for (std::size_t k = 0; k < numbers.size(); k += 2) {
    line.points.push_back(PicturePoint{static_cast<double>(numbers[k]), static_cast<double>(numbers[k + 1])} *
                          grid_.step);
  }
  return line;
}

}  // namespace

std::optional<GridLine> lineOnGrid(const LineFit& fit, const LineGrid& grid, std::int64_t bend) {
  Search search(fit, grid, bend);
  for (std::size_t i = 0; i < fit.points.size(); ++i) {
    if (!search.place(i)) return std::nullopt;
  }
  return search.best();
}

}  // namespace spineloft::publish
