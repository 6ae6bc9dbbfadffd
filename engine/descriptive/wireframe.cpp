#include "engine/descriptive/wireframe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include "engine/base/groups.h"
#include "engine/descriptive/outlines.h"
#include "engine/descriptive/square.h"
#include "engine/descriptive/straight.h"

namespace spineloft::descriptive {
namespace {

using Corner = std::uint32_t;
using EdgeEnds = std::pair<Corner, Corner>;

/// Two edges at a corner of only two go on straight when they turn by less, radians.
constexpr double kStraightOn = 0.45;

/// Places within kSameCorner of a corner belong to it; else they are a new one.
class Corners {
 public:
  explicit Corners(double size) : reach_(kSameCorner * size) {}
  Corner of(PicturePoint p) {
    Corner best = 0;
    for (Corner i = 1; i < at.size(); ++i) {
      if (distance(at[i], p) < distance(at[best], p)) best = i;
    }
    if (at.empty() || distance(at[best], p) > reach_) {
      at.push_back(p);
      sums_.push_back({p, 1});
      return static_cast<Corner>(at.size() - 1);
    }
    auto& [sum, count] = sums_[best];
    sum += p;
    at[best] = sum / ++count;
    return best;
  }
  std::vector<PicturePoint> at;

 private:
  double reach_;
  std::vector<std::pair<PicturePoint, double>> sums_;
};

/// The edges that the straight lines of a drawing make.
class Edges {
 public:
  struct Edge {
    EdgeEnds ends;
    Run run;
    bool hidden = false;
  };
  Edges(std::span<const MeasuredLine> lines, std::span<const Node> nodes, double size) : lines_(lines), corners_(size) {
    std::vector<std::vector<double>> own;
    for (const MeasuredLine& line : lines) {
      own.push_back(cornersOf(line, size, kEdgeCorner));
      straight_.push_back(isStraightBetween(line, own.back(), size));
    }
    for (const Node& node : nodes) {
      if (node.kind != NodeKind::Branch || !straight_[node.places[0].line]) continue;
      for (const Place& place : node.places) {
        if (straight_[place.line]) own[place.line].push_back(place.share);
      }
    }
    for (std::uint32_t i = 0; i < lines.size(); ++i) {
      if (straight_[i]) addLine(i, own[i]);
    }
  }
  const std::vector<Edge>& all() const { return edges_; }
  const std::vector<PicturePoint>& corners() const { return corners_.at; }

 private:
  void addLine(std::uint32_t index, std::vector<double> shares) {
    const MeasuredLine& line = lines_[index];
    // The first point of a closed line is a corner, so that no edge leads through it.
    if (line.closed) shares.push_back(0);
    std::ranges::sort(shares);
    std::vector<std::pair<double, Corner>> places;
    for (const double share : shares) {
      const Corner corner = corners_.of(line.at(share));
      if (places.empty() || places.back().second != corner) places.emplace_back(share, corner);
    }
    if (line.closed) {
      if (places.size() > 1 && places.back().second == places.front().second) places.pop_back();
      places.emplace_back(1, places.front().second);
    }
    places.back().first = 1;  // an end stays the end of its line
    for (std::size_t i = 0; i + 1 < places.size(); ++i) add(index, places[i], places[i + 1]);
  }
  void add(std::uint32_t index, std::pair<double, Corner> from, std::pair<double, Corner> to) {
    const MeasuredLine& line = lines_[index];
    int hidden = 0;
    constexpr int kLooks = 17;
    for (int k = 0; k < kLooks; ++k) {
      hidden += line.isHidden(from.first + (to.first - from.first) * (k + 0.5) / kLooks) ? 1 : 0;
    }
    edges_.push_back({{from.second, to.second}, {index, from.first, to.first}, 2 * hidden > kLooks});
  }

  std::span<const MeasuredLine> lines_;
  Corners corners_;
  std::vector<bool> straight_;
  std::vector<Edge> edges_;
};

/// Where a corner of seen faces and one of hidden faces are drawn at one place, away from the silhouette, they are two.
void splitLayers(Wireframe& solid) {
  const std::vector<Corner> outline = outerCycle(solid.faces, solid.isFront);
  std::set<Corner> inside;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    if (solid.isFront[f]) inside.insert(solid.faces[f].begin(), solid.faces[f].end());
  }
  for (const Corner corner : outline) inside.erase(corner);
  std::map<Corner, Corner> behind;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    for (Corner& corner : solid.faces[f]) {
      if (solid.isFront[f] || !inside.contains(corner)) continue;
      const auto [at, isNew] = behind.try_emplace(corner, static_cast<Corner>(solid.corners.size()));
      if (isNew) solid.corners.push_back(solid.corners[corner]);
      corner = at->second;
    }
  }
}

/// The faces of one connected set of edges; none where they are no solid.
class Solid {
 public:
  Solid(const Edges& edges, std::vector<std::uint32_t> chosen) : edges_(edges), chosen_(std::move(chosen)) {}

  /// Cycles of corners, counter-clockwise seen from outside; those in front first.
  std::optional<Wireframe> make() {
    std::vector<std::uint32_t> seen, hidden;
    for (const std::uint32_t e : chosen_) (edges_.all()[e].hidden ? hidden : seen).push_back(e);
    if (!hasEnoughEdges()) return std::nullopt;
    const std::optional<Layer> front = layerOf(seen);
    if (!front) return std::nullopt;
    std::vector<std::uint32_t> behind = hidden;
    for (const std::uint32_t e : seen) {
      if (isOn(front->outer, edges_.all()[e].ends)) behind.push_back(e);
    }
    const std::optional<Layer> back = layerOf(behind);
    if (!back || back->outer.size() != front->outer.size()) return std::nullopt;
    Wireframe out;
    out.corners = edges_.corners();
    out.faces = front->faces;
    out.isFront.assign(out.faces.size(), true);
    for (Wireframe::Face face : back->faces) {
      std::ranges::reverse(face);
      out.faces.push_back(std::move(face));
      out.isFront.push_back(false);
    }
    Wireframe apart = out;
    splitLayers(apart);
    std::set<Corner> used;
    for (const auto& face : apart.faces) used.insert(face.begin(), face.end());
    const bool isBall = used.size() + out.faces.size() == chosen_.size() + 2;
    return isBall && out.faces.size() >= 4 ? std::optional(out) : std::nullopt;
  }

  /// Where all edges are seen and they are some of those of a prism: its others. A prism is a face, the base, and the
  /// same moved by the way that edges lead away from it; all of them are within `reach` of that way. Of several bases
  /// the one that fits best. Else none.
  std::vector<std::array<PicturePoint, 2>> missingOfPrism(double reach) const {
    const bool isSeen = std::ranges::none_of(chosen_, [&](std::uint32_t e) { return edges_.all()[e].hidden; });
    const std::optional<Layer> front = isSeen ? layerOf(chosen_) : std::nullopt;
    if (!front) return {};
    const Neighbours drawn = withoutPassed(front->outer);
    std::vector<std::array<PicturePoint, 2>> best;
    double least = reach;
    for (Wireframe::Face base : front->faces) {
      std::erase_if(base, [&](Corner c) { return !drawn.contains(c); });
      const std::optional<Prism> prism = prismOver(base, drawn, reach);
      if (!prism || prism->off >= least) continue;
      best = prism->missing;
      least = prism->off;
    }
    return best;
  }

 private:
  struct Layer {
    std::vector<Wireframe::Face> faces;
    Wireframe::Face outer;  ///< counter-clockwise
  };
  using Neighbours = std::map<Corner, std::vector<Corner>>;
  struct Prism {
    std::vector<std::array<PicturePoint, 2>> missing;
    double off = 0;  ///< how far an edge that leads away from the base is from the mean of them, the most; pixels
  };

  PicturePoint at(Corner c) const { return edges_.corners()[c]; }
  Neighbours neighbours() const {
    Neighbours out;
    for (const std::uint32_t e : chosen_) {
      const auto [a, b] = edges_.all()[e].ends;
      out[a].push_back(b);
      out[b].push_back(a);
    }
    return out;
  }
  bool goesStraightOn(Corner corner, const std::vector<Corner>& others) const {
    if (others.size() != 2) return false;
    const PicturePoint in = at(corner) - at(others[0]), out = at(others[1]) - at(corner);
    return std::abs(std::atan2(cross(in, out), dot(in, out))) < kStraightOn;
  }
  /// One edge from corner to corner, through places inside the silhouette where it goes straight on.
  Neighbours withoutPassed(const Wireframe::Face& silhouette) const {
    Neighbours out = neighbours();
    for (auto at = out.begin(); at != out.end();) {
      const auto& [corner, others] = *at;
      if (!goesStraightOn(corner, others) || std::ranges::find(silhouette, corner) != silhouette.end()) {
        ++at;
        continue;
      }
      std::ranges::replace(out.at(others[0]), corner, others[1]);
      std::ranges::replace(out.at(others[1]), corner, others[0]);
      at = out.erase(at);
    }
    return out;
  }
  /// Level or upright, within 10°.
  static bool isAlongPicture(PicturePoint way) {
    const auto [low, high] = std::minmax({std::abs(way.x), std::abs(way.y)});
    return low < 0.176 * high;
  }
  std::optional<Prism> prismOver(const Wireframe::Face& base, const Neighbours& drawn, double reach) const {
    const auto isBase = [&](Corner c) { return std::ranges::find(base, c) != base.end(); };
    std::map<Corner, Corner> image;
    PicturePoint way{};
    for (const Corner c : base) {
      for (const Corner other : drawn.at(c)) {
        if (isBase(other)) continue;
        if (!image.try_emplace(c, other).second) return std::nullopt;
        way += at(other) - at(c);
      }
    }
    if (image.empty()) return std::nullopt;
    way = way / static_cast<double>(image.size());
    Prism out;
    for (const auto& [c, other] : image) out.off = std::max(out.off, norm(at(other) - at(c) - way));
    if (!(out.off < reach)) return std::nullopt;
    std::set<Corner> known(base.begin(), base.end());
    for (const auto& [c, other] : image) known.insert(other);
    // A corner that no edge leads to is at a place of its own, or was not drawn.
    const std::map<Corner, Corner> ledTo = image;
    std::map<Corner, PicturePoint> place;
    for (const Corner c : base) {
      place[c] = at(c) + way;
      double least = reach;
      for (const auto& [other, ways] : drawn) {
        if (ledTo.contains(c) || known.contains(other) || distance(at(other), place[c]) >= least) continue;
        least = distance(at(other), place[c]);
        image[c] = other;
      }
      if (!image.contains(c)) continue;
      known.insert(image[c]);
      place[c] = at(image[c]);
    }
    if (!std::ranges::all_of(drawn, [&](const auto& one) { return known.contains(one.first); })) return std::nullopt;
    const auto isDrawn = [&](Corner a, Corner b) { return std::ranges::find(drawn.at(a), b) != drawn.at(a).end(); };
    std::size_t found = 0, sides = 0;
    bool isUpright = false;
    const auto want = [&](std::optional<Corner> a, PicturePoint from, std::optional<Corner> b, PicturePoint to) {
      if (a && b && isDrawn(*a, *b)) {
        ++found;
      } else {
        out.missing.push_back({from, to});
      }
    };
    const auto imageOf = [&](Corner c) { return image.contains(c) ? std::optional(image.at(c)) : std::nullopt; };
    for (std::size_t i = 0; i < base.size(); ++i) {
      const Corner a = base[i], b = base[(i + 1) % base.size()];
      want(a, at(a), b, at(b));
      want(a, at(a), imageOf(a), place[a]);
      want(imageOf(a), place[a], imageOf(b), place[b]);
      if (!ledTo.contains(a) || !ledTo.contains(b) || !isDrawn(ledTo.at(a), ledTo.at(b))) continue;
      ++sides;
      isUpright = isAlongPicture(way) && isAlongPicture(at(b) - at(a));
    }
    // A roof on a wall, both seen from the front.
    if (sides == 1 && isUpright) return std::nullopt;
    std::size_t all = 0;
    for (const auto& [corner, others] : drawn) all += others.size();
    return 2 * found == all && !out.missing.empty() ? std::optional(out) : std::nullopt;
  }
  /// Three at every corner, or two that go on straight.
  bool hasEnoughEdges() const {
    std::set<EdgeEnds> all;
    for (const std::uint32_t e : chosen_) {
      const auto [a, b] = edges_.all()[e].ends;
      if (!all.insert(std::minmax(a, b)).second) return false;
    }
    return std::ranges::all_of(
        neighbours(), [&](const auto& one) { return one.second.size() > 2 || goesStraightOn(one.first, one.second); });
  }
  static bool isOn(const Wireframe::Face& cycle, EdgeEnds ends) {
    for (std::size_t i = 0; i < cycle.size(); ++i) {
      const Corner a = cycle[i], b = cycle[(i + 1) % cycle.size()];
      if (EdgeEnds{a, b} == ends || EdgeEnds{b, a} == ends) return true;
    }
    return false;
  }
  bool anyCross(const std::vector<std::uint32_t>& layer) const {
    for (std::size_t i = 0; i < layer.size(); ++i) {
      for (std::size_t k = i + 1; k < layer.size(); ++k) {
        const auto [a, b] = edges_.all()[layer[i]].ends;
        const auto [c, d] = edges_.all()[layer[k]].ends;
        if (a == c || a == d || b == c || b == d) continue;
        const PicturePoint r = at(b) - at(a), q = at(d) - at(c);
        const double whole = cross(r, q);
        if (whole == 0) continue;
        const double t = cross(at(c) - at(a), q) / whole, u = cross(at(c) - at(a), r) / whole;
        if (t >= 0 && t <= 1 && u >= 0 && u <= 1) return true;
      }
    }
    return false;
  }
  /// The bounded faces of a plane graph and its outer outline; none where it is not connected, has an end that leads
  /// nowhere, or edges that cross.
  std::optional<Layer> layerOf(const std::vector<std::uint32_t>& layer) const {
    if (layer.size() < 3 || anyCross(layer)) return std::nullopt;
    Neighbours around;
    for (const std::uint32_t e : layer) {
      const auto [a, b] = edges_.all()[e].ends;
      around[a].push_back(b);
      around[b].push_back(a);
    }
    for (auto& [corner, others] : around) {
      if (others.size() < 2) return std::nullopt;
      // Counter-clockwise with y up.
      std::ranges::sort(others, {}, [&, here = at(corner)](Corner other) {
        const PicturePoint way = at(other) - here;
        return std::atan2(-way.y, way.x);
      });
    }
    Layer out;
    std::set<EdgeEnds> done;
    bool hasOuter = false;
    for (const auto& [start, others] : around) {
      for (const Corner first : others) {
        if (done.contains({start, first})) continue;
        Wireframe::Face face;
        double area = 0;
        EdgeEnds step{start, first};
        while (done.insert(step).second) {
          face.push_back(step.first);
          area -= cross(at(step.first), at(step.second)) / 2;
          // The next edge clockwise from the one that leads back.
          const auto& ways = around.at(step.second);
          const auto back = std::ranges::find(ways, step.first);
          step = {step.second, back == ways.begin() ? ways.back() : *(back - 1)};
        }
        if (std::set<Corner>(face.begin(), face.end()).size() != face.size()) return std::nullopt;
        if (area > 0) {
          out.faces.push_back(std::move(face));
        } else if (std::exchange(hasOuter, true)) {
          return std::nullopt;
        } else {
          std::ranges::reverse(face);
          out.outer = std::move(face);
        }
      }
    }
    return hasOuter ? std::optional(std::move(out)) : std::nullopt;
  }

  const Edges& edges_;
  std::vector<std::uint32_t> chosen_;
};

/// Edges by what is connected.
std::vector<std::vector<std::uint32_t>> connected(const Edges& edges) {
  Groups groups(edges.corners().size());
  for (const auto& edge : edges.all()) groups.unite(edge.ends.first, edge.ends.second);
  std::map<std::uint32_t, std::vector<std::uint32_t>> sets;
  for (std::uint32_t e = 0; e < edges.all().size(); ++e) sets[groups.of(edges.all()[e].ends.first)].push_back(e);
  std::vector<std::vector<std::uint32_t>> out;
  for (auto& [first, set] : sets) out.push_back(std::move(set));
  // In the order of lines.
  std::ranges::sort(out);
  return out;
}

/// A tetrahedron has six edges; more than this are no drawing by hand.
bool isEnough(const std::vector<std::uint32_t>& edges) { return edges.size() >= 6 && edges.size() <= 3 * kMostCorners; }

}  // namespace

std::vector<std::uint32_t> outerCycle(std::span<const Wireframe::Face> faces, const std::vector<bool>& isChosen) {
  std::set<EdgeEnds> chosen;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t i = 0; isChosen[f] && i < faces[f].size(); ++i) {
      chosen.insert({faces[f][i], faces[f][(i + 1) % faces[f].size()]});
    }
  }
  std::map<Corner, Corner> next;
  for (const auto& [a, b] : chosen) {
    if (!chosen.contains({b, a})) next[a] = b;
  }
  std::vector<Corner> cycle;
  for (auto at = next.begin(); at != next.end() && cycle.size() < next.size(); at = next.find(at->second)) {
    cycle.push_back(at->first);
  }
  const bool isOne = cycle.size() > 2 && cycle.size() == next.size() && next.at(cycle.back()) == cycle.front();
  return isOne ? cycle : std::vector<Corner>{};
}

std::vector<std::vector<Outline>> proposeWireframes(std::span<const MeasuredLine> lines, std::span<const Node> nodes,
                                                    double size) {
  std::vector<std::vector<Outline>> out;
  const Edges edges(lines, nodes, size);
  for (std::vector<std::uint32_t>& set : connected(edges)) {
    if (!isEnough(set)) continue;
    std::map<EdgeEnds, std::uint32_t> between;
    for (const std::uint32_t e : set) between[std::minmax(edges.all()[e].ends.first, edges.all()[e].ends.second)] = e;
    const std::optional<Wireframe> wireframe = Solid(edges, std::move(set)).make();
    if (!wireframe) continue;
    std::vector<Outline> faces;
    for (const Wireframe::Face& face : wireframe->faces) {
      Outline& outline = faces.emplace_back();
      for (std::size_t i = 0; i < face.size(); ++i) {
        const Edges::Edge& edge = edges.all()[between.at(std::minmax(face[i], face[(i + 1) % face.size()]))];
        const auto [line, from, to] = edge.run;
        outline.push_back(edge.ends.first == face[i] ? Run{line, from, to} : Run{line, to, from});
      }
    }
    const Result<Wireframe> given = wireframeOf(lines, faces, size);
    if (given && isSquare(given.value(), size)) out.push_back(std::move(faces));
  }
  return out;
}

std::vector<Line> missingEdges(std::span<const Line> lines, std::span<const MeasuredLine> measured,
                               std::span<const Node> nodes) {
  const double size = sizeOf(lines);
  const Edges edges(measured, nodes, size);
  std::vector<Line> added, whole(lines.begin(), lines.end());
  for (std::vector<std::uint32_t>& set : connected(edges)) {
    if (!isEnough(set)) continue;
    std::vector<Line> some;
    for (const auto& [a, b] : Solid(edges, std::move(set)).missingOfPrism(2 * kSameCorner * size)) {
      some.push_back({{a, b}, {{0, 1}}, false});
    }
    if (some.empty()) continue;
    std::vector<Line> with = whole;
    with.insert(with.end(), some.begin(), some.end());
    const auto meeting = meetingLines(with);
    if (!meeting) continue;
    const auto hasNew = [&](const Outline& face) {
      return std::ranges::any_of(face, [&](const Run& run) { return run.line >= whole.size(); });
    };
    const auto solids = proposeWireframes(meeting.value(), nodesOf(meeting.value(), size), size);
    if (std::ranges::none_of(solids, [&](const auto& faces) { return std::ranges::any_of(faces, hasNew); })) continue;
    added.insert(added.end(), some.begin(), some.end());
    whole = std::move(with);
  }
  return added;
}

std::vector<Piece> proposePieces(std::span<const MeasuredLine> lines, std::span<const Node> nodes, double size) {
  std::vector<Piece> pieces;
  std::vector<bool> isEdge(lines.size(), false);
  for (std::vector<Outline>& faces : proposeWireframes(lines, nodes, size)) {
    for (const Outline& face : faces) {
      for (const Run& run : face) isEdge[run.line] = true;
    }
    Piece& piece = pieces.emplace_back();
    piece.kind = PieceKind::Solid;
    piece.outlines = std::move(faces);
  }
  for (Outline& outline : proposeOutlines(lines, nodes)) {
    if (std::ranges::all_of(outline, [&](const Run& run) { return isEdge[run.line]; })) continue;
    pieces.emplace_back().outlines = {std::move(outline)};
  }
  std::ranges::stable_sort(pieces, {}, [](const Piece& piece) { return piece.outlines[0][0].line; });
  return pieces;
}

namespace {

/// Faces as cycles of corners, with the way along each edge.
struct DrawnFaces {
  Wireframe wireframe;
  std::map<EdgeEnds, Run> runs;  ///< by an edge as its face goes along it; none where a gap closes straight
};

/// Each edge in two faces, once each way.
bool isClosed(const std::vector<Wireframe::Face>& faces) {
  std::set<EdgeEnds> edges;
  for (const auto& face : faces) {
    if (face.size() < 3) return false;
    for (std::size_t i = 0; i < face.size(); ++i) {
      if (!edges.insert({face[i], face[(i + 1) % face.size()]}).second) return false;
    }
  }
  return std::ranges::all_of(edges, [&](EdgeEnds edge) { return edges.contains({edge.second, edge.first}); });
}

Result<DrawnFaces> drawnFaces(std::span<const MeasuredLine> lines, std::span<const Outline> faces, double size) {
  DrawnFaces out;
  Wireframe& solid = out.wireframe;
  Corners corners(size);
  for (const Outline& outline : faces) {
    if (const Result<OutlinePath> path = pathOf(lines, outline); !path) return path.failure();
    Wireframe::Face face;
    for (const Run& run : outline) {
      const Corner from = corners.of(lines[run.line].at(run.from)), to = corners.of(lines[run.line].at(run.to));
      if (face.empty() || face.back() != from) face.push_back(from);
      if (to == from) continue;
      face.push_back(to);
      out.runs[{from, to}] = run;
    }
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    solid.faces.push_back(std::move(face));
  }
  solid.corners = std::move(corners.at);
  if (solid.corners.size() > kMostCorners || solid.faces.size() > kMostFaces) {
    return Failure{Error::ShapeInvalid, "at most " + std::to_string(kMostCorners) + " corners and faces"};
  }
  for (const auto& face : solid.faces) {
    double area = 0;
    for (std::size_t i = 0; i < face.size(); ++i) {
      area -= cross(solid.corners[face[i]], solid.corners[face[(i + 1) % face.size()]]) / 2;
    }
    solid.isFront.push_back(area > 0);
  }
  splitLayers(solid);
  const auto fronts = std::ranges::count(solid.isFront, true);
  if (!isClosed(solid.faces) || fronts == 0 || static_cast<std::size_t>(fronts) == solid.faces.size()) {
    return Failure{Error::ShapeInvalid, "every edge is one of two faces, and some face is seen"};
  }
  return out;
}

}  // namespace

Result<Wireframe> wireframeOf(std::span<const MeasuredLine> lines, std::span<const Outline> faces, double size) {
  Result<DrawnFaces> drawn = drawnFaces(lines, faces, size);
  if (!drawn) return drawn.failure();
  return std::move(drawn.value().wireframe);
}

Result<Outline> silhouetteOf(std::span<const MeasuredLine> lines, std::span<const Outline> faces, double size) {
  const Result<DrawnFaces> drawn = drawnFaces(lines, faces, size);
  if (!drawn) return drawn.failure();
  const auto& [solid, runs] = drawn.value();
  const std::vector<Corner> cycle = outerCycle(solid.faces, solid.isFront);
  Outline out;
  for (std::size_t i = 0; i < cycle.size(); ++i) {
    const auto run = runs.find({cycle[i], cycle[(i + 1) % cycle.size()]});
    if (run != runs.end()) out.push_back(run->second);
  }
  if (out.empty()) return Failure{Error::ShapeInvalid, "what is seen of it has more than one outline"};
  return out;
}

}  // namespace spineloft::descriptive
