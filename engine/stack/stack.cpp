#include "engine/stack/stack.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <optional>
#include <span>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/mesh/laws.h"
#include "engine/mesh/self_crossing.h"
#include "engine/mesh/soften.h"
#include "engine/sections/common_points.h"
#include "engine/stack/fork.h"
#include "engine/stack/network.h"
#include "engine/stack/passage.h"
#include "engine/stack/roughness.h"
#include "engine/stack/skin.h"

namespace spineloft::stack {
namespace {

using sections::CapStyle;

/// Most vertices of a stack, about, and most rows between two planes.
constexpr std::size_t kMostVertices = 400000;
constexpr int kMostRows = 256;

/// An outer curve somewhere along a tube.
struct Row {
  Passage::Section place;  ///< its figure is the outer curve alone
  RingVertices ring;
};

/// An outer curve and all that it becomes.
struct Tube {
  std::vector<std::size_t> curves;
  bool closed = false, holed = false;
  std::vector<Row> rows;
};

class Builder {
 public:
  Builder(const Sheets& sheets, const Network& network, const StackParams& params, image::Size picture)
      : sheets_(sheets),
        network_(network),
        params_(params),
        roughness_(params.rough),
        skin_(picture),
        rings_(network.curves.size()) {}

  void setShape(const JointShape& shape) { shape_ = shape; }

  /// Holes: a lid cannot be filled. TooRough: a curve would cross itself.
  enum class Outcome { Filled, Holes, TooRough };
  Outcome run() {
    for (const Link& link : network_.links) passages_.emplace_back(sheets_, network_, link);
    if (!roughness_.moveRings(sheets_, network_)) return Outcome::TooRough;
    std::size_t points = 0;
    for (const Passage& passage : passages_) points += passage.count();
    most_ = static_cast<int>(std::clamp<std::size_t>(kMostVertices / std::max<std::size_t>(1, points), 4, kMostRows));
    bool filled = true;
    for (Tube& tube : tubes()) {
      walls(tube);
      if (tooRough_) return Outcome::TooRough;
      if (!tube.closed) filled = filled && ends(tube);
      for (const std::size_t outer : tube.curves) filled = filled && pockets(outer);
    }
    for (const Fork& fork : network_.forks) join(fork);
    return filled ? Outcome::Filled : Outcome::Holes;
  }
  mesh::TriMesh take() { return skin_.take(); }
  const std::vector<Ways::Fork>& forks() const { return forks_; }
  const std::vector<mesh::Crease>& creases() const { return creases_; }
  /// By vertex: kFixed on curves that were drawn, the region of the crease of its fork, or 0.
  std::vector<std::uint32_t> regions() const {
    std::vector<std::uint32_t> regions = regions_;
    regions.resize(skin_.vertices(), 0);
    for (const RingVertices& ring : rings_) {
      for (const std::uint32_t v : ring) regions[v] = mesh::kFixed;
    }
    return regions;
  }

 private:
  std::vector<Tube> tubes() const {
    std::vector<Tube> out;
    std::vector<bool> done(network_.curves.size(), false);
    for (const bool closed : {false, true}) {
      for (std::size_t first = 0; first < network_.curves.size(); ++first) {
        const Drawn& start = network_.curves[first];
        if (done[first] || start.hole || (!closed && start.down != kNone)) continue;
        Tube tube;
        tube.closed = closed;
        for (std::size_t at = first; at != kNone && !done[at]; at = network_.curves[at].up) {
          done[at] = true;
          tube.curves.push_back(at);
        }
        const bool goesOn = tube.closed || tube.curves.size() > 1 || start.forksUp || start.forksDown;
        if (goesOn) out.push_back(std::move(tube));
      }
    }
    return out;
  }

  const Stand& standOf(std::size_t curve) const { return sheets_.all[network_.curves[curve].sheet].stand; }

  /// The vertices of a drawn curve.
  const RingVertices& ringOf(std::size_t curve) {
    RingVertices& ring = rings_[curve];
    if (ring.empty()) {
      for (const SectionPoint p : network_.curves[curve].ring) ring.push_back(skin_.vertex(standOf(curve).at(p)));
    }
    return ring;
  }

  Loop loopOf(std::size_t curve, bool below) {
    const Drawn& drawn = network_.curves[curve];
    const Trait& trait = sheets_.all[drawn.sheet].traits[drawn.piece];
    Loop loop{{}, ringOf(curve), standOf(curve).normal(), below ? trait.forkAt : trait.joinAt};
    for (const SectionPoint p : drawn.ring) loop.points.push_back(standOf(curve).at(p));
    return loop;
  }
  void join(const Fork& fork) {
    Joint joint;
    std::vector<std::size_t> curves[2];  // below, above
    for (const auto& link : fork.links) {
      auto& numbers = joint.links.emplace_back();
      for (const std::size_t side : {0u, 1u}) {
        const auto known = std::ranges::find(curves[side], link[side]);
        numbers[side] = static_cast<std::size_t>(known - curves[side].begin());
        if (known != curves[side].end()) continue;
        curves[side].push_back(link[side]);
        (side == 0 ? joint.below : joint.above).push_back(loopOf(link[side], side == 0));
      }
    }
    joint.inwards = network_.curves[curves[0].front()].hole;
    const std::size_t before = skin_.vertices();
    JointCuts cuts = addJoint(joint, shape_, skin_);
    double radii = 0;
    for (const auto& side : curves) {
      for (const std::size_t curve : side) radii += network_.curves[curve].radius;
    }
    const auto count = static_cast<double>(curves[0].size() + curves[1].size());
    if (!cuts.crease.empty()) {
      const auto region = static_cast<std::uint32_t>(creases_.size() + 1);
      regions_.resize(before, 0);
      regions_.resize(skin_.vertices(), region);
      creases_.push_back({std::move(cuts.crease), region, params_.melt * radii / count});
    }
    for (const bool up : {true, false}) {
      const auto& of = up ? cuts.below : cuts.above;
      for (std::size_t i = 0; i < of.size(); ++i) {
        const Drawn& drawn = network_.curves[curves[up ? 0 : 1][i]];
        const Standing& standing = sheets_.all[drawn.sheet].plane;
        if (!of[i]) continue;
        const Ways::Fork made{standing.number, drawn.piece, up, *of[i]};
        if (std::ranges::find(forks_, made) == forks_.end()) forks_.push_back(made);
      }
    }
  }

  Row drawnRow(std::size_t curve) {
    const Drawn& drawn = network_.curves[curve];
    const Stand& stand = standOf(curve);
    Row row{{{}, stand.at(drawn.centre), stand.x, stand.y, {}}, ringOf(curve)};
    for (const SectionPoint p : network_.curves[curve].ring) row.place.figure.push_back(p - drawn.centre);
    return row;
  }

  Passage::Section sectionAt(const Passage& passage, double t) {
    Passage::Section section = passage.section(t);
    if (!roughness_.any()) return section;
    std::vector<ModelPoint> places;
    for (const SectionPoint p : section.figure) places.push_back(section.at(p));
    const double away = std::min(t, 1 - t) * passage.length();
    if (!roughness_.move(section.figure, passage.sizes(), places, roughness_.shareAt(away))) tooRough_ = true;
    return section;
  }

  /// All walls between the curves of a tube, and its rows.
  void walls(Tube& tube) {
    for (const std::size_t curve : tube.curves) {
      tube.rows.push_back(drawnRow(curve));
      const auto link = std::ranges::find(network_.links, curve, &Link::from);
      if (link == network_.links.end()) continue;
      const Passage& passage = passages_[static_cast<std::size_t>(link - network_.links.begin())];
      tube.holed = tube.holed || passage.sizes().size() > 1;
      std::vector<RingVertices> last;
      for (const std::size_t own : passage.from()) last.push_back(ringOf(own));
      for (const double t : passage.rows(most_, roughness_.rowsOf(passage.length()))) {
        std::vector<RingVertices> next(last.size());
        if (t == 1) {
          for (std::size_t c = 0; c < next.size(); ++c) next[c] = ringOf(passage.to()[c]);
        } else {
          Passage::Section section = sectionAt(passage, t);
          std::size_t at = 0;
          for (std::size_t c = 0; c < next.size(); ++c) {
            for (std::size_t k = 0; k < passage.sizes()[c]; ++k) {
              next[c].push_back(skin_.vertex(section.at(section.figure[at++])));
            }
          }
          section.figure.resize(passage.sizes().front());
          tube.rows.push_back({std::move(section), next.front()});
        }
        for (std::size_t c = 0; c < next.size(); ++c) skin_.strip(last[c], next[c], c > 0);
        last = std::move(next);
      }
    }
  }

  /// From where an end is finished: a point that sees the whole curve. None: it ends flat.
  static std::optional<SectionPoint> hubOf(const Row& row) {
    const double size = radiusOf(row);
    std::vector<SectionPoint> points = row.place.figure;
    for (SectionPoint& p : points) p = p / size;
    const std::optional<SectionPoint> hub = sections::hubOf(points);
    return hub ? std::optional(*hub * size) : std::nullopt;
  }
  static double radiusOf(const Row& row) {
    const double area = geometry::signedArea(std::span<const SectionPoint>(row.place.figure));
    return std::sqrt(std::abs(area) / std::numbers::pi);
  }

  /// The row shrunk towards its hub and moved along its normal.
  RingVertices shrunk(const Row& row, SectionPoint hub, double scale, double ahead) {
    RingVertices ring;
    const ModelPoint shift = cross(row.place.x, row.place.y) * ahead;
    for (const SectionPoint p : row.place.figure) {
      ring.push_back(skin_.vertex(row.place.at(lerp(hub, p, scale)) + shift));
    }
    return ring;
  }

  bool ends(Tube& tube) {
    const bool startsHere = !network_.curves[tube.curves.front()].forksDown;
    const bool endsHere = !network_.curves[tube.curves.back()].forksUp;
    CapStyle start = startsHere ? params_.startCap : CapStyle::Flat, end = endsHere ? params_.endCap : CapStyle::Flat;
    const bool open = start == CapStyle::Open || end == CapStyle::Open;
    const bool alone = tube.rows.size() < 2;  // nothing to be hollow
    const bool seen = !alone && std::ranges::all_of(tube.rows, [](const Row& row) { return hubOf(row).has_value(); });
    if (open && (tube.holed || !seen)) {
      if (start == CapStyle::Open) start = CapStyle::Flat;
      if (end == CapStyle::Open) end = CapStyle::Flat;
    }
    if (start == CapStyle::Open && end == CapStyle::Open) {
      bore(tube);
      return true;
    }
    if (start == CapStyle::Open) mouth(tube, true);
    if (end == CapStyle::Open) mouth(tube, false);
    return (!startsHere || start == CapStyle::Open || cap(tube, start, true)) &&
           (!endsHere || end == CapStyle::Open || cap(tube, end, false));
  }

  /// A closed end: flat, round or pointed.
  bool cap(const Tube& tube, CapStyle style, bool before) {
    const Row& row = before ? tube.rows.front() : tube.rows.back();
    const std::size_t outer = before ? tube.curves.front() : tube.curves.back();
    const std::optional<SectionPoint> hub = style == CapStyle::Flat || tube.holed ? std::nullopt : hubOf(row);
    if (!hub || hasHoles(outer, before)) return lid(outer, before);
    const double radius = radiusOf(row), way = before ? -1 : 1;
    const double height = radius * (style == CapStyle::Round ? sections::kDomeHeight : sections::kPointLength);
    RingVertices last = row.ring;
    for (int i = 1; style == CapStyle::Round && i <= params_.capRings; ++i) {
      const double angle = std::numbers::pi / 2 * i / (params_.capRings + 1);
      const RingVertices next = shrunk(row, *hub, std::cos(angle), way * height * std::sin(angle));
      if (before) {
        skin_.strip(next, last, false);
      } else {
        skin_.strip(last, next, false);
      }
      last = next;
    }
    const ModelPoint tip = row.place.at(*hub) + cross(row.place.x, row.place.y) * (way * height);
    skin_.cone(last, skin_.vertex(tip), before);
    return true;
  }

  static bool goesOn(const Drawn& curve, bool up) {
    return up ? curve.up != kNone || curve.forksUp : curve.down != kNone || curve.forksDown;
  }
  Skin::Rim rimOf(std::size_t curve) { return {ringOf(curve), network_.curves[curve].ring}; }

  /// Whether holes in an outer curve go on from its end.
  bool hasHoles(std::size_t outer, bool up) const {
    return std::ranges::any_of(network_.curves,
                               [&](const Drawn& c) { return c.hole && c.outer == outer && goesOn(c, up); });
  }

  /// A flat lid on an outer curve, with the holes that go on from there.
  bool lid(std::size_t outer, bool before) {
    std::vector<Skin::Rim> holes;
    for (std::size_t i = 0; i < network_.curves.size(); ++i) {
      const Drawn& hole = network_.curves[i];
      if (hole.hole && hole.outer == outer && goesOn(hole, before)) holes.push_back(rimOf(i));
    }
    return skin_.lid(rimOf(outer), holes, before);
  }

  /// The floors of holes that end at a sheet where the curve round them goes on.
  bool pockets(std::size_t outer) {
    bool filled = true;
    const Drawn& around = network_.curves[outer];
    for (std::size_t i = 0; i < network_.curves.size(); ++i) {
      const Drawn& hole = network_.curves[i];
      if (!hole.hole || hole.outer != outer || goesOn(hole, true) == goesOn(hole, false)) continue;
      const bool endsAbove = !goesOn(hole, true);
      if (!goesOn(around, endsAbove)) continue;  // the lid leaves it open
      filled = filled && skin_.lid(rimOf(i), {}, endsAbove);
    }
    return filled;
  }

  /// A wall inside from end to end.
  void bore(const Tube& tube) {
    RingVertices first, last;
    for (std::size_t i = tube.rows.size(); i-- > 0;) {
      const Row& row = tube.rows[i];
      RingVertices next = shrunk(row, *hubOf(row), 1 - sections::kWall, 0);
      skin_.strip(last.empty() ? tube.rows.back().ring : last, next, false);
      last = std::move(next);
    }
    skin_.strip(last, tube.rows.front().ring, false);
  }

  /// A wall inside from one end almost to the other.
  void mouth(const Tube& tube, bool before) {
    const std::size_t n = tube.rows.size();
    const auto rowAt = [&](std::size_t i) -> const Row& { return tube.rows[before ? i : n - 1 - i]; };
    std::vector<double> along(n, 0.0);
    for (std::size_t i = 1; i < n; ++i) {
      along[i] = along[i - 1] + distance(rowAt(i - 1).place.centre, rowAt(i).place.centre);
    }
    const double floor = sections::kMouthDepth * along.back();
    RingVertices last = rowAt(0).ring;
    const auto go = [&](RingVertices next) {
      if (before) {
        skin_.strip(next, last, false);
      } else {
        skin_.strip(last, next, false);
      }
      last = std::move(next);
    };
    std::size_t i = 0;
    constexpr double kJustBefore = 0.98;  // a ring just before the floor would leave slivers
    for (; i + 1 < n && along[i] <= kJustBefore * floor; ++i) go(inner(rowAt(i), 0, rowAt(i)));
    const double step = along[i] - along[i - 1];
    const double t = step > 0 ? std::clamp((floor - along[i - 1]) / step, 0.05, 1.0) : 0.5;
    go(inner(rowAt(i - 1), t, rowAt(i)));
    skin_.cone(last, skin_.vertex(floorOf(rowAt(i - 1), t, rowAt(i))), before);
  }
  static ModelPoint floorOf(const Row& a, double t, const Row& b) {
    return lerp(a.place.at(*hubOf(a)), b.place.at(*hubOf(b)), t);
  }
  RingVertices inner(const Row& a, double t, const Row& b) {
    const SectionPoint hubA = *hubOf(a), hubB = *hubOf(b);
    RingVertices ring;
    for (std::size_t k = 0; k < a.place.figure.size(); ++k) {
      const ModelPoint p = a.place.at(lerp(hubA, a.place.figure[k], 1 - sections::kWall));
      const ModelPoint q = b.place.at(lerp(hubB, b.place.figure[k], 1 - sections::kWall));
      ring.push_back(skin_.vertex(lerp(p, q, t)));
    }
    return ring;
  }

  const Sheets& sheets_;
  Network network_;  ///< its rings uneven, once the passages are made
  const StackParams& params_;
  Roughness roughness_;
  Skin skin_;
  bool tooRough_ = false;
  std::vector<RingVertices> rings_;
  std::vector<Passage> passages_;
  std::vector<Ways::Fork> forks_;
  std::vector<mesh::Crease> creases_;
  std::vector<std::uint32_t> regions_;  ///< of the vertices so far
  int most_ = kMostRows;
  JointShape shape_;
};

/// Several curves become several others through a place of each link half way (fork.h): those are apart. Errors:
/// StackInvalid, which names the curves.
Status checkApart(const Sheets& sheets, const Network& network) {
  constexpr double kLeast = 0.1;  // of a curve's radius
  const auto drawn = [&](std::size_t curve) -> const Drawn& { return network.curves[curve]; };
  const auto middle = [&](const auto& link) {
    const Drawn &a = drawn(link[0]), &b = drawn(link[1]);
    return (sheets.all[a.sheet].stand.at(a.centre) + sheets.all[b.sheet].stand.at(b.centre)) / 2;
  };
  const auto name = [&](const auto& link) {
    return "curve " + std::to_string(drawn(link[0]).piece + 1) + " with " + std::to_string(drawn(link[1]).piece + 1);
  };
  for (const Fork& fork : network.forks) {
    for (const auto& one : fork.links) {
      for (const auto& other : fork.links) {
        if (one[0] == other[0] || one[1] == other[1]) continue;
        const double least = kLeast * std::min(drawn(one[0]).radius, drawn(one[1]).radius);
        if (distance(middle(one), middle(other)) >= least) continue;
        return {Error::StackInvalid, "the links of " + name(one) + " and of " + name(other) + " from " +
                                         nameOf(sheets.all[drawn(one[0]).sheet].plane) +
                                         " on cross half way: take one of them out, or move a curve"};
      }
    }
  }
  return Done{};
}

/// Each once, however often its planes are repeated.
std::vector<Ways::Link> linksOf(const Sheets& sheets, const Network& network) {
  std::vector<Ways::Link> links;
  const auto add = [&](std::size_t from, std::size_t to) {
    const Drawn &a = network.curves[from], &b = network.curves[to];
    const Ways::Link link{sheets.all[a.sheet].plane.number, a.piece, sheets.all[b.sheet].plane.number, b.piece};
    if (std::ranges::find(links, link) == links.end()) links.push_back(link);
  };
  for (std::size_t i = 0; i < network.curves.size(); ++i) {
    if (network.curves[i].up != kNone) add(i, network.curves[i].up);
  }
  for (const Fork& fork : network.forks) {
    for (const auto& [from, to] : fork.links) add(from, to);
  }
  return links;
}

/// What a solid needs to have its creases rounded.
struct Melting {
  std::vector<mesh::Crease> creases;
  std::vector<std::uint32_t> regions;  ///< see Builder
};

/// With rounded creases, narrower where the surface would go through itself or break a law otherwise. Curves that were
/// drawn stay.
mesh::TriMesh melted(const mesh::TriMesh& mesh, const Melting& melting, image::Size picture) {
  for (const double share : {1.0, 0.7}) {
    mesh::TriMesh round = mesh;
    std::vector<mesh::Crease> creases = melting.creases;
    for (mesh::Crease& crease : creases) crease.reach *= share;
    std::vector<std::uint32_t> regions = melting.regions;
    mesh::soften(round, std::move(creases), regions);
    for (std::size_t v = 0; v < round.positions.size(); ++v) {
      const auto& p = round.positions[v];
      if (v >= mesh.positions.size() || p != mesh.positions[v]) round.uv[v] = Skin::uvOf({p[0], p[1], p[2]}, picture);
    }
    if (mesh::inspect(round).valid() && !mesh::selfCrossing(round)) return round;
  }
  return mesh;
}

/// The solid with as much of its roughness as `params` say. Errors: StackInvalid. None: it would cross itself so rough.
std::optional<Result<Stacked>> built(const Sheets& sheets, const Network& network, const StackParams& params,
                                     image::Size picture) {
  // Full joints first; where their walls cross, straighter ones, then such whose branches part half way already.
  // Without a fork the first is as good as any.
  constexpr std::array<JointShape, 6> kShapes{{{.fullness = 0.35},
                                               {.fullness = 0.175},
                                               {.fullness = 0.0875},
                                               {.fullness = 0},
                                               {.fullness = 0.35, .halves = true, .waist = 0.3},
                                               {.fullness = 0, .halves = true, .waist = 0.3}}};
  Stacked made;
  Melting melting;
  for (const JointShape& shape : kShapes) {
    Builder builder(sheets, network, params, picture);
    builder.setShape(shape);
    const Builder::Outcome outcome = builder.run();
    if (outcome == Builder::Outcome::TooRough) return std::nullopt;
    if (params.melt > 0) melting = {builder.creases(), builder.regions()};
    made = {builder.take(), {linksOf(sheets, network), builder.forks()}};
    mesh::MeshReport report = mesh::inspect(made.mesh);
    if (!report.outward) {  // it goes back through itself more than ahead
      for (auto& t : made.mesh.triangles) std::swap(t[1], t[2]);
      report.outward = true;
    }
    if (outcome == Builder::Outcome::Holes || !report.valid()) {
      return Failure{Error::StackInvalid,
                     "the sheets are too close to each other or their curves too fine: move them apart"};
    }
    if (network.forks.empty() || !mesh::selfCrossing(made.mesh)) break;
  }
  if (!melting.creases.empty()) made.mesh = melted(made.mesh, melting, picture);
  return made;
}

}  // namespace

Result<Stacked> stackPlanes(const Stack& stack, image::Size picture) {
  if (!isValid(stack.params) || picture.width < 1 || picture.height < 1) return Error::ValueOutOfRange;
  if (Status planes = checkPlanes(stack.planes, stack.rail, stack.params.patterns); !planes) return planes.failure();
  const Result<Sheets> sheets = standSheets(stack.planes, stack.rail, stack.params.patterns);
  if (!sheets) return sheets.failure();
  const Network network = linkSheets(sheets.value(), stack.params.sides);
  if (network.links.empty() && network.forks.empty()) {
    return Failure{Error::StackInvalid, "no curve is near enough to one on the next sheet: draw them above each other"};
  }
  if (Status apart = checkApart(sheets.value(), network); !apart) return apart.failure();
  StackParams params = stack.params;
  for (const double share : {1.0, 0.5, 0.25, 0.125}) {
    params.rough.amount = stack.params.rough.amount * share;
    if (auto made = built(sheets.value(), network, params, picture)) return *std::move(made);
  }
  params.rough.amount = 0;
  return *built(sheets.value(), network, params, picture);
}

}  // namespace spineloft::stack
