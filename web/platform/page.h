// What the world outside asks of the page: the contract of the exported functions, as an interface.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/vec.h"
#include "engine/image/image.h"
#include "web/words/words.h"

namespace spineloft::platform {

class Host;

enum class Device : std::uint8_t { Mouse, Touch, Pen };
enum class PointerKind : std::uint8_t { Down, Move, Up, Cancel, Leave };
/// Bits of the `modifiers` of an event.
enum Modifier : int { kShift = 1, kControl = 2, kAlt = 4, kMeta = 8 };

/// A pointer event in CSS pixels from the canvas' top left corner.
struct PointerEvent {
  PointerKind kind = PointerKind::Move;
  int id = 0;
  Device device = Device::Mouse;
  int button = 0;   ///< which button this is about: 0 left or contact, 1 middle, 2 right
  int buttons = 0;  ///< bits of those that are down now: 1 left, 2 right, 4 middle
  double x = 0, y = 0;
  double pressure = 0;  ///< 0…1
  double timeMs = 0;
  int modifiers = 0;
};
struct WheelEvent {
  double x = 0, y = 0, deltaX = 0, deltaY = 0;  ///< CSS pixels; down is positive
  int modifiers = 0;                            ///< control: a pinch on a trackpad
};
struct KeyEvent {
  std::string_view code, key;  ///< as KeyboardEvent names them
  bool down = true;
  int modifiers = 0;
};
struct CanvasSize {
  double width = 0, height = 0;  ///< CSS pixels
  double dpr = 1;                ///< device pixels a CSS pixel
  bool operator==(const CanvasSize&) const = default;
};
/// The page's colours by what they are for, as the style sheet names them: a byte each of red, green, blue and opacity,
/// red the lowest. In the order of kRoles in web/shell/surface.ts. As they are here the page is light.
struct Palette {
  static constexpr std::uint32_t rgb(std::uint32_t hex) {
    return 0xff000000u | (hex & 255u) << 16 | (hex & 0xff00u) | hex >> 16;
  }
  std::uint32_t ink = rgb(0x1f2430), muted = rgb(0x5c6474), disabled = rgb(0x9a9fab), paper = rgb(0xf7f5f0),
                surface = rgb(0xffffff), line = rgb(0xe3dfd6), accent = rgb(0xc8431d), onAccent = rgb(0xffffff),
                accentSoft = rgb(0xfdeee8), hover = rgb(0xf2efe8);
  std::uint32_t tile = rgb(0xfbfaf7);     ///< the ground of a tile, of a graph
  std::uint32_t trough = rgb(0xf1eee7);   ///< of a slider, of a switch, of the bar between the views
  std::uint32_t handle = rgb(0xb4ad9e);   ///< what is dragged in a trough
  std::uint32_t warning = rgb(0xa8500a);  ///< words
  std::uint32_t good = rgb(0x2f8f5b);     ///< a sign
  std::uint32_t bubble = rgb(0x1f2430), onBubble = rgb(0xffffff);    ///< words that hang over all others
  std::uint32_t ground = rgb(0xfcfbf8), groundEdge = rgb(0xece9e2);  ///< of the solid view, in its middle and around
  bool operator==(const Palette&) const = default;
};
struct FontFiles {
  std::vector<std::uint8_t> text, bold, icons;  ///< TrueType files
  /// Letters that those lack, of the visitor's language; empty where it has none.
  std::vector<std::uint8_t> scriptText = {}, scriptBold = {};
};

/// What is known of the last CutRequest.
struct CutAnswer {
  enum class Kind : std::uint8_t {
    Progress,
    Found,        ///< the search has ended
    Stopped,      ///< its program has ended before it
    Unreachable,  ///< its program could not be loaded
  };
  std::uint32_t id = 0;  ///< of the request
  Kind kind = Kind::Progress;
  double done = 0;                ///< of Progress: 0…1
  std::span<const double> found;  ///< of Found: vision::numbersOf
};

class Page {
 public:
  virtual ~Page() = default;
  virtual void frame() = 0;
  virtual void wake() = 0;
  /// The page speaks this language from now on; the fonts of its script are used beside the others.
  virtual void speak(words::Language language, std::vector<std::uint8_t> text, std::vector<std::uint8_t> bold) = 0;
  virtual void resize(const CanvasSize& size) = 0;
  virtual void setPalette(const Palette& palette) = 0;
  /// A part of what the first frame needs is made before it is wanted; called a few times while nobody waits.
  virtual void warmUp() = 0;
  virtual void pointer(const PointerEvent& event) = 0;
  virtual void wheel(const WheelEvent& event) = 0;
  /// True when the page used the key.
  virtual bool key(const KeyEvent& event) = 0;
  /// As `run` answers.
  virtual const std::string& addPicture(image::Picture picture, std::string_view name) = 0;
  /// What is to be known of a picture file before it is decoded (io::probeJson).
  virtual const std::string& probePicture(std::span<const std::uint8_t> file) = 0;
  /// Texts stay valid until the next call that returns one.
  virtual const std::string& state() = 0;
  virtual const std::string& commands() = 0;
  virtual const std::string& run(std::string_view id, std::string_view argsJson) = 0;
  virtual const std::string& lastError() = 0;
  /// The sentence of an error by its name; empty for an unknown one.
  virtual const std::string& sentence(std::string_view errorName) = 0;
  /// The whole model as a file; empty on failure. Valid until the next call.
  virtual std::span<const std::uint8_t> exportModel(std::string_view format) = 0;
  /// A PNG picture of the model with the model inside (engine/io/png_model.h); as `exportModel`.
  virtual std::span<const std::uint8_t> pictureWithModel(std::span<const std::uint8_t> png) = 0;
  /// Where a point of the picture is on the canvas.
  virtual Vec2<struct CanvasSpace> imageToCanvas(double x, double y) = 0;
  virtual void contextLost() = 0;
  virtual void contextRestored() = 0;
  virtual void answer(std::string_view id, std::string_view text) = 0;
  virtual bool idle() = 0;
  // Controls of the panels without a pointer, by the ids of {type: 'controls'}: what is out of sight comes into sight.
  /// A slider gets a value; without one it is pressed.
  virtual void workControl(std::uint32_t id, std::optional<double> value) = 0;
  virtual void showControl(std::uint32_t id) = 0;
  virtual void cancelWork() = 0;
  /// What the solver of solids says about the last {type: 'solve'}: JSON, and the arrays of a mesh (see
  /// web/model/solid_work.h).
  virtual void solved(std::string_view answerJson, std::span<const std::uint8_t> bytes) = 0;
  virtual void cutOutAnswered(const CutAnswer& answer) = 0;
  /// A file is wanted: the solver mends what goes through itself; `idle` when it has.
  virtual void finishParts() = 0;

  // Keeping models on the device; see web/model/keeping.h.
  /// The whole history as a base of the journal.
  virtual const std::string& history() = 0;
  /// JSON list of the content hashes of its photos.
  virtual const std::string& photos() = 0;
  /// A photo of the history; null when no step shows it.
  virtual std::shared_ptr<const image::Picture> photo(std::string_view hash) = 0;
  /// Lays a photo by for the next `restore` or `openProject`; its content hash.
  virtual const std::string& layPhotoBy(image::Picture photo) = 0;
  /// Replaces the model by one that was kept, or with an empty `base` by an empty one:
  /// {ok:true, dropped} or as `run` answers.
  virtual const std::string& restore(std::string_view base, std::string_view recordsJson) = 0;
  /// The model as the text of a link: {ok:true, text, photos} with the number of photos that are not in it, or as `run`
  /// answers. `copiesJson`: small copies of photos that go along, {content hash: file as base64url} (io::PhotoCopies).
  virtual const std::string& shareText(std::string_view copiesJson) = 0;
  /// The copies of photos in a link: {ok:true, photos: {picture: file as base64url}}, none in a project file; or as
  /// `run` answers.
  virtual const std::string& photosOfLink(std::span<const std::uint8_t> file) = 0;
  /// Replaces the model by the one in a project file, or in a link; as `run` answers. `photosJson`: what was laid by
  /// for pictures of the link, {picture: content hash}.
  virtual const std::string& openProject(std::span<const std::uint8_t> file, std::string_view photosJson) = 0;
  /// A small picture of the model, RGBA; empty while there is nothing to show. Valid until the next
  /// call.
  virtual const image::Image& thumbnail(int width, int height) = 0;
  /// The solids from home, turned by `turn` of the way round (0…1), with room for all turns; as
  /// `thumbnail`.
  virtual const image::Image& turntable(int width, int height, double turn) = 0;
};

/// Makes the page; main.cpp defines it. Null when there is no WebGL2.
std::unique_ptr<Page> makePage(Host& host, FontFiles fonts, const CanvasSize& size);

}  // namespace spineloft::platform
