#include "tests/support/fuzz_inputs.h"

#include <algorithm>
#include <memory>
#include <string_view>
#include <vector>

#include "engine/base/crc32.h"
#include "engine/base/hash.h"
#include "engine/base/limits.h"
#include "engine/document/checks.h"
#include "engine/io/glb_container.h"
#include "engine/io/journal.h"
#include "engine/io/json_fields.h"
#include "engine/io/picture_file.h"
#include "engine/io/project_file.h"
#include "engine/io/share_text.h"
#include "tests/support/photo_copies.h"

namespace spineloft::testing {
namespace {

using namespace io;

/// Any photo that is asked for: a small grey one.
std::shared_ptr<const image::Picture> anyPhoto(std::uint64_t hash) {
  auto picture = std::make_shared<image::Picture>();
  picture->width = picture->height = 64;
  picture->working = {16, 16, std::vector<std::uint8_t>(16 * 16 * 4, static_cast<std::uint8_t>(hash))};
  return picture;
}

/// What is wrong with a document that was read.
std::string faultOf(const document::Document& document) {
  for (const document::Part& part : document.parts) {
    if (!document::checkDrawn(document, part.recipe)) return "a part without anything drawn";
    const document::LoftRecipe& recipe = document::loftIn(part);
    if (!ribs::isValid(recipe.edits) || !loft::isValid(recipe.pose) || !loft::checkParams(recipe.loft) ||
        !document::isValid(recipe.ignored)) {
      return "a part that could not have been made";
    }
    if (part.id.value == 0 || part.id.value > document.lastPartId) return "a part's id";
  }
  const std::string text = writeDocument(document);
  ReadNotes notes;
  const auto again = readDocument(
      text,
      [&](std::uint64_t hash) {
        for (const document::PictureEntry& entry : document.pictures) {
          if (entry.contentHash == hash && entry.picture) return entry.picture;
        }
        return std::shared_ptr<const image::Picture>();
      },
      &notes);
  if (!again) return "a document that cannot be read again: " + failureSentence(again.failure());
  if (again.value() != document || !notes.clean()) return "a document that reads back differently";
  if (writeDocument(again.value()) != text) return "a document that writes back differently";
  return {};
}

std::string tryJournal(std::string_view text) {
  std::vector<std::string> lines;
  while (lines.size() < 50 && !text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    std::string line(text.substr(0, end));
    if (!lines.empty()) line = hashKey(Hasher().text(line).value()) + line;
    lines.push_back(std::move(line));
    text.remove_prefix(std::min(text.size(), end + 1));
  }
  if (lines.empty()) return {};
  const auto read = readHistory(lines[0], std::span(lines).subspan(1), anyPhoto);
  if (!read) return {};
  const DocumentHistory& history = read.value().history;
  for (std::size_t i = 0; i <= history.undoSteps() + history.redoSteps(); ++i) {
    if (std::string fault = faultOf(history.at(i)); !fault.empty()) return fault;
  }
  const std::string base = writeHistory(history);
  const auto again = readHistory(base, {}, anyPhoto);
  if (!again || again.value().history.present() != history.present()) return "a history lost";
  if (again.value().history.undoSteps() != history.undoSteps()) return "steps of undo lost";
  return {};
}

/// As versions 1 and 2: the check sum stands behind, whole. The text of no version yet.
std::string sealAsFirst(std::vector<std::uint8_t> bytes) {
  const std::uint32_t sum = crc32(bytes);
  for (int shift = 24; shift >= 0; shift -= 8) bytes.push_back(static_cast<std::uint8_t>(sum >> shift));
  const std::string body = base64url(bytes);
  std::string text(1, '-');
  std::size_t length = body.size();
  for (; length >= 32; length /= 32) text += kDigits64[32 + length % 32];
  text += kDigits64[length];
  return text + body;
}

}  // namespace

std::string tryProject(std::span<const std::uint8_t> input) {
  const std::string_view text(reinterpret_cast<const char*>(input.data()), input.size());
  if (text.starts_with("glTF")) {
    const auto read = readProject(input);
    if (read && !holdsProject(input)) return "a project that does not say so";
    return read ? faultOf(read.value()) : std::string();
  }
  if (!text.starts_with("{") || text.starts_with("{\"present")) return tryJournal(text);
  const std::size_t end = std::min(text.find('\0'), text.size());
  if (end == text.size()) {
    const auto read = readDocument(text, anyPhoto);
    return read ? faultOf(read.value()) : std::string();
  }
  const auto glb = writeGlbChunks({text.substr(0, end), input.subspan(end + 1)});
  if (!glb) return "a GLB that cannot be written";
  const auto read = readProject(glb.value());
  return read ? faultOf(read.value()) : std::string();
}

std::string tryPicture(std::span<const std::uint8_t> input) {
  const auto info = probePicture(input);
  // Large ones are slow and teach nothing new.
  constexpr long long kMostFuzzed = 100'000;
  if (info && static_cast<long long>(info.value().size.width) * info.value().size.height > kMostFuzzed) {
    return {};
  }
  const auto picture = decodePicture(input, Progress());
  const auto pixels = decodeImage(input, kMostFuzzed);
  const auto mask = decodeMask(input);
  if (!info && (picture || pixels || mask)) return "a picture without a header";
  if (picture && !pixels) return "a picture without pixels";
  if (pixels) {
    const auto png = encodePng(pixels.value());
    if (!png) return "pixels that cannot be written";
    if (decodeImage(png.value(), kMostFuzzed).value() != pixels.value()) return "pixels changed";
  }
  return {};
}

std::string shareTextOf(std::span<const std::uint8_t> input) {
  const int first = input.empty() ? 0 : input[0] - '0';
  const bool isTold = first >= 1 && first <= kShareVersion;
  const auto packed = input.subspan(isTold ? 1 : 0);
  std::vector<std::uint8_t> bytes(packed.begin(), packed.end());
  if (!isTold) return sealShareText(std::move(bytes));
  if (first >= 3) return sealShareText(std::move(bytes), first);
  std::string text = sealAsFirst(std::move(bytes));
  text.front() = static_cast<char>('0' + first);
  return text;
}

std::string tryShare(std::span<const std::uint8_t> input) {
  const auto read = readShareText(shareTextOf(input));
  if (!read) return {};
  const document::Document kept = shareable(read.value());
  const auto text = writeShareText(read.value());
  if (!text) return "a shared model that cannot be shared";
  const auto again = readShareText(text.value());
  return again && again.value() == kept ? std::string() : "a shared model changed";
}

}  // namespace spineloft::testing
