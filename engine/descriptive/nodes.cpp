// Where lines meet: nodesOf of lines.h.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "engine/descriptive/lines.h"
#include "engine/geometry/polyline.h"

namespace spineloft::descriptive {
namespace {

/// The nearest place of a line, looked for within a reach only.
class NearLine {
 public:
  NearLine(const MeasuredLine& line, double reach) : line_(line), reach_(reach) {
    for (std::size_t first = 0; first + 1 < line.points.size(); first += kChunk) {
      Chunk chunk{first, std::min(first + kChunk, line.points.size() - 1), line.points[first], line.points[first]};
      for (std::size_t i = first; i <= chunk.last; ++i) {
        const PicturePoint p = line.points[i];
        chunk.low = {std::min(chunk.low.x, p.x), std::min(chunk.low.y, p.y)};
        chunk.high = {std::max(chunk.high.x, p.x), std::max(chunk.high.y, p.y)};
      }
      chunks_.push_back(chunk);
    }
  }
  struct Hit {
    double distance = 0, s = 0;
    std::size_t segment = 0;
  };
  std::optional<Hit> nearest(PicturePoint p) const {
    std::optional<Hit> best;
    for (const Chunk& chunk : chunks_) {
      if (p.x < chunk.low.x - reach_ || p.x > chunk.high.x + reach_ || p.y < chunk.low.y - reach_ ||
          p.y > chunk.high.y + reach_) {
        continue;
      }
      for (std::size_t i = chunk.first; i < chunk.last; ++i) {
        const PicturePoint a = line_.points[i], along = line_.points[i + 1] - a;
        const double squared = dot(along, along);
        const double t = squared > 0 ? std::clamp(dot(p - a, along) / squared, 0.0, 1.0) : 0.0;
        const double away = distance(p, a + along * t);
        if (away <= reach_ && (!best || away < best->distance)) best = {away, line_.s[i] + t * std::sqrt(squared), i};
      }
    }
    return best;
  }
  /// On which side of the line p is, as seen from the nearest place within the reach: −1, 0, 1.
  int side(PicturePoint p) const {
    const std::optional<Hit> hit = nearest(p);
    if (!hit) return 0;
    const PicturePoint a = line_.points[hit->segment], b = line_.points[hit->segment + 1];
    const double turned = cross(b - a, p - a);
    return turned > 0 ? 1 : turned < 0 ? -1 : 0;
  }

 private:
  static constexpr std::size_t kChunk = 16;
  struct Chunk {
    std::size_t first, last;
    PicturePoint low, high;
  };
  const MeasuredLine& line_;
  double reach_;
  std::vector<Chunk> chunks_;
};

PicturePoint atLength(const MeasuredLine& line, double s) {
  if (line.closed) s = std::fmod(std::fmod(s, line.length()) + line.length(), line.length());
  return geometry::pointAt(std::span<const PicturePoint>(line.points), std::span<const double>(line.s), s);
}
double shareOf(const MeasuredLine& line, double s) {
  const double share = s / line.length();
  return line.closed ? share - std::floor(share) : std::clamp(share, 0.0, 1.0);
}

/// A stretch of one line that is at another one, in arc lengths; beyond the length it goes round.
struct Contact {
  double from = 0, to = 0, otherFrom = 0, otherTo = 0;
};

std::vector<Contact> contactsOf(const MeasuredLine& line, const NearLine& other, double step) {
  std::vector<Contact> out;
  const auto count = static_cast<std::size_t>(std::ceil(line.length() / step));
  bool open = false;
  for (std::size_t i = 0; i <= count; ++i) {
    const double s = i == count ? line.length() : line.length() * static_cast<double>(i) / static_cast<double>(count);
    const auto hit = other.nearest(atLength(line, s));
    if (hit && open) {
      out.back().to = s;
      out.back().otherTo = hit->s;
    } else if (hit) {
      out.push_back({s, s, hit->s, hit->s});
    }
    open = hit.has_value();
  }
  const bool round = line.closed && out.size() > 1 && out.front().from == 0 && out.back().to == line.length();
  if (round) {
    out.front().from = out.back().from - line.length();
    out.front().otherFrom = out.back().otherFrom;
    out.pop_back();
  }
  return out;
}

/// All nodes of two lines beside their ends.
class Pair {
 public:
  Pair(std::span<const MeasuredLine> lines, std::uint32_t a, std::uint32_t b, double size)
      : a_(lines[a]), b_(lines[b]), indexA_(a), indexB_(b), size_(size) {}

  void addNodes(std::vector<Node>& nodes) const {
    const double step = kContact * size_;
    const NearLine near(b_, step), wide(b_, 8 * step);
    for (const Contact& contact : contactsOf(a_, near, step)) {
      if (contact.to - contact.from >= kShared * size_) {
        if (!atEnd(contact.from, contact.otherFrom)) add(nodes, NodeKind::Branch, contact.from, contact.otherFrom);
        if (!atEnd(contact.to, contact.otherTo)) add(nodes, NodeKind::Branch, contact.to, contact.otherTo);
        continue;
      }
      if (atEnd(contact.from, contact.otherFrom) || atEnd(contact.to, contact.otherTo)) continue;
      const int before = wide.side(atLength(a_, contact.from - 2 * step));
      const int after = wide.side(atLength(a_, contact.to + 2 * step));
      double s = (contact.from + contact.to) / 2, other = 0;
      const bool passes = before * after < 0;
      if (passes) s = crossingNear(near, contact, s);
      const auto hit = near.nearest(atLength(a_, s));
      other = hit ? hit->s : (contact.otherFrom + contact.otherTo) / 2;
      add(nodes, passes ? NodeKind::Crossing : NodeKind::Touch, s, other);
    }
  }

 private:
  bool isTip(const MeasuredLine& line, double s) const {
    return !line.closed && (s < 2 * kContact * size_ || s > line.length() - 2 * kContact * size_);
  }
  bool atEnd(double s, double other) const { return isTip(a_, s) || isTip(b_, other); }
  void add(std::vector<Node>& nodes, NodeKind kind, double s, double other) const {
    nodes.push_back({kind, atLength(a_, s), {{indexA_, shareOf(a_, s)}, {indexB_, shareOf(b_, other)}}});
  }
  /// Where the side changes, by bisection.
  double crossingNear(const NearLine& near, const Contact& contact, double otherwise) const {
    const auto side = [&](double s) { return near.side(atLength(a_, s)); };
    double low = contact.from, high = contact.to;
    const int first = side(low);
    if (first * side(high) >= 0) return otherwise;
    for (int i = 0; i < 50; ++i) {
      const double middle = (low + high) / 2;
      (side(middle) == first ? low : high) = middle;
    }
    return (low + high) / 2;
  }

  const MeasuredLine &a_, &b_;
  std::uint32_t indexA_, indexB_;
  double size_;
};

/// Where a line crosses itself.
void addSelfCrossings(std::span<const MeasuredLine> lines, std::uint32_t index, std::vector<Node>& nodes) {
  const MeasuredLine& line = lines[index];
  const std::size_t n = line.points.size() - 1;
  for (std::size_t i = 0; i < n; ++i) {
    const PicturePoint a = line.points[i], r = line.points[i + 1] - a;
    for (std::size_t k = i + 2; k < n; ++k) {
      if (line.closed && i == 0 && k == n - 1) continue;
      const PicturePoint c = line.points[k], q = line.points[k + 1] - c;
      const double whole = cross(r, q);
      if (whole == 0) continue;
      const double t = cross(c - a, q) / whole, u = cross(c - a, r) / whole;
      if (!(t >= 0 && t < 1 && u >= 0 && u < 1)) continue;
      const double first = line.s[i] + t * norm(r), second = line.s[k] + u * norm(q);
      nodes.push_back({NodeKind::Crossing, a + r * t, {{index, shareOf(line, first)}, {index, shareOf(line, second)}}});
    }
  }
}

void addEnds(std::span<const MeasuredLine> lines, double size, std::vector<Node>& nodes) {
  std::vector<Node> ends;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    if (lines[i].closed) continue;
    for (const double share : {0.0, 1.0}) {
      const PicturePoint at = share == 0 ? lines[i].points.front() : lines[i].points.back();
      const auto same =
          std::ranges::find_if(ends, [&](const Node& node) { return distance(node.at, at) < 1e-9 * size; });
      if (same == ends.end()) {
        ends.push_back({NodeKind::End, at, {{i, share}}});
      } else {
        same->kind = NodeKind::Corner;
        same->places.push_back({i, share});
      }
    }
  }
  for (Node& node : ends) {
    for (std::uint32_t k = 0; node.kind == NodeKind::End && k < lines.size(); ++k) {
      if (k == node.places[0].line) continue;
      const auto hit = NearLine(lines[k], kContact * size).nearest(node.at);
      if (!hit) continue;
      node.kind = NodeKind::Branch;
      node.places.push_back({k, shareOf(lines[k], hit->s)});
    }
    nodes.push_back(node);
  }
}

/// A change of type that no other node explains.
void addDips(std::span<const MeasuredLine> lines, double size, std::vector<Node>& nodes) {
  std::vector<Node> dips;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    const MeasuredLine& line = lines[i];
    const double little = 1e-6;
    for (const Stretch& stretch : line.hidden) {
      for (const double share : {stretch.from, stretch.to}) {
        const auto round = [&](double at) { return line.closed ? at - std::floor(at) : at; };
        const double before = round(share - little), after = round(share + little);
        if (before < 0 || after > 1 || line.isHidden(before) == line.isHidden(after)) continue;
        const bool explained = std::ranges::any_of(nodes, [&](const Node& node) {
          return std::ranges::any_of(node.places, [&](const Place& place) {
            if (place.line != i) return false;
            double apart = std::abs(place.share - share);
            if (line.closed) apart = std::min(apart, 1 - apart);
            return apart * line.length() <= kSnapping * size;
          });
        });
        if (!explained) dips.push_back({NodeKind::Dip, line.at(round(share)), {{i, round(share)}}});
      }
    }
  }
  nodes.insert(nodes.end(), dips.begin(), dips.end());
}

}  // namespace

std::vector<Node> nodesOf(std::span<const MeasuredLine> lines, double size) {
  std::vector<Node> nodes;
  if (!(size > 0)) return nodes;
  for (std::uint32_t a = 0; a < lines.size(); ++a) {
    addSelfCrossings(lines, a, nodes);
    for (std::uint32_t b = a + 1; b < lines.size(); ++b) Pair(lines, a, b, size).addNodes(nodes);
  }
  addEnds(lines, size, nodes);
  addDips(lines, size, nodes);
  std::ranges::stable_sort(nodes, {}, &Node::kind);
  return nodes;
}

}  // namespace spineloft::descriptive
