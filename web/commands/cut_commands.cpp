// Commands about cutting things out of the picture.
#include <algorithm>
#include <array>
#include <cmath>

#include "engine/geometry/region.h"
#include "engine/geometry/triangulate.h"
#include "web/commands/command_actions.h"
#include "web/commands/command_args.h"
#include "web/commands/command_groups.h"
#include "web/commands/intents.h"
#include "web/commands/modes.h"
#include "web/edit/preview.h"
#include "web/model/messages.h"

namespace spineloft::app {
namespace {

using Env = const CommandEnv&;

bool hasPicture(Env env) { return !env.studio.document().pictures.empty(); }
bool hasDraft(Env env) { return env.ui.cut.has_value(); }
bool hasShape(Env env) { return hasDraft(env) && !env.ui.cut->shape.contours.empty() && !env.ui.cut->searching; }
bool adds(Env env) { return hasDraft(env) && env.ui.cut->adding; }
bool removes(Env env) { return hasDraft(env) && !env.ui.cut->adding; }
template <CutBy kWay>
bool cutsBy(Env env) {
  return env.ui.cutBy == kWay;
}

/// The draft becomes a part, or the region of one. It stays when it cannot.
Outcome take(Env env) {
  const CutDraft& draft = *env.ui.cut;
  const document::Region region{draft.picture, draft.shape.contours, 0};
  const document::RegionSolid solid =
      draft.into == CutInto::Sheet ? document::RegionSolid(env.ui.extrude) : document::RegionSolid(env.ui.inflate);
  if (!draft.atOnce) sendStatus(env.host, {});  // before what was made is told
  Outcome done = draft.into == CutInto::Shape ? shapeOfThing(env, draft.part, region.contours)
                 : draft.part                 ? redrawRegion(env, draft.part, region)
                                              : drawRegion(env, region, solid, true);
  if (!done) return done;
  env.ui.cut.reset();
  return {};
}

/// What a search found is shown; where it found nothing everything is as before it.
void settleSearch(Env env, Result<CutShape> found) {
  if (!env.ui.cut) return;
  CutDraft& draft = *env.ui.cut;
  draft.searching = false;
  if (!found) {
    if (found.error() != Error::Cancelled) sendError(env.host, spokenFailure(found.failure()));
    if (draft.shape.contours.empty()) {
      env.ui.cut.reset();
      return;
    }
    draft.hints.marks.resize(std::min(draft.hints.marks.size(), draft.shownMarks));
    return;
  }
  draft.shape = std::move(found).value();
  draft.shownMarks = draft.hints.marks.size();
  if (!draft.atOnce) return;
  if (const Outcome done = take(env); !done) {
    sendError(env.host, done.refusal().sentence);
    env.ui.cut.reset();
  }
}

void search(Env env) {
  CutDraft& draft = *env.ui.cut;
  draft.searching = true;
  // Studio, UiState and Host live as long as the page.
  const Status begun = env.studio.cutOut(
      draft.picture, draft.hints, [&studio = env.studio, &ui = env.ui, &host = env.host](Result<CutShape> found) {
        settleSearch({studio, ui, host}, std::move(found));
      });
  if (!begun) settleSearch(env, begun.failure());
}

/// Points along a hint line, or a single point.
std::vector<PicturePoint> hintsOf(const Json& args, std::string_view key) {
  if (auto line = strokeOf(args, key)) return *line;
  if (const auto point = pointOf(args, key)) return {*point};
  return {};
}

bool onPicture(PicturePoint p, image::Size size) {
  return p.x >= -0.5 && p.y >= -0.5 && p.x <= size.width - 0.5 && p.y <= size.height - 0.5;
}

bool allFinite(const std::vector<PicturePoint>& points) {
  return std::ranges::all_of(points, [](PicturePoint p) { return isFinite(p); });
}

/// Where the arguments say that the thing is.
vision::CutHints hintsFrom(const Json& args) {
  vision::CutHints hints;
  if (const auto at = pointOf(args, "at")) hints.inside.push_back(*at);
  for (const PicturePoint p : hintsOf(args, "inside")) hints.inside.push_back(p);
  hints.outside = hintsOf(args, "outside");
  if (const auto box = strokeOf(args, "box"); box && box->size() == 2) hints.box = {(*box)[0], (*box)[1]};
  return hints;
}

/// With a box of any two corners put in order. Errors: ValueOutOfRange, RegionOutside and RegionEmpty for a box.
Result<vision::CutHints> checkedHints(vision::CutHints hints, image::Size size) {
  const bool there =
      hints.inside.empty() || std::ranges::any_of(hints.inside, [&](PicturePoint p) { return onPicture(p, size); });
  if (!allFinite(hints.inside)) return {Error::ValueOutOfRange, "hint"};
  if (!there) return Error::RegionOutside;
  if (hints.box) {
    const auto [a, b] = *hints.box;
    if (!isFinite(a) || !isFinite(b)) return {Error::ValueOutOfRange, "box"};
    hints.box = {{std::min(a.x, b.x), std::min(a.y, b.y)}, {std::max(a.x, b.x), std::max(a.y, b.y)}};
    const auto& [low, high] = *hints.box;
    const bool beside = high.x < 0 || high.y < 0 || low.x > size.width - 1 || low.y > size.height - 1;
    if (beside) return Error::RegionOutside;
    if (high.x - low.x < 1 || high.y - low.y < 1) return Error::RegionEmpty;
  }
  return hints;
}

Outcome outside() {
  return Refusal{"RegionOutside", "That lies outside the picture. Tap or draw on the thing in the picture."};
}

/// What the tool in hand makes of a thing.
CutInto usualInto(Env env) { return env.ui.tool == ToolKind::Extrude ? CutInto::Sheet : CutInto::Puff; }

/// What is to be cut out, and what becomes of it.
struct Begin {
  vision::CutHints hints;
  PartId part;  ///< receives the outline; none: a new part
  CutInto into = CutInto::Puff;
  bool atOnce = false;
};

Outcome begin(Env env, Begin wanted) {
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), env.ui.picture);
  if (entry == nullptr) return refuse({Error::NoSuchPicture, {}});
  Result<vision::CutHints> hints = checkedHints(std::move(wanted.hints), entry->size);
  if (!hints && hints.error() == Error::RegionOutside) return outside();
  if (!hints) return refuse(hints.failure());
  if (hints.value().inside.empty() && !hints.value().box) {
    return missing("where the thing is: at, inside, or a box");
  }
  if (wanted.part) {
    const document::Part* part = document::findPart(env.studio.document(), wanted.part);
    if (part == nullptr) return noPart();
    const bool shape = wanted.into == CutInto::Shape;
    if (shape && !document::shapeOf(*part)) return refuse({Error::NotAShape, {}});
    if (!shape && !document::regionOf(part->recipe)) return refuse({Error::NotARegion, {}});
  }
  closeCut(env);
  CutDraft& draft = env.ui.cut.emplace();
  draft.part = wanted.part;
  draft.picture = entry->id;
  draft.selected = env.ui.selection;
  draft.hints = std::move(hints).value();
  draft.atOnce = wanted.atOnce;
  draft.into = wanted.into;
  search(env);
  return {};
}

/// Begins to show what is cut out, for marks to correct.
Outcome show(Env env, Begin wanted) {
  if (Outcome done = begin(env, std::move(wanted)); !done) return done;
  if (!cutsOut(env.ui.tool)) env.ui.tool = ToolKind::Inflate;
  sendStatus(env.host, "Draw over what is missing; with \"Take away\" over what is too much. Then \"Use this\".");
  return {};
}

/// None: the part that is named is not there.
std::optional<Begin> beginOf(Env env, const Json& args, bool atOnce) {
  Begin wanted{hintsFrom(args), {}, usualInto(env), atOnce};
  if (namesPart(args)) {
    const document::Part* part = partOf(env, args);
    if (part == nullptr) return std::nullopt;
    wanted.part = part->id;
  }
  if (const std::string* as = args.text("as")) {
    wanted.into = *as == "sheet" ? CutInto::Sheet : *as == "shape" ? CutInto::Shape : CutInto::Puff;
  }
  return wanted;
}

Outcome cutOut(Env env, const Json& args) {
  std::optional<Begin> wanted = beginOf(env, args, true);
  return wanted ? begin(env, std::move(*wanted)) : noPart();
}

Outcome cutStart(Env env, const Json& args) {
  std::optional<Begin> wanted = beginOf(env, args, false);
  return wanted ? show(env, std::move(*wanted)) : noPart();
}

Outcome mark(Env env, vision::CutMark mark) {
  CutDraft& draft = *env.ui.cut;
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), draft.picture);
  if (entry == nullptr) return refuse({Error::NoSuchPicture, {}});
  const double side = std::max(entry->size.width, entry->size.height);
  if (!allFinite(mark.line) || !(mark.radius >= 0 && mark.radius <= side)) {
    return refuse({Error::ValueOutOfRange, "line"});
  }
  const bool there = std::ranges::any_of(mark.line, [&](PicturePoint p) { return onPicture(p, entry->size); });
  if (!there) return outside();
  draft.hints.marks.push_back(std::move(mark));
  draft.undone.clear();
  search(env);
  return {};
}

Outcome cutMark(Env env, const Json& args) {
  const CutDraft& draft = *env.ui.cut;
  const auto line = strokeOf(args, "line");
  if (!line || line->empty()) return missing("a line: a list of [x, y] picture pixels");
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), draft.picture);
  const double side = entry ? std::max(entry->size.width, entry->size.height) : 0;
  return mark(env, {*line, args.number("radius").value_or(0.012 * side), args.flag("inside").value_or(draft.adding)});
}

template <bool kAdding>
Outcome setBrush(Env env, const Json&) {
  env.ui.cut->adding = kAdding;
  return {};
}

Outcome cutUse(Env env, const Json&) { return take(env); }

Outcome cutCancel(Env env, const Json&) {
  closeCut(env);
  return {};
}

/// Without a mark it leaves the cut-out.
Outcome undoMark(Env env, const Json& args) {
  CutDraft& draft = *env.ui.cut;
  if (draft.hints.marks.empty()) return cutCancel(env, args);
  draft.undone.push_back(std::move(draft.hints.marks.back()));
  draft.hints.marks.pop_back();
  search(env);
  sendStatus(env.host, words::tr("Undone: {what}.", {{"what", words::tr("Mark")}}));
  return {};
}

Outcome redoMark(Env env, const Json&) {
  CutDraft& draft = *env.ui.cut;
  draft.hints.marks.push_back(std::move(draft.undone.back()));
  draft.undone.pop_back();
  search(env);
  sendStatus(env.host, words::tr("Done again: {what}.", {{"what", words::tr("Mark")}}));
  return {};
}
bool canRedo(Env env) { return hasDraft(env) && !env.ui.cut->undone.empty(); }

template <CutBy kWay>
Outcome cutBy(Env env, const Json& args) {
  env.ui.cutBy = args.flag("on").value_or(env.ui.cutBy != kWay) ? kWay : CutBy::Outline;
  if (!cutsOut(env.ui.tool)) env.ui.tool = ToolKind::Inflate;
  env.ui.redraw = {};
  env.ui.focus = Focus::Picture;
  if (env.ui.cutBy == CutBy::Box) sendStatus(env.host, "Drag a box round the thing: it is cut out.");
  if (env.ui.cutBy == CutBy::Scribble)
    sendStatus(env.host, "Scribble over the thing, over all its colours: it is cut out.");
  return {};
}

constexpr Argument kAt{"at"}, kLine{"line"};

// clang-format off
constexpr std::array kTable = {
    Command{.id = "cut-by-box", .label = "Box", .icon = "square-dashed", .group = "tool",
            .hint = "Drag a box round a thing: it is cut out of the picture", .enabled = hasPicture,
            .toggled = cutsBy<CutBy::Box>, .run = cutBy<CutBy::Box>},
    Command{.id = "cut-by-scribble", .label = "Scribble", .icon = "highlighter", .group = "tool",
            .hint = "Scribble over a thing: it is cut out of the picture", .enabled = hasPicture,
            .toggled = cutsBy<CutBy::Scribble>, .run = cutBy<CutBy::Scribble>},
    Command{.id = "cut-add", .label = "Add", .icon = "brush", .group = "part",
            .hint = "Draw over what belongs to the thing", .enabled = hasDraft, .toggled = adds, .run = setBrush<true>},
    Command{.id = "cut-remove", .label = "Take away", .icon = "eraser", .group = "part",
            .hint = "Draw over what does not belong to the thing", .enabled = hasDraft, .toggled = removes,
            .run = setBrush<false>},
    Command{.id = "cut-use", .label = "Use this", .icon = "check", .shortcut = "Enter", .group = "part",
            .hint = "What is tinted becomes the part", .enabled = hasShape, .run = cutUse, .mode = &kCutMode},
    Command{.id = "cut-cancel", .label = "Not this", .icon = "x", .group = "part",
            .hint = "Leaves everything as it was", .enabled = hasDraft, .run = cutCancel},
    Command{.id = "cut-out", .label = "Cut out by a point", .icon = "lasso", .group = "part", .argument = kAt,
            .hint = "A point on the thing, or a box round it", .enabled = hasPicture, .run = cutOut},
    Command{.id = "cut-start", .label = "Show a cut-out by a point", .icon = "lasso", .group = "part", .argument = kAt,
            .hint = "The same, shown before it is used", .enabled = hasPicture, .run = cutStart},
    Command{.id = "cut-mark", .label = "Correct a cut-out by numbers", .icon = "brush", .group = "part",
            .argument = kLine, .hint = "A line in picture pixels, inside or not", .enabled = hasDraft, .run = cutMark},
};
// clang-format on

}  // namespace

CutShape filledShape(vision::CutContours contours, image::Size picture) {
  CutShape shape;
  const auto clean =
      geometry::cleanRegion(contours, 0, {static_cast<double>(picture.width), static_cast<double>(picture.height)});
  shape.contours = std::move(contours);
  if (!clean) return shape;
  const geometry::PlaneRegion region = geometry::planeRegion(clean.value());
  for (const auto& t : geometry::triangulate(region.points, region.sizes)) {
    const auto at = [&](std::size_t corner) {
      const SectionPoint p = region.points[t[corner]];
      return PicturePoint{p.x, -p.y};
    };
    shape.fill.push_back({at(0), at(1), at(2)});
  }
  return shape;
}

Outcome startCutOut(Env env, const vision::CutHints& hints, PartId part) {
  return show(env, {hints, part, usualInto(env), false});
}

Outcome fitShape(Env env, PicturePoint at, PartId part) {
  return begin(env, {vision::CutHints{{at}, {}, {}, {}}, part, CutInto::Shape, true});
}

Outcome markCutOut(Env env, const std::vector<PicturePoint>& line, double radius) {
  if (!env.ui.cut) return Refusal{"NotNow", "Nothing is being cut out."};
  return mark(env, {line, radius, env.ui.cut->adding});
}

void closeCut(const CommandEnv& env) {
  if (!env.ui.cut) return;
  env.studio.stopCutOut();
  env.ui.cut.reset();
  sendStatus(env.host, {});
}

void settleCut(const CommandEnv& env) {
  if (!env.ui.cut) return;
  const CutDraft& draft = *env.ui.cut;
  const document::Document& document = env.studio.document();
  const bool gone =
      !document::findPicture(document, draft.picture) || (draft.part && !document::findPart(document, draft.part));
  if (gone) return closeCut(env);
  if ((draft.atOnce && draft.searching) || (env.hand != nullptr && env.hand->holds())) return;
  const bool isBoard = env.ui.sections.board.has_value();
  if (cutsOut(env.ui.tool) && env.ui.picture == draft.picture && !isBoard) return;
  if (draft.shape.contours.empty()) return closeCut(env);
  // Who goes on to other work has not said no to what is shown: one step of undo takes it back.
  if (draft.searching) {
    env.ui.cut->atOnce = true;
    return;
  }
  const PartId selected = env.ui.selection;
  const bool goesOn = isBoard || (static_cast<bool>(selected) && selected != draft.selected);
  if (const Outcome done = take(env); !done) {
    sendError(env.host, done.refusal().sentence);
    return closeCut(env);
  }
  if (goesOn) env.ui.selection = selected;
}

constinit const Mode kCutMode{"cut-out", hasDraft, closeCut, undoMark, redoMark, hasDraft, canRedo};

std::span<const Command> cutCommands() { return kTable; }

}  // namespace spineloft::app
