// Arguments of commands: from JSON to the engine's values.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "engine/base/ids.h"
#include "engine/geometry/along.h"
#include "engine/mesh/tri_mesh.h"
#include "engine/ribs/edit/edit_gestures.h"
#include "web/commands/commands.h"

namespace spineloft::app {

/// "This needs …."
Outcome missing(std::string_view what);
Outcome noPart();
/// Why a part that is meant cannot be worked on as a loft: it is none, or it is not there.
Outcome noSpine(const document::Part* part);
Outcome noSpine(const CommandEnv& env, const Json& args);

/// [[x, y], …] under `key`; none when it is anything else. Numbers that are no numbers become NaN, so
/// that the engine can refuse them by name.
std::optional<std::vector<PicturePoint>> strokeOf(const Json& args, std::string_view key = "stroke");
/// [[[x, y], …], …] under `key`, likewise.
std::optional<std::vector<std::vector<PicturePoint>>> linesOf(const Json& args, std::string_view key);
/// [x, y] under `key`.
std::optional<PicturePoint> pointOf(const Json& args, std::string_view key);
/// A place of a part: [x, y, z] of its space, or [x, y] of the picture, which is cast onto the front of its mesh,
/// `back`: onto its back. None: it is neither, or beside the mesh.
std::optional<ModelPoint> placeOf(const mesh::TriMesh& mesh, const Json& place, bool back);
/// [[place, value], …] under `key`.
std::optional<geometry::AlongCurve> curveOf(const Json& args, std::string_view key);
/// `rib` and `side` ("left" or "right").
std::optional<ribs::EndRef> endOf(const Json& args);
/// None for anything but a whole number from 1 on.
PartId idFrom(const Json& args, std::string_view key);
/// How far a picture point is to move: `by`, or 1 pixel in the way of the arrow `key`, 10 with the flag `far`.
std::optional<PicturePoint> nudgeOf(const Json& args);
/// The keys of commands that take it.
inline constexpr std::string_view kArrowKeys =
    "ArrowLeft, ArrowRight, ArrowUp, ArrowDown, Shift+ArrowLeft, Shift+ArrowRight, Shift+ArrowUp, Shift+ArrowDown";
/// A part is meant by its id, not the selected one.
bool namesPart(const Json& args);

}  // namespace spineloft::app
