// The members of OneOf, for the one file that compiles them:
//   template struct OneOf<Variant>;
//   template struct Movers<Variant>;
#pragma once

#include <utility>

#include "engine/base/one_of.h"

namespace spineloft {

template <class Variant>
OneOf<Variant>::OneOf() = default;
template <class Variant>
OneOf<Variant>::OneOf(const OneOf&) = default;
template <class Variant>
OneOf<Variant>::OneOf(OneOf&&) noexcept = default;
template <class Variant>
OneOf<Variant>& OneOf<Variant>::operator=(const OneOf&) = default;
template <class Variant>
OneOf<Variant>& OneOf<Variant>::operator=(OneOf&&) noexcept = default;
template <class Variant>
OneOf<Variant>::~OneOf() = default;

template <class Variant>
OneOf<Variant>::OneOf(void* from, Mover mover) {
  mover(*this, from);
}
template <class Variant>
template <class A>
void OneOf<Variant>::moveInto(Variant& to, void* from) {
  to.template emplace<A>(std::move(*static_cast<A*>(from)));
}

/// Has moveInto compiled for every alternative.
template <class Variant>
struct Movers;
template <class... All>
struct Movers<std::variant<All...>> {
  using One = OneOf<std::variant<All...>>;
  static constexpr typename One::Mover kAll[] = {&One::template moveInto<All>...};
};

}  // namespace spineloft
