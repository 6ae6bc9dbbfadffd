// What is drawn over the picture: outlines of all parts, spine and ribs of the selected one, and what the
// tool in use would do.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/geometry/polyline.h"
#include "engine/ribs/edit/places.h"
#include "web/edit/editing.h"
#include "web/edit/outline.h"
#include "web/edit/preview.h"
#include "web/edit/region_editing.h"
#include "web/edit/spinning.h"
#include "web/panels/draw_lines.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"

namespace spineloft::panels {
namespace {

constexpr double kRibSpacing = 5;  // CSS pixels: nearer ribs are left out of the drawing

/// The ribs of one part as they are drawn.
struct RibStyle {
  const ribs::RibSet& set;
  bool grabbable = false;  ///< their ends are there to be dragged
};

bool editsRibs(app::ToolKind tool) { return tool == app::ToolKind::Ribs || tool == app::ToolKind::Shape; }

/// Tools that work on the ribs show them where they were found, others where the part stands.
const ribs::RibSet& ribsOf(const app::UiState& ui, const pipeline::PartShape& shape) {
  const bool traced = editsRibs(ui.tool) || ui.tool == app::ToolKind::Ignore;
  return traced ? shape.ribs : shape.shown;
}

void ribEnd(ImDrawList& list, ImVec2 at, ribs::RibState state, float scale) {
  const Pen pen = ribPen(state);
  list.AddCircleFilled(at, 2.6f * scale, kHalo, 12);
  if (state == ribs::RibState::Edge || state == ribs::RibState::Edited) {
    list.AddCircleFilled(at, 1.9f * scale, pen.colour, 12);
  } else if (state == ribs::RibState::Locked) {
    const float r = 2.3f * scale;
    list.AddRectFilled({at.x - r, at.y - r}, {at.x + r, at.y + r}, pen.colour, 1);
  } else {
    list.AddCircle(at, 2.2f * scale, pen.colour, 12, 1.1f);
  }
}

std::size_t ribStep(const app::UiState& ui, const ribs::RibSet& set) {
  const double spacing = distance(set.ribs[0].center, set.ribs[1].center) * ui.pictureView.zoom;
  return static_cast<std::size_t>(std::clamp(std::ceil(kRibSpacing / std::max(spacing, 1e-3)), 1.0, 64.0));
}

void drawRibs(ImDrawList& list, const app::UiState& ui, const RibStyle& look) {
  const ribs::RibSet& set = look.set;
  if (set.ribs.size() < 2) return;
  const std::size_t step = ribStep(ui, set);
  const float scale = look.grabbable ? 1.45f : 1.f;
  for (int pass = 0; pass < 2; ++pass) {
    for (std::size_t i = 0; i < set.ribs.size(); ++i) {
      const ribs::Rib& rib = set.ribs[i];
      const bool byHand = rib.leftState >= ribs::RibState::Edited || rib.rightState >= ribs::RibState::Edited;
      if (i % step != 0 && !byHand) continue;
      const ImVec2 centre = onCanvas(ui, rib.center);
      const ImVec2 left = onCanvas(ui, rib.left), right = onCanvas(ui, rib.right);
      if (pass == 0) {
        styledLine(list, centre, left, ribPen(rib.leftState));
        styledLine(list, centre, right, ribPen(rib.rightState));
      } else {
        ribEnd(list, left, rib.leftState, scale);
        ribEnd(list, right, rib.rightState, scale);
      }
    }
  }
}

void drawSpine(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> points) {
  if (points.empty()) return;
  picturePolyline(list, ui, points, {faded(kHalo, 235), 7.f, LineStyle::Solid});
  picturePolyline(list, ui, points, {kSpine, 3.f, LineStyle::Solid});
  for (const PicturePoint end : {points.front(), points.back()}) {
    list.AddCircleFilled(onCanvas(ui, end), 5.f, kHalo, 20);
    list.AddCircleFilled(onCanvas(ui, end), 3.6f, kSpine, 20);
  }
}

void outlineStroke(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> outline, bool selected,
                   bool lit) {
  // Widths of whole pixels, which Dear ImGui draws with a third of the triangles.
  const float halo = selected ? 5.f : lit ? 6.f : 4.f;
  const float width = 2.f;
  const ImU32 glow = lit && !selected ? kGlow : faded(kHalo, selected ? 200 : 120);
  picturePolyline(list, ui, outline, {glow, halo}, true);
  picturePolyline(list, ui, outline, {selected || lit ? kDark : faded(kDark, 120), width}, true);
}

void drawOutline(ImDrawList& list, const PanelEnv& env, const document::Part& part, const ribs::RibSet& set) {
  static std::vector<PicturePoint> outline;  // reused from frame to frame
  app::outlineOf(set, document::loftIn(part).loft, outline);
  outlineStroke(list, env.ui(), outline, part.id == env.ui().selection, part.id == env.ui().hover.part);
}

void grabDot(ImDrawList& list, ImVec2 at, ImU32 colour, bool hot) {
  list.AddCircleFilled(at, hot ? 8.5f : 7.f, kHalo, 24);
  list.AddCircleFilled(at, hot ? 6.5f : 5.f, colour, 24);
  if (hot) list.AddCircle(at, 10.5f, colour, 28, 1.6f);
}

/// The outlines of what has no spine; before there is a solid, as they were drawn.
void drawRegion(ImDrawList& list, const PanelEnv& env, const document::Part& part,
                const std::vector<std::vector<PicturePoint>>& contours) {
  const app::UiState& ui = env.ui();
  const bool selected = part.id == ui.selection, lit = part.id == ui.hover.part;
  const app::Preview* preview = app::previewOf(ui, part.id);
  const auto& shown = preview ? preview->shape->contours : contours;
  // The tool Lines shows its lines, and of the piece in hand the outline below them.
  const bool byLines = ui.tool == app::ToolKind::Lines && document::elementOf(part) != nullptr;
  if (byLines && !selected && !lit) return;
  for (const auto& contour : shown) outlineStroke(list, ui, contour, selected && !byLines, lit || byLines);
  const document::Region* region = document::regionOf(preview ? preview->recipe : part.recipe);
  if (app::partWithPoints(env.document(), ui) != &part || region == nullptr) return;
  for (const app::OutlinePoint at : app::outlineHandles(*region)) {
    const bool hot = ui.hover.outline == at;
    const ImVec2 c = onCanvas(ui, app::pointOf(*region, at));
    list.AddCircleFilled(c, hot ? 8.f : 6.f, kHalo, 20);
    list.AddCircleFilled(c, hot ? 6.f : 4.2f, toolColour(ui.tool), 20);
  }
  if (ui.chosen.outline) grabDot(list, onCanvas(ui, app::pointOf(*region, *ui.chosen.outline)), kDark, true);
}

/// The ends that follow a dragged one, brighter the more they do.
void drawReach(ImDrawList& list, const app::UiState& ui, const ribs::EditScene& scene, ribs::EndRef end) {
  const double at = ribs::placeOf(scene, end.rib);
  const ImU32 colour = toolColour(ui.tool);
  const auto& all = scene.ribs.ribs;
  if (all.size() < 2) return;
  const ribs::Ruler ruler(scene.spine.points);
  const std::vector<double> places = ribs::ribPlaces(ruler, scene.spine, scene.ribs);
  for (std::size_t i = 0; i < all.size(); ++i) {
    const double reach = ui.edit.ribReach;
    const double share = i == end.rib ? 1 : reach > 0 ? ribs::bell((places[i] - at) / reach) : 0;
    if (share < 0.02) continue;
    const auto alpha = static_cast<unsigned>(60 + 195 * share);
    const ImU32 ink = (colour & ~IM_COL32_A_MASK) | (alpha << IM_COL32_A_SHIFT);
    list.AddLine(onCanvas(ui, all[i].center), onCanvas(ui, app::endPoint(all[i], end.side)), ink,
                 1.5f + 2.f * static_cast<float>(share));
  }
}

/// Other places where an end might stand.
void drawOthers(ImDrawList& list, const app::UiState& ui, const ribs::RibSet& set, ribs::EndRef end) {
  const ribs::Rib& rib = set.ribs[end.rib];
  const ribs::OtherPlaces& others = app::otherPlaces(rib, end.side);
  const ImVec2 from = onCanvas(ui, app::endPoint(rib, end.side));
  for (int i = 0; i < others.count; ++i) {
    const ImVec2 at = onCanvas(ui, others.at[static_cast<std::size_t>(i)]);
    const bool hot = ui.hover.other == i && ui.hover.end == end;
    styledLine(list, from, at, {faded(kHalo, 150), 3.f, LineStyle::Solid});
    styledLine(list, from, at, {kMuted, 1.2f, LineStyle::Dotted});
    list.AddCircleFilled(at, hot ? 7.f : 5.f, faded(kHalo, 230), 20);
    list.AddCircle(at, hot ? 7.f : 5.f, hot ? kAccent : kMuted, 20, 1.8f);
  }
}

void drawRibTool(ImDrawList& list, const PanelEnv& env, const app::Subject& subject, const ribs::RibSet& seen) {
  const app::UiState& ui = env.ui();
  const app::Hover& hover = ui.hover;
  const std::optional<ribs::EndRef> end = ui.inHand.end ? ui.inHand.end : hover.end ? hover.end : ui.chosen.end;
  const auto known = [&](const std::optional<ribs::EndRef>& ref) { return ref && ref->rib < seen.ribs.size(); };
  if (known(end)) {
    const ribs::EditScene scene{subject.shape->spine, seen, document::loftIn(*subject.part).edits};
    drawReach(list, ui, scene, *end);
  }
  const bool dragging = static_cast<bool>(ui.preview);
  if (!dragging && known(ui.chosen.end)) drawOthers(list, ui, seen, *ui.chosen.end);
  if (!dragging && known(hover.end) && hover.end != ui.chosen.end) {
    drawOthers(list, ui, seen, *hover.end);
  }
  if (known(ui.chosen.end)) {
    const ribs::EndRef chosen = *ui.chosen.end;
    grabDot(list, onCanvas(ui, app::endPoint(seen.ribs[chosen.rib], chosen.side)), kDark, false);
  }
  if (known(end) && (hover.end || ui.inHand.end) && hover.other < 0) {
    grabDot(list, onCanvas(ui, app::endPoint(seen.ribs[end->rib], end->side)), toolColour(ui.tool), true);
  }
}

/// The ends that a line moves are coloured before the pen goes up.
void drawTouched(ImDrawList& list, const app::UiState& ui, const ribs::RibSet& set) {
  const ImU32 colour = toolColour(ui.tool);
  for (const ribs::EndRef end : ui.inHand.touched) {
    if (end.rib >= set.ribs.size()) continue;
    const ImVec2 tip = onCanvas(ui, app::endPoint(set.ribs[end.rib], end.side));
    list.AddLine(onCanvas(ui, set.ribs[end.rib].center), tip, colour, 2.4f);
    list.AddCircleFilled(tip, 4.2f, kHalo, 16);
    list.AddCircleFilled(tip, 3.2f, colour, 16);
  }
}

void drawSpineTool(ImDrawList& list, const app::UiState& ui, const app::Subject& subject) {
  const document::LoftRecipe& recipe = document::loftIn(*subject.part);
  const bool posed = !recipe.pose.stroke.empty();
  if (posed) picturePolyline(list, ui, subject.shape->spine.points, {faded(kSpine, 130), 1.6f, LineStyle::Dashed});
  drawSpine(list, ui, app::spineLine(subject));
  const std::vector<PicturePoint> handles = app::spineHandles(subject);
  for (std::size_t i = 0; i < handles.size(); ++i) {
    const int handle = static_cast<int>(i);
    const bool hot = handle == ui.hover.handle, chosen = handle == ui.chosen.handle;
    grabDot(list, onCanvas(ui, handles[i]), chosen ? kDark : kSpine, hot);
    const bool end = i == 0 || i + 1 == handles.size();
    if (end) list.AddCircleFilled(onCanvas(ui, handles[i]), 2.2f, kHalo, 12);
  }
}

/// Half a disc at the end of a broad line that comes from `before`; a whole one where there is no line. Nothing
/// overlaps, so that it may be seen through.
void roundEnd(ImDrawList& list, ImVec2 at, ImVec2 before, float radius, ImU32 fill) {
  const float x = at.x - before.x, y = at.y - before.y;
  const bool point = x == 0 && y == 0;
  const float half = std::numbers::pi_v<float> / 2, angle = std::atan2(y, x);
  list.PathArcTo(at, radius, angle - half, point ? angle + 3 * half : angle + half, 24);
  list.PathFillConvex(fill);
}

/// Both ends of a stroke `width` wide on the canvas.
void roundEnds(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> stroke, float width,
               ImU32 fill) {
  const std::size_t last = stroke.size() - 1;
  roundEnd(list, onCanvas(ui, stroke[last]), onCanvas(ui, stroke[last > 0 ? last - 1 : 0]), width / 2, fill);
  if (last > 0) roundEnd(list, onCanvas(ui, stroke[0]), onCanvas(ui, stroke[1]), width / 2, fill);
}

struct Band {
  std::span<const PicturePoint> stroke;
  double radius = 0;
  bool covers = false;
};

/// A scribble: a pale band with slanted lines across, or one as of paint where it covers.
void drawMark(ImDrawList& list, const app::UiState& ui, const Band& mark, bool hot) {
  const std::span<const PicturePoint> stroke = mark.stroke;
  if (stroke.empty()) return;
  const auto width = static_cast<float>(std::max(2.0, 2 * mark.radius * ui.pictureView.zoom));
  const ImU32 fill = hot ? faded(kAccent, 90) : faded(kHalo, mark.covers ? 205 : 130);
  const ImU32 ink = hot ? kAccent : toolColour(app::ToolKind::Ignore);
  picturePolyline(list, ui, stroke, {fill, width});
  roundEnds(list, ui, stroke, width, fill);
  if (mark.covers) return;
  const std::vector<double> s = geometry::arcLengths(stroke);
  const double gap = 7 / ui.pictureView.zoom;
  const float half = width * 0.35f;
  for (double at = 0; at <= s.back() + 1e-9; at += gap) {
    const ImVec2 c = onCanvas(ui, geometry::pointAt(stroke, std::span<const double>(s), at));
    list.AddLine({c.x - half, c.y + half}, {c.x + half, c.y - half}, ink, 1.3f);
  }
}

void drawMarks(ImDrawList& list, const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const app::Marks marks = app::marksOf(env.document(), ui.picture, ui.selection);
  for (int i = 0; i < marks.count(); ++i) {
    const auto& [stroke, radius, covers] = marks.at(i);
    drawMark(list, ui, {stroke, radius, covers}, ui.hover.mark == i);
  }
}

/// What a brush for cut-outs covers.
void drawCutMark(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> line, double radius,
                 ImU32 colour) {
  if (line.empty()) return;
  const auto width = static_cast<float>(std::max(3.0, 2 * radius * ui.pictureView.zoom));
  picturePolyline(list, ui, line, {colour, width});
  roundEnds(list, ui, line, width, colour);
}

constexpr ImU32 brushColour(bool adds, unsigned alpha) { return rgb(adds ? 0x12876f : 0xc8231d, alpha); }

/// The thing that is being cut out: tinted, with its outline and the marks that corrected it.
void drawCut(ImDrawList& list, const app::UiState& ui) {
  if (!ui.cut) return;
  const app::CutDraft& cut = *ui.cut;
  const ImDrawListFlags flags = list.Flags;
  list.Flags &= ~ImDrawListFlags_AntiAliasedFill;  // no seams between the triangles
  for (const auto& [a, b, c] : cut.shape.fill) {
    list.AddTriangleFilled(onCanvas(ui, a), onCanvas(ui, b), onCanvas(ui, c),
                           (toolColour(ui.tool) & ~IM_COL32_A_MASK) | (90u << IM_COL32_A_SHIFT));
  }
  list.Flags = flags;
  for (const auto& contour : cut.shape.contours) outlineStroke(list, ui, contour, true, false);
  for (const vision::CutMark& mark : cut.hints.marks) {
    drawCutMark(list, ui, mark.line, mark.radius, brushColour(mark.inside, 70));
  }
  if (cut.hints.box && cut.shape.contours.empty()) {
    list.AddRect(onCanvas(ui, cut.hints.box->low), onCanvas(ui, cut.hints.box->high), toolColour(ui.tool), 2, 0, 2);
  }
}

/// The line or scribble in hand.
void drawInHand(ImDrawList& list, const app::UiState& ui) {
  const app::InHand& hand = ui.inHand;
  if (hand.stroke.empty()) return;
  if (hand.box) {
    const ImVec2 a = onCanvas(ui, hand.stroke.front()), b = onCanvas(ui, hand.stroke.back());
    const ImVec2 low{std::min(a.x, b.x), std::min(a.y, b.y)}, high{std::max(a.x, b.x), std::max(a.y, b.y)};
    list.AddRectFilled(low, high, faded(kHalo, 50));
    list.AddRect(low, high, faded(kHalo, 220), 2, 0, 4.5f);
    list.AddRect(low, high, toolColour(ui.tool), 2, 0, 2.2f);
  } else if (ui.cut || (hand.radius > 0 && app::cutsOut(ui.tool))) {
    drawCutMark(list, ui, hand.stroke, hand.radius, brushColour(!ui.cut || ui.cut->adding, 130));
  } else if (hand.radius > 0) {
    drawMark(list, ui, {hand.stroke, hand.radius, ui.edit.paintOver}, false);
  } else if (ui.tool == app::ToolKind::Lines) {
    return;  // drawLineDrawing
  } else if (ui.tool == app::ToolKind::Shape || ui.tool == app::ToolKind::Primitive) {
    picturePolyline(list, ui, hand.stroke, {faded(kHalo, 220), 5.5f});
    picturePolyline(list, ui, hand.stroke, {toolColour(ui.tool), 2.6f});
  } else {
    drawSpine(list, ui, hand.stroke);
  }
}

/// Ribs and spine of the selected part, as it is or as the gesture in hand would make it.
void drawSelected(ImDrawList& list, const PanelEnv& env, const app::Subject& subject) {
  const app::UiState& ui = env.ui();
  const app::Preview* preview = app::previewOf(ui, subject.part->id);
  document::Part part = *subject.part;
  if (preview) part.recipe = preview->recipe;
  const app::Subject shown{&part, preview ? &*preview->shape : subject.shape};
  const ribs::RibSet& set = ribsOf(ui, *shown.shape);
  drawRibs(list, ui, {set, editsRibs(ui.tool)});
  drawOutline(list, env, part, set);
  if (ui.tool == app::ToolKind::Spine) {
    drawSpineTool(list, ui, shown);
    return;
  }
  static std::vector<PicturePoint> spine;
  spine.clear();
  for (const ribs::Rib& rib : set.ribs) spine.push_back(rib.center);
  drawSpine(list, ui, spine);
  if (ui.tool == app::ToolKind::Ribs) drawRibTool(list, env, shown, set);
  if (ui.tool == app::ToolKind::Shape) drawTouched(list, ui, set);
}

void drawParts(ImDrawList& list, const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const auto& parts = env.document().parts;
  const std::size_t count = std::min(parts.size(), env.derived.parts.size());
  const bool drawingNew = ui.preview && !ui.preview->part;
  for (std::size_t i = 0; i < count; ++i) {
    const auto& shape = env.derived.parts[i].shape;
    const document::Part& part = parts[i];
    if (document::pictureOf(part) != ui.picture || !pipeline::isVisible(env.document(), part)) continue;
    static const std::vector<std::vector<PicturePoint>> kNone;
    if (document::loftOf(part) == nullptr) {
      const document::Region* region = document::regionOf(part.recipe);
      drawRegion(list, env, part, shape ? shape->contours : region ? region->contours : kNone);
    } else if (!shape) {
      drawSpine(list, ui, document::loftIn(part).stroke);
    } else if (part.id == ui.selection && !drawingNew) {
      drawSelected(list, env, {&part, shape.get()});
    } else {
      drawOutline(list, env, part, shape->shown);
    }
  }
}

/// The axis of the tool that turns things round, its ends where a hand can drag them, and the mirror image of the line
/// in hand.
void drawAxis(ImDrawList& list, const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  const std::optional<app::ShownAxis> axis = app::shownAxis(env.document(), ui);
  if (!axis) return;
  const ImU32 colour = toolColour(ui.tool);
  const PicturePoint along = axis->to - axis->from;
  styledLine(list, onCanvas(ui, axis->from), onCanvas(ui, axis->to), {rgb(0xffffff, 200), 5.f, LineStyle::Solid});
  styledLine(list, onCanvas(ui, axis->from), onCanvas(ui, axis->to), {colour, 2.f, LineStyle::Dashed});
  if (!ui.inHand.stroke.empty() && dot(along, along) > 0) {
    static std::vector<PicturePoint> image;  // reused from frame to frame
    image.clear();
    for (const PicturePoint p : ui.inHand.stroke) {
      const PicturePoint foot = axis->from + along * (dot(p - axis->from, along) / dot(along, along));
      image.push_back(foot * 2 - p);
    }
    picturePolyline(list, ui, image, {rgb(0xffffff, 160), 4.5f, LineStyle::Solid});
    picturePolyline(list, ui, image, {colour, 2.f, LineStyle::Solid});
  }
  if (!app::axisInHand(env.document(), ui)) return;
  grabDot(list, onCanvas(ui, axis->from), colour, ui.hover.axis == 0);
  grabDot(list, onCanvas(ui, axis->to), colour, ui.hover.axis == 1);
}

void drawPreview(ImDrawList& list, const app::UiState& ui) {
  if (!ui.preview || ui.tool != app::ToolKind::Draw) return;
  if (ui.preview->shape && !ui.preview->part) drawRibs(list, ui, {ui.preview->shape->shown});
  drawSpine(list, ui, ui.preview->loft().stroke);
}

}  // namespace

void drawPictureOverlay(const PanelEnv& env) {
  const app::Rect& view = env.ui().layout.picture;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({static_cast<float>(view.x), static_cast<float>(view.y)},
                    {static_cast<float>(view.right()), static_cast<float>(view.bottom())}, true);
  const document::PictureEntry* picture = document::findPicture(env.document(), env.ui().picture);
  if (tellsByFrames() && picture != nullptr) {
    const PicturePoint far{static_cast<double>(picture->size.width), static_cast<double>(picture->size.height)};
    list.AddRect(onCanvas(env.ui(), {0, 0}), onCanvas(env.ui(), far), kLine);
  }
  if (env.ui().tool == app::ToolKind::Ignore) drawMarks(list, env);
  drawParts(list, env);
  drawBones(env);
  drawShapes(env);
  drawLineDrawing(env);
  drawAxis(list, env);
  drawPreview(list, env.ui());
  drawCut(list, env.ui());
  drawInHand(list, env.ui());
  drawInk(env);
  list.PopClipRect();
  drawFailureInPicture(env);
}

}  // namespace spineloft::panels
