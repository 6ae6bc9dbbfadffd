#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "engine/base/rng.h"
#include "engine/mesh/self_crossing.h"
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
  const Result<mesh::TriMesh> mesh = stackPlanes({planes, {}, {}}, kPaper);
  REQUIRE_MESSAGE(mesh.ok(), failureSentence(mesh.ok() ? Failure{} : mesh.failure()));
  return mesh.value();
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

TEST_CASE("wild forks are lawful and do not go through themselves") {
  int through = 0;
  const int all = rounds(40);
  for (int seed = 0; seed < all; ++seed) {
    CAPTURE(seed);
    Rng rng(static_cast<std::uint64_t>(seed));
    const int count = 2 + static_cast<int>(rng.below(5));
    const double spread = rng.uniform(70, 180);
    std::vector<Curve> branches;
    for (int i = 0; i < count; ++i) {
      const double angle = 2 * kPi * (i + rng.uniform(-0.12, 0.12)) / count;
      branches.push_back(circle(spread * std::sin(kPi / count) * rng.uniform(0.4, 0.7),
                                {spread * std::cos(angle), spread * std::sin(angle)}));
    }
    Plane top = level(rng.uniform(150, 300), branches);
    top.turn = geometry::turnAbout(ModelPoint{rng.uniform(-1, 1), rng.uniform(-1, 1), 0.01}, rng.uniform(0, 0.5));
    const mesh::TriMesh mesh = made({level(0, {circle(100)}), top});
    const mesh::MeshReport report = requireLawful(mesh);
    CHECK(report.genus == 0);
    CHECK(report.shells == 1);
    through += mesh::selfCrossing(mesh).has_value();
  }
  CHECK(through <= all / 100);
}
