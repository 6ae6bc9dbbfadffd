#include "web/tools/section_tools.h"

#include <algorithm>

#include "web/edit/section_editing.h"
#include "web/tools/drag_graph.h"
#include "web/tools/draw_section.h"
#include "web/tools/slide_section.h"

namespace spineloft::tools {
namespace {

constexpr double kDoubleTapMs = 400, kDoubleTapReach = 22;

const app::GraphArea* graphAt(const app::UiState& ui, app::ClientPoint at) {
  for (const app::GraphArea& graph : ui.sections.graphs) {
    if (graph.visible.contains(at)) return &graph;
  }
  return nullptr;
}

bool onBoard(const app::UiState& ui, app::ClientPoint at) {
  return ui.sections.board && ui.sections.board->square.contains(at);
}

}  // namespace

bool isForSections(const app::UiState& ui, app::ClientPoint at) {
  return onBoard(ui, at) || (!ui.sections.board && graphAt(ui, at) != nullptr);
}

std::unique_ptr<Tool> sectionTool(const ToolEnv& env, const ToolEvent& event) {
  app::UiState& ui = env.ui;
  if (onBoard(ui, event.at)) return std::make_unique<DrawSection>();
  if (ui.sections.board) return nullptr;
  if (const app::GraphArea* graph = graphAt(ui, event.at)) {
    return std::make_unique<DragGraph>(*graph);
  }
  if (!ui.layout.picture.contains(event.at)) return nullptr;
  if (ui.sections.placing) return std::make_unique<PlaceSection>();
  if (const auto key = sectionHandleAt(env, event.at, reachOf(event))) {
    return std::make_unique<SlideSection>(*key);
  }
  return nullptr;
}

std::optional<double> placeInGraph(const app::UiState& ui, app::ClientPoint at) {
  const app::GraphArea* graph = ui.sections.board ? nullptr : graphAt(ui, at);
  if (graph == nullptr || graph->kind != app::GraphArea::Kind::Along) return std::nullopt;
  return std::clamp((at.x - graph->at.x) / graph->at.width, 0.0, 1.0);
}

const char* sectionCursor(const ToolEnv& env, app::ClientPoint at) {
  if (onBoard(env.ui, at)) {
    return env.ui.sections.board->tool == app::BoardTool::Points ? "default" : "crosshair";
  }
  if (env.ui.sections.board) return nullptr;
  if (graphAt(env.ui, at) != nullptr) return "pointer";
  if (!env.ui.layout.picture.contains(at)) return nullptr;
  if (env.ui.sections.placing) return "copy";
  return sectionHandleAt(env, at, 12) ? "grab" : nullptr;
}

std::optional<std::size_t> sectionHandleAt(const ToolEnv& env, app::ClientPoint at, double reach) {
  const document::Part* part = document::findPart(env.document, env.ui.selection);
  if (part == nullptr || document::pictureOf(*part) != env.ui.picture) return std::nullopt;
  const auto& keys = document::loftIn(*part).loft.sections;
  const pipeline::PartShape* shape = app::shapeOf(env.document, env.derived, part->id);
  if (keys.size() < 2 || shape == nullptr) return std::nullopt;
  std::optional<std::size_t> best;
  for (std::size_t i = 0; i < keys.size(); ++i) {
    const app::ClientPoint handle =
        env.ui.pictureView.toClient(app::placeOnSpine(*shape, keys[i].at), env.ui.layout.picture);
    const double off = distance(handle, at);
    if (off > reach) continue;
    reach = off;
    best = i;
  }
  return best;
}

bool isDoubleTap(app::SectionUi& sections, const ToolEvent& event) {
  const bool twice =
      event.timeMs - sections.lastTapMs < kDoubleTapMs && distance(event.at, sections.lastTap) < kDoubleTapReach;
  sections.lastTap = event.at;
  sections.lastTapMs = twice ? -1e9 : event.timeMs;
  return twice;
}

}  // namespace spineloft::tools
