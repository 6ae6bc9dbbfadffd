// What is thinner than a printer can make because somebody set it so, and can simply be set thicker.
#pragma once

#include <string>
#include <vector>

#include "engine/document/action.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"

namespace spineloft::app {

/// Walls and flat pieces are made this thick, millimetres of the finished model: a round figure above
/// printing::kLeastWall.
inline constexpr double kThickened = 1;

struct Thickening {
  document::Action action;
  std::string what;  ///< "Part 2", "the wall of Solid 1"
};
/// Walls of scooped out solids and flat pieces that are seen and thinner than printing::kLeastWall, those that cut
/// something out left out. `millimetres`: of the finished model a unit of the world.
std::vector<Thickening> thickenings(const document::Document& document, double millimetres);
/// "Part 2, Part 3 and the wall of Solid 1".
std::string spokenList(const std::vector<Thickening>& all);

}  // namespace spineloft::app
