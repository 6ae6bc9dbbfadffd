// App's answers to the shell about keeping models.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <map>
#include <numbers>

#include "engine/io/json_fields.h"
#include "engine/io/share_text.h"
#include "engine/publish/share_copies.h"
#include "web/commands/command_actions.h"
#include "web/edit/section_editing.h"
#include "web/model/messages.h"
#include "web/page/app.h"
#include "web/scene/scene.h"

namespace spineloft::app {

namespace {

constexpr int kLargestThumbnail = 1024;  // pixels a side

/// Views for a small picture of the model: of its solid, or of its picture while there is none.
UiState thumbnailViews(const CommandEnv& env, int width, int height) {
  UiState small;
  small.canvasWidth = width;
  small.canvasHeight = height;
  small.dpr = 1;
  const Rect whole{0, 0, small.canvasWidth, small.canvasHeight};
  const auto bounds = publish::worldBounds(env.studio.document(), env.studio.derived());
  if (bounds) {
    small.layout.solid = whole;
    small.camera = homeCamera(*bounds, whole);
    return small;
  }
  small.layout.picture = whole;
  small.picture = env.ui.picture;
  const document::PictureEntry* entry = document::findPicture(env.studio.document(), small.picture);
  if (entry == nullptr) return small;
  // It fills the thumbnail; what is too much is cut off.
  const double wide = static_cast<double>(width) / entry->size.width;
  const double high = static_cast<double>(height) / entry->size.height;
  small.pictureView.centre = {(entry->size.width - 1) / 2.0, (entry->size.height - 1) / 2.0};
  small.pictureView.zoom = std::max(wide, high);
  return small;
}

/// The members of a JSON object that are texts.
std::map<std::string, std::string> textsOf(std::string_view json) {
  std::map<std::string, std::string> texts;
  const std::optional<Json> read = Json::parse(json);
  if (!read || read->object() == nullptr) return texts;
  for (const auto& [key, value] : *read->object()) {
    if (const std::string* text = value.text()) texts.emplace(key, *text);
  }
  return texts;
}

/// Copies by the keys of the hashes of their photos as copies by pictures.
io::PhotoCopies copiesOf(const document::Document& document, const std::map<std::string, std::string>& byHash) {
  io::PhotoCopies copies;
  for (const document::PictureEntry& entry : document.pictures) {
    const auto copy = byHash.find(io::hashKey(entry.contentHash));
    if (!entry.isSketch() && copy != byHash.end()) copies.emplace(entry.id, copy->second);
  }
  return copies;
}

}  // namespace

const std::string& App::history() { return text_ = keeping_.history(); }

const std::string& App::photos() {
  json_.clear();
  json_.beginArray();
  for (const std::string& hash : keeping_.photos()) json_.text(hash);
  json_.endArray();
  return text_ = json_.json();
}

std::shared_ptr<const image::Picture> App::photo(std::string_view hash) { return keeping_.photo(hash); }

const std::string& App::layPhotoBy(image::Picture photo) { return text_ = keeping_.layBy(std::move(photo)); }

const std::string& App::restore(std::string_view base, std::string_view recordsJson) {
  std::vector<std::string> records;
  const std::optional<Json> list = Json::parse(recordsJson);
  if (!list || list->array() == nullptr) return answerWith(refuse({Error::JsonInvalid, {}}));
  for (const Json& record : *list->array()) {
    // Anything else is damaged, and so ends the play.
    records.push_back(record.text() ? *record.text() : std::string());
  }
  const Result<std::size_t> dropped = keeping_.restore(base, records);
  if (!dropped) return answerWith(refuse(dropped.failure()));
  showOtherModel();
  json_.clear();
  json_.beginObject().key("ok").flag(true).key("dropped");
  json_.number(static_cast<double>(dropped.value())).endObject();
  return text_ = json_.json();
}

const std::string& App::shareText(std::string_view copiesJson) {
  Result<publish::SharedModel> shared = studio_.shareNow();  // now all is made
  const io::PhotoCopies copies = copiesOf(studio_.document(), textsOf(copiesJson));
  if (shared && !copies.empty()) shared = publish::shareModel(studio_.document(), studio_.derived(), copies);
  if (!shared) return answerWith(refuse(shared.failure()));
  json_.clear();
  json_.beginObject().key("ok").flag(true).key("text").text(shared.value().text).key("photos");
  json_.number(static_cast<double>(shared.value().photosLeft)).endObject();
  return text_ = json_.json();
}

const std::string& App::photosOfLink(std::span<const std::uint8_t> file) {
  const auto link = io::textOfLink({reinterpret_cast<const char*>(file.data()), file.size()});
  const Result<io::PhotoCopies> copies = link ? io::photosInShareText(*link) : io::PhotoCopies();
  if (!copies) return answerWith(refuse(copies.failure()));
  json_.clear();
  json_.beginObject().key("ok").flag(true).key("photos").beginObject();
  for (const auto& [picture, copy] : copies.value()) json_.key(std::to_string(picture.value)).text(copy);
  json_.endObject().endObject();
  return text_ = json_.json();
}

const std::string& App::openProject(std::span<const std::uint8_t> file, std::string_view photosJson) {
  std::map<PictureId, std::string> photos;
  for (const auto& [picture, hash] : textsOf(photosJson)) {
    PictureId id;
    std::from_chars(picture.data(), picture.data() + picture.size(), id.value);
    photos.emplace(id, hash);
  }
  const Result<std::string> mended = keeping_.openProject(file, photos);
  if (!mended) return answerWith(refuse(mended.failure()));
  showOtherModel();
  if (!mended.value().empty()) sendError(host_, mended.value());
  return answerWith({});
}

/// The history is another one: nothing of the old model stays selected, shown or in hand.
void App::showOtherModel() {
  gestures_.cancel(toolEnv());
  closeCut(env());
  closeBoard(ui_);
  ui_.selection = ui_.redraw = {};
  ui_.picture = {};
  ui_.seen.clear();
  resetNextPart(ui_);
  ui_.pictureView.fitted = true;
  ui_.tool = ToolKind::Draw;
  ui_.focus = Focus::Picture;
  ui_.flight.reset();
  ui_.cameraTouched = false;
  ui_.framePending = !studio_.document().parts.empty();
  settle();
  studio_.derived();
  watchWork();
  announce();
  touch(3);
}

const image::Image& App::thumbnail(int width, int height) {
  thumbnail_ = {};
  const int side = std::min(width, height);
  if (lost_ || side < 1 || std::max(width, height) > kLargestThumbnail) return thumbnail_;
  const UiState small = thumbnailViews(env(), width, height);
  gl::Scene scene;
  buildScene(studio_.document(), studio_.derived(), small, scene);
  scene.still = true;
  scene.ground = {};
  if (scene.meshes.empty() && !scene.picture) return thumbnail_;
  return thumbnail_ = renderer_->snapshot(scene);
}

const image::Image& App::turntable(int width, int height, double turn) {
  thumbnail_ = {};
  const int side = std::min(width, height);
  if (lost_ || side < 1 || std::max(width, height) > kLargestThumbnail) return thumbnail_;
  const auto bounds = publish::worldBounds(studio_.document(), studio_.derived());
  if (!bounds) return thumbnail_;
  // Round the middle, from as far as sees its whole way round.
  const double reach = std::hypot(bounds->high.x - bounds->low.x, bounds->high.z - bounds->low.z) / 2;
  const double x = (bounds->low.x + bounds->high.x) / 2, z = (bounds->low.z + bounds->high.z) / 2;
  UiState view = thumbnailViews(env(), width, height);
  view.camera =
      homeCamera({{x - reach, bounds->low.y, z - reach}, {x + reach, bounds->high.y, z + reach}}, view.layout.solid);
  view.camera.yaw += turn * 2 * std::numbers::pi;
  gl::Scene scene;
  buildScene(studio_.document(), studio_.derived(), view, scene);
  scene.still = true;
  scene.ground = {};
  return thumbnail_ = renderer_->snapshot(scene);
}

}  // namespace spineloft::app
