// Typed cache keys: hashes (Hasher) of everything that a value is made from. Zero is "none".
#pragma once

#include <compare>
#include <cstdint>

namespace spineloft {

/// Equal keys, equal values. Keys of different kinds of values are different types, so that none is looked up in the
/// cache of another.
template <class Tag>
struct CacheKey {
  std::uint64_t hash = 0;
  explicit operator bool() const { return hash != 0; }
  auto operator<=>(const CacheKey&) const = default;
};

using IgnoredKey = CacheKey<struct IgnoredKeyTag>;    ///< of ignored edges
using TraceKey = CacheKey<struct TraceKeyTag>;        ///< of spine and generated ribs
using InteriorKey = CacheKey<struct InteriorKeyTag>;  ///< of the skeleton and the fields of a puff
using DrawingKey = CacheKey<struct DrawingKeyTag>;    ///< of a line drawing with its pieces, solved
using ShapeKey = CacheKey<struct ShapeKeyTag>;        ///< of a part's mesh
using ReachKey = CacheKey<struct ReachKeyTag>;        ///< of what a pull reaches on a shape
using HeightsKey = CacheKey<struct HeightsKeyTag>;    ///< of what a relief finds on a shape
using RaisedKey = CacheKey<struct RaisedKeyTag>;      ///< of what its mesh is raised by
using TextureKey = CacheKey<struct TextureKeyTag>;    ///< of a part's texture
using SolidKey = CacheKey<struct SolidKeyTag>;        ///< of what the solver makes

}  // namespace spineloft
