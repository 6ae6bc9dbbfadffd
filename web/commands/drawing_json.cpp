#include "web/commands/drawing_json.h"

#include <algorithm>
#include <array>

#include "engine/document/pieces.h"
#include "engine/io/json_fields.h"
#include "web/edit/depth_dots.h"
#include "web/edit/line_drawing.h"

namespace spineloft::app {
namespace {

using document::Document;

void writePlace(JsonWriter& json, std::string_view key, double x, double y) {
  json.key(key).beginArray().number(x).number(y).endArray();
}

void writeLines(JsonWriter& json, const document::Drawing& drawing, const std::vector<LineId>& free) {
  json.key("lines").beginArray();
  for (const document::DrawnLine& line : drawing.lines) {
    json.beginObject().key("id").number(line.id.value).key("points").beginArray();
    for (const PicturePoint p : line.points) json.beginArray().number(p.x).number(p.y).endArray();
    json.endArray().key("hidden").beginArray();
    for (const auto& [from, to] : line.hidden) json.beginArray().number(from).number(to).endArray();
    json.endArray().key("closed").flag(line.closed).key("waits");
    json.flag(std::ranges::find(free, line.id) != free.end()).endObject();
  }
  json.endArray();
}

void writePieces(JsonWriter& json, const Document& document, const document::Drawing& drawing) {
  json.key("pieces").beginArray();
  for (const document::Part* part : piecesOf(document, drawing.id)) {
    const document::ElementRecipe& piece = *document::elementOf(*part);
    json.beginObject().key("part").number(part->id.value).key("kind").text(io::keyOf(piece.kind));
    json.key("outlines").beginArray();
    for (const document::LineOutline& outline : piece.outlines) {
      json.beginArray();
      for (const auto& [line, from, to] : outline.runs) {
        json.beginObject().key("line").number(line.value).key("from").number(from).key("to").number(to).endObject();
      }
      json.endArray();
    }
    json.endArray().endObject();
  }
  json.endArray();
}

/// Who is in front where, and what cannot be.
void writeOrders(JsonWriter& json, const Document& document, const pipeline::DerivedDrawing& drawing) {
  static constexpr std::array<std::string_view, 4> kFrom = {"drawn", "deduced", "guessed", "user"};
  const descriptive::Model& model = drawing.shape->model;
  const auto partOf = [&](std::uint32_t solid) { return drawing.pieces[model.solids[solid].piece]; };
  json.key("orders").beginArray();
  for (std::size_t k = 0; k < model.orders.orders.size(); ++k) {
    const descriptive::Order& order = model.orders.orders[k];
    const PicturePoint at = model.orders.overlaps.all()[k].at;
    json.beginObject().key("over").number(partOf(order.over).value).key("under").number(partOf(order.under).value);
    writePlace(json, "at", at.x, at.y);
    json.key("kind").text(order.kind == descriptive::OrderKind::Over ? "over" : "inside");
    json.key("from").text(kFrom[static_cast<std::size_t>(order.from)]).endObject();
  }
  json.endArray().key("contradictions").beginArray();
  for (const descriptive::Contradiction& one : model.orders.contradictions) {
    json.beginObject().key("pieces").beginArray();
    for (const std::uint32_t solid : one.pieces) json.number(partOf(solid).value);
    json.endArray();
    writePlace(json, "at", one.at.x, one.at.y);
    json.endObject();
  }
  for (const auto& [over, under] : model.conflicts) {
    json.beginObject().key("pieces").beginArray().number(partOf(over).value).number(partOf(under).value).endArray();
    json.key("at").null().endObject();
  }
  json.endArray().key("openEnds").beginArray();
  for (const LooseEnd& end : looseEndsOf(document, drawing)) {
    json.beginObject().key("line").number(end.line.value);
    writePlace(json, "at", end.at.x, end.at.y);
    json.endObject();
  }
  json.endArray();
}

}  // namespace

void writeDrawings(JsonWriter& json, const CommandEnv& env) {
  const Document& document = env.studio.document();
  const pipeline::Derived& derived = env.studio.derived();
  json.key("drawings").beginArray();
  for (std::size_t i = 0; i < std::min(document.drawings.size(), derived.drawings.size()); ++i) {
    const document::Drawing& drawing = document.drawings[i];
    json.beginObject().key("id").number(drawing.id.value).key("picture").number(drawing.picture.value);
    json.key("seenFrom").text(io::keyOf(drawing.seenFrom));
    writeLines(json, drawing, freeLines(document, drawing));
    writePieces(json, document, drawing);
    json.key("pins").beginArray();
    for (const auto& [line, at, z] : drawing.pins) {
      json.beginObject().key("line").number(line.value).key("at").number(at).key("z").number(z).endObject();
    }
    json.endArray();
    writeOrders(json, document, derived.drawings[i]);
    json.endObject();
  }
  json.endArray().key("bridges").beginArray();
  const LineMarks marks = lineMarks(document, derived, env.ui);
  const std::vector<Crossing> crossings =
      marks.crossings.empty() ? std::vector<Crossing>{} : crossingsOn(document, derived, env.ui.picture);
  for (std::size_t i = 0; i < std::min(crossings.size(), marks.crossings.size()); ++i) {
    json.beginObject().key("over").number(crossings[i].over.value).key("under").number(crossings[i].under.value);
    json.key("guessed").flag(crossings[i].guessed);
    writePlace(json, "at", marks.crossings[i].x, marks.crossings[i].y);
    json.endObject();
  }
  json.endArray().key("lineEnds").beginArray();
  for (const ClientPoint p : marks.looseEnds) json.beginArray().number(p.x).number(p.y).endArray();
  json.endArray().key("depthDots").beginArray();
  for (const DepthDot& dot : depthDots(document, derived, env.ui)) {
    json.beginObject().key("line").number(dot.line.value).key("along").number(dot.at).key("z").number(dot.where.z);
    json.key("pinned").flag(dot.pinned);
    writePlace(json, "at", dot.seen.x, dot.seen.y);
    json.endObject();
  }
  json.endArray();
}

}  // namespace spineloft::app
