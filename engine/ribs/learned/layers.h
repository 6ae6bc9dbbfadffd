// The layers of the network: convolutions over planes of 16-bit integers with weights of 8 bits. Sums are exact, so
// that results are equal natively and in WebAssembly; every layer's results are brought to 16 bits anew, by the
// greatest of them, so that no weights need ranges of their own.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace spineloft::ribs {

/// rows × columns × channels, channels next to each other, with a border of zeros around it.
struct Plane {
  static constexpr int kBorder = 4;      ///< as wide as the farthest tap reaches
  static constexpr float kMost = 32767;  ///< greatest magnitude of a value
  int rows = 0, columns = 0, channels = 0;
  std::vector<std::int16_t> values;  ///< in units of `unit`
  float unit = 1;

  /// Keeps its memory; values are 0 only if the shape is another one.
  void shape(int rows, int columns, int channels);
  std::size_t rowStride() const {
    return (static_cast<std::size_t>(columns) + 2 * kBorder) * static_cast<std::size_t>(channels);
  }
  std::int16_t* at(int row, int column) {
    return values.data() + static_cast<std::size_t>(row + kBorder) * rowStride() +
           static_cast<std::size_t>(column + kBorder) * static_cast<std::size_t>(channels);
  }
  const std::int16_t* at(int row, int column) const { return const_cast<Plane*>(this)->at(row, column); }
};
/// Of the two sides of a stroke: one shape and one unit.
using Planes = std::array<Plane, 2>;

/// The same before it is brought to 16 bits, without a border.
struct FloatPlane {
  int rows = 0, columns = 0, channels = 0;
  std::vector<float> values;

  void shape(int rows, int columns, int channels);
  std::size_t rowStride() const { return static_cast<std::size_t>(columns) * static_cast<std::size_t>(channels); }
  float* at(int row, int column) {
    return values.data() + static_cast<std::size_t>(row) * rowStride() +
           static_cast<std::size_t>(column) * static_cast<std::size_t>(channels);
  }
  const float* at(int row, int column) const { return const_cast<FloatPlane*>(this)->at(row, column); }
};
using FloatPlanes = std::array<FloatPlane, 2>;

/// One convolution. Its weights are `weights` × the scale of their output.
struct Convolution {
  static constexpr int kMostTerms = 500;  ///< taps × inputs: a sum of so many products stays below 2³¹
  int side = 3;                           ///< 1 or 3 taps a way, centred
  int inputs = 0, outputs = 0;            ///< inputs: even; outputs: a multiple of 4
  int rowStep = 1, columnStep = 1;
  int apart = 1;                           ///< of the taps (dilation), ≤ Plane::kBorder
  std::vector<std::int16_t> weights = {};  ///< −128…127: taps (rows, then columns) × pairs of inputs × outputs × 2
  std::vector<float> scales = {}, biases = {};
  std::size_t weightCount() const {
    return static_cast<std::size_t>(side) * static_cast<std::size_t>(side) * static_cast<std::size_t>(inputs) *
           static_cast<std::size_t>(outputs);
  }
  std::size_t at(int tap, int input, int output) const {
    return (static_cast<std::size_t>(tap * (inputs / 2) + input / 2) * static_cast<std::size_t>(outputs) +
            static_cast<std::size_t>(output)) *
               2 +
           static_cast<std::size_t>(input % 2);
  }
};

/// What comes after the sums of a convolution.
enum class After { Nothing, Rectified, AddedAndRectified };

/// out = convolution(in), rectified, or its sum with `added`, which has the shape of the result, rectified; of both
/// sides. Rows and columns of `in` are multiples of the steps; `out` takes the shape of the result.
void convolve(const Convolution& layer, const Planes& in, After after, const Planes* added, FloatPlanes& out);

/// Brings results to 16 bits: the greatest magnitude of both sides is 32767 units, all else is the nearest unit.
void toFixed(const FloatPlanes& from, Planes& to);

/// The inputs of a layer that joins both sides: own, other, and the mean of both over all rows. `sums` is memory.
void joinSides(const Planes& sides, std::vector<std::int32_t>& sums, Planes& joined);

/// out = max(0, fine + coarse), where every value of `coarse` stands for two rows and two columns.
void addCoarse(const FloatPlanes& coarse, const Planes& fine, FloatPlanes& out);

}  // namespace spineloft::ribs
