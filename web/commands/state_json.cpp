#include "web/commands/state_json.h"

#include <algorithm>
#include <array>
#include <span>

#include "engine/document/params.h"
#include "engine/inflate/ready_profiles.h"
#include "engine/inflate/thin_rings.h"
#include "engine/io/json_fields.h"
#include "web/edit/editing.h"
#include "web/edit/gizmo.h"
#include "web/edit/placing.h"
#include "web/edit/puff_bones.h"
#include "web/edit/shaping.h"
#include "web/model/colour_text.h"

#include "web/commands/bridge_json.h"
#include "web/commands/drawing_json.h"
#include "web/commands/modes.h"
#include "web/commands/pull_json.h"
#include "web/commands/relief_json.h"
#include "web/commands/section_json.h"
#include "web/commands/sheet_json.h"
#include "web/edit/solid_editing.h"
#include "web/edit/spinning.h"

namespace spineloft::app {
namespace {

void writePoint(JsonWriter& json, std::string_view key, PicturePoint p) {
  json.key(key).beginArray().number(p.x).number(p.y).endArray();
}

void writeLine(JsonWriter& json, std::span<const PicturePoint> points) {
  json.beginArray();
  for (const PicturePoint p : points) json.beginArray().number(p.x).number(p.y).endArray();
  json.endArray();
}

void writeLine(JsonWriter& json, std::string_view key, std::span<const PicturePoint> points) {
  json.key(key);
  writeLine(json, points);
}

void writeOthers(JsonWriter& json, std::string_view key, const ribs::OtherPlaces& others) {
  writeLine(json, key, std::span(others.at).first(static_cast<std::size_t>(others.count)));
}

void writePose(JsonWriter& json, const loft::Pose& pose) {
  json.key("pose").beginObject();
  writeLine(json, "stroke", pose.stroke);
  json.key("depth").beginArray();
  for (const auto& [at, value] : pose.depth.points) {
    json.beginArray().number(at).number(value).endArray();
  }
  json.endArray().key("turns").number(pose.coilTurns).key("radius").number(pose.coilRadius);
  json.key("closed").flag(pose.closed).endObject();
}

void writeEnd(JsonWriter& json, std::string_view key, const std::optional<ribs::EndRef>& end) {
  json.key(key);
  if (!end) {
    json.null();
    return;
  }
  json.beginObject().key("rib").number(static_cast<double>(end->rib));
  json.key("side").text(end->side == ribs::Side::Left ? "left" : "right").endObject();
}

/// What the tools show and how they work.
void writeEditing(JsonWriter& json, const UiState& ui) {
  json.key("hover").beginObject().key("part");
  ui.hover.part ? json.number(ui.hover.part.value) : json.null();
  writeEnd(json, "end", ui.hover.end);
  json.key("other").number(ui.hover.other).key("handle").number(ui.hover.handle);
  json.key("bone").flag(ui.hover.spine).key("depth").number(ui.hover.depth);
  json.key("mark").number(ui.hover.mark).endObject();
  json.key("chosen").beginObject();
  writeEnd(json, "end", ui.chosen.end);
  json.key("handle").number(ui.chosen.handle).key("boneHandle").number(ui.chosen.bone);
  json.key("shapeHandle").number(ui.chosen.shape).key("bridge").number(ui.chosen.crossing);
  json.key("pull").number(ui.chosen.pull).key("outline");
  if (ui.chosen.outline) {
    json.beginArray().number(static_cast<double>(ui.chosen.outline->contour));
    json.number(static_cast<double>(ui.chosen.outline->point)).endArray();
  } else {
    json.null();
  }
  json.endObject();
  json.key("touched").beginArray();
  for (const ribs::EndRef end : ui.inHand.touched) {
    json.beginObject().key("rib").number(static_cast<double>(end.rib));
    json.key("side").text(end.side == ribs::Side::Left ? "left" : "right").endObject();
  }
  json.endArray();
  const EditOptions& edit = ui.edit;
  json.key("options").beginObject().key("ribReach").number(edit.ribReach);
  json.key("boneReach").number(edit.spineReach).key("bothSides").flag(edit.bothSides);
  json.key("keepRibs").flag(edit.keepRibs).key("wholePicture").flag(edit.wholePicture);
  json.key("paintOver").flag(edit.paintOver);
  json.key("depthByPressure").flag(edit.depthByPressure).key("brush").number(edit.brush);
  json.key("hiddenPen").flag(edit.hiddenPen);
  json.key("pullReach").number(edit.pullReach).key("pullSharp").flag(edit.pullSharp);
  json.key("bridgeWidth").number(edit.bridgeWidth);
  json.endObject();
}

void writeMarks(JsonWriter& json, std::span<const ribs::IgnoreMark> marks) {
  json.key("ignored").number(static_cast<double>(marks.size()));
  const auto covering = std::ranges::count_if(marks, [](const ribs::IgnoreMark& mark) { return mark.covers; });
  json.key("paintedOver").number(static_cast<double>(covering));
}

void writeRibs(JsonWriter& json, const ribs::RibSet& set) {
  json.key("ribs").beginArray();
  for (const ribs::Rib& rib : set.ribs) {
    json.beginObject();
    writePoint(json, "center", rib.center);
    writePoint(json, "left", rib.left);
    writePoint(json, "right", rib.right);
    json.key("leftState").text(ribs::ribStateKey(rib.leftState));
    json.key("rightState").text(ribs::ribStateKey(rib.rightState));
    writeOthers(json, "leftOthers", rib.leftOthers);
    writeOthers(json, "rightOthers", rib.rightOthers);
    json.endObject();
  }
  json.endArray();
}

/// Of what is made of a region: it as drawn and as cleaned, and their numbers.
void writeRegion(JsonWriter& json, const document::Part& part, const pipeline::PartShape* shape) {
  const document::Region* region = document::regionOf(part.recipe);
  if (region == nullptr) return;
  json.key("contours").beginArray();
  for (const auto& contour : region->contours) writeLine(json, contour);
  json.endArray().key("ribbon").number(region->ribbon);
  json.key("outlines").number(shape ? static_cast<double>(shape->contours.size()) : 0);
  if (const document::InflateRecipe* inflate = document::inflateOf(part)) {
    json.key("sides").text(io::keyOf(inflate->inflate.sides));
    json.key("slice").text(inflate::profileKey(inflate->inflate.profile));
  }
  if (const document::ExtrudeRecipe* extrude = document::extrudeOf(part)) {
    json.key("edge").text(io::keyOf(extrude->extrude.edge));
  }
  if (const document::LatheRecipe* spun = document::latheOf(part)) {
    json.key("open").flag(region->open);
    writeLine(json, "axis", std::array{spun->lathe.axisFrom, spun->lathe.axisTo});
  }
}

void writeNumbers(JsonWriter& json, std::string_view key, std::initializer_list<double> values) {
  json.key(key).beginArray();
  for (const double value : values) json.number(value);
  json.endArray();
}

/// The bones of a puff with a slice, in picture pixels, and where its other slices are.
void writeBones(JsonWriter& json, const BonedPuff& puff) {
  json.key("bones");
  if (!puff) {
    json.null();
    return;
  }
  int ends = 0, forks = 0, rings = 0;
  double length = 0;
  for (const inflate::EditedSkeleton& piece : puff.shape->bones) {
    ends += piece.skeleton.ends;
    forks += piece.skeleton.forks;
    rings += piece.skeleton.rings;
    length += inflate::lengthOf(piece.skeleton);
  }
  json.beginObject().key("ends").number(ends).key("forks").number(forks).key("rings").number(rings);
  json.key("length").number(length).key("asleep").number(inflate::asleep(puff.shape->bones));
  json.key("thickened").number(inflate::thinRings(puff.shape->bones, puff.picture, *puff.params));
  const std::vector<BoneHandle> handles = boneHandles(puff);
  for (const auto& [key, hold] : {std::pair{"branches", BoneHold::Bone}, {"gone", BoneHold::Gone}}) {
    json.key(key).beginArray();
    for (const BoneHandle& handle : handles) {
      if (handle.hold == hold) writeLine(json, handle.line);
    }
    json.endArray();
  }
  json.key("knobs").beginArray();
  for (const BoneHandle& handle : handles) {
    if (handle.hold != BoneHold::Knob) continue;
    json.beginArray().number(handle.at.x).number(handle.at.y).number(handle.factor).endArray();
  }
  json.endArray().key("slices").beginArray();
  for (const inflate::ProfileSlice& slice : puff.params->profile.slices) {
    json.beginObject().key("slice").text(inflate::profileKey({{{slice.shape}}})).key("at");
    if (slice.at) {
      json.beginArray().number(slice.at->x).number(slice.at->y).endArray();
    } else {
      json.null();
    }
    json.endObject();
  }
  json.endArray().endObject();
}

/// Where the bones of the puff in hand are held on the canvas.
void writeBoneHandles(JsonWriter& json, const CommandEnv& env) {
  json.key("boneHandles").beginArray();
  const BonedPuff puff = bonesInHand(env.studio.document(), env.studio.derived(), env.ui);
  for (const BoneHandle& handle : boneHandles(puff)) {
    json.beginObject().key("hold").text(holdKey(handle.hold));
    const ClientPoint at = holdOnCanvas(handle, env.ui);
    writeNumbers(json, "at", {at.x, at.y});
    json.endObject();
  }
  json.endArray();
}

void writeOutline(JsonWriter& json, const document::Outline& outline) {
  json.beginObject().key("picture").number(outline.picture.value).key("lines").beginArray();
  for (const auto& line : outline.lines) writeLine(json, line);
  json.endArray().endObject();
}

/// Of a shape: what it is before an outline says more, picture pixels, and its outlines.
void writeShape(JsonWriter& json, const document::Part& part) {
  json.key("shape");
  const document::ShapeRecipe* recipe = document::shapeOf(part);
  if (recipe == nullptr) {
    json.null();
    return;
  }
  const shape::ShapeParams& shape = recipe->shape;
  json.beginObject().key("kind").text(io::keyOf(shape.primitive));
  writeLine(json, "axis", std::array{shape.axis.from, shape.axis.to});
  json.key("width").number(shape.width).key("depth").text(io::keyOf(shape.depth.mode));
  json.key("ratio").number(shape.depth.ratio).key("outlines").beginArray();
  for (const document::Outline& outline : recipe->outlines) writeOutline(json, outline);
  json.endArray().endObject();
}

/// The outline of the shape in hand, pixels of the picture in view, and where it is held on the canvas.
void writeShapeInHand(JsonWriter& json, const CommandEnv& env) {
  const auto seen = shapeInHand(env.studio.document(), env.ui);
  json.key("nextShape").text(io::keyOf(env.ui.primitive));
  writeLine(json, "shapeOutline", seen ? seen->outline : std::vector<PicturePoint>{});
  json.key("shapeHandles").beginArray();
  for (const ShapeHandle& handle : seen ? shapeHandles(*seen) : std::vector<ShapeHandle>{}) {
    json.beginObject().key("hold").text(holdKey(handle.hold));
    const ClientPoint at = env.ui.pictureView.toClient(heldAt(handle, env.ui.pictureView.zoom), env.ui.layout.picture);
    writeNumbers(json, "at", {at.x, at.y});
    json.endObject();
  }
  json.endArray();
}

void writeParameters(JsonWriter& json, const document::Part& part) {
  json.key("parameters").beginObject();
  for (const document::ParamInfo& info : document::paramTable(document::kindOf(part))) {
    json.key(info.key).number(info.get(part.recipe));
  }
  json.endObject();
}

/// Where a part stands: in the world, and in the numbers that are shown.
void writePlacement(JsonWriter& json, const document::Part& part, double mm) {
  const document::Placement& at = part.placement;
  const auto number = [&](std::string_view key) { return placeNumber(part, key, mm); };
  json.key("placement").beginObject();
  writeNumbers(json, "pivot", {at.pivot.x, at.pivot.y, at.pivot.z});
  writeNumbers(json, "move", {at.move.x, at.move.y, at.move.z});
  writeNumbers(json, "turn", {at.turn.w, at.turn.x, at.turn.y, at.turn.z});
  json.key("scale").number(at.scale).key("mirrored").flag(at.mirrored);
  writeNumbers(json, "mm", {number("x"), number("y"), number("z")});
  writeNumbers(json, "degrees", {number("tip"), number("turn"), number("lean")});
  json.endObject().key("mirror");
  if (part.mirror) {
    const auto& [point, normal] = *part.mirror;
    json.beginArray().number(point.x).number(point.y).number(point.z);
    json.number(normal.x).number(normal.y).number(normal.z).endArray();
  } else {
    json.null();
  }
  json.key("group");
  part.group ? json.number(part.group.value) : json.null();
}

/// What is in hand, the groups, and where the handles of the gizmo are on the canvas.
void writePlacing(JsonWriter& json, const CommandEnv& env) {
  const UiState& ui = env.ui;
  const document::Document& document = env.studio.document();
  const std::vector<PartId> parts = selectedParts(document, ui);
  json.key("selected").beginArray();
  for (const PartId part : parts) json.number(part.value);
  json.endArray().key("groups").beginArray();
  for (const document::Group& group : document.groups) {
    json.beginObject().key("id").number(group.id.value).key("name").text(group.name).endObject();
  }
  json.endArray().key("snap").flag(ui.place.snap).key("gizmo");
  const std::optional<Gizmo> gizmo = shownGizmo(document, env.studio.derived(), ui);
  if (!gizmo) {
    json.null();
    return;
  }
  json.beginObject();
  writeNumbers(json, "at", {gizmo->at.x, gizmo->at.y});
  json.key("held").flag(ui.held != GizmoHandle::None).key("knobs").beginArray();
  for (const Gizmo::Knob& knob : gizmo->knobs) {
    json.beginObject().key("handle").text(handleKey(knob.handle));
    writeNumbers(json, "at", {knob.at.x, knob.at.y});
    json.endObject();
  }
  json.endArray().endObject();
}

/// `mm`: as of mmPerUnit.
void writePart(JsonWriter& json, const document::Document& document, const document::Part& part,
               const pipeline::DerivedPart& derived, double mm) {
  static const ribs::RibSet kNoRibs;
  json.beginObject().key("id").number(part.id.value).key("name").text(part.name);
  // What only lofts have is that of an empty one for other kinds.
  const document::LoftRecipe& loft = document::loftIn(part);
  const sections::SectionShape& shape = loft.loft.sections.front().shape;
  json.key("kind").text(document::kindKey(document::kindOf(part))).key("section");
  json.text(shape.drawn() ? "drawn" : sections::sectionKey(shape.preset));
  writeSections(json, part);
  json.key("caps").beginObject();
  json.key("start").text(sections::capKey(loft.loft.startCap));
  json.key("end").text(sections::capKey(loft.loft.endCap)).endObject();
  json.key("visible").flag(pipeline::isVisible(document, part)).key("textured").flag(part.look.textured);
  json.key("colour").text(colourText(part.look.colour));
  json.key("paint").text(surface::finishOf(part.look.paint).key);
  json.key("second").text(colourText(part.look.second)).key("faceted").flag(part.look.faceted);
  json.key("inked").flag(part.look.inked);
  json.key("picture").number(document::pictureOf(part).value);
  json.key("waiting").flag(derived.waiting);
  writePlacement(json, part, mm);
  writePulls(json, part, derived);
  writeBridge(json, part, derived);
  writeRelief(json, part, derived);
  json.key("failure");
  derived.failure ? json.text(errorName(derived.failure->error)) : json.null();
  json.key("mended").flag(derived.mended != nullptr);
  if (const auto at = crossingInWorld(document, derived)) {
    writeNumbers(json, "crossesAt", {at->x, at->y, at->z});
  } else {
    json.key("crossesAt").null();
  }
  writeRibs(json, derived.shape ? derived.shape->ribs : kNoRibs);
  const ribs::RibEdits& edits = loft.edits;
  json.key("edits").beginObject().key("ends").number(static_cast<double>(edits.ends.size()));
  json.key("added").number(static_cast<double>(edits.added.size()));
  json.key("removed").number(static_cast<double>(edits.removed.size())).endObject();
  writeMarks(json, loft.ignored);
  writePose(json, loft.pose);
  writeLine(
      json, "bone",
      derived.shape && document::loftOf(part) ? spineHandles({&part, &*derived.shape}) : std::vector<PicturePoint>{});
  writeRegion(json, part, derived.shape.get());
  writeBones(json, bonedPuff(document, part, derived.shape.get()));
  writeShape(json, part);
  const std::optional<document::Outline>* side = document::sideOf(part.recipe);
  json.key("side");
  side != nullptr && *side ? writeOutline(json, **side) : static_cast<void>(json.null());
  writeParameters(json, part);
  json.key("triangles");
  json.number(derived.shape ? static_cast<double>(derived.shape->mesh.triangles.size()) : 0);
  json.endObject();
}

/// The last check for printing, while the document is as it was then.
void writePrint(JsonWriter& json, const document::Document& document, const UiState& ui) {
  json.key("print");
  if (!ui.print || !(ui.print->of == document)) {
    json.null();
    return;
  }
  const printing::PrintCheck& check = ui.print->check;
  json.beginObject()
      .key("closed")
      .flag(check.closed)
      .key("pieces")
      .number(static_cast<double>(check.pieces))
      .key("size")
      .beginArray();
  for (const double side : check.size) json.number(side);
  json.endArray().key("thinnest").number(check.thinnest).key("lean").number(check.tippingAngle);
  json.key("stands").flag(check.stands()).key("volume").number(check.volume).key("printer");
  const auto printers = printing::printers();
  check.printer < printers.size() ? json.text(printers[check.printer].name) : json.null();
  json.key("lines").beginArray();
  for (const PrintLine& line : printLines(*ui.print)) {
    json.beginObject().key("good").flag(line.good).key("text").text(line.text);
    json.key("fix").text(line.fix).endObject();
  }
  json.endArray().endObject();
}

void writePicture(JsonWriter& json, const document::PictureEntry* entry) {
  json.key("picture");
  if (entry == nullptr) {
    json.null();
    return;
  }
  json.beginObject().key("width").number(entry->size.width);
  json.key("height").number(entry->size.height).key("name").text(entry->name);
  json.key("id").number(entry->id.value);
  writeMarks(json, entry->ignored);
  json.key("sketch").flag(entry->isSketch());
  json.key("strokes").number(static_cast<double>(entry->sketch.size()));
  json.key("finished").flag(entry->isSketch() && looksFinished(*entry)).endObject();
}

void writePictureList(JsonWriter& json, const document::Document& document) {
  json.key("pictures").number(static_cast<double>(document.pictures.size()));
  json.key("pictureList").beginArray();
  for (const document::PictureEntry& entry : document.pictures) {
    json.beginObject().key("id").number(entry.id.value).key("name").text(entry.name);
    json.key("width").number(entry.size.width).key("height").number(entry.size.height);
    json.key("sketch").flag(entry.isSketch()).key("view");
    if (entry.view) {
      const geometry::View& view = entry.view->view;
      json.beginObject().key("of").number(entry.view->of.value).key("from").text(io::keyOf(view.from));
      json.key("middle").number(view.middle).key("scale").number(view.scale).key("shift").number(view.shift);
      json.endObject();
    } else {
      json.null();
    }
    json.endObject();
  }
  json.endArray();
}

/// What the pen is set to, and how many points the stroke in hand has; null: none is.
void writePen(JsonWriter& json, const Sketching& pen) {
  json.key("pen").beginObject().key("size").text(kPenSizes[pen.penSize]);
  json.key("eraser").text(kPenSizes[pen.eraserSize]).key("colour").text(colourText(pen.colour));
  json.key("points");
  pen.stroke ? json.number(static_cast<double>(pen.stroke->points.size())) : json.null();
  json.key("menu").flag(pen.menu != PenMenu::None);
  json.endObject();
}

void writeActivity(JsonWriter& json, const Studio& studio) {
  json.key("activity");
  const std::optional<Studio::Activity> activity = studio.activity();
  if (!activity) {
    json.null();
    return;
  }
  json.beginObject().key("label").text(activity->label);
  json.key("done").number(activity->done).endObject();
}

/// What is being cut out; null: nothing is.
void writeCut(JsonWriter& json, const UiState& ui) {
  json.key("cutByBox").flag(ui.cutBy == CutBy::Box);
  json.key("cutByScribble").flag(ui.cutBy == CutBy::Scribble).key("cut");
  if (!ui.cut) {
    json.null();
    return;
  }
  const CutDraft& cut = *ui.cut;
  json.beginObject().key("searching").flag(cut.searching).key("adding").flag(cut.adding);
  json.key("marks").number(static_cast<double>(cut.hints.marks.size()));
  json.key("undone").number(static_cast<double>(cut.undone.size())).key("contours").beginArray();
  for (const auto& contour : cut.shape.contours) writeLine(json, contour);
  json.endArray().endObject();
}

void writeControl(JsonWriter& json, const Control& control) {
  json.beginObject().key("kind").text(controlKey(control.kind)).key("words").text(control.words);
  writeNumbers(json, "at", {control.at.x, control.at.y, control.at.width, control.at.height});
  json.key("inSight").flag(control.inSight).key("enabled").flag(control.enabled).key("on").flag(control.on);
  json.key("id").number(control.id).key("command");
  control.command.empty() ? json.null() : json.text(control.command);
  json.key("slide");
  if (control.slide) {
    json.beginObject().key("low").number(control.slide->low).key("high").number(control.slide->high);
    json.key("value").number(control.slide->value).key("text").text(control.slide->text).endObject();
  } else {
    json.null();
  }
  json.endObject();
}

void writeControls(JsonWriter& json, const std::vector<Control>& controls) {
  json.key("controls").beginArray();
  for (const Control& control : controls) writeControl(json, control);
  json.endArray();
}

void writePreview(JsonWriter& json, const UiState& ui) {
  json.key("preview");
  if (!ui.preview) {
    json.null();
    return;
  }
  const Preview& preview = *ui.preview;
  const auto& shape = preview.shape;
  json.beginObject().key("points").number(static_cast<double>(preview.loft().stroke.size()));
  json.key("part");
  preview.part ? json.number(preview.part.value) : json.null();
  json.key("fresh").flag(preview.fresh);
  json.key("ribs").number(shape ? static_cast<double>(shape->ribs.ribs.size()) : 0);
  json.key("triangles").number(shape ? static_cast<double>(shape->mesh.triangles.size()) : 0);
  json.key("costMs").number(preview.costMs).endObject();
}

}  // namespace

void writeState(const CommandEnv& env, std::uint64_t frames, JsonWriter& json) {
  Studio& studio = env.studio;
  const UiState& ui = env.ui;
  const pipeline::Derived& derived = studio.derived();
  const document::Document& document = studio.document();
  json.beginObject().key("version").text(SPINELOFT_VERSION);
  writePicture(json, document::findPicture(document, ui.picture));
  writePictureList(json, document);
  writePen(json, ui.sketching);
  const double mm = mmPerUnit(document, derived);
  json.key("parts").beginArray();
  for (std::size_t i = 0; i < document.parts.size(); ++i) {
    writePart(json, document, document.parts[i], derived.parts[i], mm);
  }
  json.endArray();
  writeSolids(json, env);
  json.key("selection");
  ui.selection ? json.number(ui.selection.value) : json.null();
  json.key("tool").text(toolKey(ui.tool));
  json.key("axis");
  const std::optional<ShownAxis> axis = shownAxis(document, ui);
  axis ? writeLine(json, std::array{axis->from, axis->to}) : static_cast<void>(json.null());
  writeSheet(json, env);
  writeBoneHandles(json, env);
  writeShapeInHand(json, env);
  writeDrawings(json, env);
  writePullKnobs(json, env);
  writeBridgeKnobs(json, env);
  json.key("modes").beginArray();
  for (const Mode* mode : modes()) {
    if (mode->open(env)) json.text(mode->name);
  }
  json.endArray().key("redraw");
  ui.redraw ? json.number(ui.redraw.value) : json.null();
  json.key("undo").number(static_cast<double>(studio.undoSteps()));
  json.key("redo").number(static_cast<double>(studio.redoSteps()));
  json.key("history").beginObject().key("bytes");
  json.number(static_cast<double>(studio.history().bytes())).key("budget");
  json.number(static_cast<double>(studio.history().budget())).endObject();
  json.key("busy").flag(studio.busy()).key("threads").number(studio.threads());
  const pipeline::StageMs& ms = studio.lastMs();
  json.key("lastMs").beginObject().key("edges").number(ms.edges).key("ribs").number(ms.ribs);
  json.key("loft").number(ms.loft).endObject();
  json.key("unsaved").flag(studio.unsaved());
  writeActivity(json, studio);
  writePreview(json, ui);
  writeCut(json, ui);
  writeSectionUi(json, ui.sections);
  writeEditing(json, ui);
  writePlacing(json, env);
  json.key("looks").text(ui.look.textured ? "picture" : "colour");
  json.key("heightMm").number(document.height.value).key("beside");
  ui.beside ? json.text(things()[*ui.beside].key) : json.null();
  writePrint(json, document, ui);
  writeControls(json, ui.controls);
  json.key("documentName").text(document.name);
  json.key("view").text(ui.focus == Focus::Picture ? "picture" : "solid");
  json.key("camera").beginObject().key("yaw").number(ui.camera.yaw);
  json.key("pitch").number(ui.camera.pitch).key("distance").number(ui.camera.distance).endObject();
  json.key("frames").number(static_cast<double>(frames)).endObject();
}

void sendControls(platform::Host& host, const std::vector<Control>& controls) {
  JsonWriter json;
  json.beginObject().key("type").text("controls");
  writeControls(json, controls);
  json.endObject();
  host.send(json.json());
}

}  // namespace spineloft::app
