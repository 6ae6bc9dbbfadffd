// Drawing on paper: what the pen is set to, the ink in hand, and what is said about a sketch.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/document/document.h"

namespace spineloft::app {

struct UiState;

/// Radii at full pressure, in picture pixels, from fine to bold.
inline constexpr std::array kPenRadii = {1.6, 3.0, 6.5};
inline constexpr std::array kEraserRadii = {8.0, 18.0, 40.0};
inline constexpr std::array<std::string_view, 3> kPenSizes = {"fine", "medium", "bold"};

struct Ink {
  std::string_view value, label;  ///< "#rrggbb" and a word
  std::array<std::uint8_t, 3> colour;
};
inline constexpr std::array kInks = {
    Ink{"#1f2430", "Ink", {31, 36, 48}},     Ink{"#c8431d", "Red", {200, 67, 29}},
    Ink{"#d98a00", "Orange", {217, 138, 0}}, Ink{"#1f7a3f", "Green", {31, 122, 63}},
    Ink{"#2457d6", "Blue", {36, 87, 214}},
};

/// The card of pen sizes, of colours or of both that is open where there is no room for them beside the pen.
enum class PenMenu : std::uint8_t { None, Size, Colour, Both };

struct Sketching {
  std::size_t penSize = 1, eraserSize = 1;  ///< of kPenSizes
  std::array<std::uint8_t, 3> colour = kInks[0].colour;
  std::optional<image::SketchStroke> stroke;  ///< under the pen now
  PenMenu menu = PenMenu::None;
};

/// The sketch in the picture view; null when a photo is there, or nothing.
const document::PictureEntry* shownSketch(const document::Document& document, const UiState& ui);
/// The size that the tool in hand draws or erases with, of kPenSizes.
std::size_t& sizeInHand(UiState& ui);
/// Pen and eraser are for paper: on a photo the line through it is drawn instead.
void settleSketching(const document::Document& document, UiState& ui);
/// A line that comes back to about where it began.
bool closesOutline(std::span<const PicturePoint> line);
/// Something is drawn that a spine could go through: a line that comes back to where it began, or two
/// lines that are there to stay.
bool looksFinished(const document::PictureEntry& sketch);

}  // namespace spineloft::app
