#include "engine/stack/network.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>

#include "engine/geometry/polygon.h"
#include "engine/sections/common_points.h"

namespace spineloft::stack {
namespace {

using Points = std::vector<SectionPoint>;

const Points& pointsOf(const Sheets& sheets, const Drawn& curve) {
  return sheets.all[curve.sheet].pieces[curve.piece].contour.points;
}

/// Coordinates in a frame.
ModelPoint in(const geometry::Frame& frame, ModelPoint v) {
  return {dot(v, frame.across), dot(v, frame.depth), dot(v, cross(frame.across, frame.depth))};
}

std::vector<Drawn> curvesOf(const Sheets& sheets) {
  std::vector<Drawn> curves;
  for (std::size_t s = 0; s < sheets.all.size(); ++s) {
    const std::size_t first = curves.size();
    const auto& pieces = sheets.all[s].pieces;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
      const std::span<const SectionPoint> points(pieces[p].contour.points);
      Drawn curve;
      curve.sheet = s;
      curve.piece = p;
      curve.hole = pieces[p].hole;
      curve.outer = first + (curve.hole ? pieces[p].outer : p);
      curve.centre = geometry::centroid(points);
      curve.radius = std::sqrt(geometry::signedArea(points) / std::numbers::pi);
      curves.push_back(std::move(curve));
    }
    for (std::size_t i = first; i < curves.size(); ++i) curves[i].centre = curves[curves[i].outer].centre;
    for (std::size_t i = first; i < curves.size(); ++i) {
      const SectionPoint on = pieces[curves[curves[i].outer].piece].contour.points.front();
      curves[i].depth = static_cast<int>(std::ranges::count_if(pieces, [&](const auto& piece) {
        return piece.hole && geometry::holds(std::span<const SectionPoint>(piece.contour.points), on);
      }));
    }
  }
  return curves;
}

/// The curve as it is seen from another sheet: along the rail, else square to that sheet.
Points footprint(const Sheets& sheets, const Drawn& curve, const Sheet& seenFrom) {
  const Sheet& own = sheets.all[curve.sheet];
  Points out;
  for (const SectionPoint p : pointsOf(sheets, curve)) {
    const ModelPoint at = own.stand.at(p);
    if (sheets.alongRail) {
      const geometry::Frame frame = sheets.rail->at(own.at);
      const ModelPoint off = in(frame, at - frame.at);
      out.push_back({off.x, off.y});
    } else {
      out.push_back(seenFrom.stand.in(at));
    }
  }
  return out;
}

/// Share of the smaller of two polygons that is in both, from a grid over it.
double overlapOf(const Points& a, const Points& b) {
  const auto areaOf = [](const Points& p) { return std::abs(geometry::signedArea(std::span<const SectionPoint>(p))); };
  const Points &small = areaOf(a) < areaOf(b) ? a : b, &large = areaOf(a) < areaOf(b) ? b : a;
  SectionPoint low = small.front(), high = low;
  for (const SectionPoint p : small) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  SectionPoint least = large.front(), most = least;
  for (const SectionPoint p : large) {
    least = {std::min(least.x, p.x), std::min(least.y, p.y)};
    most = {std::max(most.x, p.x), std::max(most.y, p.y)};
  }
  if (least.x > high.x || least.y > high.y || most.x < low.x || most.y < low.y) return 0;
  constexpr int kGrid = 16;
  int inside = 0, both = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      const SectionPoint p{low.x + (high.x - low.x) * (i + 0.5) / kGrid, low.y + (high.y - low.y) * (j + 0.5) / kGrid};
      if (!geometry::holds(std::span<const SectionPoint>(small), p)) continue;
      ++inside;
      both += geometry::holds(std::span<const SectionPoint>(large), p);
    }
  }
  return inside == 0 ? 0 : static_cast<double>(both) / inside;
}

/// Two curves of neighbouring sheets that may belong together.
struct Pair {
  std::size_t from = 0, to = 0;
  int fromDepth = 0, toDepth = 0;
  double overlap = 0, away = 0, gap = 0;  ///< gap in sizes of the larger one
};

/// Pairs between two sheets, by curve; every group has a single curve on one side.
class Pairing {
 public:
  explicit Pairing(std::vector<Pair> pairs) : pairs_(std::move(pairs)) {
    constexpr double kOverlaps = 0.2, kFarthest = 3;
    const auto apart = [](const Pair& p) { return std::abs(p.fromDepth - p.toDepth); };
    std::ranges::stable_sort(pairs_, {}, [&](const Pair& p) { return std::pair(apart(p), -p.overlap); });
    for (const Pair& pair : pairs_) {
      if (pair.overlap >= kOverlaps) join(pair);
    }
    std::ranges::stable_sort(pairs_, {}, [&](const Pair& p) { return std::pair(apart(p), p.away); });
    for (const bool both : {true, false}) {  // first those of which neither has a partner
      for (const Pair& pair : pairs_) {
        const bool from = count(pair.from, true) > 0, to = count(pair.to, false) > 0;
        if (pair.gap <= kFarthest && !(both ? from || to : from && to)) join(pair);
      }
    }
  }
  const std::vector<Pair>& joined() const { return joined_; }

 private:
  std::size_t count(std::size_t curve, bool isFrom) const {
    return static_cast<std::size_t>(
        std::ranges::count(joined_, curve, [&](const Pair& p) { return isFrom ? p.from : p.to; }));
  }
  /// Unless a group would then have several curves on both sides, or one that lies in another.
  void join(const Pair& pair) {
    for (const Pair& other : joined_) {
      if (other.from == pair.from && other.toDepth != pair.toDepth) return;
      if (other.to == pair.to && other.fromDepth != pair.fromDepth) return;
      if (other.from == pair.from && (other.to == pair.to || count(other.to, false) > 1)) return;
      if (other.to == pair.to && count(other.from, true) > 1) return;
    }
    if (count(pair.from, true) > 0 && count(pair.to, false) > 0) return;
    joined_.push_back(pair);
  }

  std::vector<Pair> pairs_, joined_;
};

Pair pairOf(const Sheets& sheets, const std::vector<Drawn>& curves, std::size_t i, std::size_t j) {
  const Sheet& seenFrom = sheets.all[curves[i].sheet];
  const Points from = footprint(sheets, curves[i], seenFrom), to = footprint(sheets, curves[j], seenFrom);
  Pair pair{i,
            j,
            curves[i].depth,
            curves[j].depth,
            overlapOf(from, to),
            distance(geometry::centroid(from), geometry::centroid(to)),
            0};
  pair.gap = (pair.away - curves[i].radius - curves[j].radius) / (2 * std::max(curves[i].radius, curves[j].radius));
  return pair;
}

/// Pairs as a person wants them, of all that there may be.
std::vector<Pair> asLinked(std::vector<Pair> joined, const std::vector<Pair>& all, const std::vector<Drawn>& curves,
                           const std::vector<CurveLink>& links) {
  for (const CurveLink& link : links) {
    const auto meant = [&](const Pair& p) {
      return curves[p.from].piece == link.from && curves[p.to].piece == link.to;
    };
    const auto at = std::ranges::find_if(all, meant);
    if (at == all.end()) continue;
    const bool is = std::ranges::any_of(joined, meant);
    if (is && !link.on) std::erase_if(joined, meant);
    if (!is && link.on) joined.push_back(*at);
  }
  return joined;
}

/// Adds a pair to the forks from `first` on, and makes one of those that it ties together.
void addToForks(const Pair& pair, std::size_t first, std::vector<Fork>& forks) {
  Fork* own = nullptr;
  for (std::size_t i = first; i < forks.size(); ++i) {
    const auto touches = [&](const auto& link) { return link[0] == pair.from || link[1] == pair.to; };
    if (std::ranges::none_of(forks[i].links, touches)) continue;
    if (own == nullptr) {
      own = &forks[i];
    } else {
      own->links.insert(own->links.end(), forks[i].links.begin(), forks[i].links.end());
      forks[i].links.clear();
    }
  }
  if (own == nullptr) own = &forks.emplace_back();
  own->links.push_back({pair.from, pair.to});
  std::erase_if(forks, [](const Fork& fork) { return fork.links.empty(); });
}

/// Joins the curves of two sheets: the outer ones, then holes of those.
void joinSheets(const Sheets& sheets, std::size_t a, std::size_t b, Network& network) {
  std::vector<Drawn>& curves = network.curves;
  std::vector<Pair> outers;
  for (const bool holes : {false, true}) {
    std::vector<Pair> pairs;
    for (std::size_t i = 0; i < curves.size(); ++i) {
      if (curves[i].sheet != a || curves[i].hole != holes) continue;
      for (std::size_t j = 0; j < curves.size(); ++j) {
        if (curves[j].sheet != b || curves[j].hole != holes) continue;
        const auto joinsOuters = [&](const Pair& p) { return p.from == curves[i].outer && p.to == curves[j].outer; };
        if (holes && std::ranges::none_of(outers, joinsOuters)) continue;
        pairs.push_back(pairOf(sheets, curves, i, j));
      }
    }
    if (!holes && pairs.size() == 1) pairs.front().gap = 0;  // the only two belong together wherever they are
    const std::vector<Pair> joined = asLinked(Pairing(pairs).joined(), pairs, curves, sheets.all[a].links);
    if (!holes) outers = joined;
    const std::size_t first = network.forks.size();
    for (const Pair& pair : joined) {
      const Drawn &from = curves[pair.from], &to = curves[pair.to];
      const auto ups = std::ranges::count(joined, pair.from, &Pair::from);
      const auto downs = std::ranges::count(joined, pair.to, &Pair::to);
      const bool single = ups == 1 && downs == 1 && (!holes || (curves[from.outer].up == to.outer));
      if (single) {
        curves[pair.from].up = pair.to;
        curves[pair.to].down = pair.from;
        continue;
      }
      addToForks(pair, first, network.forks);
      curves[pair.from].forksUp = curves[pair.to].forksDown = true;
    }
  }
}

/// Contours about their centres and of equal areas, carried to the first of the chain.
sections::Contour normalised(const Sheets& sheets, const Drawn& curve, double carried) {
  sections::Contour contour = sheets.all[curve.sheet].pieces[curve.piece].contour;
  const SectionPoint centre = geometry::centroid(contour.points);
  for (SectionPoint& p : contour.points) p = rotated((p - centre) / curve.radius, carried);
  return contour;
}

/// The points of all curves that become each other, on common places.
void makeRings(const Sheets& sheets, int sides, Network& network) {
  std::vector<Drawn>& curves = network.curves;
  std::vector<bool> done(curves.size(), false);
  for (const bool closed : {false, true}) {  // what ends somewhere begins there
    for (std::size_t first = 0; first < curves.size(); ++first) {
      if (done[first] || (!closed && curves[first].down != kNone)) continue;
      std::vector<std::size_t> chain;
      std::vector<double> carried;
      std::vector<sections::Contour> row;
      double angle = 0;
      for (std::size_t at = first; at != kNone && !done[at]; at = curves[at].up) {
        done[at] = true;
        chain.push_back(at);
        carried.push_back(angle);
        row.push_back(normalised(sheets, curves[at], angle));
        if (const Link* link = network.above(curves[at].outer); link != nullptr) angle += link->carried;
      }
      // Copies of different curves have their corners at ever new places.
      constexpr std::size_t kMostTogether = 100000;  // points of all
      const std::size_t mostKnots = row.size() > kMostPlanes ? kMostTogether / row.size() : kMostTogether * 10;
      const auto rings = sections::onCommonPoints(row, sides, sections::Matching::LeastTurn, mostKnots);
      for (std::size_t k = 0; k < chain.size(); ++k) {
        Drawn& curve = curves[chain[k]];
        const SectionPoint centre = geometry::centroid(pointsOf(sheets, curve));
        for (const SectionPoint p : rings[k]) curve.ring.push_back(centre + rotated(p * curve.radius, -carried[k]));
      }
    }
  }
}

}  // namespace

const Link* Network::above(std::size_t curve) const {
  const auto at = std::ranges::find(links, curve, &Link::from);
  return at == links.end() ? nullptr : &*at;
}
const Link* Network::below(std::size_t curve) const {
  const auto at = std::ranges::find(links, curve, &Link::to);
  return at == links.end() ? nullptr : &*at;
}

Carried carriedBy(const Sheets& sheets, const Sheet& sheet, SectionPoint centre) {
  const Stand& stand = sheet.stand;
  if (!sheets.alongRail) return {stand.at(centre), stand.x, stand.y, stand.normal()};
  const geometry::Frame frame = sheets.rail->at(sheet.at);
  return {in(frame, stand.at(centre) - frame.at), in(frame, stand.x), in(frame, stand.y), in(frame, stand.normal())};
}

ModelPoint leastTurned(ModelPoint v, ModelPoint from, ModelPoint to) {
  const ModelPoint axis = cross(from, to);
  const ModelPoint w = cross(axis, v);
  constexpr double kOpposite = 1e-9;
  return v + w + cross(axis, w) / std::max(kOpposite, 1 + dot(from, to));
}

Network linkSheets(const Sheets& sheets, int sides) {
  Network network{curvesOf(sheets), {}, {}};
  std::vector<Drawn>& curves = network.curves;
  const std::size_t n = sheets.all.size();
  for (std::size_t i = 0; i + (sheets.closed() ? 0 : 1) < n; ++i) joinSheets(sheets, i, (i + 1) % n, network);
  for (std::size_t i = 0; i < curves.size(); ++i) {
    if (curves[i].hole || curves[i].up == kNone) continue;
    Link link{i, curves[i].up};
    const Drawn &from = curves[link.from], &to = curves[link.to];
    const Sheet &a = sheets.all[from.sheet], &b = sheets.all[to.sheet];
    const Carried start = carriedBy(sheets, a, from.centre), end = carriedBy(sheets, b, to.centre);
    const double share = b.at - a.at;
    link.length =
        sheets.alongRail ? (share > 0 ? share : share + 1) * sheets.rail->length() : distance(start.centre, end.centre);
    const ModelPoint x = leastTurned(start.x, start.normal, end.normal), y = cross(end.normal, x);
    link.carried = std::atan2(dot(end.x, y), dot(end.x, x));
    network.links.push_back(link);
  }
  makeRings(sheets, sides, network);
  const auto isGround = [&](const Drawn& curve) { return sheets.all[curve.sheet].traits[curve.piece].ground; };
  for (Link& link : network.links) {
    const Drawn &from = curves[link.from], &to = curves[link.to];
    if (isGround(from) && isGround(to)) {  // what is below stays below
      link.turn = link.carried;
      continue;
    }
    double along = 0, about = 0;
    for (std::size_t k = 0; k < from.ring.size(); ++k) {
      const SectionPoint p = from.ring[k] - from.centre, q = rotated(to.ring[k] - to.centre, link.carried);
      along += dot(p, q);
      about += cross(p, q);
    }
    link.turn = std::atan2(about, along);
  }
  return network;
}

}  // namespace spineloft::stack
