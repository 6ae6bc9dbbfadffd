#include "engine/ribs/learned/layers.h"

#include <algorithm>
#include <cassert>

#include "engine/base/shared_loop.h"
#include "engine/base/short_lanes.h"

namespace spineloft::ribs {
namespace {

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// What a tile of outputs is made from and where it goes.
struct Site {
  const std::int16_t* in;  // at the first tap of the first output
  std::size_t inRow, inPixel;
  const std::int16_t* added;
  float* out;
};
// What all tiles of a layer share.
struct Layer {
  const Convolution& of;
  After after;
  float inUnit, addedUnit;
};

// Sums of `pixels` neighbouring outputs of a row, `lanes` · 4 channels each: as many as there are registers for.
template <int pixels, int lanes>
void sumTile(const Convolution& layer, const Site& site, int firstOutput, Int4 (&sums)[pixels][lanes]) {
  const std::size_t outputs = index(layer.outputs), inputs = index(layer.inputs);
  for (auto& pixel : sums) {
    for (Int4& sum : pixel) sum = Int4{};
  }
  const std::int16_t* weights = layer.weights.data() + 2 * firstOutput;
  for (int i = 0; i < layer.side; ++i) {
    for (int j = 0; j < layer.side; ++j) {
      const std::int16_t* from = site.in + index(i * layer.apart) * site.inRow + index(j * layer.apart) * inputs;
      for (std::size_t c = 0; c < inputs; c += 2, weights += 2 * outputs) {
        Short8 w[lanes];
        for (int v = 0; v < lanes; ++v) w[v] = load8(weights + 8 * v);
        for (int p = 0; p < pixels; ++p) {
          const Short8 x = pair8(from + index(p) * site.inPixel + c);
          for (int v = 0; v < lanes; ++v) sums[p][v] += dotPairs(x, w[v]);
        }
      }
    }
  }
}

template <int pixels, int lanes>
void runTile(const Layer& layer, const Site& site, int firstOutput) {
  Int4 sums[pixels][lanes];
  sumTile(layer.of, site, firstOutput, sums);
  for (int v = 0; v < lanes; ++v) {
    const std::size_t channel = index(firstOutput + 4 * v);
    const Float4 scale = layer.inUnit * load4(&layer.of.scales[channel]), bias = load4(&layer.of.biases[channel]);
    for (int p = 0; p < pixels; ++p) {
      const std::size_t at = index(p) * index(layer.of.outputs) + channel;
      Float4 value = __builtin_convertvector(sums[p][v], Float4) * scale + bias;
      if (layer.after == After::AddedAndRectified) value += layer.addedUnit * load4(site.added + at);
      store4(layer.after == After::Nothing ? value : most4(value, all4(0)), site.out + at);
    }
  }
}

template <int pixels>
void runOutputs(const Layer& layer, const Site& site) {
  int first = 0;
  for (; first + 12 <= layer.of.outputs; first += 12) runTile<pixels, 3>(layer, site, first);
  for (; first < layer.of.outputs; first += 4) runTile<pixels, 1>(layer, site, first);
}

void convolveRow(const Layer& layer, const Plane& in, const Plane* added, int y, FloatPlane& out) {
  constexpr int kPixels = 4;
  const Convolution& of = layer.of;
  const int before = of.side / 2 * of.apart;
  const auto site = [&](int x) {
    return Site{in.at(y * of.rowStep - before, x * of.columnStep - before), in.rowStride(),
                index(of.columnStep * of.inputs), added ? added->at(y, x) : nullptr, out.at(y, x)};
  };
  int x = 0;
  for (; x + kPixels <= out.columns; x += kPixels) runOutputs<kPixels>(layer, site(x));
  for (; x < out.columns; ++x) runOutputs<1>(layer, site(x));
}

// work(side, row) for so many rows of both sides.
template <class Work>
void ofRows(int rows, const Work& work) {
  sharedLoop(2 * rows, [&](LoopShare of) {
    for (int i = of.first; i < of.end; ++i) work(index(i / rows), i % rows);
  });
}

// The greatest magnitude of `count`, a multiple of 4, values.
float mostOf(const float* values, std::size_t count) {
  Float4 most = all4(0);
  for (std::size_t i = 0; i < count; i += 4) most = most4(magnitude4(load4(values + i)), most);
  return std::max({most[0], most[1], most[2], most[3]});
}

// `count`, a multiple of 4, values to the nearest units.
void narrow(const float* from, std::size_t count, float perUnit, std::int16_t* to) {
  std::size_t i = 0;
  for (; i + 8 <= count; i += 8)
    storeShort8(nearest4(perUnit * load4(from + i)), nearest4(perUnit * load4(from + i + 4)), to + i);
  for (; i < count; i += 4) {
    const Int4 last = nearest4(perUnit * load4(from + i));
    for (std::size_t v = 0; v < 4; ++v) to[i + v] = static_cast<std::int16_t>(last[v]);
  }
}

}  // namespace

void Plane::shape(int newRows, int newColumns, int newChannels) {
  if (rows == newRows && columns == newColumns && channels == newChannels) return;
  rows = newRows;
  columns = newColumns;
  channels = newChannels;
  values.assign((index(rows) + 2 * kBorder) * rowStride(), 0);
}

void FloatPlane::shape(int newRows, int newColumns, int newChannels) {
  rows = newRows;
  columns = newColumns;
  channels = newChannels;
  values.resize(index(rows) * rowStride());
}

void convolve(const Convolution& layer, const Planes& in, After after, const Planes* added, FloatPlanes& out) {
  const Layer all{layer, after, in[0].unit, added ? (*added)[0].unit : 0};
  assert(in[0].channels == layer.inputs && layer.inputs % 2 == 0 && layer.outputs % 4 == 0);
  assert(layer.side * layer.side * layer.inputs <= Convolution::kMostTerms);
  for (FloatPlane& side : out) side.shape(in[0].rows / layer.rowStep, in[0].columns / layer.columnStep, layer.outputs);
  ofRows(out[0].rows, [&](std::size_t side, int row) {
    convolveRow(all, in[side], added ? &(*added)[side] : nullptr, row, out[side]);
  });
}

void toFixed(const FloatPlanes& from, Planes& to) {
  std::array<float, 2> ofShares{};
  sharedLoop(2 * from[0].rows, [&](LoopShare of) {
    float& most = ofShares[index(of.who)];
    for (int i = of.first; i < of.end; ++i) {
      const FloatPlane& plane = from[index(i / from[0].rows)];
      most = std::max(most, mostOf(plane.at(i % plane.rows, 0), plane.rowStride()));
    }
  });
  const float most = std::max(ofShares[0], ofShares[1]), perUnit = most > 0 ? Plane::kMost / most : 1;
  for (Plane& side : to) {
    side.shape(from[0].rows, from[0].columns, from[0].channels);
    side.unit = most > 0 ? most / Plane::kMost : 1;
  }
  ofRows(from[0].rows, [&](std::size_t side, int row) {
    narrow(from[side].at(row, 0), from[side].rowStride(), perUnit, to[side].at(row, 0));
  });
}

void joinSides(const Planes& sides, std::vector<std::int32_t>& sums, Planes& joined) {
  const Plane& shape = sides[0];
  const std::size_t channels = index(shape.channels), row = index(shape.columns) * channels;
  sums.assign(row, 0);
  for (const Plane& side : sides) {
    for (int y = 0; y < side.rows; ++y) {
      const std::int16_t* from = side.at(y, 0);
      for (std::size_t i = 0; i < row; ++i) sums[i] += from[i];
    }
  }
  const std::int32_t count = 2 * shape.rows;
  for (std::int32_t& sum : sums) sum = (sum >= 0 ? sum + shape.rows : sum - shape.rows) / count;
  for (Plane& out : joined) {
    out.shape(shape.rows, shape.columns, 3 * shape.channels);
    out.unit = shape.unit;
  }
  ofRows(shape.rows, [&](std::size_t side, int y) {
    const std::int16_t *own = sides[side].at(y, 0), *other = sides[1 - side].at(y, 0);
    std::int16_t* to = joined[side].at(y, 0);
    for (std::size_t i = 0; i < row; i += channels, to += 3 * channels) {
      std::copy_n(own + i, channels, to);
      std::copy_n(other + i, channels, to + channels);
      for (std::size_t c = 0; c < channels; ++c) to[2 * channels + c] = static_cast<std::int16_t>(sums[i + c]);
    }
  });
}

void addCoarse(const FloatPlanes& coarse, const Planes& fine, FloatPlanes& out) {
  for (const std::size_t side : {0u, 1u}) {
    const Plane& own = fine[side];
    out[side].shape(own.rows, own.columns, own.channels);
    for (int y = 0; y < own.rows; ++y) {
      for (int x = 0; x < own.columns; ++x) {
        const float* above = coarse[side].at(y / 2, x / 2);
        const std::int16_t* from = own.at(y, x);
        float* to = out[side].at(y, x);
        for (int c = 0; c < own.channels; c += 4)
          store4(most4(own.unit * load4(from + c) + load4(above + c), all4(0)), to + c);
      }
    }
  }
}

}  // namespace spineloft::ribs
