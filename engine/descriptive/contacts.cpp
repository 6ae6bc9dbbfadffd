#include "engine/descriptive/contacts.h"

#include <algorithm>
#include <vector>

namespace spineloft::descriptive {

void joinContacts(const DepthInput& input, Depths& depths) {
  const Orders& orders = input.orders;
  for (std::uint32_t overlap = 0; overlap < orders.orders.size(); ++overlap) {
    const Order& order = orders.orders[overlap];
    const bool isPlate = input.pieces[order.over].kind != PieceKind::Round;
    if (order.kind != OrderKind::Over || !isPlate || input.pieces[order.under].kind != PieceKind::Round) continue;
    const Patch &over = input.patches[order.over], &under = input.patches[order.under];
    const PieceDepth& plate = depths.pieces[order.over];
    PieceDepth& piece = depths.pieces[order.under];
    struct Hidden {
      std::size_t point = 0;
      double gap = 0, half = 0;
    };
    std::vector<Hidden> rim;
    for (std::size_t i = 0; i < under.mesh().rim(); ++i) {
      const SectionPoint p = under.mesh().points()[i];
      const auto place = over.find(p);
      if (!place || orders.overlaps.at(order.over, order.under, {p.x, -p.y}, 1) != overlap) continue;
      const double half = place->of(plate.back);
      rim.push_back({i, place->of(plate.middle) - half - piece.middle[i], half});
    }
    const auto nearest = std::ranges::min_element(rim, {}, &Hidden::gap);
    if (nearest == rim.end() || nearest->gap > kTouching) continue;
    for (const auto& [point, gap, half] : rim) {
      if (gap < kBridged) piece.front[point] = std::max(piece.front[point], gap + std::min(2 * kGap, half));
    }
  }
}

}  // namespace spineloft::descriptive
