#include "web/page/app.h"

#include <imgui.h>

#include <algorithm>

#include "engine/base/limits.h"
#include "engine/io/picture_probe.h"
#include "engine/io/png_model.h"
#include "web/commands/command_actions.h"
#include "web/commands/state_json.h"
#include "web/edit/editing.h"
#include "web/edit/line_drawing.h"
#include "web/edit/preview.h"
#include "web/edit/puff_bones.h"
#include "web/edit/section_editing.h"
#include "web/edit/shaping.h"
#include "web/edit/solid_editing.h"
#include "web/model/messages.h"
#include "web/panels/panels.h"
#include "web/panels/theme.h"
#include "web/panels/widgets.h"
#include "web/scene/scene.h"
#include "web/ui/press.h"
#include "web/words/words.h"

namespace spineloft::app {
namespace {

constexpr double kPumpMs = 16;   // how often finished work is looked for
constexpr double kWaitMs = 150;  // how often a frame says that the solver is still at it
constexpr double kTooltipMs = 650;
constexpr double kFlashMs = 900;
constexpr double kLongestStepSeconds = 0.5;

}  // namespace

App::App(Parts parts, const platform::CanvasSize& size)
    : host_(parts.host),
      renderer_(std::move(parts.renderer)),
      fontFiles_(std::move(parts.fonts)),
      studio_(parts.host, parts.threads) {
  ImGuiIO& io = ImGui::GetIO();
  io.IniFilename = nullptr;
  io.LogFilename = nullptr;
  io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
  io.BackendFlags |= ImGuiBackendFlags_HasMouseCursors;
  panels::applyTheme(ui_.palette);
  ui_.camera = homeCamera({{-0.4, -0.4, -0.25}, {0.4, 0.4, 0.25}}, {0, 0, 400, 400});
  resize(size);
  announce();
}

void App::touch(int frames) {
  framesWanted_ = std::max(framesWanted_, frames);
  host_.requestFrame();
}

void App::speak(words::Language language, std::vector<std::uint8_t> text, std::vector<std::uint8_t> bold) {
  words::speak(std::move(language));
  fontFiles_.scriptText = std::move(text);
  fontFiles_.scriptBold = std::move(bold);
  fontDpr_ = 0;
  announce();
  touch(3);
}

void App::setPalette(const platform::Palette& palette) {
  if (ui_.palette == palette) return;
  ui_.palette = palette;
  panels::applyTheme(palette);
  touch(2);
}

void App::layout() {
  const bool hasPanel = !studio_.document().pictures.empty();
  ui_.layout = ui_.sections.board ? layoutWithBoard(ui_.canvasWidth, ui_.canvasHeight)
                                  : layoutFor(ui_.canvasWidth, ui_.canvasHeight, ui_.share, hasPanel);
  if (!ui_.sections.board && studio_.document().pictures.size() > 1) reservePictures(ui_.layout);
  const document::PictureEntry* entry = document::findPicture(studio_.document(), ui_.picture);
  // What is in hand stays where it is, also where buttons for fingers take another room than those for a mouse.
  const bool isHeld = gestures_.usesTool() && fitted_ == ui_.picture;
  if (entry != nullptr && ui_.pictureView.fitted && !isHeld) {
    fitted_ = ui_.picture;
    ui_.pictureView = fitPicture(entry->size, ui_.layout.picture, ui_.barHead, ui_.barLeft, ui_.barFoot);
  }
}

/// Brings what is selected and shown in line with the document, which undo may have changed.
void App::settle() {
  settleCut(env());  // may add a part
  settleBoard(env());
  const document::Document& document = studio_.document();
  if (!document::findPicture(document, ui_.picture)) {
    featureAt(ui_, document.pictures.empty() ? PictureId{} : document.pictures.back()->id);
    gestures_.cancel(toolEnv());
  }
  settleSketching(document, ui_);
  if (!document::findPicture(document, ui_.pictureMenu)) ui_.pictureMenu = {};
  if (!document::findPart(document, ui_.selection)) ui_.selection = {};
  std::erase_if(ui_.alsoSelected,
                [&](PartId id) { return !ui_.selection || id == ui_.selection || !document::findPart(document, id); });
  const bool lost = std::ranges::any_of(
      ui_.placing, [&](const document::PlaceParts::One& one) { return !document::findPart(document, one.part); });
  if (lost) gestures_.cancel(toolEnv());
  settleChosen();
  if (!document::findPart(document, ui_.redraw)) ui_.redraw = {};
  settleSolids(document, ui_);
  studio_.expectEdit(ui_.selection);
  const bool orphaned = ui_.preview && (!document::findPicture(document, document::pictureOf(ui_.preview->recipe)) ||
                                        (ui_.preview->part && !document::findPart(document, ui_.preview->part)));
  if (orphaned) {
    gestures_.cancel(toolEnv());
    ui_.preview.reset();
  }
  if (document.parts.empty()) ui_.cameraTouched = false;
  const auto& board = ui_.sections.board;
  if (document.pictures.empty() || (board && board->part && !findPart(document, board->part))) {
    gestures_.cancel(toolEnv());
    closeBoard(ui_);
  }
  layout();
}

/// What is chosen of a part goes with it, and with the rib.
void App::settleChosen() {
  if (chosenOf_ != ui_.selection) {
    chosenOf_ = ui_.selection;
    ui_.chosen = {};
  }
  const document::Part* part = document::findPart(studio_.document(), ui_.selection);
  const document::Region* region = part ? document::regionOf(part->recipe) : nullptr;
  const auto there = [&](const OutlinePoint& at) {
    return region && at.contour < region->contours.size() && at.point < region->contours[at.contour].size();
  };
  if (ui_.chosen.outline && !there(*ui_.chosen.outline)) ui_.chosen.outline.reset();
  if (ui_.hover.outline && !there(*ui_.hover.outline)) ui_.hover.outline.reset();
  if (ui_.chosen.bone >= 0 || ui_.hover.bone >= 0) {
    const auto count = static_cast<int>(boneHandles(bonesInHand(studio_.document(), studio_.derived(), ui_)).size());
    if (ui_.chosen.bone >= count) ui_.chosen.bone = -1;
    if (ui_.hover.bone >= count) ui_.hover.bone = -1;
  }
  if (ui_.chosen.shape >= 0 || ui_.hover.shape >= 0) {
    const auto seen = shapeInHand(studio_.document(), ui_);
    const auto count = seen ? static_cast<int>(shapeHandles(*seen).size()) : 0;
    if (ui_.chosen.shape >= count) ui_.chosen.shape = -1;
    if (ui_.hover.shape >= count) ui_.hover.shape = -1;
  }
  const int pulls = part ? static_cast<int>(part->pulls.size()) : 0;
  if (ui_.chosen.pull >= pulls) ui_.chosen.pull = -1;
  if (ui_.hover.pull >= pulls) ui_.hover.pull = -1;
  if (ui_.chosen.crossing >= 0 || ui_.hover.crossing >= 0) {
    const auto count = static_cast<int>(lineMarks(studio_.document(), studio_.derived(), ui_).crossings.size());
    if (ui_.chosen.crossing >= count) ui_.chosen.crossing = -1;
    if (ui_.hover.crossing >= count) ui_.hover.crossing = -1;
  }
  if (!ui_.chosen.end && !ui_.hover.end) return;
  const Subject subject = subjectOf(studio_.document(), studio_.derived(), ui_.selection);
  const std::size_t count = subject ? subject.shape->ribs.ribs.size() : 0;
  if (ui_.hover.end && ui_.hover.end->rib >= count) ui_.hover = {};
  if (!ui_.chosen.end || ui_.chosen.end->rib < count) return;
  if (count == 0) {
    ui_.chosen.end.reset();
  } else {
    ui_.chosen.end->rib = count - 1;
  }
}

void App::runCalls() {
  for (const ActionSink::Action& action : sink_.take()) {
    if (const Outcome done = action(env()); !done) refused(done.refusal());
  }
  settle();
}

void App::refused(const Refusal& refusal) { sendError(host_, refusal.sentence); }

void App::frame() {
  const bool comes = !shown_;
  // The browser takes what is shown now when all is done that is begun before: the next frame waits for its turn.
  const bool waits = !showFrame() || comes;
  if (waits && !gestures_.active()) return host_.requestFrame();
  const bool draws = !waits || !(changesPart() || viewMoves());  // ink does not wait
  if (draws) framesWanted_ = std::max(0, framesWanted_ - 1);
  if (studio_.threads() > 0) studio_.pump();
  settle();
  reportWaitingPrint();
  growBoard(ui_, studio_.document());
  growPreview(ui_, studio_, host_);
  growSolid(ui_, studio_, host_);
  frameNewPart();
  fly();
  fadeFlash();
  // Work goes on where nothing can be drawn: it can still be saved.
  // Without a picture the start page lies over the canvas.
  if (draws && !lost_ && !studio_.document().pictures.empty()) drawFrame();
  watchWork();
  announce();
  announceControls();
  if (!draws || moving() || framesWanted_ > 0) host_.requestFrame();
}

bool App::moving() const {
  return ui_.flight || (ui_.solids.flash && ui_.solids.flash->sinceMs) || (ui_.preview && !ui_.preview->settled()) ||
         (ui_.inHand.pin && !ui_.inHand.pinShown) || studio_.works();
}

void App::layOutPanels() {
  words::forgetMuch();
  makeFonts();
  beginUi();
  panels::draw({env(), studio_.derived(), fonts_, sink_, partPictures_, mouth_});
  ImGui::Render();
}

void App::drawFrame() {
  layOutPanels();
  if (!sink_.empty()) framesWanted_ = std::max(framesWanted_, 2);
  runCalls();
  buildScene(studio_.document(), studio_.derived(), ui_, scene_);
  scene_.dpr = pixels_.dpr;
  thumbnails_.addTo(scene_, studio_.document(), studio_.derived(), ui_);
  scene_.still = !moving() && !studio_.busy() && !gestures_.active() && framesWanted_ == 0 && handRests();
  awaitRest();
  if (renderer_->drawsOnCanvas(scene_)) host_.setPixels(pixels_);
  renderer_->draw(scene_);
  shown_ = false;
  if (!showFrame()) host_.requestFrame();
  partPictures_.forgetUnused();
  ++frames_;
}

void App::frameNewPart() {
  if (!ui_.framePending) return;
  const pipeline::Derived& derived = studio_.derived();
  const bool waiting = std::ranges::any_of(derived.parts, &pipeline::DerivedPart::waiting);
  if (waiting) return;
  ui_.framePending = false;
  if (!ui_.cameraTouched) {
    flyTo(env(), studio_.document().parts.size() == 1);
    return;
  }
  // The visitor turned the solid: it stays so turned.
  const auto part = pipeline::boundsOf(studio_.document(), derived, {&ui_.selection, 1});
  if (part && !isInSight(ui_.camera, ui_.layout.solid, *part)) flyTo(env(), false);
}

void App::fly() {
  if (!ui_.flight) return;
  const double t = std::clamp((host_.nowMs() - ui_.flight->startMs) / ui_.flight->lengthMs, 0.0, 1.0);
  ui_.camera = ui_.flight->at(t);
  if (t >= 1) ui_.flight.reset();
}

/// What was just put together is lit for a moment from when it is there.
void App::fadeFlash() {
  std::optional<Flash>& flash = ui_.solids.flash;
  if (!flash) return;
  const auto& steps = studio_.derived().steps;
  const auto at = std::ranges::find(steps, flash->step, &pipeline::DerivedStep::id);
  if (at == steps.end() || at->failure) return flash.reset();
  if (at->waiting || !at->solid) return;
  if (!flash->sinceMs) {
    flash->sinceMs = host_.nowMs();
    tellLoosePieces(env(), flash->step);
  }
  const double past = (host_.nowMs() - *flash->sinceMs) / kFlashMs;
  if (past >= 1) return flash.reset();
  flash->light = host_.reducedMotion() ? 1 : 1 - past;
}

void App::beginUi() {
  ImGuiIO& io = ImGui::GetIO();
  const double now = host_.nowMs();
  io.DisplaySize = {static_cast<float>(ui_.canvasWidth), static_cast<float>(ui_.canvasHeight)};
  chooseDensity();
  io.DisplayFramebufferScale = {static_cast<float>(pixels_.dpr), static_cast<float>(pixels_.dpr)};
  io.DeltaTime = static_cast<float>(std::clamp((now - lastFrameMs_) / 1000, 1e-4, kLongestStepSeconds));
  lastFrameMs_ = now;
  workAsked();
  renderer_->beginUi();
  ImGui::NewFrame();
}

void App::watchWork() {
  if (!studio_.busy() || wakePending_) return;
  wakePending_ = true;
  host_.wakeAfter(studio_.works() ? kPumpMs : kWaitMs);
}

void App::wake() {
  wakePending_ = tooltipPending_ = restPending_ = false;
  studio_.sendAmends();
  // Without threads a search would hold up the ink under the pen, and textures what is in the hand: they
  // wait.
  const bool inHand = ui_.sketching.stroke || (gestures_.active() && (ui_.cut || !studio_.activity()));
  const bool penDown = studio_.threads() == 0 && inHand;
  if (!penDown && studio_.pump()) {
    settle();
    studio_.derived();
  }
  watchWork();
  if (!penDown) announce();
  touch(studio_.busy() && !studio_.works() ? 1 : 2);
}

/// Tells the shell what it shows, when that is not what it was told last.
void App::announce() {
  viewOf(env(), view_);
  if (view_ == told_) return;
  std::swap(view_, told_);
  sendView(host_, told_);
}

void App::feedPanels(const platform::PointerEvent& event) {
  ImGuiIO& io = ImGui::GetIO();
  using platform::PointerKind;
  panels::watchPress(event);
  io.AddKeyEvent(ImGuiMod_Shift, (event.modifiers & platform::kShift) != 0);
  io.AddMouseSourceEvent(event.device == platform::Device::Touch ? ImGuiMouseSource_TouchScreen
                         : event.device == platform::Device::Pen ? ImGuiMouseSource_Pen
                                                                 : ImGuiMouseSource_Mouse);
  const bool gone = event.kind == PointerKind::Leave || event.kind == PointerKind::Cancel;
  if (!gone) io.AddMousePosEvent(static_cast<float>(event.x), static_cast<float>(event.y));
  const int button = event.button == 2 ? 1 : 0;
  if (event.kind == PointerKind::Down && event.button != 1) io.AddMouseButtonEvent(button, true);
  if (event.kind == PointerKind::Up || gone) {
    io.AddMouseButtonEvent(0, false);
    io.AddMouseButtonEvent(1, false);
  }
  const bool lifted = event.kind == PointerKind::Up && event.device != platform::Device::Mouse;
  if (gone || lifted) io.AddMousePosEvent(-FLT_MAX, -FLT_MAX);
}

void App::nameRib() {
  const std::optional<ribs::EndRef>& end = ui_.hover.end ? ui_.hover.end : ui_.chosen.end;
  const Subject subject = subjectOf(studio_.document(), studio_.derived(), ui_.selection);
  const bool rib = end && subject && ui_.tool == ToolKind::Ribs;
  std::string name = rib ? ribSentence(subject.shape->ribs, *end) : std::string();
  if (name == named_) return;
  named_ = std::move(name);
  sendStatus(host_, named_);
}

void App::pointer(const platform::PointerEvent& event) {
  constexpr double kTremble = 3;  // CSS pixels
  handMovedMs_ = host_.nowMs();
  const ClientPoint at{event.x, event.y};
  if (event.kind == platform::PointerKind::Down) pressedAt_ = at;
  handMoves_ = event.kind == platform::PointerKind::Move && (handMoves_ || distance(at, pressedAt_) > kTremble);
  const Hover before = ui_.hover;
  const bool onPanels = gestures_.pointer(event, toolEnv()) == Gestures::Target::Panels;
  if (onPanels) {
    feedPanels(event);
    touch(4);  // ImGui takes its queued events in over several frames
    // Something may come of a pointer that rests: a tooltip, or what a long press asks for.
    const bool finger = event.device == platform::Device::Touch;
    if (finger && event.kind == platform::PointerKind::Down) host_.wakeAfter(kLongPressMs + kPumpMs);
    if (!tooltipPending_ && !finger) {
      tooltipPending_ = true;
      host_.wakeAfter(kTooltipMs);
    }
  } else if (overPanels_) {
    ImGui::GetIO().AddMousePosEvent(-FLT_MAX, -FLT_MAX);
    touch(2);
  }
  overPanels_ = onPanels;
  if (!sink_.empty()) runCalls();
  if (event.kind != platform::PointerKind::Move || gestures_.active()) touch();
  if (!(ui_.hover == before)) {
    touch();
    nameRib();
  }
  const std::string_view cursor = gestures_.cursor(toolEnv());
  if (cursor != cursor_) {
    cursor_ = cursor;
    sendCursor(host_, cursor_);
  }
}

void App::wheel(const platform::WheelEvent& event) {
  handMovedMs_ = host_.nowMs();
  ImGuiIO& io = ImGui::GetIO();
  if (ui_.layout.panel.contains({event.x, event.y})) {
    io.AddMouseWheelEvent(static_cast<float>(-event.deltaX / 100), static_cast<float>(-event.deltaY / 100));
    touch(3);
    return;
  }
  gestures_.wheel(event, toolEnv());
  touch();
}

/// What is in hand, on the views or on its way out of a panel, goes back to where it came from.
void App::drop() {
  gestures_.cancel(toolEnv());
  ui_.sections.pressed.reset();
  if (!ui_.sections.carried) return;
  ui_.sections.carried.reset();
  ui_.sections.marked.reset();
}

bool App::key(const platform::KeyEvent& event) {
  if (event.code == "Space") {
    ui_.spaceHeld = event.down;
    touch();
    return true;
  }
  if (!event.down) return false;
  const CommandEnv now = env();
  const Command* command = commandForKey(event, &now);
  if (command == nullptr) return false;
  if (!enabled(*command, env())) return (event.modifiers & ~platform::kShift) != 0;
  // Keys that mean something in a mode only also say which one they are.
  const Json args = command->mode == nullptr
                        ? Json()
                        : Json::Object{{"key", event.key}, {"far", (event.modifiers & platform::kShift) != 0}};
  if (const Outcome done = runCommand(env(), *command, args); !done) refused(done.refusal());
  settle();
  gestures_.again(toolEnv());
  nameRib();
  touch(2);
  return true;
}

const std::string& App::addPicture(image::Picture picture, std::string_view name) {
  Status status = Done{};
  const int side = std::min(picture.width, picture.height);
  if (picture.working.empty() || side <= 0) {
    status = Error::PictureEmpty;
  } else if (side < kMinPictureSide || std::min(picture.working.width, picture.working.height) < 1) {
    status = Error::PictureTooSmall;
  } else {
    std::vector<document::Action> actions;
    const bool first = studio_.document().pictures.empty() && studio_.document().parts.empty();
    auto shared = std::make_shared<const image::Picture>(std::move(picture));
    actions.push_back(document::AddPicture{std::string(name), std::move(shared)});
    const std::string stem(name.substr(0, name.rfind('.')));
    if (first && !stem.empty()) actions.push_back(document::RenameDocument{stem});
    status = studio_.act(actions);
  }
  if (!status) return answerWith(refuse(status.failure()));
  featureAt(ui_, studio_.document().pictures.back()->id);
  if (partOfViews(studio_.document(), ui_) == nullptr) ui_.selection = {};  // it may be the side of what is in hand
  ui_.redraw = {};
  ui_.focus = Focus::Picture;
  settle();
  studio_.derived();
  watchWork();
  announce();
  touch(3);
  return answerWith({});
}

const std::string& App::state() {
  json_.clear();
  writeState(env(), frames_, json_);
  return text_ = json_.json();
}

const std::string& App::commands() {
  json_.clear();
  writeCommands(env(), json_);
  return text_ = json_.json();
}

const std::string& App::run(std::string_view id, std::string_view argsJson) {
  Outcome outcome;
  const std::optional<Json> args = argsJson.empty() ? Json() : Json::parse(argsJson);
  if (args) {
    outcome = runCommand(env(), id, *args);
    settle();
    studio_.derived();
    watchWork();
    announce();
    touch(2);
  } else {
    outcome = refuse({Error::JsonInvalid, {}});
  }
  return answerWith(outcome);
}

const std::string& App::answerWith(const Outcome& outcome) {
  json_.clear();
  json_.beginObject().key("ok").flag(outcome.ok());
  if (!outcome) json_.key("error").text(outcome.refusal().error).key("sentence").text(outcome.refusal().sentence);
  json_.endObject();
  text_ = json_.json();
  if (!outcome) lastError_ = text_;
  return text_;
}

const std::string& App::lastError() { return text_ = lastError_; }

const std::string& App::probePicture(std::span<const std::uint8_t> file) { return text_ = io::probeJson(file); }

const std::string& App::sentence(std::string_view name) {
  text_.clear();
  for (int i = 0; i < static_cast<int>(Error::kCount); ++i) {
    if (errorName(static_cast<Error>(i)) == name) text_ = errorSentence(static_cast<Error>(i));
  }
  return text_;
}

std::span<const std::uint8_t> App::exported(Result<publish::Bytes> bytes) {
  exported_.clear();
  if (bytes) {
    exported_ = std::move(bytes).value();
    return exported_;
  }
  json_.clear();
  json_.beginObject().key("ok").flag(false).key("error").text(errorName(bytes.error()));
  json_.key("sentence").text(spokenFailure(bytes.failure())).endObject();
  lastError_ = json_.json();
  return {};
}

std::span<const std::uint8_t> App::exportModel(std::string_view format) {
  const std::optional<publish::Format> known = publish::formatFromKey(format);
  if (!known) return exported({Error::ValueOutOfRange, std::string(format)});
  return exported(studio_.publishNow(*known));
}

std::span<const std::uint8_t> App::pictureWithModel(std::span<const std::uint8_t> png) {
  const Result<publish::Bytes> model = studio_.publishNow(publish::Format::Project);
  return exported(model ? io::withModel(png, model.value()) : Result<publish::Bytes>(model.failure()));
}

Vec2<platform::CanvasSpace> App::imageToCanvas(double x, double y) {
  settle();
  const ClientPoint p = ui_.pictureView.toClient({x, y}, ui_.layout.picture);
  return {p.x, p.y};
}

void App::contextLost() {
  lost_ = shown_ = true;
  gestures_.cancel(toolEnv());
  renderer_->contextLost();
}

void App::contextRestored() {
  if (!renderer_->contextRestored()) {
    sendError(host_, "The graphics did not come back. Reload the page; your picture is still here.");
    return;
  }
  lost_ = false;
  touch(2);
}

void App::answer(std::string_view id, std::string_view text) {
  if (const Outcome done = answerQuestion(env(), id, std::string(text)); !done) refused(done.refusal());
  runCalls();
  touch(2);
}

bool App::idle() {
  return !studio_.busy() && framesWanted_ == 0 && shown_ && !restPending_ && !ui_.flight &&
         !(ui_.preview && !ui_.preview->settled());
}

void App::cancelWork() {
  studio_.cancelWork();
  ui_.printWaits = false;
  touch();
}

void App::solved(std::string_view answerJson, std::span<const std::uint8_t> bytes) {
  const std::optional<Json> answer = Json::parse(answerJson);
  if (!answer) return;
  if (!studio_.takeSolid(*answer, bytes)) return;
  reportWaitingPrint();
  announce();
  touch(2);
}

void App::cutOutAnswered(const platform::CutAnswer& answer) {
  if (!studio_.takeCutOut(answer)) return;
  wakePending_ = false;  // what was waited for elsewhere may be work here now
  settle();
  studio_.derived();
  watchWork();
  announce();
  touch(2);
}

/// The check for printing that was asked for before all was made.
void App::reportWaitingPrint() {
  if (!ui_.printWaits) return;
  studio_.derived();
  if (!studio_.shapesMade()) return;
  ui_.printWaits = false;
  if (const Outcome done = reportPrint(env()); !done) refused(done.refusal());
}

}  // namespace spineloft::app
