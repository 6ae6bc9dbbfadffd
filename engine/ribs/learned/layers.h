// The layers of the network: convolutions over planes, in single precision. Every sum is taken in the same order on
// every machine, so that results are equal natively and in WebAssembly.
#pragma once

#include <cstddef>
#include <vector>

namespace spineloft::ribs {

/// rows × columns × channels, channels next to each other, with a border of zeros around it.
struct Plane {
  static constexpr int kBorder = 4;  ///< as wide as the farthest tap reaches
  int rows = 0, columns = 0, channels = 0;
  std::vector<float> values;

  /// Keeps its memory; values are 0 only if the shape is another one.
  void shape(int rows, int columns, int channels);
  std::size_t rowStride() const {
    return (static_cast<std::size_t>(columns) + 2 * kBorder) * static_cast<std::size_t>(channels);
  }
  float* at(int row, int column) {
    return values.data() + static_cast<std::size_t>(row + kBorder) * rowStride() +
           static_cast<std::size_t>(column + kBorder) * static_cast<std::size_t>(channels);
  }
  const float* at(int row, int column) const { return const_cast<Plane*>(this)->at(row, column); }
};

/// One convolution. `weights`: taps (rows, then columns) × inputs × outputs.
struct Convolution {
  int side = 3;                 ///< 1 or 3 taps a way, centred
  int inputs = 0, outputs = 0;  ///< outputs: a multiple of 4
  int rowStep = 1, columnStep = 1;
  int apart = 1;  ///< of the taps (dilation), ≤ Plane::kBorder
  std::vector<float> weights = {}, biases = {};
  std::size_t weightCount() const {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * static_cast<std::size_t>(inputs) *
           static_cast<std::size_t>(outputs);
  }
};

/// What comes after the sums of a convolution.
enum class After { Nothing, Rectified, AddedAndRectified };

/// out = rectified(convolution(in)), or of its sum with `added`, which has the shape of `out` and may be `out`'s
/// predecessor but not `out`. Rows and columns of `in` are multiples of the steps; `out` takes the shape of the result.
void convolve(const Convolution& layer, const Plane& in, After after, const Plane* added, Plane& out);

/// The input of a layer that joins both sides: own, other, and the mean of both over all rows.
void joinSides(const Plane& own, const Plane& other, Plane& out);

/// fine = max(0, fine + coarse), where every value of `coarse` stands for two rows and two columns.
void addCoarse(const Plane& coarse, Plane& fine);

}  // namespace spineloft::ribs
