#include "tests/support/random_documents.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "engine/document/params.h"

namespace spineloft::testing {
namespace {

using namespace document;

constexpr int kWidth = 96, kHeight = 72;

PartId anyPart(Rng& rng, const Document& document) {
  if (document.parts.empty() || rng.below(20) == 0) return PartId{rng.below(9)};
  return document.parts[rng.below(static_cast<std::uint32_t>(document.parts.size()))].id;
}

PictureId anyPicture(Rng& rng, const Document& document) {
  if (document.pictures.empty() || rng.below(20) == 0) return PictureId{rng.below(9)};
  return document.pictures[rng.below(static_cast<std::uint32_t>(document.pictures.size()))].id;
}

loft::SectionPreset anySection(Rng& rng) {
  return static_cast<loft::SectionPreset>(
      rng.below(static_cast<std::uint32_t>(loft::SectionPreset::kCount) + 1));
}

loft::CapStyle anyCap(Rng& rng) {
  return static_cast<loft::CapStyle>(
      rng.below(static_cast<std::uint32_t>(loft::CapStyle::kCount) + 1));
}

std::vector<PicturePoint> anyStroke(Rng& rng) {
  std::vector<PicturePoint> stroke = randomStroke(rng, kWidth, kHeight);
  if (rng.below(15) == 0) stroke.resize(1);
  if (rng.below(15) == 0) stroke.back().x = std::numeric_limits<double>::quiet_NaN();
  return stroke;
}

/// One maker for every alternative of the variant: a new action without one does not compile.
template <class A>
struct Make;
template <>
struct Make<AddPicture> {
  static AddPicture from(Rng& rng, const Document&) {
    return {"picture", rng.below(10) == 0 ? nullptr : ellipsePicture(kWidth, kHeight, rng.below(3))};
  }
};
template <>
struct Make<RemovePicture> {
  static RemovePicture from(Rng& rng, const Document& d) { return {anyPicture(rng, d)}; }
};
template <>
struct Make<DrawSpine> {
  static DrawSpine from(Rng& rng, const Document& d) {
    return {anyPicture(rng, d), anyStroke(rng), anySection(rng), anyCap(rng), anyCap(rng), {}};
  }
};
template <>
struct Make<RedrawSpine> {
  static RedrawSpine from(Rng& rng, const Document& d) { return {anyPart(rng, d), anyStroke(rng)}; }
};
template <>
struct Make<SetSection> {
  static SetSection from(Rng& rng, const Document& d) { return {anyPart(rng, d), anySection(rng)}; }
};
template <>
struct Make<SetCaps> {
  static SetCaps from(Rng& rng, const Document& d) {
    return {anyPart(rng, d), anyCap(rng), anyCap(rng)};
  }
};
template <>
struct Make<SetLook> {
  static SetLook from(Rng& rng, const Document& d) {
    return {anyPart(rng, d),
            {rng.below(2) == 0, {static_cast<std::uint8_t>(rng.below(256)), 20, 30}}};
  }
};
template <>
struct Make<SetParameter> {
  static SetParameter from(Rng& rng, const Document& d) {
    const auto table = paramTable();
    const ParamInfo& info = table[rng.below(static_cast<std::uint32_t>(table.size()))];
    const double room = info.high - info.low;
    return {anyPart(rng, d), std::string(info.key),
            rng.uniform(info.low - 0.1 * room, info.high + 0.1 * room)};
  }
};
template <>
struct Make<RenamePart> {
  static RenamePart from(Rng& rng, const Document& d) {
    return {anyPart(rng, d), std::string(rng.below(300), 'x')};
  }
};
template <>
struct Make<ShowPart> {
  static ShowPart from(Rng& rng, const Document& d) { return {anyPart(rng, d), rng.below(2) == 0}; }
};
template <>
struct Make<DeletePart> {
  static DeletePart from(Rng& rng, const Document& d) { return {anyPart(rng, d)}; }
};
template <>
struct Make<SetHeight> {
  static SetHeight from(Rng& rng, const Document&) { return {{rng.uniform(-10, 12000)}}; }
};
template <>
struct Make<RenameDocument> {
  static RenameDocument from(Rng& rng, const Document&) {
    return {std::string(rng.below(300), 'y')};
  }
};

template <std::size_t... I>
Action makeAction(std::index_sequence<I...>, std::size_t which, Rng& rng, const Document& d) {
  using Maker = Action (*)(Rng&, const Document&);
  constexpr std::array<Maker, sizeof...(I)> makers = {[](Rng& r, const Document& doc) -> Action {
    return Make<std::variant_alternative_t<I, Action>>::from(r, doc);
  }...};
  return makers[which](rng, d);
}

}  // namespace

std::shared_ptr<const image::Picture> ellipsePicture(int width, int height, std::uint64_t seed) {
  auto picture = std::make_shared<image::Picture>();
  picture->width = width;
  picture->height = height;
  picture->working.width = width;
  picture->working.height = height;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const double u = (x + 0.5) / width * 2 - 1, v = (y + 0.5) / height * 2 - 1;
      const bool inside = u * u / 0.64 + v * v / 0.25 < 1;
      const auto tone = static_cast<std::uint8_t>((inside ? 60 : 230) + static_cast<int>(seed % 20));
      for (const std::uint8_t channel : {tone, tone, tone, std::uint8_t{255}}) {
        picture->working.pixels.push_back(channel);
      }
    }
  }
  return picture;
}

std::vector<PicturePoint> randomStroke(Rng& rng, int width, int height) {
  const int count = 2 + static_cast<int>(rng.below(59));
  const double y = rng.uniform(0.35, 0.65) * height, wave = rng.uniform(0, 0.1) * height;
  const double left = rng.uniform(0.1, 0.3) * width, right = rng.uniform(0.6, 0.9) * width;
  std::vector<PicturePoint> stroke;
  for (int i = 0; i < count; ++i) {
    const double t = static_cast<double>(i) / (count - 1);
    stroke.push_back({left + (right - left) * t, y + wave * std::sin(5 * t)});
  }
  return stroke;
}

document::Action randomAction(Rng& rng, const document::Document& document) {
  constexpr std::size_t kActions = std::variant_size_v<Action>;
  // A board without pictures accepts little: fill it first.
  std::size_t which = document.pictures.empty() && rng.below(4) != 0 ? 0 : rng.below(kActions);
  // Removing a whole picture is rare in life, and would keep the random documents small.
  if (std::holds_alternative<RemovePicture>(
          makeAction(std::make_index_sequence<kActions>{}, which, rng, document)) &&
      rng.below(4) != 0) {
    which = 2;
  }
  return makeAction(std::make_index_sequence<kActions>{}, which, rng, document);
}

}  // namespace spineloft::testing
