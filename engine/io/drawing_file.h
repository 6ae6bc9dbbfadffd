// Bare drawings as recipes of the command line: lines in, pieces out.
#pragma once

#include <string>
#include <string_view>

#include "engine/base/result.h"
#include "engine/descriptive/model.h"
#include "engine/io/json_values.h"

namespace spineloft::io {

/// Whether the text is a JSON object with `drawing`.
bool isDrawing(std::string_view json);

/// {"drawing": {"size": [w, h], "lines": [{"points": [x, y, …], "closed", "hidden": true | [[from, to], …]}, …],
/// "pieces": "auto" | [{"name", "kind": "round" | "flat", "outlines": [[{"line", "from", "to"}, …], …], "stiffness",
/// "front", "back", "thickness"}, …], "pins": [{"line", "at", "z"}, …], "folds": [{"line", "at"}, …],
/// "orders": [{"over", "under", "at": [x, y]}, …], "seenFrom": "above" | "below" | "unknown"}}: see
/// descriptive/drawing.h. Only size and lines must be there. Errors: JsonInvalid with the key that is wrong or that
/// nobody knows, OutOfMemory.
Result<descriptive::Drawing> readDrawing(std::string_view json);

/// {"drawing": {"size", "nodes": {"crossing", "touch", "branch", "dip", "corner", "end"}, "pieces": [{"name", "kind",
/// "outlines", "planarity", "mesh"}], "lost": [{"name", "words"}], "openLines", "orders": [{"over", "under", "at",
/// "kind": "over" | "inside", "from": "drawn" | "deduced" | "guessed" | "user"}], "indices": [{"piece", "outline",
/// "from", "to", "hidden", "index"}], "contradictions": [{"pieces", "at", "words"}], "qp": {"unknowns", "rows",
/// "active", "rounds", "broken", "pinsHold"}}, "milliseconds"}. Pieces are named; places and lengths along outlines are
/// picture pixels, planarity a share of "size".
std::string writeDrawingReport(const descriptive::Model& model, const NamedNumbers& milliseconds);

}  // namespace spineloft::io
