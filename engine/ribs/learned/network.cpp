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
  std::int8_t byte() { return static_cast<std::int8_t>(bytes_[at_++]); }

 private:
  std::span<const std::uint8_t> bytes_;
  std::size_t at_ = 0;
};

Failure damaged(const char* what) { return {Error::FileUnreadable, std::string("the network's weights: ") + what}; }

// Outputs beyond those of the file are 0: sums are taken four at a time.
void readLayer(Reader& from, Convolution& layer) {
  const int outputs = layer.outputs, padded = (outputs + 3) / 4 * 4;
  layer.outputs = padded;
  layer.scales.assign(index(padded), 0.f);
  layer.biases.assign(index(padded), 0.f);
  layer.weights.assign(layer.weightCount(), 0);
  for (int i = 0; i < outputs; ++i) layer.scales[index(i)] = from.number();
  for (int i = 0; i < outputs; ++i) layer.biases[index(i)] = from.number();
  for (int tap = 0; tap < layer.side * layer.side; ++tap) {
    for (int input = 0; input < layer.inputs; ++input) {
      for (int i = 0; i < outputs; ++i) layer.weights[layer.at(tap, input, i)] = from.byte();
    }
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
  const auto& l = layers_;
  const auto run = [&](Layer layer, const Planes& in, After after, const Planes* added, Planes& out) {
    convolve(l[layer], in, after, added, s.sums);
    toFixed(s.sums, out);
  };
  const auto deepen = [&](Layer layer, const Planes& from, Planes& to) {
    run(layer, from, After::AddedAndRectified, &from, to);
  };
  const auto join = [&](Layer layer, const Planes& from, Planes& to) {
    joinSides(from, s.columnSums, s.joined);
    run(layer, s.joined, After::AddedAndRectified, &from, to);
  };
  run(Enter, channels.planes, After::Rectified, nullptr, s.refined);
  deepen(Near, s.refined, s.fine);
  run(Down, s.fine, After::Rectified, nullptr, s.coarse);
  join(Join, s.coarse, s.deeper);
  deepen(Deep, s.deeper, s.coarse);
  deepen(Deeper, s.coarse, s.deeper);
  deepen(Deepest, s.deeper, s.coarse);
  join(Rejoin, s.coarse, s.deeper);
  deepen(Last, s.deeper, s.coarse);
  convolve(l[Up], s.coarse, After::Nothing, nullptr, s.raised);
  addCoarse(s.raised, s.fine, s.sums);
  toFixed(s.sums, s.fine);
  deepen(Refine, s.fine, s.refined);
  convolve(l[Out], s.refined, After::Nothing, nullptr, s.sums);
  for (const std::size_t side : {0u, 1u}) {
    scores[side].resize(index(channels.rows) * index(channels.levels));
    float* out = scores[side].data();
    for (int r = 0; r < channels.rows; ++r) {
      for (int k = 0; k < channels.levels; k += 2, out += 2) std::copy_n(s.sums[side].at(r, k / 2), 2, out);
    }
  }
}

const RibNetwork* builtInNetwork() {
  static const Result<RibNetwork> kNetwork = RibNetwork::read(builtInWeights());
  return kNetwork.ok() ? &kNetwork.value() : nullptr;
}

}  // namespace spineloft::ribs
