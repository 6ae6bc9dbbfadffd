#include "engine/ribs/learned/layers.h"

#include <algorithm>
#include <cassert>

#include "engine/base/lanes.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// Sums of `pixels` neighbouring outputs of a row, `lanes` · 4 channels each: as many as there are registers for.
template <int pixels, int lanes>
struct Tile {
  const Convolution& layer;
  const float* in;  // at the first tap of the first output
  std::size_t inRow, inPixel;
  int firstOutput;

  void sum(Float4 (&sums)[pixels][lanes]) const {
    const auto outputs = index(layer.outputs), inputs = index(layer.inputs);
    for (int p = 0; p < pixels; ++p) {
      for (int v = 0; v < lanes; ++v) sums[p][v] = load4(&layer.biases[index(firstOutput + 4 * v)]);
    }
    const float* weights = layer.weights.data() + firstOutput;
    for (int i = 0; i < layer.side; ++i) {
      for (int j = 0; j < layer.side; ++j) {
        const float* from = in + index(i * layer.apart) * inRow + index(j * layer.apart) * inputs;
        for (std::size_t c = 0; c < inputs; ++c, weights += outputs) {
          Float4 w[lanes];
          for (int v = 0; v < lanes; ++v) w[v] = load4(weights + 4 * v);
          for (int p = 0; p < pixels; ++p) {
            const Float4 x = all4(from[index(p) * inPixel + c]);
            for (int v = 0; v < lanes; ++v) sums[p][v] += x * w[v];
          }
        }
      }
    }
  }
};

struct Target {
  After after;
  const float* added;
  float* out;
  std::size_t pixel;  // from one output to the next
};

template <int pixels, int lanes>
void runTile(const Convolution& layer, const float* in, std::size_t inRow, int firstOutput, const Target& target) {
  Float4 sums[pixels][lanes];
  Tile<pixels, lanes>{layer, in, inRow, index(layer.columnStep * layer.inputs), firstOutput}.sum(sums);
  for (int p = 0; p < pixels; ++p) {
    for (int v = 0; v < lanes; ++v) {
      const std::size_t at = index(p) * target.pixel + index(firstOutput + 4 * v);
      Float4 value = sums[p][v];
      if (target.after == After::AddedAndRectified) value += load4(target.added + at);
      store4(target.after == After::Nothing ? value : most4(value, all4(0)), target.out + at);
    }
  }
}

template <int pixels>
void runOutputs(const Convolution& layer, const float* in, std::size_t inRow, const Target& target) {
  int first = 0;
  for (; first + 12 <= layer.outputs; first += 12) runTile<pixels, 3>(layer, in, inRow, first, target);
  for (; first < layer.outputs; first += 4) runTile<pixels, 1>(layer, in, inRow, first, target);
}

}  // namespace

void Plane::shape(int newRows, int newColumns, int newChannels) {
  if (rows == newRows && columns == newColumns && channels == newChannels) return;
  rows = newRows;
  columns = newColumns;
  channels = newChannels;
  values.assign((index(rows) + 2 * kBorder) * rowStride(), 0.f);
}

void convolve(const Convolution& layer, const Plane& in, After after, const Plane* added, Plane& out) {
  constexpr int kPixels = 4;
  assert(in.channels == layer.inputs && layer.outputs % 4 == 0 && &in != &out);
  out.shape(in.rows / layer.rowStep, in.columns / layer.columnStep, layer.outputs);
  const int before = layer.side / 2 * layer.apart;
  for (int y = 0; y < out.rows; ++y) {
    const auto run = [&](int x, auto&& outputs) {
      const float* from = in.at(y * layer.rowStep - before, x * layer.columnStep - before);
      const Target target{after, added ? added->at(y, x) : nullptr, out.at(y, x), index(layer.outputs)};
      outputs(layer, from, in.rowStride(), target);
    };
    int x = 0;
    for (; x + kPixels <= out.columns; x += kPixels) run(x, runOutputs<kPixels>);
    for (; x < out.columns; ++x) run(x, runOutputs<1>);
  }
}

void joinSides(const Plane& own, const Plane& other, Plane& out) {
  const auto channels = index(own.channels);
  out.shape(own.rows, own.columns, 3 * own.channels);
  const float share = 0.5f / static_cast<float>(own.rows);
  for (int x = 0; x < own.columns; ++x) {
    float* mean = out.at(0, x) + 2 * channels;
    std::fill(mean, mean + channels, 0.f);
    for (int y = 0; y < own.rows; ++y) {
      const float *a = own.at(y, x), *b = other.at(y, x);
      for (std::size_t c = 0; c < channels; ++c) mean[c] += a[c] + b[c];
    }
    for (std::size_t c = 0; c < channels; ++c) mean[c] *= share;
    for (int y = 0; y < own.rows; ++y) {
      float* to = out.at(y, x);
      std::copy_n(own.at(y, x), channels, to);
      std::copy_n(other.at(y, x), channels, to + channels);
      if (y > 0) std::copy_n(mean, channels, to + 2 * channels);
    }
  }
}

void addCoarse(const Plane& coarse, Plane& fine) {
  const int channels = fine.channels;
  for (int y = 0; y < fine.rows; ++y) {
    for (int x = 0; x < fine.columns; ++x) {
      const float* from = coarse.at(y / 2, x / 2);
      float* to = fine.at(y, x);
      for (int c = 0; c < channels; ++c) to[c] = std::max(0.f, to[c] + from[c]);
    }
  }
}

}  // namespace spineloft::ribs
