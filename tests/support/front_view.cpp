#include "tests/support/front_view.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace spineloft::testing {

std::array<double, 3> sampled(const image::Image& image, double u, double v) {
  const double x = std::clamp(u * image.width - 0.5, 0.0, image.width - 1.0);
  const double y = std::clamp(v * image.height - 0.5, 0.0, image.height - 1.0);
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const int x1 = std::min(x0 + 1, image.width - 1), y1 = std::min(y0 + 1, image.height - 1);
  const double fx = x - x0, fy = y - y0;
  std::array<double, 3> out{};
  for (std::size_t c = 0; c < 3; ++c) {
    const auto at = [&](int px, int py) {
      return double(image.pixels[4 * (std::size_t(py) * std::size_t(image.width) + std::size_t(px)) + c]);
    };
    out[c] = (at(x0, y0) * (1 - fx) + at(x1, y0) * fx) * (1 - fy) + (at(x0, y1) * (1 - fx) + at(x1, y1) * fx) * fy;
  }
  return out;
}

std::vector<std::optional<std::array<double, 3>>> frontView(const mesh::TriMesh& mesh, image::Size size,
                                                            const ColourAt& colour) {
  const std::size_t count = std::size_t(size.width) * std::size_t(size.height);
  std::vector<std::optional<std::array<double, 3>>> out(count);
  std::vector<double> depth(count, -std::numeric_limits<double>::infinity());
  for (const auto& t : mesh.triangles) {
    const auto &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
    const double ax = a[0], ay = -a[1], bx = b[0], by = -b[1], cx = c[0], cy = -c[1];
    const double area = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
    if (std::abs(area) < 1e-12) continue;
    const int left = std::max(0, int(std::ceil(std::min({ax, bx, cx}))));
    const int right = std::min(size.width - 1, int(std::floor(std::max({ax, bx, cx}))));
    const int top = std::max(0, int(std::ceil(std::min({ay, by, cy}))));
    const int bottom = std::min(size.height - 1, int(std::floor(std::max({ay, by, cy}))));
    for (int y = top; y <= bottom; ++y) {
      for (int x = left; x <= right; ++x) {
        const double wb = ((x - ax) * (cy - ay) - (y - ay) * (cx - ax)) / area;
        const double wc = ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / area;
        const double wa = 1 - wb - wc;
        if (wa < 0 || wb < 0 || wc < 0) continue;
        const double z = wa * a[2] + wb * b[2] + wc * c[2];
        const std::size_t i = std::size_t(y) * std::size_t(size.width) + std::size_t(x);
        if (z <= depth[i]) continue;
        depth[i] = z;
        const auto mixed = [&](std::size_t k) {
          return wa * mesh.uv[t[0]][k] + wb * mesh.uv[t[1]][k] + wc * mesh.uv[t[2]][k];
        };
        out[i] = colour(mixed(0), mixed(1));
      }
    }
  }
  return out;
}

double psnr(const std::vector<std::optional<std::array<double, 3>>>& seen, const image::Image& truth) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = 0; i < seen.size(); ++i) {
    if (!seen[i]) continue;
    for (std::size_t c = 0; c < 3; ++c) {
      const double d = (*seen[i])[c] - truth.pixels[4 * i + c];
      sum += d * d;
      ++count;
    }
  }
  if (count == 0) return 0;
  return 10 * std::log10(255.0 * 255.0 / std::max(1e-9, sum / double(count)));
}

}  // namespace spineloft::testing
