#include "engine/relief/grid.h"

#include <algorithm>
#include <cmath>

namespace spineloft::relief {
namespace {

// Weights of a Gaussian, from its middle on.
std::vector<float> halfGaussian(double sigma) {
  constexpr double kReach = 3;  // sigmas: beyond is nothing
  std::vector<float> weights;
  for (int i = 0; i <= std::ceil(kReach * sigma); ++i) {
    weights.push_back(static_cast<float>(std::exp(-0.5 * i * i / (sigma * sigma))));
  }
  return weights;
}

// One line of `count` values that lie `stride` apart.
void sumAlong(const float* in, float* out, int count, std::size_t stride, const std::vector<float>& weights) {
  const int reach = static_cast<int>(weights.size()) - 1;
  for (int i = 0; i < count; ++i) {
    float sum = 0;
    for (int j = std::max(0, i - reach); j <= std::min(count - 1, i + reach); ++j) {
      sum += weights[static_cast<std::size_t>(std::abs(j - i))] * in[static_cast<std::size_t>(j) * stride];
    }
    out[static_cast<std::size_t>(i) * stride] = sum;
  }
}

void sumRound(const Grid& grid, Values& values, const std::vector<float>& weights) {
  Values along(values.size());
  const auto width = static_cast<std::size_t>(grid.width);
  for (int y = 0; y < grid.height; ++y) {
    sumAlong(&values[grid.at(0, y)], &along[grid.at(0, y)], grid.width, 1, weights);
  }
  for (int x = 0; x < grid.width; ++x) {
    sumAlong(&along[grid.at(x, 0)], &values[grid.at(x, 0)], grid.height, width, weights);
  }
}

}  // namespace

Values blurred(const Grid& grid, const Values& values, const Cells& counts, double sigma) {
  Values sums(grid.size()), weights(grid.size());
  for (std::size_t i = 0; i < sums.size(); ++i) {
    sums[i] = counts[i] ? values[i] : 0;
    weights[i] = counts[i] ? 1.0F : 0.0F;
  }
  if (!(sigma > 0.1)) return sums;
  const std::vector<float> gaussian = halfGaussian(sigma);
  sumRound(grid, sums, gaussian);
  sumRound(grid, weights, gaussian);
  for (std::size_t i = 0; i < sums.size(); ++i) sums[i] = counts[i] ? sums[i] / weights[i] : 0;
  return sums;
}

Values largestNear(const Grid& grid, const Values& values, const Cells& counts, int reach) {
  Values along(grid.size()), out(grid.size());
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = counts[i] ? values[i] : 0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      const auto first = out.begin() + static_cast<std::ptrdiff_t>(grid.at(std::max(0, x - reach), y));
      const auto last = out.begin() + static_cast<std::ptrdiff_t>(grid.at(std::min(grid.width - 1, x + reach), y));
      along[grid.at(x, y)] = *std::max_element(first, last + 1);
    }
  }
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) {
      float most = 0;
      for (int k = std::max(0, y - reach); k <= std::min(grid.height - 1, y + reach); ++k) {
        most = std::max(most, along[grid.at(x, k)]);
      }
      out[grid.at(x, y)] = most;
    }
  }
  return out;
}

Values depthWithin(const Grid& grid, const Cells& counts) {
  constexpr float kStraight = 1, kAslant = 4.0F / 3;
  Values depth(grid.size(), 0);
  const auto near = [&](int x, int y) {
    return x < 0 || y < 0 || x >= grid.width || y >= grid.height ? 0.0F : depth[grid.at(x, y)];
  };
  const auto sweep = [&](int x, int y, int back) {
    float& here = depth[grid.at(x, y)];
    here = std::min({here, near(x - back, y) + kStraight, near(x, y - back) + kStraight,
                     near(x - back, y - back) + kAslant, near(x + back, y - back) + kAslant});
  };
  for (std::size_t i = 0; i < depth.size(); ++i) depth[i] = counts[i] ? 1e9F : 0;
  for (int y = 0; y < grid.height; ++y) {
    for (int x = 0; x < grid.width; ++x) sweep(x, y, 1);
  }
  for (int y = grid.height; y-- > 0;) {
    for (int x = grid.width; x-- > 0;) sweep(x, y, -1);
  }
  return depth;
}

double sample(const Grid& grid, std::span<const float> values, double x, double y) {
  x = std::clamp(x, 0.0, grid.width - 1.0);
  y = std::clamp(y, 0.0, grid.height - 1.0);
  const int left = std::min(static_cast<int>(x), std::max(0, grid.width - 2));
  const int top = std::min(static_cast<int>(y), std::max(0, grid.height - 2));
  const int right = std::min(left + 1, grid.width - 1), bottom = std::min(top + 1, grid.height - 1);
  const double u = x - left, v = y - top;
  const double upper = std::lerp(values[grid.at(left, top)], values[grid.at(right, top)], u);
  return std::lerp(upper, std::lerp(values[grid.at(left, bottom)], values[grid.at(right, bottom)], u), v);
}

}  // namespace spineloft::relief
