#include "engine/document/update.h"

#include <algorithm>
#include <cmath>

#include "engine/document/params.h"
#include "engine/ribs/spine.h"

namespace spineloft::document {
namespace {

/// Cuts at most kMaxNameBytes off without splitting a UTF-8 character; `fallback` replaces emptiness.
std::string tidyName(std::string name, std::string fallback) {
  if (name.empty()) return fallback;
  if (name.size() <= kMaxNameBytes) return name;
  std::size_t end = kMaxNameBytes;
  while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xc0) == 0x80) --end;
  name.resize(end);
  return name;
}

std::string numberedName(std::uint32_t id) { return "Part " + std::to_string(id); }

bool known(loft::SectionPreset section) { return section < loft::SectionPreset::kCount; }
bool known(loft::CapStyle cap) { return cap < loft::CapStyle::kCount; }

Part* editPart(Document& document, PartId id) {
  const auto at = std::ranges::find(document.parts, id, &Part::id);
  return at == document.parts.end() ? nullptr : &*at;
}

/// Done when the stroke would make a spine on that picture.
Status checkStroke(const Document& document, const LoftRecipe& recipe) {
  const PictureEntry* entry = findPicture(document, recipe.picture);
  if (entry == nullptr) return Error::NoSuchPicture;
  const image::Size size{entry->picture->width, entry->picture->height};
  const Result<ribs::Spine> spine = ribs::cleanSpine(recipe.stroke, size, recipe.spine);
  if (!spine) return spine.failure();
  return Done{};
}

/// Applies one action to a copy of the document; every action has its overload, or this does not
/// compile.
struct Apply {
  Document& document;

  Status operator()(const AddPicture& a) const {
    if (!a.picture || a.picture->working.empty()) return Error::PictureEmpty;
    const PictureId id{++document.lastPictureId};
    document.pictures.push_back({id, tidyName(a.name, "Picture " + std::to_string(id.value)),
                                 a.picture, contentHash(*a.picture)});
    return Done{};
  }
  Status operator()(const RemovePicture& a) const {
    if (findPicture(document, a.picture) == nullptr) return Error::NoSuchPicture;
    std::erase_if(document.parts, [&](const Part& p) { return p.recipe.picture == a.picture; });
    std::erase_if(document.pictures, [&](const PictureEntry& p) { return p.id == a.picture; });
    return Done{};
  }
  Status operator()(const DrawSpine& a) const {
    if (!known(a.section) || !known(a.startCap) || !known(a.endCap)) return Error::ValueOutOfRange;
    Part part;
    part.recipe.picture = a.picture;
    part.recipe.stroke = a.stroke;
    part.recipe.loft.section = a.section;
    part.recipe.loft.startCap = a.startCap;
    part.recipe.loft.endCap = a.endCap;
    part.look = a.look;
    if (Status stroke = checkStroke(document, part.recipe); !stroke) return stroke;
    part.id = PartId{++document.lastPartId};
    part.name = numberedName(part.id.value);
    document.parts.push_back(std::move(part));
    return Done{};
  }
  Status operator()(const RedrawSpine& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    part->recipe.stroke = a.stroke;
    return checkStroke(document, part->recipe);
  }
  Status operator()(const SetSection& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    if (!known(a.section)) return Error::ValueOutOfRange;
    part->recipe.loft.section = a.section;
    return Done{};
  }
  Status operator()(const SetCaps& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    if (!known(a.start) || !known(a.end)) return Error::ValueOutOfRange;
    part->recipe.loft.startCap = a.start;
    part->recipe.loft.endCap = a.end;
    return Done{};
  }
  Status operator()(const SetLook& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    part->look = a.look;
    return Done{};
  }
  Status operator()(const SetParameter& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    const ParamInfo* info = findParam(a.key);
    if (info == nullptr) return {Error::ValueOutOfRange, a.key};
    // Written so that NaN fails too.
    if (!(a.value >= info->low && a.value <= info->high)) return {Error::ValueOutOfRange, a.key};
    const double steps = std::round((a.value - info->low) / info->step);
    info->set(part->recipe, std::min(info->high, info->low + steps * info->step));
    return checkStroke(document, part->recipe);
  }
  Status operator()(const RenamePart& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    part->name = tidyName(a.name, numberedName(a.part.value));
    return Done{};
  }
  Status operator()(const ShowPart& a) const {
    Part* part = editPart(document, a.part);
    if (part == nullptr) return Error::NoSuchPart;
    part->visible = a.visible;
    return Done{};
  }
  Status operator()(const DeletePart& a) const {
    if (editPart(document, a.part) == nullptr) return Error::NoSuchPart;
    std::erase_if(document.parts, [&](const Part& p) { return p.id == a.part; });
    return Done{};
  }
  Status operator()(const SetHeight& a) const {
    if (!(a.height.value >= kMinHeightMm && a.height.value <= kMaxHeightMm)) {
      return {Error::ValueOutOfRange, "height 1 mm to 10 m"};
    }
    document.height = a.height;
    return Done{};
  }
  Status operator()(const RenameDocument& a) const {
    document.name = tidyName(a.name, "Model");
    return Done{};
  }
};

}  // namespace

Result<Document> update(const Document& document, const Action& action) {
  Document next = document;
  const Status status = std::visit(Apply{next}, action);
  if (!status) return status.failure();
  return next;
}

}  // namespace spineloft::document
