// Line drawings over the picture: lines, seen and hidden, the rings where one is not closed, and the crossings where
// pieces overlap.
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/geometry/polyline.h"
#include "web/edit/line_drawing.h"
#include "web/panels/draw_lines.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"
#include "web/words/words.h"

namespace spineloft::panels {
namespace {

constexpr float kHaloWidth = 5.f, kLineWidth = 2.4f, kDash = 7.f, kGapOfDash = 6.f;
constexpr float kCrossing = 12.f, kRing = 8.f;

/// Dashes along a whole polyline, not of each side of it.
void dashed(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> points, const Pen& pen) {
  float along = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const ImVec2 a = onCanvas(ui, points[i - 1]), b = onCanvas(ui, points[i]);
    const float length = std::hypot(b.x - a.x, b.y - a.y);
    if (length <= 0) continue;
    const ImVec2 way{(b.x - a.x) / length, (b.y - a.y) / length};
    for (float at = 0; at < length;) {
      const float in = std::fmod(along + at, kDash + kGapOfDash);
      const float end = std::min(length, at + (in < kDash ? kDash - in : kDash + kGapOfDash - in) + 1e-3f);
      if (in < kDash) {
        list.AddLine({a.x + way.x * at, a.y + way.y * at}, {a.x + way.x * end, a.y + way.y * end}, pen.colour,
                     pen.width);
      }
      at = end;
    }
    along += length;
  }
}

void stretch(ImDrawList& list, const app::UiState& ui, std::span<const PicturePoint> points, bool hidden) {
  const ImU32 colour = toolColour(app::ToolKind::Lines);
  picturePolyline(list, ui, points, {faded(kHalo, 200), kHaloWidth});
  if (hidden) {
    dashed(list, ui, points, {faded(colour, 210), kLineWidth});
  } else {
    picturePolyline(list, ui, points, {colour, kLineWidth});
  }
}

/// The points of a line from one share of its length to another.
void cutOut(const std::vector<PicturePoint>& line, const std::vector<double>& s, descriptive::Stretch part,
            std::vector<PicturePoint>& out) {
  const double from = part.from * s.back(), to = part.to * s.back();
  out.clear();
  out.push_back(geometry::pointAt(std::span<const PicturePoint>(line), std::span<const double>(s), from));
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (s[i] > from && s[i] < to) out.push_back(line[i]);
  }
  out.push_back(geometry::pointAt(std::span<const PicturePoint>(line), std::span<const double>(s), to));
}

void drawnLine(ImDrawList& list, const app::UiState& ui, const document::DrawnLine& line) {
  static std::vector<PicturePoint> points, part;  // reused from frame to frame
  static std::vector<double> s;
  points = line.points;
  if (line.closed) points.push_back(points.front());
  geometry::arcLengths(std::span<const PicturePoint>(points), s);
  double seen = 0;
  for (const descriptive::Stretch& hidden : line.hidden) {
    if (hidden.from > seen) {
      cutOut(points, s, {seen, hidden.from}, part);
      stretch(list, ui, part, false);
    }
    cutOut(points, s, hidden, part);
    stretch(list, ui, part, true);
    seen = hidden.to;
  }
  if (seen >= 1) return;
  cutOut(points, s, {seen, 1}, part);
  stretch(list, ui, part, false);
}

/// One sheet in front of another one. Filled where lines say so, hollow where it is a guess.
void crossing(ImDrawList& list, ImVec2 at, bool guessed, bool hot, bool chosen) {
  const ImU32 colour = chosen ? kDark : toolColour(app::ToolKind::Lines);
  const float r = hot || chosen ? kCrossing + 2 : kCrossing;
  list.AddCircleFilled(at, r + 2.5f, kHalo, 32);
  const ImU32 ground = guessed ? kHalo : colour, ink = guessed ? colour : kOnAccent;
  list.AddCircleFilled(at, r, ground, 32);
  if (guessed) list.AddCircle(at, r, colour, 32, 2.f);
  const auto sheet = [&](float shift, float half, ImU32 filled, bool outlined) {
    const ImVec2 low{at.x + shift - half, at.y - shift - half}, high{at.x + shift + half, at.y - shift + half};
    if (outlined) {
      list.AddRect(low, high, filled, 1.5f, 0, 1.6f);
    } else {
      list.AddRectFilled(low, high, filled, 1.5f);
    }
  };
  const float shift = r * 0.2f, half = r * 0.34f;
  sheet(shift, half, ink, true);
  sheet(-shift, half + 1.5f, ground, false);
  sheet(-shift, half, ink, false);
}

void ring(const PanelEnv& env, ImDrawList& list, ImVec2 at, bool hot, bool withWords) {
  const float r = hot ? kRing + 2 : kRing;
  list.AddCircle(at, r, kHalo, 28, 5.f);
  list.AddCircle(at, r, kFailure, 28, 2.4f);
  if (!withWords) return;
  const std::string_view text = shortened(env.fonts.small, words::text("not closed here"), 200);
  const ImVec2 size = extentOf(env.fonts.small, text);
  const app::Rect& view = env.ui().layout.picture;
  ImVec2 low{at.x + r + 6, at.y - size.y / 2 - 3};
  if (low.x + size.x + 12 > view.right()) low.x = at.x - r - 18 - size.x;
  const ImVec2 high{low.x + size.x + 12, low.y + size.y + 6};
  list.AddRectFilled(low, high, faded(kHalo, 235), 8);
  drawLine(list, {env.fonts.small, {low.x + 6, low.y + 3}, kFailure}, text);
}

}  // namespace

void drawLineDrawing(const PanelEnv& env) {
  const app::UiState& ui = env.ui();
  if (ui.tool != app::ToolKind::Lines) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  for (const document::Drawing& drawing : env.document().drawings) {
    if (drawing.picture != ui.picture) continue;
    for (const document::DrawnLine& line : drawing.lines) drawnLine(list, ui, line);
  }
  for (const pipeline::DerivedDrawing& one : env.derived.drawings) {
    const document::Drawing* drawing = document::findDrawing(env.document(), one.id);
    if (drawing == nullptr || drawing->picture != ui.picture || !one.shape) continue;
    for (const auto& way : one.shape->model.completed) {
      dashed(list, ui, way, {faded(toolColour(app::ToolKind::Lines), 110), kLineWidth});
    }
  }
  if (!ui.inHand.stroke.empty()) stretch(list, ui, ui.inHand.stroke, ui.inHand.hidden);
  const app::LineMarks marks = app::lineMarks(env.document(), env.derived, ui);
  const auto where = [](app::ClientPoint at) { return ImVec2{static_cast<float>(at.x), static_cast<float>(at.y)}; };
  for (std::size_t i = 0; i < marks.looseEnds.size(); ++i) {
    // One of them says it; while a line is drawn, none.
    ring(env, list, where(marks.looseEnds[i]), ui.hover.looseEnd == static_cast<int>(i),
         i == 0 && ui.inHand.stroke.empty());
  }
  if (marks.crossings.empty()) return;
  const std::vector<app::Crossing> crossings = app::crossingsOn(env.document(), env.derived, ui.picture);
  for (std::size_t i = 0; i < std::min(crossings.size(), marks.crossings.size()); ++i) {
    const int number = static_cast<int>(i);
    crossing(list, where(marks.crossings[i]), crossings[i].guessed, ui.hover.crossing == number,
             ui.chosen.crossing == number);
  }
}

}  // namespace spineloft::panels
