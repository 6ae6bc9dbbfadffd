#include "engine/descriptive/outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/descriptive/completion.h"
#include "engine/geometry/line_distance.h"

namespace spineloft::descriptive {
namespace {

/// An end of an open line: 2 · line, + 1 at its last point.
using EndId = std::uint32_t;
constexpr EndId kNoEnd = 0xffffffffu;

EndId endAt(const Place& place) { return 2 * place.line + (place.share > 0.5 ? 1 : 0); }

/// The direction in which a line leaves its end: to the place 2 % of its length away.
PicturePoint leaving(const MeasuredLine& line, bool last) {
  constexpr double kLook = 0.02;
  return normalized(last ? line.at(1 - kLook) - line.points.back() : line.at(kLook) - line.points.front());
}

/// The turn of someone who comes in along one end and leaves along the other, squared; 0 straight on.
double turnOf(PicturePoint one, PicturePoint other) {
  const double turn = std::atan2(std::abs(cross(-one, other)), dot(-one, other));
  return turn * turn;
}

/// Pairs of directions with the least sum of squared turns; with an odd number one stays alone.
class Pairing {
 public:
  explicit Pairing(std::span<const PicturePoint> directions) : directions_(directions) {
    best_.assign(directions.size(), -1);
    std::vector<int> partner(directions.size(), -1);
    search(partner, 0, 0, directions.size() % 2 == 1);
  }
  const std::vector<int>& partners() const { return best_; }

 private:
  void search(std::vector<int>& partner, std::size_t first, double cost, bool mayLeave) {
    if (cost >= cost_) return;
    while (first < partner.size() && partner[first] != -1) ++first;
    if (first == partner.size()) {
      cost_ = cost;
      best_ = partner;
      return;
    }
    for (std::size_t k = first + 1; k < partner.size(); ++k) {
      if (partner[k] != -1) continue;
      partner[first] = static_cast<int>(k);
      partner[k] = static_cast<int>(first);
      search(partner, first + 1, cost + turnOf(directions_[first], directions_[k]), mayLeave);
      partner[first] = partner[k] = -1;
    }
    if (!mayLeave) return;
    partner[first] = kAlone;
    search(partner, first + 1, cost, false);
    partner[first] = -1;
  }
  static constexpr int kAlone = -2;
  std::span<const PicturePoint> directions_;
  std::vector<int> best_;
  double cost_ = std::numeric_limits<double>::infinity();
};

/// Whether two ends that meet on a third line turn so sharply there that both may end at it.
bool mayBothEnd(std::span<const MeasuredLine> lines, const Node& node, PicturePoint one, PicturePoint other,
                double size) {
  constexpr double kSharpest = 2.1;  // radians, about 120°
  if (turnOf(one, other) < kSharpest * kSharpest) return false;
  for (std::uint32_t k = 0; k < lines.size(); ++k) {
    if (std::ranges::find(node.places, k, &Place::line) != node.places.end()) continue;
    if (geometry::distanceToLine(node.at, std::span<const PicturePoint>(lines[k].points)) <= kWelding * size)
      return true;
  }
  return false;
}

/// For every end the end with which it goes on.
class Partners {
 public:
  Partners(std::span<const MeasuredLine> lines, std::span<const Node> nodes, double size)
      : of_(2 * lines.size(), kNoEnd) {
    for (const Node& node : nodes) {
      if (node.kind != NodeKind::Corner) continue;
      std::vector<PicturePoint> directions;
      for (std::size_t i = 0; i < std::min(node.places.size(), kMostPaired); ++i) {
        const Place& place = node.places[i];
        directions.push_back(leaving(lines[place.line], place.share > 0.5));
      }
      const Pairing pairing(directions);
      for (std::size_t i = 0; i < directions.size(); ++i) {
        const int found = pairing.partners()[i];
        if (found < static_cast<int>(i)) continue;  // none, or done
        const auto other = static_cast<std::size_t>(found);
        const std::array<EndId, 2> pair{endAt(node.places[i]), endAt(node.places[other])};
        if (mayBothEnd(lines, node, directions[i], directions[other], size)) {
          parted_.push_back(pair);
        } else {
          join(pair[0], pair[1]);
        }
      }
    }
  }
  void join(EndId one, EndId other) {
    of_[one] = other;
    of_[other] = one;
  }
  /// Those that might have ended where they meet, and go on nowhere else, are a corner.
  void joinParted() {
    for (const auto& [one, other] : parted_) {
      if (of_[one] == kNoEnd && of_[other] == kNoEnd) join(one, other);
    }
  }
  const std::vector<EndId>& all() const { return of_; }

 private:
  std::vector<EndId> of_;
  std::vector<std::array<EndId, 2>> parted_;
};

Run runFrom(EndId start) { return start % 2 == 0 ? Run{start / 2, 0, 1} : Run{start / 2, 1, 0}; }

/// The closed line and the place on which an end lies.
std::optional<Place> closedUnder(std::span<const MeasuredLine> lines, std::span<const Node> nodes, EndId end) {
  for (const Node& node : nodes) {
    if (node.kind != NodeKind::Branch || node.places[0].line != end / 2) continue;
    if (endAt(node.places[0]) != end || (node.places[0].share > 0 && node.places[0].share < 1)) continue;
    for (std::size_t k = 1; k < node.places.size(); ++k) {
      if (lines[node.places[k].line].closed) return node.places[k];
    }
  }
  return std::nullopt;
}

/// The shorter way from one share of a closed line to another.
Outline shorterWay(Place from, Place to) {
  const double ahead = to.share - from.share;
  if (std::abs(ahead) <= 0.5) return {{from.line, from.share, to.share}};
  if (ahead > 0) return {{from.line, from.share, 0}, {from.line, 1, to.share}};
  return {{from.line, from.share, 1}, {from.line, 0, to.share}};
}

/// The chain through an open line, as far as it goes both ways: its first end, and its runs.
struct Chain {
  Outline runs;
  EndId first = kNoEnd, last = kNoEnd;
  bool closed = false;
};
Chain chainThrough(const std::vector<EndId>& partner, std::uint32_t line, std::size_t lines) {
  EndId start = 2 * line;
  // Back to where it begins.
  for (std::size_t k = 0; k <= lines && partner[start] != kNoEnd; ++k) {
    const EndId before = partner[start] ^ 1u;
    if (before == 2 * line) break;  // round
    start = before;
  }
  Chain chain;
  chain.first = start;
  EndId here = start;
  for (std::size_t k = 0; k <= lines; ++k) {
    chain.runs.push_back(runFrom(here));
    chain.last = here ^ 1u;
    if (partner[chain.last] == kNoEnd) return chain;
    here = partner[chain.last];
    if (here == start) break;
  }
  chain.closed = true;
  return chain;
}

}  // namespace

namespace {

LineEnd lineEnd(std::span<const MeasuredLine> lines, EndId end) { return endOf(lines, end / 2, end % 2 == 1); }

/// Whether both ends of an open chain go on behind something, the one into the other.
bool closesHidden(std::span<const MeasuredLine> lines, const Chain& chain, double size) {
  const LineEnd last = lineEnd(lines, chain.last), first = lineEnd(lines, chain.first);
  return goesUnder(lines, last, size) && goesUnder(lines, first, size) &&
         hiddenWay(last, first).turn <= kMostHiddenTurn;
}

/// What can hide something: closed lines and chains, and chains that would close by themselves behind others.
std::vector<Cover> coversOf(std::span<const MeasuredLine> lines, const std::vector<EndId>& partner, double size) {
  std::vector<Cover> covers;
  std::vector<bool> used(lines.size(), false);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    Chain chain{{{i, 0, 1}}, kNoEnd, kNoEnd, true};
    if (!lines[i].closed) chain = chainThrough(partner, i, lines.size());
    Cover cover;
    for (const Run& run : chain.runs) {
      used[run.line] = true;
      cover.lines.push_back(run.line);
    }
    auto path = pathOf(lines, chain.runs);
    if (!path || (!chain.closed && !closesHidden(lines, chain, size))) continue;
    cover.outline = std::move(path).value().points;
    covers.push_back(std::move(cover));
  }
  return covers;
}

/// Ends that lie on another line and go on behind it get the end at which they come out again.
void pairHidden(std::span<const MeasuredLine> lines, double size, Partners& partners) {
  for (;;) {
    std::vector<EndId> ids;
    std::vector<LineEnd> ends;
    for (EndId id = 0; id < partners.all().size(); ++id) {
      if (lines[id / 2].closed || partners.all()[id] != kNoEnd) continue;
      ids.push_back(id);
      ends.push_back(lineEnd(lines, id));
    }
    if (ends.size() < 2) return;
    const auto pairs = hiddenPairs(ends, coversOf(lines, partners.all(), size), size);
    if (pairs.empty()) return;
    for (const auto& [one, other] : pairs) partners.join(ids[one], ids[other]);
  }
}

}  // namespace

std::vector<Outline> proposeOutlines(std::span<const MeasuredLine> lines, std::span<const Node> nodes) {
  const double size = sizeOf(lines);
  Partners partners(lines, nodes, size);
  pairHidden(lines, size, partners);
  partners.joinParted();
  std::vector<Outline> out;
  std::vector<bool> used(lines.size(), false);
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (used[i]) continue;
    if (lines[i].closed) {
      out.push_back({{i, 0, 1}});
      continue;
    }
    Chain chain = chainThrough(partners.all(), i, lines.size());
    for (const Run& run : chain.runs) used[run.line] = true;
    if (!chain.closed) {
      const auto from = closedUnder(lines, nodes, chain.last), to = closedUnder(lines, nodes, chain.first);
      if (!from || !to || from->line != to->line) continue;
      for (const Run& run : shorterWay(*from, *to)) chain.runs.push_back(run);
    }
    out.push_back(std::move(chain.runs));
  }
  return out;
}

namespace {

/// Adds the points of a run but its last.
void addRun(const MeasuredLine& line, const Run& run, OutlinePath& path) {
  std::vector<double> shares{run.from, run.to};
  const double low = std::min(run.from, run.to), high = std::max(run.from, run.to);
  for (const double s : line.s) shares.push_back(s / line.length());
  for (const Stretch& stretch : line.hidden) shares.insert(shares.end(), {stretch.from, stretch.to});
  std::erase_if(shares, [&](double share) { return share < low || share > high; });
  std::ranges::sort(shares);
  const double least = 1e-9;
  shares.erase(std::ranges::unique(shares, [&](double a, double b) { return b - a < least; }).begin(), shares.end());
  if (run.from > run.to) std::ranges::reverse(shares);
  for (std::size_t i = 0; i + 1 < shares.size(); ++i) {
    path.points.push_back(line.at(shares[i]));
    path.hidden.push_back(line.isHidden((shares[i] + shares[i + 1]) / 2));
  }
}

/// Closes the gap between the end of a run and the beginning of the next one; with its first point, without its last.
void addGap(std::span<const MeasuredLine> lines, const Run& run, const Run& next, OutlinePath& path) {
  std::vector<PicturePoint> points{lines[run.line].at(run.to), lines[next.line].at(next.from)};
  bool isHidden = false;
  if ((run.to == 0 || run.to == 1) && (next.from == 0 || next.from == 1)) {
    const LineEnd from = endOf(lines, run.line, run.to == 1), to = endOf(lines, next.line, next.from == 1);
    const double size = sizeOf(lines);
    HiddenWay way = hiddenWay(from, to);
    isHidden = way.turn <= kMostHiddenTurn && goesUnder(lines, from, size) && goesUnder(lines, to, size);
    if (isHidden) points = std::move(way.points);
  }
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    path.points.push_back(points[i]);
    path.hidden.push_back(isHidden);
  }
  if (isHidden) path.completed.push_back(std::move(points));
}

}  // namespace

Result<OutlinePath> pathOf(std::span<const MeasuredLine> lines, const Outline& outline) {
  OutlinePath path;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Run& run = outline[i];
    const bool inside = run.from >= 0 && run.from <= 1 && run.to >= 0 && run.to <= 1 && run.from != run.to;
    if (run.line >= lines.size() || !inside) return Error::ValueOutOfRange;
    addRun(lines[run.line], run, path);
    const Run& next = outline[(i + 1) % outline.size()];
    if (next.line >= lines.size()) return Error::ValueOutOfRange;
    if (distance(lines[run.line].at(run.to), lines[next.line].at(next.from)) > 1e-6) addGap(lines, run, next, path);
  }
  if (path.points.size() < 3) return Error::RegionEmpty;
  return path;
}

}  // namespace spineloft::descriptive
