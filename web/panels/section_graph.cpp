// Twist, depth, lean and front along the spine: which curve, its graph, shapes for one tap.
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <variant>

#include "engine/mesh/self_crossing.h"
#include "web/commands/intents.h"
#include "web/edit/graph_points.h"
#include "web/edit/placing.h"
#include "web/edit/preview.h"
#include "web/edit/section_editing.h"
#include "web/model/messages.h"
#include "web/panels/curve_graph.h"
#include "web/panels/draw_lines.h"
#include "web/panels/point_control.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"

namespace spineloft::panels {
namespace {

using document::AlongKind;

app::Rect rectOf(ImVec2 low, ImVec2 high) {
  return {low.x, low.y, std::max(0.f, high.x - low.x), std::max(0.f, high.y - low.y)};
}

const char* unitOf(AlongKind kind) {
  switch (kind) {
    case AlongKind::Twist:
      return "{n} turns";
    case AlongKind::Squash:
      return "{n} ×";
    case AlongKind::Tilt:
      return "{n}°";
    default:
      return "{n}";
  }
}

/// The values that a graph shows: at least `shown` about the rest, and all points.
std::pair<double, double> rangeOf(const app::AlongInfo& info, const geometry::AlongCurve& curve) {
  double most = info.shown;
  for (const geometry::AlongPoint& p : curve.points) most = std::max(most, std::abs(p.value - info.rest));
  constexpr std::array kNice = {1.0, 2.0, 3.0, 5.0, 7.0, 11.0, 30.0, 60.0, 70.0};
  for (const double nice : kNice) {
    if (nice >= most - 1e-9) {
      most = nice;
      break;
    }
  }
  // A point at the edge asks for more room.
  return {std::max(info.low, info.rest - most), std::min(info.high, info.rest + most)};
}

/// A drawing of what a kind does.
void paintKind(ImDrawList& list, AlongKind kind, ImVec2 c, float r, ImU32 ink) {
  constexpr int kSteps = 24;
  const auto curve = [&](const auto& y, float phase) {
    for (int i = 0; i <= kSteps; ++i) {
      const float t = static_cast<float>(i) / kSteps;
      list.PathLineTo({c.x - r + 2 * r * t, c.y + y(t + phase) * r});
    }
    list.PathStroke(ink, 0, 1.7f);
  };
  switch (kind) {
    case AlongKind::Twist:
      curve([](float t) { return 0.6f * std::sin(t * 9); }, 0);
      curve([](float t) { return -0.6f * std::sin(t * 9); }, 0);
      break;
    case AlongKind::Squash:
      curve([](float t) { return 0.75f - 0.65f * t; }, 0);
      curve([](float t) { return -0.75f + 0.65f * t; }, 0);
      break;
    case AlongKind::Tilt:
      for (const float x : {-0.6f, 0.f, 0.6f}) {
        list.AddLine({c.x + (x - 0.3f) * r, c.y + 0.7f * r}, {c.x + (x + 0.3f) * r, c.y - 0.7f * r}, ink, 1.7f);
      }
      break;
    default:
      curve([](float t) { return -0.9f * std::sin(t * 3.14159f) + 0.3f; }, 0);
      curve([](float) { return 0.3f; }, 0);
  }
}

void kinds(const PanelEnv& env, const loft::LoftParams& params, float width, int columns) {
  const bool labels = !env.ui().layout.strip;
  const float gap = 4, side = (width - gap * static_cast<float>(columns - 1)) / static_cast<float>(columns);
  int index = 0;
  for (const app::AlongInfo& info : app::alongTable()) {
    if (index++ % columns != 0) ImGui::SameLine(0, gap);
    const std::string id(info.key);
    const bool on = env.ui().sections.along == info.kind;
    const ImVec2 at = ImGui::GetCursorScreenPos();
    const ImVec2 size{std::floor(side), labels ? 50.f : 44.f};
    const auto paint = [&](ImDrawList& list, ImVec2 c, float r, ImU32 ink) { paintKind(list, info.kind, c, r, ink); };
    if (tile(env, {id.c_str(), labels ? info.label : std::string_view(), info.hint, size, on}, paint)) {
      env.sink.run(app::showAlong, info.kind);
    }
    if (!document::alongOf(params, info.kind).empty()) {  // it is in use
      ImGui::GetWindowDrawList()->AddCircleFilled({at.x + size.x - 8, at.y + 8}, 3.5f, kAccent, 12);
    }
  }
}

void shapes(const PanelEnv& env, const app::AlongInfo& info, bool used, float width) {
  const float height = env.ui().touch ? 44.f : 30.f;
  float room = width;
  bool first = true;
  const auto chip = [&](std::string_view key, Text text, const geometry::AlongCurve& curve, bool enabled) {
    const float wide = textButtonWidth(env, text);
    if (!first && room >= wide + 4) {
      ImGui::SameLine(0, 4);
    } else {
      room = width;
    }
    room -= wide + 4;
    first = false;
    const std::string id = "shape-" + std::string(key);
    if (textButton(env, {id.c_str(), text, false, enabled, height})) {
      env.sink.run(app::setAlong, app::selectedParts(env.document(), env.ui()), info.kind, curve);
    }
  };
  for (const app::AlongShape& shape : app::alongShapes()) {
    if (shape.kind == info.kind) chip(shape.key, shape.label, {shape.points}, true);
  }
  chip("none", "Reset", {}, used);
}

std::string_view numberOf(const CurveGraph& graph, double value) {
  return words::tr(graph.unit, {{"n", std::round(value * 100) / 100}});
}

/// The numbers of one point.
void askedPoint(const PanelEnv& env, const CurveGraph& graph, std::size_t i, ImVec2 at,
                std::optional<geometry::AlongCurve>& asked, const geometry::AlongCurve& curve) {
  const geometry::AlongPoint& p = curve.points[i];
  const auto [low, high] = app::roomOfPoint(curve, i);
  const auto control = [&](const char* what, const char* sentence) {
    const std::string_view words =
        words::tr(sentence, {{"graph", graph.name}, {"n", i + 1}, {"all", curve.points.size()}});
    return PointControl{what + std::to_string(i), words, at};
  };
  const auto ask = [&]() -> geometry::AlongPoint& { return (asked = curve)->points[i]; };
  const auto value = pointSlider(env, control("value", "{graph}, point {n} of {all}: value"),
                                 {graph.low, graph.high, p.value, std::string(numberOf(graph, p.value))});
  if (value) ask().value = *value;
  const double share = std::round(100 * p.at);
  const auto place = pointSlider(env, control("place", "{graph}, point {n} of {all}: place"),
                                 {100 * std::min(low, p.at), 100 * std::max(high, p.at), 100 * p.at,
                                  std::string(words::tr("{n} %", {{"n", share}}))});
  if (place) ask().at = *place / 100;
  if (pointButton(env, control("remove", "{graph}, point {n} of {all}: take it away"))) {
    asked = curve;
    asked->points.erase(asked->points.begin() + static_cast<std::ptrdiff_t>(i));
  }
}

/// The points without a pointer: the curve that was asked for.
template <class ToCanvas>
std::optional<geometry::AlongCurve> askedPoints(const PanelEnv& env, const CurveGraph& graph,
                                                const geometry::AlongCurve& curve, const ToCanvas& toCanvas) {
  std::optional<geometry::AlongCurve> asked;
  ImGui::PushID(static_cast<int>(graph.kind));
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    if (!app::isFixedPoint(graph.kind, curve, i)) askedPoint(env, graph, i, toCanvas(curve.points[i]), asked, curve);
  }
  const double at = app::widestGap(curve), value = geometry::valueAt(curve, at, graph.rest);
  const PointControl add{"add", words::tr("{graph}: add a point", {{"graph", graph.name}}), toCanvas({at, value})};
  if (curve.points.size() < geometry::kMostAlongPoints && pointButton(env, add)) {
    std::size_t point = 0;
    asked = app::withPointAt(curve, {at, value}, graph.rest, point);
  }
  ImGui::PopID();
  return asked;
}

/// The curve that was asked for without a pointer, as far as a drag would take it.
void bend(const PanelEnv& env, const document::Part& part, const app::AlongInfo& info,
          const geometry::AlongCurve& asked) {
  loft::LoftParams params = document::loftIn(part).loft;
  geometry::AlongCurve& curve = document::alongOf(params, info.kind) = asked;
  for (geometry::AlongPoint& p : curve.points) p.value *= info.unit;
  if (!holdsBack(env, part, std::move(params))) env.sink.run(app::setAlong, app::Parts{part.id}, info.kind, asked);
}

}  // namespace

std::optional<geometry::AlongCurve> curveGraph(const PanelEnv& env, const CurveGraph& graph,
                                               const geometry::AlongCurve& curve) {
  const ImVec2 at = ImGui::GetCursorScreenPos(), end{at.x + graph.size.x, at.y + graph.size.y};
  ImGui::Dummy(graph.size);
  if (env.ui().sections.revealGraph) {
    ImGui::SetScrollHereY(1);
    env.ui().sections.revealGraph = false;
  }
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImVec2 clipLow = list.GetClipRectMin(), clipHigh = list.GetClipRectMax();
  constexpr float kPad = 9;  // so that points at the edge can be taken
  const ImVec2 low{at.x + kPad, at.y + kPad}, high{end.x - kPad, end.y - kPad};
  app::GraphArea area{graph.kind, rectOf(low, high), {}, graph.low, graph.high};
  area.visible = rectOf({std::max(at.x, clipLow.x), std::max(at.y, clipLow.y)},
                        {std::min(end.x, clipHigh.x), std::min(end.y, clipHigh.y)});
  env.ui().sections.graphs.push_back(area);
  const auto x = [&](double t) { return low.x + (high.x - low.x) * static_cast<float>(t); };
  const auto y = [&](double v) {
    return high.y - (high.y - low.y) * static_cast<float>((v - graph.low) / (graph.high - graph.low));
  };
  list.AddRectFilled(at, end, kTile, 8);
  list.AddRect(at, end, kLine, 8);
  list.PushClipRect(at, end, true);
  styledLine(list, {low.x, y(graph.rest)}, {high.x, y(graph.rest)}, {faded(kMuted, 120), 1, LineStyle::Dashed});
  if (const auto& marked = env.ui().sections.marked; marked && graph.kind == app::GraphArea::Kind::Along) {
    list.AddLine({x(*marked), at.y}, {x(*marked), end.y}, kGlow, 3);
  }
  const auto& hovered = env.ui().hover.along;
  const bool pointed = hovered && !env.ui().sections.marked && graph.kind == app::GraphArea::Kind::Along;
  if (pointed) list.AddLine({x(*hovered), at.y}, {x(*hovered), end.y}, kMuted, 1);
  constexpr int kSteps = 64;
  for (int i = 0; i <= kSteps; ++i) {
    const double t = static_cast<double>(i) / kSteps;
    list.PathLineTo({x(t), y(geometry::valueAt(curve, t, graph.rest))});
  }
  list.PathStroke(kSpine, 0, 2.2f);
  const bool dragging = env.ui().sections.graph.has_value();
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const ImVec2 p{x(curve.points[i].at), y(curve.points[i].value)};
    const bool on = dragging && i == env.ui().sections.graphPoint;
    list.AddCircleFilled(p, env.ui().touch ? 7.f : 5.5f, on ? kAccent : kSurface, 20);
    list.AddCircle(p, env.ui().touch ? 7.f : 5.5f, on ? kAccent : kSpine, 20, 2);
  }
  const auto number = [&](double value) { return asIs(numberOf(graph, value)); };
  Text text = "";
  if (dragging && env.ui().sections.graphPoint < curve.points.size()) {
    text = number(curve.points[env.ui().sections.graphPoint].value);
  } else if (pointed && !curve.empty()) {
    text = number(geometry::valueAt(curve, *hovered, graph.rest));
  } else if (curve.empty() && graph.kind == app::GraphArea::Kind::Along) {
    text = "Tap to bend the line";
  }
  drawLine(list, {env.fonts.small, {at.x + 8, at.y + 4}, kMuted}, text.shown());
  list.PopClipRect();
  return askedPoints(env, graph, curve, [&](const geometry::AlongPoint& p) { return ImVec2{x(p.at), y(p.value)}; });
}

bool holdsBack(const PanelEnv& env, const document::Part& part, loft::LoftParams params) {
  const auto now = std::ranges::find(env.derived.parts, part.id, &pipeline::DerivedPart::id);
  if (now == env.derived.parts.end() || !now->shape || mesh::selfCrossing(now->shape->mesh)) return false;
  document::Recipe recipe = part.recipe;
  std::get<document::LoftRecipe>(recipe).loft = std::move(params);
  pipeline::PartShape shape;
  if (!env.env.studio.preview(recipe, {part.pulls}, shape) || !mesh::selfCrossing(shape.mesh)) return false;
  app::sendStatus(env.env.host, words::tr("Any further, and it would go through itself"));
  return true;
}

void alongPanel(const PanelEnv& env, float width) {
  const document::Part* part = env.selected();
  if (part == nullptr) {
    ImGui::PushTextWrapPos(ImGui::GetCursorPosX() + width);
    label(env.fonts.small, kMuted, "Draw or choose a part; then it can be twisted, flattened and leant.");
    ImGui::PopTextWrapPos();
    return;
  }
  const app::Preview* preview = app::previewOf(env.ui(), part->id);
  const loft::LoftParams& params = preview ? preview->loft().loft : document::loftIn(*part).loft;
  const app::AlongInfo& info = app::alongInfo(env.ui().sections.along);
  geometry::AlongCurve curve = document::alongOf(document::loftIn(*part).loft, info.kind);
  for (geometry::AlongPoint& p : curve.points) p.value /= info.unit;
  const auto [low, high] = rangeOf(info, curve);  // steady while a point is dragged
  const bool blending = env.ui().sections.graph && !env.ui().sections.graphs.empty() &&
                        env.ui().sections.graphs.front().kind == app::GraphArea::Kind::Blend;
  if (env.ui().sections.graph && !blending) curve = *env.ui().sections.graph;
  CurveGraph graph{.low = low, .high = high, .rest = info.rest, .unit = unitOf(info.kind)};
  graph.name = words::tr(info.label);
  std::optional<geometry::AlongCurve> asked;
  const bool strip = env.ui().layout.strip;
  if (strip) {
    width -= ImGui::GetStyle().ScrollbarSize + 2;
    const float left = 4 * 48.f + 12 < width * 0.4f ? 4 * 48.f + 12 : 2 * 48.f + 4;
    ImGui::BeginGroup();
    kinds(env, params, left, left > 150 ? 4 : 2);
    ImGui::EndGroup();
    ImGui::SameLine(0, 8);
    graph.size = {width - left - 8, 94};
    asked = curveGraph(env, graph, curve);
  } else {
    kinds(env, params, width, 4);
    graph.size = {width, 116};
    asked = curveGraph(env, graph, curve);
  }
  if (asked) bend(env, *part, info, *asked);
  shapes(env, info, !document::alongOf(document::loftIn(*part).loft, info.kind).empty(), width);
  commandText(env, {"fly-along", width});
}

}  // namespace spineloft::panels
