// Typed ids. An id survives save, load and undo; zero is "none"; ids are never reused in a document.
#pragma once

#include <compare>
#include <cstdint>

namespace spineloft {

template <class Tag>
struct Id {
  std::uint32_t value = 0;
  explicit operator bool() const { return value != 0; }
  auto operator<=>(const Id&) const = default;
};

using PartId = Id<struct PartTag>;
using PictureId = Id<struct PictureTag>;
using StepId = Id<struct StepTag>;
using GroupId = Id<struct GroupTag>;
using DrawingId = Id<struct DrawingTag>;
using LineId = Id<struct LineTag>;  ///< of a line in its drawing

}  // namespace spineloft
