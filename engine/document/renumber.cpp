#include "engine/document/renumber.h"

#include <map>

namespace spineloft::document {
namespace {

const PictureEntry& valueOf(const Box<PictureEntry>& box) { return box; }
const Part& valueOf(const Box<Part>& box) { return box; }
const Step& valueOf(const Box<Step>& box) { return box; }
const Drawing& valueOf(const Box<Drawing>& box) { return box; }
const Group& valueOf(const Group& group) { return group; }

/// The new ids by the old ones.
template <class IdType>
class NewIds {
 public:
  template <class T>
  explicit NewIds(const std::vector<T>& list) {
    for (const T& element : list)
      ids_.emplace(valueOf(element).id, IdType{static_cast<std::uint32_t>(ids_.size() + 1)});
  }
  void to(IdType& id) const {
    const auto at = ids_.find(id);
    id = at == ids_.end() ? IdType{} : at->second;
  }
  std::uint32_t count() const { return static_cast<std::uint32_t>(ids_.size()); }

 private:
  std::map<IdType, IdType> ids_;
};

template <class T, class Change>
void changeAll(std::vector<Box<T>>& boxes, const Change& change) {
  for (Box<T>& box : boxes) {
    T value = box;
    change(value);
    box = std::move(value);
  }
}

}  // namespace

void renumber(Document& document) {
  const NewIds<PictureId> pictures(document.pictures);
  const NewIds<PartId> parts(document.parts);
  const NewIds<StepId> steps(document.steps);
  const NewIds<GroupId> groups(document.groups);
  const NewIds<DrawingId> drawings(document.drawings);
  changeAll(document.pictures, [&](PictureEntry& entry) {
    pictures.to(entry.id);
    if (entry.view) pictures.to(entry.view->of);
  });
  changeAll(document.drawings, [&](Drawing& drawing) {
    drawings.to(drawing.id);
    pictures.to(drawing.picture);
    for (PieceOrder& order : drawing.orders) {
      parts.to(order.over);
      parts.to(order.under);
    }
  });
  changeAll(document.parts, [&](Part& part) {
    parts.to(part.id);
    groups.to(part.group);
    PictureId picture = pictureOf(part);
    pictures.to(picture);
    setPicture(part.recipe, picture);
    if (ElementRecipe* element = elementOf(part)) drawings.to(element->drawing);
    for (Outline* outline : outlinesOf(part.recipe)) pictures.to(outline->picture);
    if (part.relief && part.relief->laid) pictures.to(part.relief->laid->picture);
    if (BridgeRecipe* bridge = bridgeOf(part)) {
      parts.to(bridge->from.part);
      parts.to(bridge->to.part);
    }
  });
  changeAll(document.steps, [&](Step& step) {
    steps.to(step.id);
    for (Operand& operand : step.operands) {
      parts.to(operand.part);
      steps.to(operand.step);
    }
  });
  for (Group& group : document.groups) groups.to(group.id);
  document.lastPictureId = pictures.count();
  document.lastPartId = parts.count();
  document.lastStepId = steps.count();
  document.lastGroupId = groups.count();
  document.lastDrawingId = drawings.count();
}

}  // namespace spineloft::document
