#include "web/commands/sheet_json.h"

#include <initializer_list>
#include <optional>

#include "web/edit/drawn_rail.h"
#include "web/edit/layer_joints.h"
#include "web/edit/layers.h"

namespace spineloft::app {
namespace {

void writePlace(JsonWriter& json, std::optional<ClientPoint> at) {
  if (!at) {
    json.null();
    return;
  }
  json.beginArray().number(at->x).number(at->y).endArray();
}

void writeOf(JsonWriter& json, std::initializer_list<std::size_t> numbers) {
  json.beginObject().key("of").beginArray();
  for (const std::size_t number : numbers) json.number(static_cast<double>(number));
  json.endArray();
}

}  // namespace

void writeSheet(JsonWriter& json, const CommandEnv& env) {
  json.key("sheet");
  const auto sheet = shownSheet(env.studio.document(), env.ui);
  if (!sheet) {
    json.null();
    return;
  }
  const pipeline::ToWorld toWorld = sheetInWorld(env.studio.document(), env.studio.derived(), env.ui, *sheet);
  const auto onCanvas = [&](ModelPoint p) { return pointOnCanvas(env.ui.camera, env.ui.layout.solid, toWorld(p)); };
  json.beginObject().key("at").number(sheet->at).key("half").number(sheet->half).key("layer");
  sheet->layer ? json.number(static_cast<double>(*sheet->layer)) : json.null();
  json.key("free").flag(sheet->isFree());
  json.key("layers").beginArray();
  for (const stack::Plane& plane : sheet->recipe.planes) {
    json.beginObject().key("at").number(plane.at).key("curves");
    json.number(static_cast<double>(plane.curves.size())).endObject();
  }
  json.endArray().key("corners").beginArray();
  for (const ModelPoint corner : cornersOf(*sheet)) writePlace(json, onCanvas(corner));
  json.endArray().key("knob");
  writePlace(json, sheet->onRail() ? onCanvas(knobOf(*sheet)) : std::nullopt);
  const Lean lean = leanOf(*sheet);
  json.key("lean").beginObject().key("front").number(lean.front).key("side").number(lean.side).endObject();
  json.key("leanKnobs").beginArray();
  for (const auto way : kLeans) {
    if (sheet->onRail()) writePlace(json, onCanvas(leanKnobOf(*sheet, way)));
  }
  json.endArray().key("drawsRail").flag(drawsRail(env.studio.document(), env.ui));
  const LayerJoints joints = jointsOf(env.studio.document(), env.studio.derived(), env.ui, *sheet);
  json.key("links").beginArray();
  for (const LayerLink& link : joints.links) {
    writeOf(json, {link.plane, link.from, link.to});
    json.key("on").flag(link.on).key("mark");
    writePlace(json, onCanvas(link.mark));
    json.endObject();
  }
  json.endArray().key("forks").beginArray();
  for (const LayerFork& fork : joints.forks) {
    writeOf(json, {fork.plane, fork.curve});
    json.key("up").flag(fork.up).key("at").number(fork.at).key("knob");
    writePlace(json, onCanvas(fork.knob()));
    json.endObject();
  }
  json.endArray().endObject();
}

}  // namespace spineloft::app
