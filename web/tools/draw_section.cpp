#include "web/tools/draw_section.h"

#include <algorithm>

#include "web/commands/intents.h"
#include "web/edit/section_editing.h"
#include "web/tools/section_tools.h"

namespace spineloft::tools {
namespace {

constexpr double kPointSpacing = 1.5;  // CSS pixels between the points of a stroke

using app::BoardTool;
using Kind = app::BoardStroke::Kind;

/// How far a place on the canvas is from the outline after a point of a curve.
double distanceToStretch(const app::SectionBoard& board, const sections::DrawnCurve& curve, std::size_t i,
                         app::ClientPoint at) {
  double best = 1e9;
  const std::vector<SectionPoint> stretch = sections::stretchOf(curve, i);
  for (std::size_t k = 1; k < stretch.size(); ++k) {
    const app::ClientPoint a = app::toCanvas(board, stretch[k - 1]);
    const app::ClientPoint along = app::toCanvas(board, stretch[k]) - a;
    const double length2 = dot(along, along);
    const double t = length2 > 0 ? std::clamp(dot(at - a, along) / length2, 0.0, 1.0) : 0.0;
    best = std::min(best, distance(at, a + along * t));
  }
  return best;
}

}  // namespace

void DrawSection::begin(const ToolEnv& env, const ToolEvent& event) {
  if (!env.ui.sections.board) return;
  watch_.begin(event);
  last_ = event;
  app::SectionBoard& board = *env.ui.sections.board;
  from_ = to_ = app::toSection(board, event.at);
  doubled_ = isDoubleTap(env.ui.sections, event);
  board.stroke.clear();
  if (board.tool == BoardTool::Points) takePoint(env);
  if (board.tool == BoardTool::Line && board.corners.empty()) board.corners.push_back(from_);
}

/// What lies under the pointer: a point, else a stretch of a curve.
void DrawSection::takePoint(const ToolEnv& env) {
  app::SectionBoard& board = *env.ui.sections.board;
  double reach = reachOf(last_);
  double stretchReach = reach;
  for (std::size_t c = 0; c < board.drawing.size(); ++c) {
    const sections::DrawnCurve& curve = board.drawing[c];
    for (std::size_t i = 0; i < curve.points.size(); ++i) {
      const double off = distance(app::toCanvas(board, curve.points[i].at), last_.at);
      if (off < reach) {
        reach = off;
        held_ = sections::PointRef{c, i};
      }
      if (const double side = distanceToStretch(board, curve, i, last_.at); side < stretchReach) {
        stretchReach = side;
        after_ = sections::PointRef{c, i};
      }
    }
  }
}

void DrawSection::move(const ToolEnv& env, const ToolEvent& event) {
  if (!env.ui.sections.board) return;  // a key has closed it
  watch_.move(event);
  last_ = event;
  app::SectionBoard& board = *env.ui.sections.board;
  to_ = app::toSection(board, event.at);
  if (!watch_.moved()) return;
  switch (board.tool) {
    case BoardTool::Pen: {
      if (board.stroke.empty()) board.stroke.push_back(from_);
      const app::ClientPoint before = app::toCanvas(board, board.stroke.back());
      if (distance(before, event.at) >= kPointSpacing) board.stroke.push_back(to_);
      break;
    }
    case BoardTool::Line:
      if (!board.corners.empty()) board.stroke = {board.corners.back(), to_};
      break;
    case BoardTool::Box:
    case BoardTool::Ellipse:
      board.stroke = sections::outlineOf(board.tool == BoardTool::Box ? sections::boxCurve(from_, to_)
                                                                      : sections::ellipseCurve(from_, to_));
      break;
    case BoardTool::Points:
      if (!held_ && after_) {  // pulling at the curve pulls a new point out of it
        sections::Drawing next = board.drawing;
        held_ = sections::addPoint(next, *after_, from_, board.symmetry);
        board.live = std::move(next);
      }
      if (held_) {
        if (!board.live) board.live = board.drawing;
        board.point = held_;
        sections::movePoint(*board.live, *held_, to_, board.symmetry);
        app::previewBoard(env.ui, env.document);
      }
      break;
    case BoardTool::kCount:
      break;
  }
}

void DrawSection::commit(const ToolEnv& env) {
  if (!env.ui.sections.board) return;
  app::SectionBoard& board = *env.ui.sections.board;
  std::vector<SectionPoint> stroke = std::exchange(board.stroke, {});
  const bool moved = watch_.moved();
  switch (board.tool) {
    case BoardTool::Pen:
      board.live.reset();
      if (moved) env.sink.run(app::drawOnBoard, app::BoardStroke{Kind::Freehand, std::move(stroke)});
      break;
    case BoardTool::Line:
      commitLine(env);
      break;
    case BoardTool::Box:
    case BoardTool::Ellipse: {
      board.live.reset();
      const Kind kind = board.tool == BoardTool::Box ? Kind::Box : Kind::Ellipse;
      if (moved) env.sink.run(app::drawOnBoard, app::BoardStroke{kind, {from_, to_}});
      break;
    }
    case BoardTool::Points:
      commitPoint(env);
      break;
    case BoardTool::kCount:
      break;
  }
}

/// The end of a straight line is a corner; one on the first corner closes the curve.
void DrawSection::commitLine(const ToolEnv& env) {
  app::SectionBoard& board = *env.ui.sections.board;
  if (board.corners.empty()) return;  // taken back in the middle of the line
  const app::ClientPoint first = app::toCanvas(board, board.corners.front());
  const bool back = board.corners.size() >= 3 && distance(first, last_.at) < reachOf(last_);
  if (back || (doubled_ && !watch_.moved())) {
    if (board.corners.size() < 3) return;
    env.sink.run(app::drawOnBoard, app::BoardStroke{Kind::Corners, board.corners});
    return;
  }
  const app::ClientPoint before = app::toCanvas(board, board.corners.back());
  if (distance(before, last_.at) > kMouseSlop) board.corners.push_back(to_);
}

void DrawSection::commitPoint(const ToolEnv& env) {
  app::SectionBoard& board = *env.ui.sections.board;
  if (!watch_.moved()) {
    board.point = held_;
    if (held_ && doubled_) env.sink.run(app::removeBoardPoint, *held_);
    if (!held_ && after_) env.sink.run(app::addBoardPoint, *after_, from_, std::nullopt);
    return;
  }
  if (!board.live) return;
  sections::Drawing next = *std::exchange(board.live, std::nullopt);
  if (!held_) return;
  // One step even where a point was pulled out of the curve.
  if (after_ && next.size() == board.drawing.size() &&
      next[held_->curve].points.size() != board.drawing[held_->curve].points.size()) {
    env.sink.run(app::addBoardPoint, *after_, from_, to_);
    return;
  }
  env.sink.run(app::moveBoardPoint, *held_, to_);
}

void DrawSection::cancel(const ToolEnv& env) {
  if (!env.ui.sections.board) return;
  app::SectionBoard& board = *env.ui.sections.board;
  board.stroke.clear();
  board.live.reset();
  if (board.tool == BoardTool::Line && board.corners.size() == 1) board.corners.clear();
  app::previewBoard(env.ui, env.document);
}

}  // namespace spineloft::tools
