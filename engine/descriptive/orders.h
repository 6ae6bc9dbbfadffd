// Who is in front of whom, at every place where pieces overlap, from what is seen and what is hidden.
#pragma once

#include <span>
#include <vector>

#include "engine/descriptive/overlaps.h"

namespace spineloft::descriptive {

enum class OrderKind : std::uint8_t {
  Over,   ///< one is wholly in front of the other there
  Inside  ///< the outline of `under` goes into `over` there: seen before it, hidden within it
};
enum class OrderFrom : std::uint8_t {
  Drawn,    ///< a line says so
  Deduced,  ///< it follows from lines
  Guessed,  ///< nothing says; the choice that hides the shorter outlines
  User      ///< given
};

/// Of one overlap.
struct Order {
  std::uint32_t over = 0, under = 0;  ///< pieces
  OrderKind kind = OrderKind::Over;
  OrderFrom from = OrderFrom::Guessed;
  bool operator==(const Order&) const = default;
};

/// A part of an outline between places where it crosses others, or where it changes its type away from them.
struct OrderedStretch {
  std::uint32_t piece = 0, outline = 0;
  double from = 0, to = 0;           ///< pixels along the outline from its first point; to > length goes round
  bool hidden = false;               ///< as drawn, changes near crossings put there
  std::vector<std::uint32_t> cover;  ///< pieces round it
  std::vector<std::uint32_t> at;     ///< the overlap with each of them
  bool isVague = false;              ///< it runs along the edge of another piece, which may be round it or not
  bool dips = false;                 ///< hidden, and becomes so away from crossings
  double index = 0;                  ///< pieces in front of it, and ½ when it is inside one (paper, 5.3)
};

/// What lines say and cannot be.
struct Contradiction {
  std::vector<std::uint32_t> pieces;  ///< that say it, growing: no smaller set does
  PicturePoint at;                    ///< the line that is not obeyed
};

struct Orders {
  Overlaps overlaps;
  std::vector<Order> orders;  ///< one an overlap
  std::vector<OrderedStretch> stretches;
  std::vector<Contradiction> contradictions;
  std::vector<std::uint32_t> unexplained;  ///< stretches that are hidden with nothing in front of them
};

/// One order an overlap (local layering): the same two pieces may pass each other differently elsewhere. A seen stretch
/// is in front of all pieces round it; a hidden one is behind at least one of them; one that becomes hidden away from
/// crossings goes into the frontmost of them. Where three pieces overlap in one place, their order has no cycle. All of
/// it by unit propagation and search (order_search.h); a clause weighs the length of its stretch, a given order more
/// than all lines; of several for one overlap the last one counts. Guesses put that piece in front which has more of
/// its outline within the overlap, else the later one. `size`: of the drawing, pixels, > 0. Cost: edges squared by
/// pairs of pieces whose bounds overlap, and cells.
Orders ordersOf(std::span<const Sheet> sheets, std::span<const GivenOrder> given, double size);

}  // namespace spineloft::descriptive
