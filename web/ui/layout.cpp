#include "web/ui/layout.h"

#include <algorithm>
#include <cmath>

#include "web/ui/views.h"

namespace spineloft::app {

namespace {

/// A strip below the views of a phone on its side would have room for one row.
constexpr double kLeastForStrip = 400;

bool isStrip(double width, double height) {
  const bool stacked = width < kStackedWidth && height >= kLowShape * width;
  return width < kPanelWidthFrom && (stacked || height >= kLeastForStrip);
}

double panelWidth(double width) { return width < kPanelWidthFrom ? kLowPanelWidth : kPanelWidth; }

}  // namespace

Layout layoutFor(double width, double height, double share, bool hasPanel) {
  share = std::clamp(share, kMinShare, kMaxShare);
  Layout out;
  out.stacked = width < kStackedWidth && height >= kLowShape * width;
  out.strip = isStrip(width, height);
  Rect views{0, 0, width, height};
  if (hasPanel && out.strip) {
    const double full = width >= kFlatStripFrom ? kFlatStripHeight : kStripHeight;
    const double strip = std::min(full, std::floor(height * 0.3));
    views.height = height - strip;
    out.panel = {0, views.height, width, strip};
  } else if (hasPanel) {
    views.width = width - panelWidth(width);
    out.panel = {views.width, 0, panelWidth(width), height};
  }
  const double length = out.stacked ? views.height : views.width;
  const double first = std::round((length - kSplitter) * share);
  const double second = std::max(0.0, length - kSplitter - first);
  if (out.stacked) {
    out.picture = {0, 0, views.width, first};
    out.splitter = {0, first, views.width, kSplitter};
    out.solid = {0, first + kSplitter, views.width, second};
  } else {
    out.picture = {0, 0, first, views.height};
    out.splitter = {first, 0, kSplitter, views.height};
    out.solid = {first + kSplitter, 0, second, views.height};
  }
  return out;
}

void reservePictures(Layout& layout) {
  Rect& view = layout.picture;
  if (buttonsAtSide(view)) {
    const double width = std::min(kPicturesStrip, view.width);
    layout.pictures = {view.x, view.y, width, view.height};
    view = {view.x + width, view.y, view.width - width, view.height};
  } else {
    const double height = std::min(kPicturesStrip, view.height);
    layout.pictures = {view.x, view.y, view.width, height};
    view = {view.x, view.y + height, view.width, view.height - height};
  }
}

Layout layoutWithBoard(double width, double height) {
  constexpr double kTallShare = 0.27, kWideShare = 0.58;  // of the solid above, of the board beside
  Layout out;
  out.stacked = width < kStackedWidth && height >= kLowShape * width;
  out.strip = isStrip(width, height);
  if (out.stacked) {
    const double solid = std::floor(height * kTallShare);
    out.solid = {0, 0, width, solid};
    out.picture = {0, solid, width, height - solid};
    return out;
  }
  double views = width;
  if (!out.strip) {
    views -= panelWidth(width);
    out.panel = {views, 0, panelWidth(width), height};
  }
  const double board = std::floor(views * kWideShare);
  out.picture = {0, 0, board, height};
  out.solid = {board, 0, views - board, height};
  return out;
}

Rect clearOf(Rect words, std::span<const Rect> taken, double gap, Toward way) {
  constexpr double kRounding = 1e-6;
  // Whatever is passed once is behind it for good: an end is reached.
  for (bool moved = true; moved;) {
    moved = false;
    for (const Rect& one : taken) {
      const double near = gap - kRounding;
      if (!words.meets({one.x - near, one.y - near, one.width + 2 * near, one.height + 2 * near})) continue;
      words.y = way == Toward::Head ? one.y - gap - words.height : one.bottom() + gap;
      moved = true;
    }
  }
  return words;
}

Rect roomBeside(Rect view, std::span<const Rect> taken) {
  const Rect whole = view;
  for (const Rect& one : taken) {
    const bool covers =
        one.x <= whole.x && one.y <= whole.y && one.right() >= whole.right() && one.bottom() >= whole.bottom();
    if (covers || !view.meets(one)) continue;
    const Rect sides[] = {{view.x, view.y, view.width, one.y - view.y},
                          {view.x, one.bottom(), view.width, view.bottom() - one.bottom()},
                          {view.x, view.y, one.x - view.x, view.height},
                          {one.right(), view.y, view.right() - one.right(), view.height}};
    const auto area = [](const Rect& side) { return std::max(0.0, side.width) * std::max(0.0, side.height); };
    view = *std::ranges::max_element(sides, {}, area);
    view.width = std::max(0.0, view.width);
    view.height = std::max(0.0, view.height);
  }
  return view;
}

double shareAt(const Layout& layout, ClientPoint at) {
  // The strip of pictures counts with the picture view, wherever it is cut off.
  const double length =
      layout.stacked ? layout.picture.bottom() + layout.solid.height : layout.picture.right() + layout.solid.width;
  const double first = (layout.stacked ? at.y : at.x) - kSplitter / 2;
  return length > 0 ? std::clamp(first / length, kMinShare, kMaxShare) : 0.5;
}

}  // namespace spineloft::app
