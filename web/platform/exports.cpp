// The functions of the page's contract with the shell. Strings come in as UTF-8; strings that go
// out live until the next call.
#include <emscripten.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>
#include <optional>

#include "web/platform/browser_host.h"
#include "web/platform/page.h"
#include "web/platform/warm_up.h"

namespace {

using namespace spineloft;
using namespace spineloft::platform;

/// The one page of this module: exported C functions have no other place for it.
struct Door {
  BrowserHost host;
  BrowserWords words;
  std::unique_ptr<Page> page;
};
Door& door() {
  static Door instance;
  return instance;
}
Page* page() { return door().page.get(); }

CanvasSize sizeOf(double width, double height, double dpr) {
  CanvasSize size{std::max(1.0, width), std::max(1.0, height), dpr};
  size.dpr = usableDpr(size);
  return size;
}

std::vector<std::uint8_t> bytesOf(const std::uint8_t* data, int length) {
  if (data == nullptr || length <= 0) return {};
  return {data, data + length};
}

image::Picture pictureOf(const std::uint8_t* rgba, image::Size working, image::Size original) {
  image::Picture picture;
  picture.working = {working.width, working.height,
                     bytesOf(rgba, static_cast<int>(4LL * working.width * working.height))};
  picture.width = std::max(original.width, working.width);
  picture.height = std::max(original.height, working.height);
  return picture;
}

const char* text(const char* given) { return given ? given : ""; }

}  // namespace

extern "C" {

EMSCRIPTEN_KEEPALIVE int spl_start(const std::uint8_t* font, int fontLength, const std::uint8_t* bold, int boldLength,
                                   const std::uint8_t* icons, int iconsLength, double width, double height,
                                   double dpr) {
  if (page() != nullptr) return 1;
  if (fontLength < 1 || boldLength < 1) return 0;  // no other font is inside
  const CanvasSize size = sizeOf(width, height, dpr);
  if (!openWindow(size)) return 0;
  FontFiles fonts{bytesOf(font, fontLength), bytesOf(bold, boldLength), bytesOf(icons, iconsLength)};
  door().page = makePage(door().host, std::move(fonts), size);
  door().host.page = page();
  return page() != nullptr ? 1 : 0;
}

/// The visitor's language, and fonts with the letters of its script where the page's own lack them.
EMSCRIPTEN_KEEPALIVE void spl_speak(const char* id, int rightToLeft, const std::uint8_t* font, int fontLength,
                                    const std::uint8_t* bold, int boldLength) {
  if (page() == nullptr) return;
  const bool english = std::string_view(text(id)) == "en";
  page()->speak({text(id), rightToLeft != 0, english ? nullptr : &door().words}, bytesOf(font, fontLength),
                bytesOf(bold, boldLength));
}

EMSCRIPTEN_KEEPALIVE void spl_resize(double width, double height, double dpr) {
  if (page() == nullptr) return;
  page()->resize(sizeOf(width, height, dpr));
}

EMSCRIPTEN_KEEPALIVE void spl_setPalette(const std::uint8_t* bytes, int length) {
  Palette palette;
  if (page() == nullptr || length != static_cast<int>(sizeof palette)) return;
  std::memcpy(&palette, bytes, sizeof palette);
  page()->setPalette(palette);
}

EMSCRIPTEN_KEEPALIVE void spl_pointer(int kind, int id, int device, int button, int buttons, double x, double y,
                                      double pressure, double timeMs, int modifiers) {
  if (page() == nullptr || kind < 0 || kind > 4 || device < 0 || device > 2) return;
  page()->pointer({static_cast<PointerKind>(kind), id, static_cast<Device>(device), button, buttons, x, y, pressure,
                   timeMs, modifiers});
}

EMSCRIPTEN_KEEPALIVE void spl_wheel(double x, double y, double deltaX, double deltaY, int modifiers) {
  if (page() != nullptr) page()->wheel({x, y, deltaX, deltaY, modifiers});
}

EMSCRIPTEN_KEEPALIVE int spl_key(const char* code, const char* key, int down, int modifiers) {
  if (page() == nullptr) return 0;
  return page()->key({text(code), text(key), down != 0, modifiers}) ? 1 : 0;
}

EMSCRIPTEN_KEEPALIVE const char* spl_addPicture(const std::uint8_t* rgba, int width, int height, int originalWidth,
                                                int originalHeight, const char* name) {
  if (page() == nullptr) return "";
  image::Picture picture;
  if (rgba != nullptr && width > 0 && height > 0) {
    picture = pictureOf(rgba, {width, height}, {originalWidth, originalHeight});
  }
  return page()->addPicture(std::move(picture), text(name)).c_str();
}

EMSCRIPTEN_KEEPALIVE const char* spl_probe(const std::uint8_t* bytes, std::uint32_t length) {
  if (page() == nullptr || bytes == nullptr) return "";
  return page()->probePicture({bytes, length}).c_str();
}

EMSCRIPTEN_KEEPALIVE const char* spl_state() { return page() ? page()->state().c_str() : "null"; }
EMSCRIPTEN_KEEPALIVE const char* spl_commands() { return page() ? page()->commands().c_str() : "[]"; }
EMSCRIPTEN_KEEPALIVE const char* spl_run(const char* id, const char* args) {
  return page() ? page()->run(text(id), text(args)).c_str() : "";
}
EMSCRIPTEN_KEEPALIVE const char* spl_lastError() { return page() ? page()->lastError().c_str() : "null"; }
EMSCRIPTEN_KEEPALIVE const char* spl_sentence(const char* errorName) {
  return page() ? page()->sentence(text(errorName)).c_str() : "";
}

EMSCRIPTEN_KEEPALIVE const std::uint8_t* spl_export(const char* format, std::uint32_t* length) {
  const std::span<const std::uint8_t> bytes =
      page() ? page()->exportModel(text(format)) : std::span<const std::uint8_t>();
  if (length != nullptr) *length = static_cast<std::uint32_t>(bytes.size());
  return bytes.empty() ? nullptr : bytes.data();
}

/// As spl_export.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* spl_pictureWithModel(const std::uint8_t* png, std::uint32_t size,
                                                              std::uint32_t* length) {
  const std::span<const std::uint8_t> bytes =
      page() && png ? page()->pictureWithModel({png, size}) : std::span<const std::uint8_t>();
  if (length != nullptr) *length = static_cast<std::uint32_t>(bytes.size());
  return bytes.empty() ? nullptr : bytes.data();
}

EMSCRIPTEN_KEEPALIVE void spl_imageToClient(double x, double y, double* out) {
  if (page() == nullptr || out == nullptr) return;
  const auto at = page()->imageToCanvas(x, y);
  out[0] = at.x;
  out[1] = at.y;
}

EMSCRIPTEN_KEEPALIVE void spl_contextLost() {
  if (page() != nullptr) page()->contextLost();
}
EMSCRIPTEN_KEEPALIVE void spl_contextRestored() {
  if (page() != nullptr) page()->contextRestored();
}
EMSCRIPTEN_KEEPALIVE void spl_answer(const char* id, const char* answer) {
  if (page() != nullptr) page()->answer(text(id), text(answer));
}
EMSCRIPTEN_KEEPALIVE int spl_idle() { return page() == nullptr || page()->idle() ? 1 : 0; }
/// Not a number: it is pressed.
EMSCRIPTEN_KEEPALIVE void spl_workControl(std::uint32_t id, double value) {
  if (page() != nullptr) page()->workControl(id, std::isnan(value) ? std::nullopt : std::optional(value));
}
EMSCRIPTEN_KEEPALIVE void spl_showControl(std::uint32_t id) {
  if (page() != nullptr) page()->showControl(id);
}
EMSCRIPTEN_KEEPALIVE int spl_warmUp() {
  if (page() != nullptr) page()->warmUp();
  return warmUp() ? 1 : 0;
}
EMSCRIPTEN_KEEPALIVE void spl_cancelWork() {
  if (page() != nullptr) page()->cancelWork();
}
EMSCRIPTEN_KEEPALIVE void spl_solved(const char* answer, const std::uint8_t* bytes, std::uint32_t length) {
  if (page() == nullptr) return;
  page()->solved(text(answer), {bytes, bytes == nullptr ? 0 : length});
}
EMSCRIPTEN_KEEPALIVE void spl_cutOutAnswered(std::uint32_t id, int kind, double done, const double* found,
                                             std::uint32_t count) {
  if (page() == nullptr || kind < 0 || kind > static_cast<int>(CutAnswer::Kind::Unreachable)) return;
  page()->cutOutAnswered({id, static_cast<CutAnswer::Kind>(kind), done, {found, found == nullptr ? 0 : count}});
}
EMSCRIPTEN_KEEPALIVE void spl_finishParts() {
  if (page() != nullptr) page()->finishParts();
}

EMSCRIPTEN_KEEPALIVE const char* spl_history() { return page() ? page()->history().c_str() : ""; }
EMSCRIPTEN_KEEPALIVE const char* spl_photos() { return page() ? page()->photos().c_str() : "[]"; }

/// Pixels of a photo of the history, which live as long as the history shows it; `sizes` receives the
/// width and height of the working copy and of the original. 0 when there is no such photo.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* spl_photo(const char* hash, std::int32_t* sizes) {
  const auto photo = page() ? page()->photo(text(hash)) : nullptr;
  if (photo == nullptr || sizes == nullptr) return nullptr;
  const image::Picture& picture = *photo;
  const std::int32_t all[] = {picture.working.width, picture.working.height, picture.width, picture.height};
  std::ranges::copy(all, sizes);
  return picture.working.pixels.data();
}

EMSCRIPTEN_KEEPALIVE const char* spl_layPhotoBy(const std::uint8_t* rgba, int width, int height, int originalWidth,
                                                int originalHeight) {
  if (page() == nullptr || rgba == nullptr || width < 1 || height < 1) return "";
  return page()->layPhotoBy(pictureOf(rgba, {width, height}, {originalWidth, originalHeight})).c_str();
}

EMSCRIPTEN_KEEPALIVE const char* spl_restore(const char* base, const char* records) {
  return page() ? page()->restore(text(base), text(records)).c_str() : "";
}

EMSCRIPTEN_KEEPALIVE const char* spl_shareText(const char* copies) {
  return page() ? page()->shareText(text(copies)).c_str() : "";
}

EMSCRIPTEN_KEEPALIVE const char* spl_photosOfLink(const std::uint8_t* bytes, std::uint32_t length) {
  if (page() == nullptr || bytes == nullptr) return "";
  return page()->photosOfLink({bytes, length}).c_str();
}

EMSCRIPTEN_KEEPALIVE const char* spl_openProject(const std::uint8_t* bytes, std::uint32_t length, const char* photos) {
  if (page() == nullptr || bytes == nullptr) return "";
  return page()->openProject({bytes, length}, text(photos)).c_str();
}

/// RGBA pixels, valid until the next call; 0 while there is nothing to show.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* spl_thumbnail(int width, int height) {
  if (page() == nullptr) return nullptr;
  const image::Image& image = page()->thumbnail(width, height);
  return image.empty() ? nullptr : image.pixels.data();
}

/// As spl_thumbnail, turned by a share of the way round.
EMSCRIPTEN_KEEPALIVE const std::uint8_t* spl_turntable(int width, int height, double turn) {
  if (page() == nullptr) return nullptr;
  const image::Image& image = page()->turntable(width, height, turn);
  return image.empty() ? nullptr : image.pixels.data();
}

}  // extern "C"
