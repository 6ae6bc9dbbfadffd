// A finished model as a file: document + derived parts → bytes. The only place that joins pipeline
// and io; the page and the command line both export through it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/progress.h"
#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/pipeline/derive.h"
#include "engine/pipeline/world.h"
#include "engine/printing/print_check.h"

namespace spineloft::publish {

using Bytes = std::vector<std::uint8_t>;

/// Project: the GLB under a name of its own, also of a board without any part.
/// ObjZip: OBJ with its materials and its texture in one archive.
enum class Format : std::uint8_t { Glb, Obj, Stl, Project, ObjZip, ThreeMf };
/// "glb", "obj", "stl", "spineloft", "zip", "3mf"; none for anything else.
std::optional<Format> formatFromKey(std::string_view key);
std::string_view formatKey(Format format);
std::string_view mediaType(Format format);
/// Whether a model can be opened again from a file of this format: the editable document is inside.
bool holdsDocument(Format format);

// How parts come to the world is the pipeline's (world.h).
using pipeline::worldBounds;
using pipeline::WorldBounds;
using pipeline::worldFrame;
using pipeline::WorldFrame;

/// What goes into a GLB besides the visible parts.
struct Options {
  bool withProject = true;  ///< the editable document and its photos (io/project_file.h)
  bool operator==(const Options&) const = default;
};

/// All visible parts as one file.
/// All stand on the ground, centred, as tall as Document::height.
/// - GLB: metres, y up, +z to the viewer; one node a part, one texture for all parts with a picture or two colours
///   (texture_assignment.h). The whole editable document is inside: io::readProject gives it back.
/// - Project: the same bytes; with nothing to show, or a part that cannot be shown, it is written all
///   the same.
/// - STL: millimetres, z up.
/// - 3MF: millimetres, z up, in the positive octant, with colours and texture.
/// - OBJ: millimetres, y up, one object a part; ObjZip: the same with materials and texture.
/// Pictures are encoded anew: the metadata of a photo is in none of them.
/// Errors: NothingToExport (not for Project), MeshInvalid (not for Project), Cancelled, OutOfMemory.
Result<Bytes> publish(const document::Document& document, const pipeline::Derived& derived, Format format,
                      const Progress& progress, const Options& options = {});

/// The visible parts in millimetres, as they go into a file for a printer, looked at before they are
/// printed. Errors: NothingToExport, OutOfMemory.
Result<printing::PrintCheck> checkPrint(const document::Document& document, const pipeline::Derived& derived);

/// How much of the model's lowest end a flat foot takes, millimetres (printing::flatFoot); none when
/// that does not make it stand. Errors: those of checkPrint.
Result<std::optional<double>> flatFoot(const document::Document& document, const pipeline::Derived& derived);

/// The model's name in portable characters, such as "swan-neck".
std::string plainName(const document::Document& document);

/// A file name such as "swan-neck-100mm.glb": the model's name in portable characters and its height; a
/// project's is without its height, "swan-neck.spineloft".
std::string fileName(const document::Document& document, Format format);

}  // namespace spineloft::publish
