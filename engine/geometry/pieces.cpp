#include "engine/geometry/pieces.h"

#include <cmath>
#include <span>

#include "engine/geometry/polygon.h"

namespace spineloft::geometry {

std::vector<Contours> piecesOf(const Contours& contours) {
  std::vector<double> areas;  // y is down: outer outlines are negative
  for (const auto& contour : contours) areas.push_back(signedArea(std::span<const PicturePoint>(contour)));
  std::vector<Contours> pieces;
  std::vector<std::size_t> piece(contours.size());
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (areas[i] >= 0) continue;
    piece[i] = pieces.size();
    pieces.push_back({contours[i]});
  }
  for (std::size_t i = 0; i < contours.size(); ++i) {
    if (areas[i] < 0) continue;
    std::size_t around = contours.size();
    for (std::size_t k = 0; k < contours.size(); ++k) {
      if (areas[k] >= 0 || -areas[k] < areas[i]) continue;
      if (around < contours.size() && areas[k] < areas[around]) continue;
      if (holds(std::span<const PicturePoint>(contours[k]), contours[i].front())) around = k;
    }
    if (around < contours.size()) pieces[piece[around]].push_back(contours[i]);
  }
  return pieces;
}

}  // namespace spineloft::geometry
