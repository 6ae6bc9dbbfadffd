// The project: a GLB that any viewer shows and that carries the editable document and its pictures
// inside, as the glTF extension SPINELOFT_project. Hostile-proof: every number is checked against the
// ranges of the document, every size against the bytes that are there.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/io/export_part.h"

namespace spineloft::io {

/// What this program writes; it reads 1 … this. Every version has a golden file in tests/golden and a
/// migration step that a test runs.
inline constexpr int kProjectVersion = 2;

/// Finds a photo by its content hash; null when it is not there.
using PictureSource = std::function<std::shared_ptr<const image::Picture>(std::uint64_t)>;

/// What reading had to mend.
struct ReadNotes {
  std::size_t dropped = 0;            ///< pictures and parts that could not be kept
  std::size_t repaired = 0;           ///< values that were damaged or out of range, replaced by sound ones
  std::vector<std::string> why = {};  ///< what is wrong with the first of these, in plain words, where that is known
  void say(std::string words) {
    constexpr std::size_t kMostWords = 64;
    if (why.size() < kMostWords) why.push_back(std::move(words));
  }
  bool clean() const { return dropped == 0 && repaired == 0; }
  bool operator==(const ReadNotes&) const = default;
};

/// The document as JSON; photos by their content hash. Keys that this program did not know when it
/// read the document are written back as they came. Equal documents give equal texts.
std::string writeDocument(const document::Document& document);
/// Values that are damaged or out of range become defaults, parts without a usable stroke or picture are
/// left out; `notes`, when given, receives how many. What comes back could have been made by
/// document::update. Errors: ProjectInvalid (no document at all, with what is wrong), ProjectTooNew,
/// NoSuchPicture (a photo that `pictures` does not have), OutOfMemory.
Result<document::Document> readDocument(std::string_view json, const PictureSource& pictures,
                                        ReadNotes* notes = nullptr);

/// A photo of the document as it goes into the file: what writePhoto made of it.
struct ProjectPhoto {
  std::shared_ptr<const image::Picture> picture;
  std::span<const std::uint8_t> bytes;  ///< must outlive the call
};
/// The working copy as PNG: every pixel comes back as it was, nothing of the original file (place,
/// camera) goes along. Errors: PictureEmpty, OutOfMemory.
Result<Bytes> writePhoto(const image::Picture& picture);

/// The GLB with the document and its photos inside; `glb` is one of writeGlb, or empty for a project
/// without a model. A photo whose bytes the GLB shows as a texture is not stored again. Passes the
/// Khronos validator without errors or warnings; equal input gives equal bytes. Errors: NoSuchPicture
/// (a photo of the document is not among `photos`), ProjectInvalid (`glb` is no GLB), OutOfMemory (also
/// over 4 GiB).
Result<Bytes> embedProject(std::span<const std::uint8_t> glb, const document::Document& document,
                           std::span<const ProjectPhoto> photos);

/// Whether the bytes are, or at least begin as, a GLB with a project inside (cheap: looks at headers and
/// the JSON chunk).
bool holdsProject(std::span<const std::uint8_t> glb);
/// The document of a GLB that was written with one, alone or inside a PNG (png_model.h), mended as by readDocument;
/// pictures that cannot be read are left out with the parts on them, and counted. Errors: NoProjectInside (no GLB, or
/// one of another program), ProjectInvalid (also when it is cut off), ProjectTooNew, PictureUnreadable (not one of its
/// pictures can be read), those of modelInPng, OutOfMemory.
Result<document::Document> readProject(std::span<const std::uint8_t> file, ReadNotes* notes = nullptr);

}  // namespace spineloft::io
