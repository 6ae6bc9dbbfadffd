#include "web/edit/solid_editing.h"

#include <algorithm>

#include "web/model/colour_text.h"
#include "web/model/solid_faults.h"

namespace spineloft::app {
namespace {

using document::Operand;

bool isRoot(const document::Document& document, Operand operand) {
  const bool exists =
      operand.part ? findPart(document, operand.part) != nullptr : findStep(document, operand.step) != nullptr;
  return exists && holderOf(document, operand) == nullptr;
}

const pipeline::DerivedStep* derivedOf(const CommandEnv& env, StepId id) {
  const auto& steps = env.studio.derived().steps;
  const auto at = std::ranges::find(steps, id, &pipeline::DerivedStep::id);
  return at == steps.end() ? nullptr : &*at;
}

void writeOperands(JsonWriter& json, std::span<const Operand> operands) {
  json.beginArray();
  for (const Operand& operand : operands) {
    json.beginObject().key(operand.part ? "part" : "step");
    json.number(operand.part ? operand.part.value : operand.step.value).endObject();
  }
  json.endArray();
}

void writeStep(JsonWriter& json, const CommandEnv& env, const document::Step& step) {
  const pipeline::DerivedStep* derived = derivedOf(env, step.id);
  const bool root = holderOf(env.studio.document(), {{}, step.id}) == nullptr;
  json.beginObject().key("id").number(step.id.value).key("name").text(step.name);
  json.key("kind").text(document::stepKindKey(step.kind)).key("operands");
  writeOperands(json, step.operands);
  json.key("blend").number(step.blend).key("wall").number(step.wall);
  json.key("opening").text(document::openingKey(step.opening.side));
  json.key("openingDepth").number(step.opening.depth);
  json.key("visible").flag(step.visible).key("root").flag(root);
  json.key("ownLook").flag(step.ownLook).key("textured").flag(step.look.textured);
  json.key("colour").text(colourText(step.look.colour)).key("status");
  const bool failed = derived && derived->failure, ready = derived && derived->solid && !derived->waiting;
  json.text(!root ? "inside" : failed ? "failed" : ready ? "ready" : "waiting").key("failure");
  failed ? json.text(errorName(derived->failure->error)) : json.null();
  json.key("sentence").text(stepFailureWords(env, step)).key("faulty");
  failed && derived->faulty ? json.number(derived->faulty.value) : json.null();
  json.key("at");
  if (failed && derived->at) {
    json.beginArray().number(derived->at->x).number(derived->at->y).number(derived->at->z).endArray();
  } else {
    json.null();
  }
  const pipeline::Solid* solid = derived ? derived->solid.get() : nullptr;
  json.key("triangles").number(solid ? static_cast<double>(solid->mesh.triangles.size()) : 0);
  json.key("volume").number(solid ? solid->volume : 0).key("area").number(solid ? solid->area : 0);
  json.key("genus").number(solid ? solid->genus : 0).key("ms").number(solid ? solid->ms : 0);
  json.endObject();
}

/// The part, or the solid that it is in.
Operand rootOperand(const document::Document& document, const document::Part& part) {
  const document::Step* root = rootOf(document, {part.id, {}});
  return root ? Operand{{}, root->id} : Operand{part.id, {}};
}

}  // namespace

std::vector<Operand> rootsOf(const document::Document& document) {
  std::vector<Operand> roots;
  for (const document::Part& part : document.parts) {
    const Operand operand = rootOperand(document, part);
    if (std::ranges::find(roots, operand) == roots.end()) roots.push_back(operand);
  }
  return roots;
}

bool hasSeveralRoots(const document::Document& document) {
  const auto& parts = document.parts;
  return std::ranges::any_of(parts, [&](const document::Part& part) {
    return rootOperand(document, part) != rootOperand(document, parts.front());
  });
}

void settleSolids(const document::Document& document, UiState& ui) {
  const document::Step* chosen = findStep(document, ui.solids.step);
  // Who takes a part of something else in hand has left the solid.
  const auto holds = [&] { return std::ranges::count(partsIn(document, {{}, chosen->id}), ui.selection) > 0; };
  if (chosen != nullptr && ui.selection && !holds()) chosen = nullptr;
  if (chosen == nullptr) ui.solids.step = {};
  if (chosen == nullptr || chosen->kind != document::StepKind::Hollow) ui.solids.pointing = false;
  if (ui.solids.hollow && !isRoot(document, ui.solids.hollow->operands.front())) ui.solids.hollow.reset();
  std::erase_if(ui.solids.picked, [&](const Operand& o) { return !isRoot(document, o); });
  std::erase_if(ui.solids.folded, [&](StepId id) { return findStep(document, id) == nullptr; });
}

bool isPicked(const UiState& ui, Operand operand) {
  return std::ranges::find(ui.solids.picked, operand) != ui.solids.picked.end();
}

double millimetresPerUnit(const CommandEnv& env) {
  return millimetresPerUnit(env.studio.document(), env.studio.derived());
}

const document::Step* chosenStep(const CommandEnv& env) { return findStep(env.studio.document(), env.ui.solids.step); }

std::string stepFailureWords(const CommandEnv& env, const document::Step& step) {
  const pipeline::DerivedStep* derived = derivedOf(env, step.id);
  if (derived == nullptr || !derived->failure) return {};
  return spokenFailure(env.studio.document(), env.studio.derived(), *derived);
}

bool hasPlace(const CommandEnv& env, const document::Step& step) {
  const pipeline::DerivedStep* derived = derivedOf(env, step.id);
  return derived != nullptr && derived->failure && (derived->at || findPart(env.studio.document(), derived->faulty));
}

void writeSolids(JsonWriter& json, const CommandEnv& env) {
  json.key("steps").beginArray();
  for (const document::Step& step : env.studio.document().steps) writeStep(json, env, step);
  json.endArray().key("picked");
  writeOperands(json, env.ui.solids.picked);
  json.key("selectedStep");
  env.ui.solids.step ? json.number(env.ui.solids.step.value) : json.null();
  json.key("pointing").flag(env.ui.solids.pointing).key("hollow");
  if (!env.ui.solids.hollow) {
    json.null();
    return;
  }
  const document::CombineParts& draft = *env.ui.solids.hollow;
  json.beginObject().key("what");
  writeOperands(json, draft.operands);
  json.key("wall").number(draft.wall).key("opening").text(openingKey(draft.opening.side));
  json.key("openingDepth").number(draft.opening.depth).endObject();
}

}  // namespace spineloft::app
