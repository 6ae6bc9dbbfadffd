#include "engine/document/update_steps.h"

#include <algorithm>

#include "engine/document/checks.h"
#include "engine/document/update_parts.h"

namespace spineloft::document {
namespace {

/// Changes the step: `change` gets a copy and says whether it may replace the original.
template <class Change>
Status edit(Document& document, StepId id, const Change& change) {
  const auto at = std::ranges::find_if(document.steps, [&](const Step& step) { return step.id == id; });
  if (at == document.steps.end()) return Error::NoSuchStep;
  Step copy = *at;
  if (Status status = change(copy); !status) return status;
  if (Status status = checkStep(copy); !status) return status;
  *at = std::move(copy);
  return Done{};
}

Status checkOperands(const Document& document, std::span<const Operand> operands) {
  const Step* holder = operands.empty() ? nullptr : holderOf(document, operands.front());
  for (const Operand& operand : operands) {
    if (operand.part && !findPart(document, operand.part)) return Error::NoSuchPart;
    if (operand.step && !findStep(document, operand.step)) return Error::NoSuchStep;
    if (holderOf(document, operand) != holder) return Error::AlreadyUsed;
  }
  return Done{};
}

}  // namespace

Status applyStep(Document& document, const CombineParts& action) {
  if (document.steps.size() >= kMostSteps) return {Error::ValueOutOfRange, "too many solids"};
  Step step;
  step.kind = action.kind;
  step.operands = action.operands;
  step.wall = action.wall;
  step.opening = action.opening;
  if (Status sound = checkStep(step); !sound) return sound;
  if (Status known = checkOperands(document, step.operands); !known) return known;
  step.id = StepId{++document.lastStepId};
  step.name = fallbackName(step);
  const Operand self{{}, step.id};
  const Step* holder = holderOf(document, step.operands.front());
  const StepId above = holder == nullptr ? StepId{} : holder->id;
  document.steps.push_back(step);
  if (!above) return Done{};
  for (Box<Step>& box : document.steps) {
    if (box->id != above) continue;
    Step copy = *box;
    *std::ranges::find(copy.operands, step.operands.front()) = self;
    std::erase_if(copy.operands,
                  [&](const Operand& operand) { return std::ranges::count(step.operands, operand) > 0; });
    box = std::move(copy);
  }
  const Step* left = findStep(document, above);
  if (left->operands.size() < leastOperands(left->kind)) dissolve(document, above);
  return Done{};
}

Status applyStep(Document& document, const SetStep& action) {
  return edit(document, action.step, [&](Step& step) -> Status {
    step.kind = action.kind;
    step.blend = action.blend;
    step.wall = action.wall;
    step.opening = action.opening;
    return Done{};
  });
}

Status applyStep(Document& document, const OrderOperands& action) {
  return edit(document, action.step, [&](Step& step) -> Status {
    if (!std::ranges::is_permutation(step.operands, action.operands)) {
      return {Error::ValueOutOfRange, "other parts"};
    }
    step.operands = action.operands;
    return Done{};
  });
}

Status applyStep(Document& document, const ReleaseStep& action) {
  if (findStep(document, action.step) == nullptr) return Error::NoSuchStep;
  // A hollow inside holds one operand, which may be all that comes out of it; a join within a hollow comes apart into
  // more than a hollow can hold: then the hollow goes as well, and so does one that holds that one.
  for (StepId next = action.step; next;) {
    const Step* holder = holderOf(document, {{}, next});
    const StepId above = holder == nullptr ? StepId{} : holder->id;
    dissolve(document, next);
    const Step* left = above ? findStep(document, above) : nullptr;
    next = left != nullptr && !checkStep(*left) ? above : StepId{};
  }
  return Done{};
}

Status applyStep(Document& document, const DeleteStep& action) {
  if (findStep(document, action.step) == nullptr) return Error::NoSuchStep;
  const std::vector<PartId> parts = partsIn(document, {{}, action.step});
  for (const PartId id : parts) erasePart(document, id);
  return Done{};
}

Status applyStep(Document& document, const RenameStep& action) {
  return edit(document, action.step, [&](Step& step) -> Status {
    step.name = tidyName(action.name, fallbackName(step));
    return Done{};
  });
}

Status applyStep(Document& document, const ShowStep& action) {
  return edit(document, action.step, [&](Step& step) -> Status {
    step.visible = action.visible;
    return Done{};
  });
}

Status applyStep(Document& document, const SetStepLook& action) {
  return edit(document, action.step, [&](Step& step) -> Status {
    step.ownLook = action.own;
    step.look = action.look;
    return Done{};
  });
}

}  // namespace spineloft::document
