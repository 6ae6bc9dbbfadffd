#include "engine/ribs/learned/network.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <string>

#include "engine/base/crc32.h"

namespace spineloft::ribs {
namespace {

constexpr std::uint32_t kMagic = 0x4E524C53;  // "SLRN"
constexpr std::uint32_t kVersion = 1;
constexpr int kFine = 12, kCoarse = 24;

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// The layers without their weights.
std::array<Convolution, RibNetwork::kLayers> architecture() {
  std::array<Convolution, RibNetwork::kLayers> layers;
  const auto set = [&](RibNetwork::Layer which, int side, int inputs, int outputs) -> Convolution& {
    Convolution& layer = layers[which];
    layer.side = side;
    layer.inputs = inputs;
    layer.outputs = outputs;
    return layer;
  };
  set(RibNetwork::Enter, 3, kChannels, kFine).columnStep = 2;
  set(RibNetwork::Near, 3, kFine, kFine);
  Convolution& down = set(RibNetwork::Down, 3, kFine, kCoarse);
  down.rowStep = down.columnStep = 2;
  set(RibNetwork::Join, 1, 3 * kCoarse, kCoarse);
  set(RibNetwork::Deep, 3, kCoarse, kCoarse);
  set(RibNetwork::Deeper, 3, kCoarse, kCoarse).apart = 2;
  set(RibNetwork::Deepest, 3, kCoarse, kCoarse).apart = 4;
  set(RibNetwork::Rejoin, 1, 3 * kCoarse, kCoarse);
  set(RibNetwork::Last, 3, kCoarse, kCoarse);
  set(RibNetwork::Up, 1, kCoarse, kFine);
  set(RibNetwork::Refine, 3, kFine, kFine);
  set(RibNetwork::Out, 1, kFine, 2);
  return layers;
}

// Reads numbers one after the other; the size of the file was checked.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes) : bytes_(bytes) {}
  std::uint32_t word() {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) value |= static_cast<std::uint32_t>(bytes_[at_ + i]) << (8 * i);
    at_ += 4;
    return value;
  }
  float number() { return std::bit_cast<float>(word()); }
  float byte() { return static_cast<float>(static_cast<std::int8_t>(bytes_[at_++])); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Failure damaged(const char* what) { return {Error::FileUnreadable, std::string("the network's weights: ") + what}; }

// Outputs beyond those of the file are 0: sums are taken four at a time.
void readLayer(Reader& from, Convolution& layer) {
  const int outputs = layer.outputs, padded = (outputs + 3) / 4 * 4;
  std::vector<float> scales;
  layer.outputs = padded;
  layer.biases.assign(index(padded), 0.f);
  layer.weights.assign(layer.weightCount(), 0.f);
  for (int i = 0; i < outputs; ++i) scales.push_back(from.number());
  for (int i = 0; i < outputs; ++i) layer.biases[index(i)] = from.number();
  for (std::size_t row = 0; row < layer.weights.size(); row += index(padded)) {
    for (int i = 0; i < outputs; ++i) layer.weights[row + index(i)] = scales[index(i)] * from.byte();
  }
}

}  // namespace

Result<RibNetwork> RibNetwork::read(std::span<const std::uint8_t> file) {
  constexpr std::size_t kHeader = 12, kOfLayer = 12, kCrc = 4;
  RibNetwork network;
  network.layers_ = architecture();
  std::size_t size = kHeader + kCrc;
  for (const Convolution& layer : network.layers_) size += kOfLayer + 8 * index(layer.outputs) + layer.weightCount();
  if (file.size() < kHeader || Reader(file).word() != kMagic) return damaged("this is no weights file");
  Reader from(file);
  from.word();
  if (from.word() != kVersion) return damaged("another version of the file's format");
  if (from.word() != kLayers || file.size() != size) return damaged("the file is too short, or of another network");
  const auto body = file.first(file.size() - kCrc);
  if (Reader(file.last(kCrc)).word() != crc32(body)) return damaged("the checksum is wrong");
  for (const Convolution& layer : network.layers_) {
    const bool same = from.word() == static_cast<std::uint32_t>(layer.side) &&
                      from.word() == static_cast<std::uint32_t>(layer.inputs) &&
                      from.word() == static_cast<std::uint32_t>(layer.outputs);
    if (!same) return damaged("layers of other sizes");
  }
  for (Convolution& layer : network.layers_) readLayer(from, layer);
  return network;
}

void RibNetwork::run(const StripChannels& channels, NetworkScratch& s,
                     std::array<std::vector<float>, 2>& scores) const {
  const auto both = [&](auto&& step) {
    step(0, 1);
    step(1, 0);
  };
  const auto& l = layers_;
  both([&](std::size_t side, std::size_t) {
    Plane& input = s.input[side];
    input.shape(channels.rows, channels.levels, kChannels);
    const std::size_t row = index(channels.levels) * kChannels;
    for (int r = 0; r < channels.rows; ++r) std::copy_n(&channels.planes[side][channels.at(r, 0)], row, input.at(r, 0));
    convolve(l[Enter], input, After::Rectified, nullptr, s.refined[side]);
    convolve(l[Near], s.refined[side], After::AddedAndRectified, &s.refined[side], s.fine[side]);
    convolve(l[Down], s.fine[side], After::Rectified, nullptr, s.coarse[side]);
  });
  const auto join = [&](Layer layer, std::array<Plane, 2>& from, std::array<Plane, 2>& to) {
    both([&](std::size_t side, std::size_t other) {
      joinSides(from[side], from[other], s.joined);
      convolve(l[layer], s.joined, After::AddedAndRectified, &from[side], to[side]);
    });
  };
  const auto deepen = [&](Layer layer, std::array<Plane, 2>& from, std::array<Plane, 2>& to) {
    both([&](std::size_t side, std::size_t) {
      convolve(l[layer], from[side], After::AddedAndRectified, &from[side], to[side]);
    });
  };
  join(Join, s.coarse, s.deeper);
  deepen(Deep, s.deeper, s.coarse);
  deepen(Deeper, s.coarse, s.deeper);
  deepen(Deepest, s.deeper, s.coarse);
  join(Rejoin, s.coarse, s.deeper);
  deepen(Last, s.deeper, s.coarse);
  both([&](std::size_t side, std::size_t) {
    convolve(l[Up], s.coarse[side], After::Nothing, nullptr, s.raised[side]);
    addCoarse(s.raised[side], s.fine[side]);
    convolve(l[Refine], s.fine[side], After::AddedAndRectified, &s.fine[side], s.refined[side]);
    convolve(l[Out], s.refined[side], After::Nothing, nullptr, s.scores[side]);
    scores[side].resize(index(channels.rows) * index(channels.levels));
    float* out = scores[side].data();
    for (int r = 0; r < channels.rows; ++r) {
      for (int k = 0; k < channels.levels; k += 2, out += 2) std::copy_n(s.scores[side].at(r, k / 2), 2, out);
    }
  });
}

const RibNetwork* builtInNetwork() {
  static const Result<RibNetwork> kNetwork = RibNetwork::read(builtInWeights());
  return kNetwork.ok() ? &kNetwork.value() : nullptr;
}

}  // namespace spineloft::ribs
