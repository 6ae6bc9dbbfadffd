// Sections in the arguments of commands, in state() and on the shelf that the browser keeps.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "web/model/json.h"
#include "web/ui/section_ui.h"

namespace spineloft::app {

/// [[x, y], …]; none when it is anything else. Numbers that are no numbers become NaN.
std::optional<std::vector<SectionPoint>> pointsFrom(const Json* list);
/// [[at, value], …] as a curve; none when it is anything else.
std::optional<geometry::AlongCurve> curveFrom(const Json* list);

/// The section that `args` names: {section: "star"}, {shelf: id}, or {contours: [[[x, y], …], …]},
/// which may be in any order, direction and size. None when it names none. Errors: ValueOutOfRange
/// for an unknown name, SectionInvalid for curves that make no section.
Result<std::optional<sections::SectionShape>> shapeFrom(const Json& args, const SectionUi& sections);
/// A blend from {blend: key, points?: [[t, value], …]}; `fallback` without a key. Errors:
/// ValueOutOfRange.
Result<sections::Blend> blendFrom(const Json& args, const sections::Blend& fallback);

/// {section: key} or {contours: …}: what shapeFrom reads.
Json shapeJson(const sections::SectionShape& shape);

/// The shelf as one text for the browser's storage, and back: what is not sound is left out.
Json shelfJson(const SectionUi& sections);
void readShelf(SectionUi& sections, const Json& shelf);

/// What state() says about the sections of a part: `sections` and `along`.
void writeSections(JsonWriter& json, const document::Part& part);
/// The open board, the shelf and what is picked: `sliceBoard`, `shelf`, `section`.
void writeSectionUi(JsonWriter& json, const SectionUi& sections);

}  // namespace spineloft::app
