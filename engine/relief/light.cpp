#include "engine/relief/light.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace spineloft::relief {
namespace {

constexpr int kRounds = 10;           // of the reweighted least squares
constexpr double kHuber = 1.5;        // σ: what is farther off counts by its size, not its square
constexpr double kRidge = 1e-5;       // of the terms' own energy: seen from the front they are nearly dependent
constexpr double kLeastSigma = 1e-4;  // of the mean brightness

constexpr int kBins = 32;             // of each of two chromas
constexpr double kApart = 0.06;       // two colours are at least so far apart in chroma
constexpr double kLeastShare = 0.02;  // of the cells: less is not a colour
constexpr double kDark = 0.15;        // of the median brightness: below it chroma is noise
constexpr double kBlend = 0.03;       // chroma: how far one colour passes into another
constexpr float kEdge = 0.25f;        // of a share, from a cell to the next: more is an edge

using Colour = std::array<float, 3>;
using Chroma = std::array<double, 2>;  // shares of red and green

double brightnessOf(const std::array<double, 3>& c) { return (c[0] + c[1] + c[2]) / 3; }
double distance(Chroma a, Chroma b) { return std::hypot(a[0] - b[0], a[1] - b[1]); }

// Moves the values about.
double median(std::vector<double>& values) {
  if (values.empty()) return 0;
  const auto at = values.begin() + std::ssize(values) / 2;
  std::ranges::nth_element(values, at);
  return *at;
}

// The cells about (x, y) that `inside` has, itself among them.
template <typename Each>
void around(int width, int height, std::span<const std::uint8_t> inside, int x, int y, Each each) {
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u) {
      const auto cell = static_cast<std::size_t>(v) * width + u;
      if (inside[cell]) each(cell);
    }
  }
}

struct Chromas {
  std::vector<Chroma> of;             // every cell
  std::vector<std::uint32_t> bright;  // the cells that are bright enough to tell
};

Chroma chromaOf(const std::array<double, 3>& c) {
  const double sum = c[0] + c[1] + c[2];
  return sum > 0 ? Chroma{c[0] / sum, c[1] / sum} : Chroma{1.0 / 3, 1.0 / 3};
}

// Of the mean of those of the 3 × 3 cells that are alike: noise is a third.
template <typename Alike>
Chromas chromasOf(int width, int height, const std::vector<std::array<double, 3>>& colour,
                  std::span<const std::uint8_t> inside, double dark, Alike alike) {
  Chromas out;
  out.of.assign(colour.size(), chromaOf({}));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const auto cell = static_cast<std::size_t>(y) * width + x;
      if (!inside[cell]) continue;
      std::array<double, 3> sum{};
      double count = 0;
      around(width, height, inside, x, y, [&](std::size_t near) {
        if (!alike(cell, near)) return;
        ++count;
        for (std::size_t k = 0; k < 3; ++k) sum[k] += colour[near][k];
      });
      out.of[cell] = chromaOf(sum);
      if (brightnessOf(sum) / count > dark) out.bright.push_back(static_cast<std::uint32_t>(cell));
    }
  }
  return out;
}

// The mean of what is near the fullest bin of those cells that are far from all centres.
bool nextCentre(const Chromas& chromas, std::vector<Chroma>& centres) {
  std::array<std::uint32_t, kBins * kBins> bins{};
  const auto binOf = [](Chroma c) {
    const auto of = [](double share) { return std::clamp(static_cast<int>(share * kBins), 0, kBins - 1); };
    return static_cast<std::size_t>(of(c[0]) * kBins + of(c[1]));
  };
  std::vector<std::uint32_t> far;
  for (const std::uint32_t cell : chromas.bright) {
    const Chroma c = chromas.of[cell];
    if (std::ranges::any_of(centres, [&](Chroma centre) { return distance(c, centre) < kApart; })) continue;
    far.push_back(cell);
    ++bins[binOf(c)];
  }
  if (far.empty() || static_cast<double>(far.size()) < kLeastShare * static_cast<double>(chromas.bright.size()))
    return false;
  const auto fullest = static_cast<int>(std::ranges::max_element(bins) - bins.begin());
  Chroma centre{(fullest / kBins + 0.5) / kBins, (fullest % kBins + 0.5) / kBins};
  for (int pass = 0; pass < 3; ++pass) {
    Chroma sum{};
    double count = 0;
    for (const std::uint32_t cell : far) {
      if (distance(chromas.of[cell], centre) > kApart) continue;
      ++count;
      sum = {sum[0] + chromas.of[cell][0], sum[1] + chromas.of[cell][1]};
    }
    if (count > 0) centre = {sum[0] / count, sum[1] / count};
  }
  centres.push_back(centre);
  return true;
}

}  // namespace

Light::Terms Light::terms(Slope slope) {
  const double z = 1 / std::sqrt(1 + slope.p * slope.p + slope.q * slope.q), x = -slope.p * z, y = -slope.q * z;
  return {1, x, y, z, x * y, x * z, y * z, x * x - y * y, 3 * z * z - 1};
}

double Light::operator()(Slope slope) const {
  const Terms y = terms(slope);
  return std::inner_product(c_.begin(), c_.end(), y.begin(), 0.0);
}

Slope Light::derivative(Slope slope) const {
  const double z = 1 / std::sqrt(1 + slope.p * slope.p + slope.q * slope.q), x = -slope.p * z, y = -slope.q * z;
  const double gx = c_[1] + c_[4] * y + c_[5] * z + 2 * c_[7] * x, gy = c_[2] + c_[4] * x + c_[6] * z - 2 * c_[7] * y,
               gz = c_[3] + c_[5] * x + c_[6] * y + 6 * c_[8] * z;
  // n = v / |v| with v = (−p, −q, 1): what turns n is across it.
  const double along = gx * x + gy * y + gz * z;
  return {-z * (gx - along * x), -z * (gy - along * y)};
}

Colours coloursOf(int width, int height, std::span<const Colour> colour, std::span<const std::uint8_t> inside) {
  std::vector<std::array<double, 3>> positive(colour.size());
  std::vector<double> levels;
  for (std::size_t cell = 0; cell < colour.size(); ++cell) {
    if (!inside[cell]) continue;
    for (std::size_t k = 0; k < 3; ++k) positive[cell][k] = usable(colour[cell][k]);
    levels.push_back(brightnessOf(positive[cell]));
  }
  const double dark = kDark * median(levels);
  Chromas chromas = chromasOf(width, height, positive, inside, dark, [](std::size_t, std::size_t) { return true; });
  std::vector<Chroma> centres;
  while (centres.size() < kMostColours && nextCentre(chromas, centres)) {
  }
  Colours out{std::max<std::size_t>(centres.size(), 1), {}, {}};
  out.shares.assign(colour.size(), {1});
  out.sure.assign(colour.size(), 1);
  if (out.count == 1) return out;
  std::vector<std::uint8_t> nearest(colour.size(), 0);
  for (std::size_t cell = 0; cell < colour.size(); ++cell) {
    const auto far = [&](Chroma centre) { return distance(chromaOf(positive[cell]), centre); };
    nearest[cell] = static_cast<std::uint8_t>(std::ranges::min_element(centres, {}, far) - centres.begin());
  }
  chromas = chromasOf(width, height, positive, inside, dark,
                      [&](std::size_t cell, std::size_t near) { return nearest[near] == nearest[cell]; });
  for (std::size_t cell = 0; cell < colour.size(); ++cell) {
    std::array<double, kMostColours> far{};
    for (std::size_t k = 0; k < out.count; ++k) far[k] = distance(chromas.of[cell], centres[k]) / kBlend;
    const double least = *std::min_element(far.begin(), far.begin() + static_cast<std::ptrdiff_t>(out.count));
    double sum = 0;
    for (std::size_t k = 0; k < out.count; ++k) sum += far[k] = std::exp((least * least - far[k] * far[k]) / 2);
    for (std::size_t k = 0; k < out.count; ++k) out.shares[cell][k] = static_cast<float>(far[k] / sum);
  }
  std::ranges::fill(out.sure, std::uint8_t{0});
  for (const std::uint32_t cell : chromas.bright) {
    float most = 0;
    around(width, height, inside, static_cast<int>(cell) % width, static_cast<int>(cell) / width,
           [&](std::size_t near) {
             for (std::size_t k = 0; k < out.count; ++k)
               most = std::max(most, std::abs(out.shares[near][k] - out.shares[cell][k]));
           });
    // What is nearly of one colour can be trusted also next to another.
    const bool pure = distance(chromaOf(positive[cell]), centres[nearest[cell]]) < kBlend;
    out.sure[cell] = pure || most < kEdge;
  }
  return out;
}

double robustSigma(std::vector<double> residuals) {
  for (double& r : residuals) r = std::abs(r);
  return 1.4826 * median(residuals);
}

LightFit::LightFit(std::vector<double> brightness, Colours colours, std::vector<std::uint32_t> use,
                   const std::vector<Slope>& slopes)
    : brightness_(std::move(brightness)), colours_(std::move(colours)), use_(std::move(use)) {
  terms_.reserve(use_.size());
  for (const std::uint32_t cell : use_) terms_.push_back(Light::terms(slopes[cell]));
  weights_.assign(use_.size(), 1.0);
  lit_.assign(use_.size(), 1.0);
  for (std::size_t k = 0; k < kMostColours; ++k) {
    double sum = 0, count = 0;
    for (const std::uint32_t cell : use_) {
      sum += colours_.shares[cell][k] * brightness_[cell];
      count += colours_.shares[cell][k];
    }
    if (sum > 0) albedo_[k] = sum / count;
  }
}

double LightFit::shading(std::uint32_t cell) const {
  double albedo = 0;
  for (std::size_t k = 0; k < colours_.count; ++k) albedo += colours_.shares[cell][k] * albedo_[k];
  return albedo > 0 ? brightness_[cell] / albedo : 0;
}

// Light and the changes δ of the albedos at once: brightness / albedo ≈ c·Y + δ · (c·Y of the round before).
bool LightFit::round() {
  if (use_.empty() || rounds_ == kRounds) return false;
  constexpr int kUnknowns = static_cast<int>(Light::kCount + kMostColours - 1);
  using Vector = Eigen::Matrix<double, kUnknowns, 1>;
  Eigen::Matrix<double, kUnknowns, kUnknowns> normal = Eigen::Matrix<double, kUnknowns, kUnknowns>::Zero();
  Vector right = Vector::Zero(), row = Vector::Zero();
  for (std::size_t i = 0; i < use_.size(); ++i) {
    std::ranges::copy(terms_[i], row.begin());
    for (std::size_t k = 1; k < colours_.count; ++k)
      row[static_cast<int>(Light::kCount + k) - 1] = lit_[i] * colours_.shares[use_[i]][k];
    normal.selfadjointView<Eigen::Lower>().rankUpdate(row, weights_[i]);
    right += weights_[i] * shading(use_[i]) * row;
  }
  normal.diagonal() += kRidge * normal(0, 0) * Vector::Ones();
  const Vector found = normal.selfadjointView<Eigen::Lower>().ldlt().solve(right);
  if (!found.allFinite()) return false;
  Light::Terms c{};
  std::copy_n(found.begin(), Light::kCount, c.begin());
  light_ = Light(c);
  for (std::size_t k = 1; k < colours_.count; ++k)
    albedo_[k] *= std::clamp(1 + found[static_cast<int>(Light::kCount + k) - 1], 0.5, 2.0);
  std::vector<double> residuals(use_.size());
  for (std::size_t i = 0; i < use_.size(); ++i) {
    lit_[i] = std::inner_product(c.begin(), c.end(), terms_[i].begin(), 0.0);
    residuals[i] = shading(use_[i]) - lit_[i];
  }
  const double far = kHuber * std::max(robustSigma(residuals), kLeastSigma);
  for (std::size_t i = 0; i < use_.size(); ++i) weights_[i] = far / std::max(far, std::abs(residuals[i]));
  return ++rounds_ < kRounds;
}

double LightFit::explained() const {
  const auto variance = [&](auto value) {
    double sum = 0, squares = 0;
    for (std::size_t i = 0; i < use_.size(); ++i) sum += value(i);
    const double mean = sum / static_cast<double>(use_.size());
    for (std::size_t i = 0; i < use_.size(); ++i) squares += (value(i) - mean) * (value(i) - mean);
    return squares / static_cast<double>(use_.size());
  };
  if (use_.empty()) return 0;
  const double all = variance([&](std::size_t i) { return shading(use_[i]); });
  const double left = variance([&](std::size_t i) { return shading(use_[i]) - lit_[i]; });
  return all > kLeastSigma * kLeastSigma ? std::clamp(1 - left / all, 0.0, 1.0) : 0.0;
}

}  // namespace spineloft::relief
