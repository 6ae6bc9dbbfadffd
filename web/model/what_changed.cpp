#include "web/model/what_changed.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <vector>

#include "web/words/words.h"

namespace spineloft::app {
namespace {

using document::Document;
using document::LoftRecipe;
using document::Part;
using document::PictureEntry;
using document::Step;

/// What about a part can change; the first that differs names the step.
struct Aspect {
  const char* what;
  bool (*differs)(const Part&, const Part&);
};

template <auto... Members>
bool loftDiffers(const Part& a, const Part& b) {
  const LoftRecipe *x = document::loftOf(a), *y = document::loftOf(b);
  return x && y && !((x->*Members == y->*Members) && ...);
}
template <auto... Members>
bool lofted(const Part& a, const Part& b) {
  const LoftRecipe *x = document::loftOf(a), *y = document::loftOf(b);
  return x && y && !((x->loft.*Members == y->loft.*Members) && ...);
}
bool regionDiffers(const Part& a, const Part& b) {
  const document::Region *x = document::regionOf(a.recipe), *y = document::regionOf(b.recipe);
  return x && y && !(*x == *y);
}
bool bridgeDiffers(const Part& a, const Part& b) {
  const document::BridgeRecipe *x = document::bridgeOf(a), *y = document::bridgeOf(b);
  return x && y && !(*x == *y);
}
template <auto Member>
bool differs(const Part& a, const Part& b) {
  return !(a.*Member == b.*Member);
}

constexpr std::array kAspects = {
    Aspect{"Line", loftDiffers<&LoftRecipe::stroke>},
    Aspect{"Bone", loftDiffers<&LoftRecipe::pose>},
    Aspect{"Ribs", loftDiffers<&LoftRecipe::edits, &LoftRecipe::ribs, &LoftRecipe::spine>},
    Aspect{"Ignore edges", loftDiffers<&LoftRecipe::ignored>},
    Aspect{"Slice", lofted<&loft::LoftParams::sections>},
    Aspect{"Ends", lofted<&loft::LoftParams::startCap, &loft::LoftParams::endCap>},
    Aspect{
        "Twist and depth",
        lofted<&loft::LoftParams::twist, &loft::LoftParams::squash, &loft::LoftParams::tilt, &loft::LoftParams::bulge>},
    Aspect{"Outline", regionDiffers},
    Aspect{"Bridge", bridgeDiffers},
    Aspect{"Shape", differs<&Part::recipe>},
    Aspect{"Pull", differs<&Part::pulls>},
    Aspect{"Relief", differs<&Part::relief>},
    Aspect{"Colour", differs<&Part::look>},
    Aspect{"Place", differs<&Part::placement>},
    Aspect{"Symmetry", differs<&Part::mirror>},
    Aspect{"Show or hide", differs<&Part::visible>},
    Aspect{"Rename", differs<&Part::name>},
    Aspect{"Group", differs<&Part::group>},
};

/// What is only in one of two lists, and what is in both and differs.
template <class T>
struct Difference {
  std::vector<const T*> added, removed, changed, before;  ///< `before`: what `changed` was
};
template <class T>
Difference<T> differenceOf(const std::vector<Box<T>>& before, const std::vector<Box<T>>& after) {
  Difference<T> out;
  const auto find = [](const std::vector<Box<T>>& list, auto id) {
    return std::ranges::find_if(list, [&](const Box<T>& one) { return one->id == id; });
  };
  for (const Box<T>& old : before) {
    if (find(after, old->id) == after.end()) out.removed.push_back(&*old);
  }
  for (const Box<T>& now : after) {
    const auto old = find(before, now->id);
    if (old == before.end()) {
      out.added.push_back(&*now);
    } else if (!(*old == now)) {
      out.changed.push_back(&*now);
      out.before.push_back(&**old);
    }
  }
  return out;
}

std::string about(const char* what, std::string_view name) {
  return std::string(words::tr("{what} ({name})", {{"what", words::tr(what)}, {"name", name}}));
}
std::string about(const char* what, const std::vector<const Part*>& parts) {
  return about(what,
               parts.size() == 1 ? words::nameOf(parts.front()->name) : words::tr("{n} parts", {{"n", parts.size()}}));
}
template <class T>
std::string about(const char* what, const std::vector<const T*>& all) {
  return about(what, words::nameOf(all.front()->name));
}

std::string ofParts(const Difference<Part>& parts) {
  if (!parts.added.empty()) return about("New part", parts.added);
  if (!parts.removed.empty()) return about("Delete part", parts.removed);
  if (parts.changed.empty()) return {};
  const auto aspect = std::ranges::find_if(
      kAspects, [&](const Aspect& one) { return one.differs(*parts.before.front(), *parts.changed.front()); });
  return about(aspect == kAspects.end() ? "Shape" : aspect->what, parts.changed);
}

std::string ofSteps(const Difference<Step>& steps) {
  if (!steps.added.empty()) return about("Solid", steps.added);
  if (!steps.removed.empty()) return about("Break apart", steps.removed);
  return steps.changed.empty() ? std::string() : about("Solid", steps.changed);
}

/// What is on lines alone: one more that waits, a swap, a depth.
std::string ofDrawings(const Difference<document::Drawing>& drawings) {
  if (drawings.added.empty() && drawings.removed.empty() && drawings.changed.empty()) return {};
  const bool order = !drawings.changed.empty() && drawings.changed.front()->orders != drawings.before.front()->orders;
  return std::string(words::tr(order ? "Swap front and back" : "Lines"));
}

std::string ofPicture(const PictureEntry& before, const PictureEntry& after) {
  const char* what = before.name != after.name         ? "Rename"
                     : before.ignored != after.ignored ? "Ignore edges"
                     : before.view != after.view       ? "Side picture"
                                                       : "Pen";
  return about(what, words::nameOf(after.name));
}

}  // namespace

std::string whatChanged(const Document& before, const Document& after) {
  const Difference<PictureEntry> pictures = differenceOf(before.pictures, after.pictures);
  if (after.pictures.empty() && !before.pictures.empty()) return std::string(words::tr("Empty the board"));
  if (!pictures.added.empty()) return about("Picture", pictures.added);
  if (!pictures.removed.empty()) return about("Remove picture", pictures.removed);
  // A new solid of copies is about the copies; one that lost its last part but one, about the part.
  const Difference<Part> parts = differenceOf(before.parts, after.parts);
  const bool only = parts.added.empty() && parts.removed.empty();
  if (std::string steps = only ? ofSteps(differenceOf(before.steps, after.steps)) : std::string(); !steps.empty()) {
    return steps;
  }
  if (std::string part = ofParts(parts); !part.empty()) return part;
  if (std::string lines = ofDrawings(differenceOf(before.drawings, after.drawings)); !lines.empty()) return lines;
  if (!pictures.changed.empty()) return ofPicture(*pictures.before.front(), *pictures.changed.front());
  if (before.groups != after.groups) return std::string(words::tr("Group"));
  if (!(before.height == after.height)) return std::string(words::tr("Size"));
  if (before.name != after.name) return std::string(words::tr("Rename model"));
  return before == after ? std::string() : std::string(words::tr("Move in the list"));
}

}  // namespace spineloft::app
