// What stays as it is from frame to frame need not be drawn each time: a picture of it, drawn once, stands for it.
#pragma once

#include <algorithm>
#include <iterator>
#include <span>
#include <vector>

namespace spineloft::gl {

/// Which things of a frame a picture stands for, and which are drawn besides.
template <class Item>
class KeptItems {
 public:
  /// The things of this frame; `alike`: they are seen as in the frame before. Every frame is told, in order.
  void follow(std::span<const Item> items, bool alike) {
    kept_.clear();
    if (alike) std::ranges::copy_if(items, std::back_inserter(kept_), isIn(before_));
    if (!alike) picture_.clear();
    before_.assign(items.begin(), items.end());
  }
  /// The picture would have to be of another size. What stays is known.
  void dropPicture() { picture_.clear(); }
  /// Shares the frame's things out. True when the picture is to be drawn: of `picture()`.
  bool share() {
    const bool serves =
        !picture_.empty() && 2 * picture_.size() >= kept_.size() && std::ranges::all_of(picture_, isIn(before_));
    if (!serves) picture_ = kept_;
    others_.clear();
    std::ranges::copy_if(before_, std::back_inserter(others_), [&](const Item& item) { return !isIn(picture_)(item); });
    return !serves && !picture_.empty();
  }
  const std::vector<Item>& picture() const { return picture_; }
  const std::vector<Item>& others() const { return others_; }
  /// There is no picture any more.
  void forget() {
    before_.clear();
    picture_.clear();
  }

 private:
  static auto isIn(const std::vector<Item>& items) {
    return [&items](const Item& item) { return std::ranges::find(items, item) != items.end(); };
  }
  std::vector<Item> before_, kept_, picture_, others_;
};

}  // namespace spineloft::gl
