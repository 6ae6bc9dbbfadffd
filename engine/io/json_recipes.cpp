// The recipes of parts as JSON, of every kind. They are most of what a document can say: compiled in this file alone.
#include "engine/io/json_fields.h"

namespace spineloft::io {

void WriteMembers::recipe(const char* kindKey, const char* key, const document::Recipe& value) {
  if (document::kindOf(value) != document::PartKind::Loft) {
    out_[kindKey] = document::kindKey(document::kindOf(value));
  }
  std::visit([&](const auto& one) { (*this)(key, one); }, value);
}

void ReadMembers::recipe(const char* kindKey, const char* key, document::Recipe& value) {
  const auto kind = object_.find(kindKey);
  if (kind != object_.end()) {
    const auto* name = kind->get_ptr<const std::string*>();
    const document::PartKind known = name ? document::kindFromKey(*name) : document::PartKind::kCount;
    value = document::emptyRecipe(known);
    object_.erase(kind);
    if (known == document::PartKind::kCount) {
      reading_.notes.say(std::string(kindKey) + " must be " + wanted(known));
      return;
    }
  }
  std::visit([&](auto& one) { (*this)(key, one); }, value);
}

}  // namespace spineloft::io
