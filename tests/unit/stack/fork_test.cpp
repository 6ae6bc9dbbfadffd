#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include "engine/base/rng.h"
#include "engine/mesh/self_crossing.h"
#include "engine/mesh/topology.h"
#include "engine/stack/stack.h"
#include "tests/support/mesh_laws.h"
#include "tests/support/plane_cut.h"
#include "tests/support/rounds.h"

using namespace spineloft;
using namespace spineloft::stack;
using namespace spineloft::testing;

namespace {

constexpr double kPi = std::numbers::pi;
constexpr image::Size kPaper{800, 800};

Curve circle(double radius, SectionPoint centre = {}) {
  Curve curve;
  for (int i = 0; i < 8; ++i) {
    const double angle = 2 * kPi * i / 8;
    curve.through.push_back(centre + SectionPoint{radius * std::cos(angle), radius * std::sin(angle)});
  }
  return curve;
}

Plane level(double height, std::vector<Curve> curves) {
  Plane plane;
  plane.origin = ModelPoint{0, 0, height};
  plane.curves = std::move(curves);
  return plane;
}

mesh::TriMesh made(const std::vector<Plane>& planes) {
  const Result<Stacked> stacked = stackPlanes({planes, {}, {}}, kPaper);
  REQUIRE_MESSAGE(stacked.ok(), failureSentence(stacked.ok() ? Failure{} : stacked.failure()));
  return stacked.value().mesh;
}

/// Lawful, of one piece with so many handles, and not through itself.
mesh::MeshReport requireOne(const mesh::TriMesh& mesh, int genus) {
  const mesh::MeshReport report = requireLawful(mesh);
  CHECK(report.genus == genus);
  CHECK(report.shells == 1);
  CHECK(!mesh::selfCrossing(mesh));
  return report;
}

const std::vector<Curve> kTwo{circle(70, {-120, 0}), circle(70, {120, 0})};

/// Whether a level cut of a Y with arms to the left and right is in one piece: something of it is in the middle.
bool isJoined(const mesh::TriMesh& mesh, double height) {
  const PlaneCut cut = cutBy(mesh, {{0, 0, height}, {1, 0, 0}, {0, 1, 0}});
  for (int i = -200; i <= 200; ++i) {
    if (cut.holds({0, i * 0.51})) return true;
  }
  return false;
}

/// The height at which a level cut comes apart.
double forkOf(const mesh::TriMesh& mesh, double low, double high) {
  for (int i = 0; i < 20; ++i) (isJoined(mesh, (low + high) / 2) ? low : high) = (low + high) / 2;
  return high;
}

/// Volume of the union of the cones from one circle to others, by counting points.
double unionOfCones(double stem, const std::vector<Curve>& branches, double height) {
  constexpr int kGrid = 120;
  int inside = 0;
  for (int i = 0; i < kGrid; ++i) {
    for (int j = 0; j < kGrid; ++j) {
      for (int k = 0; k < kGrid; ++k) {
        const double t = (k + 0.5) / kGrid;
        const SectionPoint p{-250 + 500 * (i + 0.5) / kGrid, -250 + 500 * (j + 0.5) / kGrid};
        inside += std::ranges::any_of(branches, [&](const Curve& branch) {
          SectionPoint centre;
          for (const SectionPoint q : branch.through) centre += q / static_cast<double>(branch.through.size());
          const double radius = distance(branch.through[0], centre);
          return distance(p, centre * t) < stem + (radius - stem) * t;
        });
      }
    }
  }
  return inside * std::pow(500.0 / kGrid, 2) * height / kGrid;
}

}  // namespace

TEST_CASE("a curve that becomes two is a Y: one below the fork, two above it, as large as its arms") {
  const mesh::TriMesh y = made({level(0, {circle(100)}), level(300, kTwo)});
  const mesh::MeshReport report = requireOne(y, 0);
  const double fork = forkOf(y, 10, 290);
  CHECK(fork > 60);
  CHECK(fork < 240);
  for (double height = 5; height < 295; height += 10) CHECK(isJoined(y, height) == (height < fork));
  const double arms = unionOfCones(100, kTwo, 300);
  CHECK(report.volume > 0.95 * arms);
  CHECK(report.volume < 1.02 * arms);
}

TEST_CASE("what is drawn at a fork is there") {
  const mesh::TriMesh y = made({level(0, {circle(100)}), level(300, kTwo)});
  const auto at = [&](double height) { return cutBy(y, {{0, 0, height}, {1, 0, 0}, {0, 1, 0}}); };
  const auto stem = [](SectionPoint p) { return norm(p) < 100; };
  const auto arms = [](SectionPoint p) { return distance(p, {-120, 0}) < 70 || distance(p, {120, 0}) < 70; };
  CHECK(overlapShare(at(0.01), stem, {-200, -200}, {200, 200}) >= 0.995);
  CHECK(overlapShare(at(299.99), arms, {-200, -200}, {200, 200}) >= 0.995);
}

TEST_CASE("two curves join into one as one becomes two") {
  const mesh::TriMesh up = made({level(0, {circle(100)}), level(300, kTwo)});
  const mesh::TriMesh down = made({level(0, kTwo), level(300, {circle(100)})});
  CHECK(requireOne(down, 0).volume == doctest::Approx(requireLawful(up).volume).epsilon(1e-3));
  // Trousers upside down on trousers: a ring.
  requireOne(made({level(0, {circle(100)}), level(300, kTwo), level(600, {circle(100)})}), 1);
  requireOne(made({level(0, kTwo), level(300, {circle(100)}), level(600, kTwo)}), 0);
}

TEST_CASE("a table has four feet, a tooth three roots and a hand five fingers, which go on") {
  const std::vector<Curve> feet{circle(25, {-70, -70}), circle(25, {70, -70}), circle(25, {70, 70}),
                                circle(25, {-70, 70})};
  requireOne(made({level(0, {circle(120)}), level(200, feet)}), 0);
  const std::vector<Curve> roots{circle(30, {-60, -40}), circle(30, {60, -40}), circle(35, {0, 55})};
  requireOne(made({level(0, {circle(110)}), level(80, {circle(100)}), level(220, roots)}), 0);
  std::vector<Curve> fingers, tips;
  for (int i = 0; i < 4; ++i) {
    fingers.push_back(circle(19, {-75.0 + 50 * i, 0}));
    tips.push_back(circle(14, {-95.0 + 63 * i, 5}));
  }
  fingers.push_back(circle(22, {130, -20}));
  tips.push_back(circle(16, {185, -30}));
  Curve palm;
  palm.through = {{115, 0}, {70, 38}, {-70, 38}, {-115, 0}, {-70, -38}, {70, -38}};
  requireOne(made({level(0, {circle(60)}), level(150, {palm}), level(260, fingers), level(400, tips)}), 0);
}

TEST_CASE("holes in a stem and in its branches make a pipe that forks") {
  const auto bored = [](double radius, SectionPoint centre) {
    return std::vector{circle(radius, centre), circle(radius * 0.6, centre)};
  };
  std::vector<Curve> arms = bored(70, {-120, 0});
  for (const Curve& curve : bored(70, {120, 0})) arms.push_back(curve);
  requireOne(made({level(0, bored(100, {})), level(300, arms)}), 2);
  // Bored in one arm only: a bent pipe.
  requireOne(made({level(0, bored(100, {})),
                   level(300, {circle(70, {-120, 0}), circle(40, {-120, 0}), circle(70, {120, 0})})}),
             1);
}

namespace {

/// A closed curve whose points are off a circle by up to `uneven` of its radius.
Curve unevenCircle(Rng& rng, double radius, SectionPoint centre, double uneven) {
  Curve curve = circle(radius, centre);
  for (SectionPoint& p : curve.through) p = centre + (p - centre) * (1 + rng.uniform(-uneven, uneven));
  return curve;
}

}  // namespace

TEST_CASE("wild forks, with branches that lean by up to 60 degrees, are lawful and do not go through themselves") {
  int through = 0, refused = 0;
  const int all = rounds(50);
  for (int seed = 0; seed < all; ++seed) {
    CAPTURE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const int count = 2 + static_cast<int>(rng.below(5));
    const double spread = rng.uniform(70, 220);
    std::vector<Curve> branches;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * kPi * (i + rng.uniform(-0.12, 0.12)) / count;
      branches.push_back(unevenCircle(rng, spread * std::sin(kPi / count) * rng.uniform(0.4, 0.7),
                                      {spread * std::cos(angle), spread * std::sin(angle)}, 0.2));
    }
    Plane top = level(rng.uniform(150, 300), branches);
    top.turn = geometry::turnAbout(ModelPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), 0.01}, rng.uniform(0, kPi / 3));
    const std::vector<Plane> planes{level(0, {unevenCircle(rng, 100, {}, 0.35)}), top};
    const Result<Stacked> stacked = stackPlanes({planes, {}, {}}, kPaper);
    if (!stacked.ok()) {
      CHECK(stacked.failure().detail ==
            "sheet 1 and sheet 2 stand at one place or cut each other inside their curves: move or turn one");
      ++refused;
      continue;
    }
    const mesh::MeshReport report = requireLawful(stacked.value().mesh);
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
    through += mesh::selfCrossing(stacked.value().mesh).has_value();
  }
  CHECK(through == 0);
  CHECK(refused <= all / 10);
}

namespace {

/// All that is said about two sheets, in which every pair of curves is either linked or not.
std::vector<CurveLink> onlyLinks(std::uint32_t below, std::uint32_t above,
                                 const std::vector<std::array<std::uint32_t, 2>>& on) {
  std::vector<CurveLink> links;
  for (std::uint32_t i = 0; i < below; ++i) {
    for (std::uint32_t j = 0; j < above; ++j) {
      links.push_back({i, j, std::ranges::find(on, std::array{i, j}) != on.end()});
    }
  }
  return links;
}

Failure failureOf(const std::vector<Plane>& planes) {
  const Result<Stacked> stacked = stackPlanes({planes, {}, {}}, kPaper);
  REQUIRE_FALSE(stacked.ok());
  return stacked.failure();
}

}  // namespace

TEST_CASE("two curves become two others across each other, as they are linked: a piece, or a ring") {
  Plane low = level(0, kTwo);
  const Plane high = level(300, {circle(70, {0, -120}), circle(70, {0, 120})});
  low.links = onlyLinks(2, 2, {{0, 0}, {0, 1}, {1, 1}});
  const mesh::TriMesh piece = made({low, high});
  requireOne(piece, 0);
  const auto at = [&](double height) { return cutBy(piece, {{0, 0, height}, {1, 0, 0}, {0, 1, 0}}); };
  const auto below = [](SectionPoint p) { return distance(p, {-120, 0}) < 70 || distance(p, {120, 0}) < 70; };
  const auto above = [](SectionPoint p) { return distance(p, {0, -120}) < 70 || distance(p, {0, 120}) < 70; };
  CHECK(overlapShare(at(0.01), below, {-200, -200}, {200, 200}) >= 0.995);
  CHECK(overlapShare(at(299.99), above, {-200, -200}, {200, 200}) >= 0.995);
  low.links = onlyLinks(2, 2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  requireOne(made({low, high}), 1);
}

TEST_CASE("curves in rows, linked each with its neighbours, are one piece without a handle") {
  int through = 0;
  const int all = rounds(30);
  for (int seed = 0; seed < all; ++seed) {
    CAPTURE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const auto row = [&](std::uint32_t count) {
      std::vector<Curve> curves;
      for (std::uint32_t i = 0; i < count; ++i) {
        const double place = (i + 0.5) / count - 0.5, room = 180.0 / count;
        curves.push_back(circle(room * rng.uniform(0.5, 0.8), {360 * place, rng.uniform(-10, 10)}));
      }
      return curves;
    };
    const auto below = static_cast<std::uint32_t>(1 + rng.below(4)),
               above = static_cast<std::uint32_t>(1 + rng.below(4));
    std::vector<std::array<std::uint32_t, 2>> on{{0, 0}};
    while (on.back() != std::array{below - 1, above - 1}) {
      auto [i, j] = on.back();
      const bool right = j + 1 == above || (i + 1 < below && rng.below(2) == 0);
      on.push_back({i + (right ? 1 : 0), j + (right ? 0 : 1)});
    }
    Plane low = level(0, row(below));
    low.links = onlyLinks(below, above, on);
    const mesh::TriMesh mesh = made({low, level(rng.uniform(200, 300), row(above))});
    const mesh::MeshReport report = requireLawful(mesh);
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
    through += mesh::selfCrossing(mesh).has_value();
  }
  CHECK(through <= all / 25);
}

TEST_CASE("a link that is cut leaves a curve that ends, and one that is wanted joins curves far from each other") {
  Plane low = level(0, {circle(100)});
  low.links = {{0, 1, false}};
  const mesh::TriMesh arm = made({low, level(300, kTwo)});
  CHECK(requireOne(arm, 0).volume < 0.7 * requireLawful(made({level(0, {circle(100)}), level(300, kTwo)})).volume);
  Plane apart = level(0, {circle(20, {-300, 0}), circle(20, {300, 0})});
  const Plane top = level(100, {circle(20, {-300, 0})});
  CHECK(requireLawful(made({apart, top})).volume < 150000);
  apart.links = {{1, 0, true}};
  CHECK(requireOne(made({apart, top}), 0).volume > 150000);
}

TEST_CASE("a fork and a join are as high as they are said to be") {
  constexpr double kTouch = 35;
  for (const double share : {0.2, 0.5, 0.8}) {
    CAPTURE(share);
    Plane low = level(0, {circle(100)});
    low.curves[0].forkAt = share;
    const double above = forkOf(made({low, level(300, kTwo)}), 10, 290) - 300 * share;
    CHECK(above > -5);  // the arms touch for a while above the cut
    CHECK(above < kTouch);
    Plane high = level(300, {circle(100)});
    high.curves[0].joinAt = share;
    const mesh::TriMesh down = made({level(0, kTwo), high});
    requireOne(down, 0);
    for (double height = 5; height < 295; height += 10) {
      const double below = 300 * (1 - share) - height;
      if (below > -5 && below < kTouch) continue;
      CHECK(isJoined(down, height) == (below < 0));
    }
  }
}

namespace {

mesh::TriMesh melted(const std::vector<Plane>& planes, double melt) {
  StackParams params;
  params.melt = melt;
  const Result<Stacked> stacked = stackPlanes({planes, {}, params}, kPaper);
  REQUIRE(stacked.ok());
  return stacked.value().mesh;
}

/// How sharp the edges between two levels are, degrees, the sharpest first.
std::vector<double> edgesBetween(const mesh::TriMesh& mesh, double low, double high) {
  const mesh::Twins twins = mesh::findTwins(mesh);
  const auto at = [&](std::uint32_t v) {
    const auto& p = mesh.positions[v];
    return ModelPoint{p[0], p[1], p[2]};
  };
  const auto normalOf = [&](const auto& t) { return normalized(cross(at(t[1]) - at(t[0]), at(t[2]) - at(t[0]))); };
  std::vector<double> edges;
  for (std::uint32_t h = 0; h < twins.of.size(); ++h) {
    const ModelPoint a = at(mesh::cornerVertex(mesh, h)), b = at(mesh::cornerVertex(mesh, mesh::nextHalfEdge(h)));
    if (twins.of[h] < h || std::min(a.z, b.z) < low || std::max(a.z, b.z) > high) continue;
    const double along = dot(normalOf(mesh.triangles[h / 3]), normalOf(mesh.triangles[twins.of[h] / 3]));
    edges.push_back(std::acos(std::clamp(along, -1.0, 1.0)) * 180 / kPi);
  }
  std::ranges::sort(edges, std::greater());
  return edges;
}

struct NamedFork {
  std::vector<Plane> planes;
  std::size_t at = 0;  ///< the plane below the fork
};
/// A Y, a join, a table, a tooth, a hand, two pipes that cross, trousers.
std::vector<NamedFork> namedForks() {
  const std::vector<Curve> feet{circle(25, {-70, -70}), circle(25, {70, -70}), circle(25, {70, 70}),
                                circle(25, {-70, 70})};
  const std::vector<Curve> roots{circle(30, {-60, -40}), circle(30, {60, -40}), circle(35, {0, 55})};
  const Curve palm{{{112, 0}, {70, 36}, {-70, 36}, {-112, 0}, {-70, -36}, {70, -36}}, {}};
  const auto fingers = [](double by, double size) {
    return std::vector<Curve>{circle(19 * size, {-75 * by, 0}), circle(20 * size, {-25 * by, 0}),
                              circle(20 * size, {25 * by, 0}), circle(18 * size, {75 * by, 0}),
                              circle(22 * size, {130 * by, 10 * by})};
  };
  Plane crossed = level(0, kTwo);
  crossed.links = onlyLinks(2, 2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  const Plane across = level(300, {circle(70, {0, -120}), circle(70, {0, 120})});
  return {{{level(0, {circle(100)}), level(300, kTwo)}},
          {{level(0, kTwo), level(300, {circle(100)})}},
          {{level(0, {circle(120)}), level(300, feet)}},
          {{level(0, {circle(100)}), level(300, roots)}},
          {{level(0, {circle(60)}), level(150, {palm}), level(240, fingers(1, 1)), level(360, fingers(1.3, 0.7))}, 1},
          {{crossed, across}},
          {{level(0, {circle(100)}), level(300, kTwo), level(600, {circle(100)})}}};
}

}  // namespace

TEST_CASE("a melted fork is lawful, has as many handles as before, no crease, and what was drawn is where it was") {
  const std::vector<NamedFork> all = namedForks();
  for (std::size_t i = 0; i < all.size(); ++i) {
    CAPTURE(i);
    const auto& [planes, at] = all[i];
    const mesh::TriMesh sharp = melted(planes, 0), soft = melted(planes, 0.5);
    requireOne(soft, requireLawful(sharp).genus);
    const double top = planes.back().origin->z;
    const double low = planes[at].origin->z + 1, high = planes[at + 1].origin->z - 1;
    CHECK(edgesBetween(sharp, low, high).front() > 120);
    CHECK(edgesBetween(soft, low, high).front() <= 33);
    for (const double height : {0.01, top - 0.01}) {
      const auto cut = [&](const mesh::TriMesh& mesh) { return cutBy(mesh, {{0, 0, height}, {1, 0, 0}, {0, 1, 0}}); };
      const PlaneCut drawn = cut(sharp);
      CHECK(overlapShare(cut(soft), [&](SectionPoint p) { return drawn.holds(p); }, {-200, -200}, {200, 200}) >= 0.995);
    }
  }
}

TEST_CASE("copies of a pattern are linked as the planes that they copy") {
  Plane trunk, arms, end;
  trunk.curves = {circle(60)};
  trunk.links = {{0, 1, false}};
  arms.at = 0.2;
  arms.curves = {circle(30, {-50, 0}), circle(30, {50, 0})};
  end.at = 1;
  end.curves = {circle(50)};
  const Rail rail{{{0, 0, 0}, {0, 0, 500}}, false};
  StackParams repeated;
  repeated.patterns = {{0, 1, 2, 0.4}};
  Plane second = trunk, third = arms;
  second.at = 0.4;
  third.at = arms.at + 0.4;
  const std::vector<Plane> once{trunk, arms, end}, written{trunk, arms, second, third, end};
  const auto copied = stackPlanes({once, rail, repeated}, kPaper), drawn = stackPlanes({written, rail, {}}, kPaper);
  REQUIRE(copied.ok());
  REQUIRE(drawn.ok());
  CHECK(copied.value().mesh == drawn.value().mesh);
}

TEST_CASE("links that cannot be are refused with a sentence that names them") {
  const auto said = [](std::vector<CurveLink> links, std::vector<Curve> above = kTwo) {
    Plane low = level(0, {circle(100), circle(60)});
    low.links = std::move(links);
    return failureOf({low, level(300, std::move(above))}).detail;
  };
  CHECK(said({{0, 2}}) == "sheet 1 links curve 1 with curve 3 of the next: there is no such curve");
  CHECK(said({{0, 1}, {0, 1, false}}) == "sheet 1 says twice whether curve 1 becomes curve 2: say it once");
  CHECK(said({{1, 0}}) ==
        "curve 2 on sheet 1 is linked with curve 1 on sheet 2, and only one of them is a hole: link holes with holes");
  Plane straight = level(0, kTwo);
  straight.links = onlyLinks(2, 2, {{0, 0}, {0, 1}, {1, 0}, {1, 1}});
  CHECK(failureOf({straight, level(300, kTwo)}).detail ==
        "the links of curve 1 with 2 and of curve 2 with 1 from sheet 1 on cross half way: take one of them out, or "
        "move a curve");
  Plane high = level(300, kTwo);
  high.links = {{0, 0}};
  CHECK(failureOf({level(0, {circle(100)}), high}).detail ==
        "sheet 2 has links, and no sheet follows it: take them out");
}
