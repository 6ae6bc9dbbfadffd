// One frame of the page: finished work → shapes → panels → commands → scene. The rest of the world
// talks to it through platform::Page.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "web/commands/action_sink.h"
#include "web/commands/commands.h"
#include "web/commands/shell_view.h"
#include "web/edit/hollowing.h"
#include "web/edit/part_pictures.h"
#include "web/gl/renderer.h"
#include "web/model/json.h"
#include "web/model/keeping.h"
#include "web/model/studio.h"
#include "web/page/gestures.h"
#include "web/platform/host.h"
#include "web/platform/page.h"
#include "web/scene/rehearsal.h"
#include "web/scene/thumbnails.h"
#include "web/ui/fonts.h"
#include "web/ui/ui_state.h"

struct ImGuiContext;

namespace spineloft::app {

class App final : public platform::Page, Hand {
 public:
  struct Parts {
    platform::Host& host;
    std::unique_ptr<gl::Renderer> renderer;
    platform::FontFiles fonts;
    int threads = 0;
  };
  /// Needs a current ImGui context, which it does not own.
  App(Parts parts, const platform::CanvasSize& size);

  void frame() override;
  void speak(words::Language language, std::vector<std::uint8_t> text, std::vector<std::uint8_t> bold) override;
  void wake() override;
  void resize(const platform::CanvasSize& size) override;
  void setPalette(const platform::Palette& palette) override;
  void warmUp() override;
  void pointer(const platform::PointerEvent& event) override;
  void wheel(const platform::WheelEvent& event) override;
  bool key(const platform::KeyEvent& event) override;
  const std::string& addPicture(image::Picture picture, std::string_view name) override;
  const std::string& probePicture(std::span<const std::uint8_t> file) override;
  const std::string& state() override;
  const std::string& commands() override;
  const std::string& run(std::string_view id, std::string_view argsJson) override;
  const std::string& lastError() override;
  const std::string& sentence(std::string_view errorName) override;
  std::span<const std::uint8_t> exportModel(std::string_view format) override;
  std::span<const std::uint8_t> pictureWithModel(std::span<const std::uint8_t> png) override;
  Vec2<platform::CanvasSpace> imageToCanvas(double x, double y) override;
  void contextLost() override;
  void contextRestored() override;
  void answer(std::string_view id, std::string_view text) override;
  bool idle() override;
  void workControl(std::uint32_t id, std::optional<double> value) override;
  void showControl(std::uint32_t id) override;
  void cancelWork() override;
  void solved(std::string_view answerJson, std::span<const std::uint8_t> bytes) override;
  void cutOutAnswered(const platform::CutAnswer& answer) override;
  void finishParts() override { studio_.finishParts(); }
  const std::string& history() override;
  const std::string& photos() override;
  std::shared_ptr<const image::Picture> photo(std::string_view hash) override;
  const std::string& layPhotoBy(image::Picture photo) override;
  const std::string& restore(std::string_view base, std::string_view recordsJson) override;
  const std::string& shareText(std::string_view copiesJson) override;
  const std::string& photosOfLink(std::span<const std::uint8_t> file) override;
  const std::string& openProject(std::span<const std::uint8_t> file, std::string_view photosJson) override;
  const image::Image& thumbnail(int width, int height) override;
  const image::Image& turntable(int width, int height, double turn) override;

  gl::Renderer& renderer() { return *renderer_; }
  const UiState& ui() const { return ui_; }

 private:
  CommandEnv env() { return {studio_, ui_, host_, this}; }
  tools::ToolEnv toolEnv() { return {studio_.document(), studio_.derived(), ui_, sink_, &picker_}; }
  /// Something happened: draw soon, and `frames` times at least.
  void touch(int frames = 1);
  /// Runs what tools and panels asked for; refusals become toasts.
  void runCalls();
  void settle();
  bool holds() const override { return gestures_.active() || ui_.sections.carried; }
  void drop() override;
  void settleChosen();
  void showOtherModel();
  void layout();
  void reportWaitingPrint();
  void fly();
  void fadeFlash();
  void frameNewPart();
  void beginUi();
  void workAsked();
  void makeFonts();
  void chooseDensity();
  bool showFrame();
  bool handRests() const;
  bool changesPart() const;
  bool viewMoves() const;
  void awaitRest();
  void layOutPanels();
  void drawFrame();
  /// Something on the screen moves by itself, or work is under way.
  bool moving() const;
  void watchWork();
  void announce();
  void announceControls();
  void addRibs(const ribs::RibSet& set, std::vector<Control>& controls) const;
  /// Names the rib end that is lit, for screen readers.
  void nameRib();
  void refused(const Refusal& refusal);
  const std::string& answerWith(const Outcome& outcome);
  /// Empty on failure, with the reason in `lastError_`.
  std::span<const std::uint8_t> exported(Result<publish::Bytes> bytes);
  void feedPanels(const platform::PointerEvent& event);

  platform::Host& host_;
  std::unique_ptr<gl::Renderer> renderer_;
  platform::FontFiles fontFiles_;
  Fonts fonts_;
  double fontDpr_ = 0;  ///< pixels that `fonts_` are for; 0: they are to be made
  Studio studio_;
  Keeping keeping_{studio_};
  UiState ui_;
  Gestures gestures_;
  ActionSink sink_;
  Picker picker_;
  gl::Scene scene_;
  Thumbnails thumbnails_;
  Rehearsal rehearsal_;
  PartPictures partPictures_;
  ShownMouth mouth_;
  JsonWriter json_;
  std::string text_, lastError_ = "null";
  std::vector<std::uint8_t> exported_;
  image::Image thumbnail_;
  std::string cursor_;
  PartId chosenOf_;    ///< the part that ui_.chosen is about
  std::string named_;  ///< the rib end that the status names
  std::vector<Control> toldControls_;
  ShellView told_, view_;  ///< what the shell knows, and what it is compared with
  std::uint64_t frames_ = 0;
  int framesWanted_ = 0;
  PictureId fitted_;  ///< whose view was fitted last
  double handMovedMs_ = 0;
  ClientPoint pressedAt_;
  bool handMoves_ = false;    ///< farther from there than a press that means to stay
  bool restPending_ = false;  ///< a wake is asked for when the hand rests
  // Of the frame that is drawn.
  platform::CanvasSize pixels_;
  Camera seenFrom_;
  PictureView pictureSeen_;
  bool shown_ = true;  ///< the last frame is on the canvas
  bool wakePending_ = false, tooltipPending_ = false;
  bool overPanels_ = false;  ///< the last pointer event was for ImGui
  bool lost_ = false;
  double lastFrameMs_ = 0;
};

}  // namespace spineloft::app
