// A variant with many alternatives. How one is copied, moved and destroyed is compiled in one file (one_of_members.h):
// with fifty of them every file that has one would take seconds longer.
#pragma once

#include <concepts>
#include <variant>

namespace spineloft {

template <class A, class Variant>
inline constexpr bool isAlternativeOf = false;
template <class A, class... All>
inline constexpr bool isAlternativeOf<A, std::variant<All...>> = (std::same_as<A, All> || ...);

/// Behaves as `Variant` does; std::visit, std::get_if and so on take it. `extern template struct OneOf<Variant>`
/// belongs behind it.
template <class Variant>
struct OneOf : Variant {
  OneOf();
  template <class A>
    requires isAlternativeOf<A, Variant>
  OneOf(A one) : OneOf(&one, &moveInto<A>) {}
  OneOf(const OneOf& other);
  OneOf(OneOf&& other) noexcept;
  OneOf& operator=(const OneOf& other);
  OneOf& operator=(OneOf&& other) noexcept;
  ~OneOf();

 private:
  using Mover = void (*)(Variant& to, void* from);
  OneOf(void* from, Mover mover);
  template <class A>
  static void moveInto(Variant& to, void* from);
  template <class>
  friend struct Movers;
};

}  // namespace spineloft
