#include "engine/relief/shade.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "engine/relief/grid.h"
#include "engine/relief/light.h"

namespace spineloft::relief {
namespace {

constexpr double kSmooth = 2e-6;      // μ, in half sizes
constexpr double kFlat = 1;           // ε, in half sizes
constexpr int kRounds = 3;            // of Gauss and Newton
constexpr double kOutlier = 2.5;      // σ: what is farther off counts by its size, not its square
constexpr double kLeastSigma = 1e-3;  // of the mean brightness
constexpr double kSteep = 0.25;       // n_z: what is turned away further is not used
constexpr double kFade = 0.03;        // of the size
constexpr double kRound = 0.5;        // of a half ball, where no shape is known

// ---- systems of equations on a grid ----

constexpr int kReach = 2;  // cells: how far the equation of a cell reaches; as wide is the empty border about a grid
constexpr int kAcross = 2 * kReach + 1;
constexpr int kSweeps = 8;           // each way, on the coarsest grid
constexpr double kTolerance = 1e-5;  // of the residual, in the norm of the preconditioner
constexpr int kMostIterations = 48;  // of one system
constexpr int kIterationsAStep = 3;

constexpr int kStencil = kAcross * kAcross;
using Stencil = std::array<float, kStencil>;
constexpr int inStencil(int u, int v) { return (v + kReach) * kAcross + u + kReach; }

// The cells of a grid half as fine that (u, v) lies among, with their shares of it; cell (i, j) of that one is cell
// (2 i, 2 j) here.
template <typename Each>
void amongCoarse(int u, int v, Each each) {
  for (int cv = v >> 1; cv <= (v + 1) >> 1; ++cv)
    for (int cu = u >> 1; cu <= (u + 1) >> 1; ++cu) each(cu, cv, (u & 1 ? 0.5f : 1.0f) * (v & 1 ? 0.5f : 1.0f));
}

// One of the grids, each half as fine as the one before.
struct Level {
  Level(int w, int h) : width(w), height(h), stride(w + 2 * kReach) {
    const auto cells = static_cast<std::size_t>(stride) * (height + 2 * kReach);
    a.assign(cells, {});
    inverse.assign(cells, 0.0f);
    x = b = inverse;
  }
  std::ptrdiff_t at(int u, int v) const { return static_cast<std::ptrdiff_t>(v + kReach) * stride + u + kReach; }
  // Row of the matrix times a vector; in sums that do not wait for each other.
  template <typename Number>
  Number row(std::ptrdiff_t i, const Number* vector) const {
    const float* coefficient = a[i].data();
    const Number* from = vector + i - kReach * stride - kReach;
    std::array<Number, kAcross> sums{};
    for (Number& sum : sums) {
      sum = coefficient[0] * from[0] + coefficient[1] * from[1] + coefficient[2] * from[2] + coefficient[3] * from[3] +
            coefficient[4] * from[4];
      coefficient += kAcross;
      from += stride;
    }
    return (sums[0] + sums[1]) + (sums[2] + sums[3]) + sums[4];
  }
  template <typename Each>
  void eachUnknown(Each each) const {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const std::ptrdiff_t i = at(u, v);
        if (inverse[i] != 0) each(i, u, v);
      }
    }
  }
  void sweep(bool back);

  int width, height, stride;
  std::vector<Stencil> a;
  std::vector<float> inverse;  // of the diagonal; 0: no unknown
  std::vector<float> x, b;
};

// Gauss and Seidel.
void Level::sweep(bool back) {
  for (int k = 0; k < height; ++k) {
    const int v = back ? height - 1 - k : k;
    for (int j = 0; j < width; ++j) {
      const std::ptrdiff_t i = at(back ? width - 1 - j : j, v);
      if (inverse[i] != 0) x[i] += inverse[i] * (b[i] - row(i, x.data()));
    }
  }
}

// A symmetric positive system, an unknown a cell, by conjugate gradients. The preconditioner is a V-cycle over grids of
// half the cells each, their equations Pᵀ A P with P bilinear.
class System {
 public:
  System(int width, int height) {
    while (true) {
      levels_.emplace_back(width, height);
      if (std::max(width, height) <= 3) break;
      width = width / 2 + 1;
      height = height / 2 + 1;
    }
    x_.assign(fine().x.size(), 0.0);
    b_ = r_ = p_ = product_ = x_;
  }
  std::ptrdiff_t at(int u, int v) const { return levels_.front().at(u, v); }
  std::ptrdiff_t stride() const { return levels_.front().stride; }
  double& x(std::ptrdiff_t cell) { return x_[cell]; }
  double& right(std::ptrdiff_t cell) { return b_[cell]; }
  void clear();
  // Adds weight · (Σ factor · x[cell + offset])² to the energy; offsets are at most kReach apart in u and in v.
  struct Term {
    int u, v;
    double factor;
  };
  void add(std::ptrdiff_t cell, std::span<const Term> terms, double weight);
  // Once all terms are there; starts from the x that is.
  void prepare();
  // One more iteration; false: the residual is small, or it does not get smaller.
  bool improve();

 private:
  Level& fine() { return levels_.front(); }
  void coarsen(const Level& from, Level& to);
  void precondition();
  void cycle(std::size_t level);

  std::vector<Level> levels_;
  std::vector<double> x_, b_, r_, p_, product_;  // p: the direction; product: A p
  double rz_ = 0, start_ = 0;
};

void System::clear() {
  std::ranges::fill(fine().a, Stencil{});
  std::ranges::fill(b_, 0.0);
}

void System::add(std::ptrdiff_t cell, std::span<const Term> terms, double weight) {
  for (const Term& s : terms) {
    auto& a = fine().a[cell + s.v * stride() + s.u];
    for (const Term& t : terms) a[inStencil(t.u - s.u, t.v - s.v)] += static_cast<float>(weight * s.factor * t.factor);
  }
}

// Cell by cell: the cell's row of A P, then its part of Pᵀ (A P).
void System::coarsen(const Level& from, Level& to) {
  std::ranges::fill(to.a, Stencil{});
  from.eachUnknown([&](std::ptrdiff_t i, int u, int v) {
    Stencil row{};  // about the coarse cell (u / 2, v / 2)
    for (int dv = -kReach; dv <= kReach; ++dv) {
      for (int du = -kReach; du <= kReach; ++du) {
        const float value = from.a[i][inStencil(du, dv)];
        if (value == 0) continue;
        amongCoarse(u + du, v + dv,
                    [&](int cu, int cv, float share) { row[inStencil(cu - u / 2, cv - v / 2)] += value * share; });
      }
    }
    amongCoarse(u, v, [&](int cu, int cv, float share) {
      Stencil& a = to.a[to.at(cu, cv)];
      const int shift = inStencil(cu - u / 2, cv - v / 2) - inStencil(0, 0);
      for (int k = 0; k < kStencil; ++k)
        if (row[k] != 0) a[k - shift] += share * row[k];
    });
  });
}

void System::prepare() {
  for (std::size_t level = 0; level < levels_.size(); ++level) {
    Level& grid = levels_[level];
    if (level > 0) coarsen(levels_[level - 1], grid);
    for (std::size_t i = 0; i < grid.a.size(); ++i) {
      const float diagonal = grid.a[i][inStencil(0, 0)];
      grid.inverse[i] = diagonal > 0 ? 1 / diagonal : 0.0f;
    }
  }
  for (std::vector<double>* vector : {&r_, &p_, &product_}) std::ranges::fill(*vector, 0.0);
  fine().eachUnknown([&](std::ptrdiff_t i, int, int) { r_[i] = b_[i] - fine().row(i, x_.data()); });
  rz_ = start_ = 0;
}

bool System::improve() {
  precondition();
  const std::vector<float>& z = fine().x;
  double rz = 0;
  for (std::size_t i = 0; i < z.size(); ++i) rz += r_[i] * z[i];
  if (start_ == 0) start_ = rz;
  if (!(rz > kTolerance * kTolerance * start_) || !std::isfinite(rz)) return false;
  const double beta = rz_ > 0 ? rz / rz_ : 0;
  rz_ = rz;
  for (std::size_t i = 0; i < z.size(); ++i) p_[i] = z[i] + beta * p_[i];
  double energy = 0;
  fine().eachUnknown([&](std::ptrdiff_t i, int, int) {
    product_[i] = fine().row(i, p_.data());
    energy += product_[i] * p_[i];
  });
  if (!(energy > 0)) return false;
  const double length = rz / energy;
  for (std::size_t i = 0; i < x_.size(); ++i) {
    x_[i] += length * p_[i];
    r_[i] -= length * product_[i];
  }
  return true;
}

// fine().x ≈ A⁻¹ r
void System::precondition() {
  for (std::size_t i = 0; i < r_.size(); ++i) fine().b[i] = static_cast<float>(r_[i]);
  cycle(0);
}

// One sweep before and the same backwards behind it, so that the whole is symmetric.
void System::cycle(std::size_t level) {
  Level& grid = levels_[level];
  std::ranges::fill(grid.x, 0.0f);
  if (level + 1 == levels_.size()) {
    for (int k = 0; k < kSweeps; ++k) {
      grid.sweep(false);
      grid.sweep(true);
    }
    return;
  }
  grid.sweep(false);
  Level& coarse = levels_[level + 1];
  std::ranges::fill(coarse.b, 0.0f);
  grid.eachUnknown([&](std::ptrdiff_t i, int u, int v) {
    const float left = grid.b[i] - grid.row(i, grid.x.data());
    amongCoarse(u, v, [&](int cu, int cv, float share) { coarse.b[coarse.at(cu, cv)] += share * left; });
  });
  cycle(level + 1);
  grid.eachUnknown([&](std::ptrdiff_t i, int u, int v) {
    amongCoarse(u, v, [&](int cu, int cv, float share) { grid.x[i] += share * coarse.x[coarse.at(cu, cv)]; });
  });
  grid.sweep(true);
}

}  // namespace

struct ShadeSteps::State {
  enum class Stage { Shape, Look, Light, Build, Solve, Done };

  int width = 0, height = 0;
  double half = 1;  // size, cells
  std::vector<std::array<float, 3>> colour;
  std::vector<std::uint8_t> inside;
  std::vector<double> z;
  std::vector<Slope> slopes;  // of z, where all four neighbours are inside
  std::vector<float> fade;    // 0: not used … 1
  std::vector<std::uint32_t> use;
  std::optional<LightFit> fit;
  std::vector<double> shown;  // brightness by albedo
  std::optional<System> system;
  int round = 0, iterations = 0;
  Stage stage = Stage::Shape;
  Shaded out;

  explicit State(const Shading& input);
  std::size_t cell(int u, int v) const { return static_cast<std::size_t>(v) * width + u; }
  bool within(int u, int v) const { return u >= 0 && v >= 0 && u < width && v < height && inside[cell(u, v)]; }
  bool amid(int u, int v) const {
    return within(u, v) && within(u - 1, v) && within(u + 1, v) && within(u, v - 1) && within(u, v + 1);
  }
  template <typename Each>
  void eachCell(Each each) const {
    for (int v = 0; v < height; ++v)
      for (int u = 0; u < width; ++u) each(u, v, cell(u, v));
  }
  void step();
  void startDome();
  void endDome();
  void look();
  void build();
  Slope slopeWithHeight(int u, int v);
  void finish();
};

ShadeSteps::State::State(const Shading& input) : width(input.width), height(input.height) {
  if (width < 2 || height < 2 || width > kMostCells || height > kMostCells) {
    stage = Stage::Done;
    return;
  }
  const auto cells = static_cast<std::size_t>(width) * height;
  out.height.assign(cells, 0.0f);
  if (input.colour.size() != cells || input.inside.size() != cells || (!input.z.empty() && input.z.size() != cells)) {
    stage = Stage::Done;
    return;
  }
  half = std::max(width, height) / 2.0;
  colour.assign(input.colour.begin(), input.colour.end());
  inside.assign(input.inside.begin(), input.inside.end());
  z.assign(input.z.begin(), input.z.end());
  system.emplace(width, height);
  if (!z.empty()) {
    stage = Stage::Look;
    return;
  }
  startDome();
}

// −Δu = 4 inside, u = 0 where that ends: √u of a circle is a half ball.
void ShadeSteps::State::startDome() {
  z.assign(colour.size(), 0.0);
  eachCell([&](int u, int v, std::size_t i) {
    if (!inside[i]) return;
    const std::ptrdiff_t at = system->at(u, v);
    for (const auto& [du, dv] : {std::pair(-1, 0), {1, 0}, {0, -1}, {0, 1}}) {
      if (!within(u + du, v + dv)) {
        system->add(at, std::array{System::Term{0, 0, 1}}, 1);
      } else if (du + dv > 0) {
        system->add(at, std::array{System::Term{0, 0, 1}, System::Term{du, dv, -1}}, 1);
      }
    }
    system->right(at) = 4;
  });
  system->prepare();
}

void ShadeSteps::State::endDome() {
  eachCell([&](int u, int v, std::size_t i) { z[i] = kRound * std::sqrt(std::max(0.0, system->x(system->at(u, v)))); });
  system.emplace(width, height);
}

void ShadeSteps::State::look() {
  slopes.assign(colour.size(), {});
  std::vector<std::uint8_t> good(colour.size(), 0);
  const double steep2 = 1 / (kSteep * kSteep) - 1;
  eachCell([&](int u, int v, std::size_t i) {
    if (!amid(u, v)) return;
    slopes[i] = {(z[i + 1] - z[i - 1]) / 2, (z[cell(u, v + 1)] - z[cell(u, v - 1)]) / 2};
    good[i] = slopes[i].p * slopes[i].p + slopes[i].q * slopes[i].q < steep2;
  });
  fade = depthWithin(Grid{width, height, {}, 1}, good);
  for (float& d : fade) {
    const float t = std::min(1.0f, d / static_cast<float>(kFade * 2 * half + 1));
    d = t * t * (3 - 2 * t);
  }
  Colours colours = coloursOf(width, height, colour, inside);
  std::vector<double> brightness(colour.size(), 0.0);
  std::vector<std::uint32_t> wholly;  // for the light
  for (std::uint32_t i = 0; i < colour.size(); ++i) {
    if (!inside[i]) continue;
    brightness[i] = (usable(colour[i][0]) + usable(colour[i][1]) + usable(colour[i][2])) / 3;
    if (!good[i] || !colours.sure[i]) continue;
    use.push_back(i);
    if (fade[i] == 1) wholly.push_back(i);
  }
  fit.emplace(std::move(brightness), std::move(colours), std::move(wholly), slopes);
}

Slope ShadeSteps::State::slopeWithHeight(int u, int v) {
  const Slope coarse = slopes[cell(u, v)];
  const std::ptrdiff_t at = system->at(u, v), row = system->stride();
  return {coarse.p + (system->x(at + 1) - system->x(at - 1)) / 2,
          coarse.q + (system->x(at + row) - system->x(at - row)) / 2};
}

void ShadeSteps::State::build() {
  const Light& light = fit->light();
  system->clear();
  std::vector<double> residuals;
  residuals.reserve(use.size());
  for (const std::uint32_t i : use) {
    const int u = static_cast<int>(i) % width, v = static_cast<int>(i) / width;
    residuals.push_back(shown[i] - light(slopeWithHeight(u, v)));
  }
  const double far = kOutlier * std::max(robustSigma(residuals), kLeastSigma);
  for (std::size_t k = 0; k < use.size(); ++k) {
    const std::uint32_t i = use[k];
    const int u = static_cast<int>(i) % width, v = static_cast<int>(i) / width;
    const std::ptrdiff_t at = system->at(u, v);
    const Slope slope = slopeWithHeight(u, v), d = light.derivative(slope), coarse = slopes[i];
    const double trust = far / std::max(far, std::abs(residuals[k]));
    const double weight = fade[i] * (residuals[k] > 0 ? trust * trust : trust);  // too bright: shine, most likely
    const std::array terms{System::Term{-1, 0, -d.p / 2}, System::Term{1, 0, d.p / 2}, System::Term{0, -1, -d.q / 2},
                           System::Term{0, 1, d.q / 2}};
    system->add(at, terms, weight);
    const double told = residuals[k] + d.p * (slope.p - coarse.p) + d.q * (slope.q - coarse.q);
    for (const System::Term& t : terms) system->right(at + t.v * system->stride() + t.u) += weight * t.factor * told;
  }
  const double smooth = kSmooth * half * half, flat = kFlat / (half * half);
  eachCell([&](int u, int v, std::size_t i) {
    if (!inside[i]) return;
    system->add(system->at(u, v), std::array{System::Term{0, 0, 1}}, flat);
    if (amid(u, v))
      system->add(system->at(u, v),
                  std::array{System::Term{0, 0, -4}, System::Term{-1, 0, 1}, System::Term{1, 0, 1},
                             System::Term{0, -1, 1}, System::Term{0, 1, 1}},
                  smooth);
  });
  system->prepare();
}

void ShadeSteps::State::finish() {
  bool finite = true;
  eachCell([&](int u, int v, std::size_t i) {
    out.height[i] = static_cast<float>(fade[i] * system->x(system->at(u, v)));
    finite &= std::isfinite(out.height[i]);
  });
  if (!finite) std::ranges::fill(out.height, 0.0f);
  out.explained = fit->explained();
}

void ShadeSteps::State::step() {
  const auto solved = [&] {
    for (int k = 0; k < kIterationsAStep; ++k)
      if (iterations++ >= kMostIterations || !system->improve()) return true;
    return false;
  };
  switch (stage) {
    case Stage::Shape:
      if (!solved()) return;
      endDome();
      stage = Stage::Look;
      return;
    case Stage::Look:
      look();
      stage = Stage::Light;
      return;
    case Stage::Light:
      if (fit->round()) return;
      shown.assign(colour.size(), 0.0);
      for (const std::uint32_t i : use) shown[i] = fit->shading(i);
      stage = use.empty() ? Stage::Done : Stage::Build;
      return;
    case Stage::Build:
      build();
      iterations = 0;
      stage = Stage::Solve;
      return;
    case Stage::Solve:
      if (!solved()) return;
      stage = ++round < kRounds ? Stage::Build : Stage::Done;
      if (stage == Stage::Done) finish();
      return;
    case Stage::Done:
      return;
  }
}

ShadeSteps::ShadeSteps(const Shading& input) : state_(std::make_unique<State>(input)) {}
ShadeSteps::~ShadeSteps() = default;
ShadeSteps::ShadeSteps(ShadeSteps&&) noexcept = default;
ShadeSteps& ShadeSteps::operator=(ShadeSteps&&) noexcept = default;

bool ShadeSteps::step() {
  state_->step();
  return state_->stage != State::Stage::Done;
}

Shaded ShadeSteps::take() { return std::move(state_->out); }

Shaded shade(const Shading& input) {
  ShadeSteps steps(input);
  while (steps.step()) {
  }
  return steps.take();
}

}  // namespace spineloft::relief
