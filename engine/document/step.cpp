#include "engine/document/step.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "engine/document/document.h"

namespace spineloft::document {
namespace {

constexpr std::array<std::string_view, static_cast<std::size_t>(StepKind::kCount)> kKinds = {"join", "cut", "common",
                                                                                             "hollow"};
constexpr std::array<std::string_view, static_cast<std::size_t>(OpeningSide::kCount)> kSides = {
    "none", "start", "end", "up", "down", "left", "right", "front", "back"};

bool namesOne(const Operand& operand) { return bool(operand.part) != bool(operand.step); }

bool exists(const Document& document, const Operand& operand) {
  return operand.part ? findPart(document, operand.part) != nullptr : findStep(document, operand.step) != nullptr;
}

/// Whether the step can be reached from itself by going up; every way up ends after as many steps as
/// there are.
bool isInsideItself(const Document& document, StepId id) {
  Operand at{{}, id};
  for (std::size_t i = 0; i <= document.steps.size(); ++i) {
    const Step* holder = holderOf(document, at);
    if (holder == nullptr) return false;
    at = {{}, holder->id};
  }
  return true;
}

/// Changes the step in a copy.
template <class Change>
void change(Document& document, StepId id, const Change& to) {
  for (Box<Step>& box : document.steps) {
    if (box->id != id) continue;
    Step copy = *box;
    to(copy);
    box = std::move(copy);
    return;
  }
}

void collect(const Document& document, const Operand& operand, std::size_t depth, std::vector<PartId>& parts) {
  if (operand.part) parts.push_back(operand.part);
  const Step* step = operand.step ? findStep(document, operand.step) : nullptr;
  if (step == nullptr || depth > document.steps.size()) return;
  for (const Operand& inner : step->operands) collect(document, inner, depth + 1, parts);
}

}  // namespace

std::size_t leastOperands(StepKind kind) { return kind == StepKind::Hollow ? 1 : 2; }
std::size_t mostOperands(StepKind kind) { return kind == StepKind::Hollow ? 1 : kMostOperands; }

std::string_view stepKindKey(StepKind kind) {
  return kind < StepKind::kCount ? kKinds[static_cast<std::size_t>(kind)] : std::string_view();
}
std::string_view openingKey(OpeningSide side) {
  return side < OpeningSide::kCount ? kSides[static_cast<std::size_t>(side)] : std::string_view();
}

const Step* findStep(const Document& document, StepId id) {
  const auto at = std::ranges::find_if(document.steps, [&](const Step& step) { return step.id == id; });
  return at == document.steps.end() ? nullptr : &at->get();
}

const Step* holderOf(const Document& document, Operand operand) {
  const auto at = std::ranges::find_if(document.steps, [&](const Step& step) {
    return std::ranges::find(step.operands, operand) != step.operands.end();
  });
  return at == document.steps.end() ? nullptr : &at->get();
}

const Step* rootOf(const Document& document, Operand operand) {
  const Step* root = nullptr;
  for (std::size_t i = 0; i <= document.steps.size(); ++i) {
    const Step* holder = holderOf(document, operand);
    if (holder == nullptr) return root;
    root = holder;
    operand = {{}, holder->id};
  }
  return root;
}

std::vector<PartId> partsIn(const Document& document, Operand operand) {
  std::vector<PartId> parts;
  collect(document, operand, 0, parts);
  return parts;
}

Status checkStep(const Step& step) {
  if (step.kind >= StepKind::kCount) return {Error::ValueOutOfRange, "kind"};
  if (!(step.blend >= 0 && step.blend <= kMostBlend)) return {Error::ValueOutOfRange, "blend"};
  if (!(step.wall >= kLeastWall && step.wall <= kMostWall)) return {Error::ValueOutOfRange, "wall"};
  if (step.opening.side >= OpeningSide::kCount || !(step.opening.depth >= 0 && step.opening.depth <= kMostOpening)) {
    return {Error::ValueOutOfRange, "opening"};
  }
  const std::size_t count = step.operands.size();
  if (count < leastOperands(step.kind) || count > mostOperands(step.kind)) {
    return {Error::ValueOutOfRange, "number of parts"};
  }
  for (std::size_t i = 0; i < count; ++i) {
    const auto before = std::span(step.operands).first(i);
    if (!namesOne(step.operands[i]) || std::ranges::find(before, step.operands[i]) != before.end()) {
      return {Error::ValueOutOfRange, "part twice"};
    }
  }
  return Done{};
}

bool isForest(const Document& document) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> held;
  for (const Step& step : document.steps) {
    for (const Operand& operand : step.operands) {
      if (!namesOne(operand) || !exists(document, operand)) return false;
      if (!held.insert({operand.part.value, operand.step.value}).second) return false;
    }
  }
  return std::ranges::none_of(document.steps, [&](const Step& step) { return isInsideItself(document, step.id); });
}

std::size_t mendForest(Document& document) {
  std::size_t mended = 0;
  std::set<std::pair<std::uint32_t, std::uint32_t>> held;
  for (Box<Step>& box : document.steps) {
    Step step = *box;
    const std::size_t gone = std::erase_if(step.operands, [&](const Operand& operand) {
      return !namesOne(operand) || !exists(document, operand) ||
             !held.insert({operand.part.value, operand.step.value}).second;
    });
    if (gone == 0) continue;
    mended += gone;
    box = std::move(step);
  }
  const auto unsound = [&](const Step& step) { return !checkStep(step) || isInsideItself(document, step.id); };
  for (auto at = std::ranges::find_if(document.steps, unsound); at != document.steps.end();
       at = std::ranges::find_if(document.steps, unsound)) {
    dissolve(document, (*at)->id);
    ++mended;
  }
  return mended;
}

void dissolve(Document& document, StepId id) {
  const Step* step = findStep(document, id);
  if (step == nullptr) return;
  const std::vector<Operand> freed = step->operands;
  const Operand self{{}, id};
  const Step* holder = holderOf(document, self);
  const bool ofItself = holder == step;
  if (holder != nullptr && !ofItself) {
    const StepId above = holder->id;
    change(document, above, [&](Step& to) {
      auto at = std::ranges::find(to.operands, self);
      at = to.operands.erase(at);
      // One that comes back to its own holder stands alone: steps in a ring come apart.
      for (const Operand& operand : freed) {
        if (operand == Operand{{}, above}) continue;
        at = to.operands.insert(at, operand) + 1;
      }
    });
  }
  std::erase_if(document.steps, [&](const Step& s) { return s.id == id; });
}

void takeOut(Document& document, Operand operand) {
  const Step* holder = holderOf(document, operand);
  if (holder == nullptr) return;
  const StepId id = holder->id;
  change(document, id, [&](Step& step) { std::erase(step.operands, operand); });
  const Step* left = findStep(document, id);
  if (left->operands.size() >= leastOperands(left->kind)) return;
  if (left->operands.empty()) {
    takeOut(document, {{}, id});
    std::erase_if(document.steps, [&](const Step& s) { return s.id == id; });
  } else {
    dissolve(document, id);
  }
}

}  // namespace spineloft::document
