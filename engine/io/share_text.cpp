#include "engine/io/share_text.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "engine/base/crc32.h"
#include "engine/geometry/polyline.h"
#include "engine/io/document_json.h"
#include "engine/io/foretold.h"
#include "engine/io/packed_json.h"
#include "engine/io/picture_file.h"
#include "engine/ribs/base/spine.h"
#include "engine/ribs/edit/end_curves.h"
#include "engine/ribs/edit/places.h"

namespace spineloft::io {
namespace {

using document::Document;

// ---- what is kept -------------------------------------------------------------------------------

/// Numbers of no other meaning keep this many decimal digits: unit vectors stay of length 1 to within 1e-6.
constexpr int kDigits = 7;
/// Longest side of the white picture that stands for a photo, pixels of its working copy.
constexpr int kBlankSide = 64;
/// Pressures of a pen are multiples of 1 / this.
constexpr float kPressures = 32;
/// Places along a spine are multiples of 1 / this.
constexpr double kPlaces = 4096;
/// The version from which on ends at ribs are told beside their curves, and the text is the shorter by its zeros.
constexpr int kFirstOnCurves = 3;

/// Rounds places on one picture.
class Grid {
 public:
  explicit Grid(image::Size size) : size_(size), step_(shareStep(size)) {}
  image::Size size() const { return size_; }
  double operator()(double value) const { return std::round(value / step_) * step_; }
  PicturePoint operator()(PicturePoint p) const { return {(*this)(p.x), (*this)(p.y)}; }
  std::vector<PicturePoint> rounded(std::vector<PicturePoint> line) const {
    for (PicturePoint& p : line) p = (*this)(p);
    return line;
  }
  /// Rounded, and simplified where that is shorter in a text: what has been through it stays as it is.
  std::vector<PicturePoint> operator()(const std::vector<PicturePoint>& line) const {
    const std::vector<PicturePoint> all = rounded(line);
    const std::vector<PicturePoint> few = geometry::simplifiedLine(std::span(all), tolerance());
    return bits(all) < bits(few) ? all : few;
  }
  double tolerance() const { return step_ / 2; }
  /// For what is not simplified besides.
  double alone() const { return 2 * step_; }
  double alone(double value) const { return std::round(value / alone()) * alone(); }

 private:
  std::size_t bits(const std::vector<PicturePoint>& line) const { return lineCost(line, size_); }

  image::Size size_;
  double step_;
};

image::SketchStroke kept(const image::SketchStroke& stroke, const Grid& grid) {
  image::SketchStroke out = stroke;
  const std::vector<PicturePoint> points = grid.rounded(stroke.points);
  out.points.clear();
  out.pressure.clear();
  for (const std::size_t i : geometry::keptPoints(std::span(points), grid.tolerance())) {
    out.points.push_back(points[i]);
    if (i < stroke.pressure.size()) out.pressure.push_back(std::round(stroke.pressure[i] * kPressures) / kPressures);
  }
  return out;
}

void keepMarks(std::vector<ribs::IgnoreMark>& marks, const Grid& grid) {
  for (ribs::IgnoreMark& mark : marks) mark.stroke = grid(mark.stroke);
}

void keepRegion(document::Region& region, const Grid& grid) {
  for (std::vector<PicturePoint>& contour : region.contours) contour = grid(contour);
}
/// In a text the place of the i-th rib is this and i: the spine tells where it is.
constexpr double kFirstRib = 2;

/// Ends of so many ribs in a text are told beside curves, those of the first parts; others in the frame of the spine.
/// This bounds the time that a text takes, whoever wrote it.
struct TracedRibs {
  std::size_t left = 20000;
};

/// What the ends of a part's ribs are told by; without ribs where the stroke gives no spine.
class RibsOfText {
 public:
  RibsOfText(const document::LoftRecipe& recipe, image::Size picture, TracedRibs& traced) {
    const auto spine = ribs::cleanSpine(recipe.stroke, picture, recipe.spine);
    if (!spine) return;
    const ribs::Ruler ruler(spine.value().points);
    for (std::size_t i = 0; i < spine.value().points.size(); ++i) places_.push_back(ruler.placeOfPoint(i));
    if (places_.size() > traced.left) return;
    traced.left -= places_.size();
    curves_.emplace(spine.value(), picture);
  }
  /// As a text says it: with a place of a grid, or at the rib that is the nearest to this, beside its curve.
  void tell(ribs::EndEdit& end, const Grid& grid) const {
    end.at = std::round(end.at * kPlaces) / kPlaces;
    const auto above = std::ranges::lower_bound(places_, end.at - 0.5 / kPlaces);
    if (above != places_.end() && *above <= end.at + 0.5 / kPlaces) {
      const auto rib = static_cast<std::size_t>(above - places_.begin());
      end.at = kFirstRib + static_cast<double>(rib);
      if (curves_) {
        const ribs::EndOnCurve told = curves_->tell(rib, end, grid.alone());
        end.along = told.beside;
        end.out = told.length;
      }
    }
    end.along = grid.alone(end.along);
    end.out = grid.alone(end.out);
  }
  /// The end that a text of this version says.
  void find(ribs::EndEdit& end, int version) const {
    const double rib = end.at - kFirstRib;
    if (!(rib >= 0 && rib < static_cast<double>(places_.size()))) return;
    const auto i = static_cast<std::size_t>(rib);
    end.at = places_[i];
    if (curves_ && version >= kFirstOnCurves) curves_->put(i, {end.along, end.out}, end);
  }

 private:
  std::vector<double> places_;
  std::optional<ribs::EndCurves> curves_;
};

void keep(document::LoftRecipe& recipe, const Grid& grid) {
  recipe.stroke = grid(recipe.stroke);
  keepMarks(recipe.ignored, grid);
}
/// As a text says the ends of a kept recipe.
void tellEnds(document::LoftRecipe& recipe, const Grid& grid, TracedRibs& traced) {
  if (recipe.edits.ends.empty()) return;
  const RibsOfText row(recipe, grid.size(), traced);
  for (ribs::EndEdit& end : recipe.edits.ends) {
    end.reach = std::round(end.reach * kPlaces) / kPlaces;
    row.tell(end, grid);
  }
}
void keep(document::InflateRecipe& recipe, const Grid& grid) {
  keepRegion(recipe.region, grid);
  for (inflate::ProfileSlice& slice : recipe.inflate.profile.slices) {
    if (slice.at) slice.at = grid(*slice.at);
  }
}
void keep(document::ExtrudeRecipe& recipe, const Grid& grid) { keepRegion(recipe.region, grid); }
void keep(document::StackRecipe& recipe, const Grid& grid) {
  const auto rounded = [&](ModelPoint& p) { p = {grid(p.x), grid(p.y), grid(p.z)}; };
  for (stack::Plane& plane : recipe.planes) {
    if (plane.origin) rounded(*plane.origin);
    for (stack::Curve& curve : plane.curves) {
      for (SectionPoint& p : curve.through) p = {grid(p.x), grid(p.y)};
    }
  }
  for (ModelPoint& p : recipe.rail.points) rounded(p);
}
/// Outlines are on grids of their own pictures.
void keep(document::ShapeRecipe& recipe, const Grid& grid) {
  document::ShapeRecipe kept = recipe;
  kept.shape.axis = {grid(recipe.shape.axis.from), grid(recipe.shape.axis.to)};
  kept.shape.width = grid(recipe.shape.width);
  if (isValid(kept.shape)) recipe = std::move(kept);
}
void keep(document::LatheRecipe& recipe, const Grid& grid) {
  keepRegion(recipe.region, grid);
  recipe.lathe.axisFrom = grid(recipe.lathe.axisFrom);
  recipe.lathe.axisTo = grid(recipe.lathe.axisTo);
}

std::shared_ptr<const image::Picture> blankPicture(image::Size size) {
  image::Picture blank;
  blank.width = size.width;
  blank.height = size.height;
  const image::Size small = image::fitSize(size, kBlankSide * kBlankSide, kBlankSide);
  blank.working.width = small.width;
  blank.working.height = small.height;
  blank.working.pixels.assign(4 * static_cast<std::size_t>(small.width) * static_cast<std::size_t>(small.height), 255);
  return std::make_shared<const image::Picture>(std::move(blank));
}

double withDigits(double value) {
  if (value == 0 || !std::isfinite(value)) return value;
  const int digits = kDigits - 1 - static_cast<int>(std::floor(std::log10(std::abs(value))));
  const double scale = std::pow(10.0, std::min(digits, 9));
  const double out = std::round(value * scale) / scale;
  return std::isfinite(out) ? out : value;
}

/// Every number that has more digits than it keeps and is on no grid.
void roundNumbers(Json& json) {
  if (json.is_number_float()) {
    const double value = json.get<double>();
    if (std::trunc(value * 4096) != value * 4096) json = toJson(withDigits(value));
  }
  if (json.is_structured()) {
    for (Json& element : json) roundNumbers(element);
  }
}

constexpr const char* kPhotoKey = "photo";
constexpr const char* kPicturesKey = "pictures";

Json* listOf(Json& json, const char* key) {
  if (!json.is_object()) return nullptr;
  const auto at = json.find(key);
  return at != json.end() && at->is_array() ? &*at : nullptr;
}

/// Rib ends at a rib come to where the text says that they are.
void findEnds(Json& json, int version) {
  Json* parts = listOf(json, "parts");
  const Json* pictures = listOf(json, kPicturesKey);
  if (parts == nullptr || pictures == nullptr) return;
  TracedRibs traced;
  for (Json& part : *parts) {
    const auto recipe = part.is_object() ? part.find("recipe") : part.end();
    if (recipe == part.end() || !recipe->is_object()) continue;
    const auto edits = recipe->find("edits");
    Json* ends = edits != recipe->end() ? listOf(*edits, "ends") : nullptr;
    if (ends == nullptr || ends->empty()) continue;
    ReadNotes notes;
    document::LoftRecipe loft;
    Json stroke = {{"picture", recipe->value("picture", Json())}, {"stroke", recipe->value("stroke", Json())}};
    if (recipe->contains("spine")) stroke["spine"] = (*recipe)["spine"];
    read(stroke, loft, {notes, {}});
    image::Size size;
    for (const Json& picture : *pictures) {
      std::uint32_t id = 0;
      const bool ours = picture.is_object() && get(picture.value("id", Json()), id) && id == loft.picture.value;
      if (ours) get(picture.value("size", Json()), size);
    }
    const RibsOfText row(loft, size, traced);
    for (Json& end : *ends) {
      ribs::EndEdit edit;
      if (!get(end, edit)) continue;
      row.find(edit, version);
      end = toJson(edit);
    }
  }
}

/// The id of a picture of the document's JSON; none where it has no usable one.
PictureId idOf(const Json& picture) {
  PictureId id;
  if (picture.is_object()) get(picture.value("id", Json()), id.value);
  return id;
}

/// The document's JSON with rounded numbers; of a photo its copy, or that there is one.
Json keptJson(const Document& document, const PhotoCopies& copies = {}) {
  Document rounded = document;
  TracedRibs traced;
  std::map<std::uint32_t, Grid> grids;
  for (Box<document::PictureEntry>& box : rounded.pictures) {
    document::PictureEntry entry = box.get();
    const Grid& grid = grids.try_emplace(entry.id.value, entry.size).first->second;
    for (Box<image::SketchStroke>& stroke : entry.sketch) stroke = kept(stroke.get(), grid);
    keepMarks(entry.ignored, grid);
    box = std::move(entry);
  }
  for (Box<document::Part>& box : rounded.parts) {
    document::Part part = box.get();
    const auto grid = grids.find(document::pictureOf(part).value);
    if (grid == grids.end()) continue;
    std::visit([&](auto& recipe) { keep(recipe, grid->second); }, part.recipe);
    if (document::LoftRecipe* loft = document::loftOf(part)) tellEnds(*loft, grid->second, traced);
    if (document::ShapeRecipe* shape = document::shapeOf(part)) {
      for (document::Outline& outline : shape->outlines) {
        const auto own = grids.find(outline.picture.value);
        if (own == grids.end()) continue;
        for (auto& line : outline.lines) line = own->second(line);
      }
    }
    box = std::move(part);
  }
  Json json = documentJson(rounded);
  roundNumbers(json);
  if (Json* pictures = listOf(json, kPicturesKey)) {
    for (Json& picture : *pictures) {
      if (!picture.contains(kPhotoKey)) continue;
      const auto copy = copies.find(idOf(picture));
      picture[kPhotoKey] = copy == copies.end() ? Json(true) : Json(copy->second);
    }
  }
  return json;
}

/// The photo as one of a picture of this size; null where it is of another shape.
std::shared_ptr<const image::Picture> sizedPhoto(const CopiedPhotos& photos, PictureId id, image::Size size) {
  const auto at = photos.find(id);
  if (at == photos.end()) return nullptr;
  image::Picture photo = *at->second;
  const double off =
      static_cast<double>(photo.working.width) * size.height - static_cast<double>(photo.working.height) * size.width;
  if (std::abs(off) > std::max(size.width, size.height)) return nullptr;
  photo.width = size.width;
  photo.height = size.height;
  return std::make_shared<const image::Picture>(std::move(photo));
}

/// The photos that are there, and white pictures in place of the others.
Result<Document> documentOf(Json json, int version, ReadNotes* notes, const CopiedPhotos& copied = {}) {
  std::map<std::uint64_t, std::shared_ptr<const image::Picture>> shown;
  std::set<PictureId> missing;
  if (Json* pictures = listOf(json, kPicturesKey)) {
    for (Json& picture : *pictures) {
      if (!picture.is_object() || !picture.contains(kPhotoKey)) continue;
      image::Size size;
      const auto at = picture.find("size");
      if (at == picture.end() || !get(*at, size) || size.width < 1 || size.height < 1) continue;
      auto photo = sizedPhoto(copied, idOf(picture), size);
      if (photo == nullptr) {
        if (picture[kPhotoKey].is_string()) missing.insert(idOf(picture));
        photo = blankPicture(size);
      }
      const std::uint64_t hash = document::contentHash(*photo);
      picture[kPhotoKey] = hashKey(hash);
      shown[hash] = std::move(photo);
    }
  }
  findEnds(json, version);
  const PictureSource photos = [&](std::uint64_t hash) -> std::shared_ptr<const image::Picture> {
    const auto found = shown.find(hash);
    return found == shown.end() ? nullptr : found->second;
  };
  ReadNotes ours;
  Result<Document> read = documentFrom(std::move(json), {notes != nullptr ? *notes : ours, photos}, MissingPhoto::Drop);
  if (!read.ok()) return read;
  for (Box<document::Part>& box : read.value().parts) {
    if (!missing.contains(document::pictureOf(box.get()))) continue;
    document::Part part = box.get();
    part.look.textured = false;
    box = std::move(part);
  }
  makeRoomForIds(read.value(), notes != nullptr ? *notes : ours);
  return read;
}

// ---- the text -----------------------------------------------------------------------------------

/// Bytes of the checksum: of crc32 the last ones. A text changed by chance passes once in 16 million times.
constexpr std::size_t kSumBytes = 3;
constexpr std::uint32_t kSumMask = 0xFFFFFF;

constexpr std::string_view kDigits64 = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";

int digitOf(char c) {
  const std::size_t at = kDigits64.find(c);
  return at == std::string_view::npos ? -1 : static_cast<int>(at);
}

/// Five bits a character, lowest first; all but the last are above 31.
void appendNumber(std::string& text, std::size_t value) {
  for (; value >= 32; value /= 32) text += kDigits64[32 + value % 32];
  text += kDigits64[value];
}

/// Takes the number from the front; none when it is not there whole.
std::optional<std::size_t> takeNumber(std::string_view& text) {
  std::size_t value = 0;
  for (int shift = 0; shift < 30 && !text.empty(); shift += 5) {
    const int digit = digitOf(text.front());
    if (digit < 0) return std::nullopt;
    text.remove_prefix(1);
    value |= static_cast<std::size_t>(digit % 32) << shift;
    if (digit < 32) return value;
  }
  return std::nullopt;
}

std::string toText(std::span<const std::uint8_t> bytes) {
  std::string text;
  std::uint32_t bits = 0;
  int held = 0;
  for (const std::uint8_t byte : bytes) {
    bits = bits << 8 | byte;
    for (held += 8; held >= 6; held -= 6) text += kDigits64[bits >> (held - 6) & 63];
  }
  if (held > 0) text += kDigits64[bits << (6 - held) & 63];
  return text;
}

/// None when a character is no digit, or bits are left over that are not 0.
std::optional<std::vector<std::uint8_t>> toBytes(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  std::uint32_t bits = 0;
  int held = 0;
  for (const char c : text) {
    const int digit = digitOf(c);
    if (digit < 0) return std::nullopt;
    bits = bits << 6 | static_cast<std::uint32_t>(digit);
    held += 6;
    if (held < 8) continue;
    held -= 8;
    bytes.push_back(static_cast<std::uint8_t>(bits >> held));
  }
  const bool rest = held >= 6 || (bits & ((1U << held) - 1)) != 0;
  return rest ? std::nullopt : std::optional(std::move(bytes));
}

int versionOf(std::string_view text) { return text.front() - '0'; }

std::uint32_t takeSum(std::span<const std::uint8_t> bytes) {
  std::uint32_t sum = 0;
  for (const std::uint8_t byte : bytes) sum = sum << 8 | byte;
  return sum;
}

/// Three bytes of the checksum, then what packJson wrote, without the zeros at its end.
std::optional<std::vector<std::uint8_t>> packedIn(std::string_view body) {
  if (body.ends_with(kDigits64[0])) return std::nullopt;
  std::string whole(body);
  while (whole.size() % 4 != 0 || whole.size() < 4 * kSumBytes) whole += kDigits64[0];
  auto bytes = toBytes(whole);
  if (!bytes) return std::nullopt;
  const std::uint32_t sum = takeSum(std::span(*bytes).first(kSumBytes));
  bytes->erase(bytes->begin(), bytes->begin() + kSumBytes);
  while (!bytes->empty() && bytes->back() == 0) bytes->pop_back();
  return (crc32(*bytes) & kSumMask) == sum ? bytes : std::nullopt;
}

/// Of versions 1 and 2: all of what packJson wrote, then four bytes.
std::optional<std::vector<std::uint8_t>> packedFirst(std::string_view body) {
  constexpr std::size_t kSum = 4;
  auto bytes = toBytes(body);
  if (!bytes || bytes->size() < kSum) return std::nullopt;
  const std::uint32_t sum = takeSum(std::span(*bytes).last(kSum));
  bytes->resize(bytes->size() - kSum);
  return crc32(*bytes) == sum ? bytes : std::nullopt;
}

Result<Json> jsonOf(std::string_view text) {
  if (!isShareText(text)) return Error::LinkForeign;
  const int version = versionOf(text);
  if (version > kShareVersion) return Error::ProjectTooNew;
  if (text.size() > kMostShareText) return Error::OutOfMemory;
  text.remove_prefix(1);
  const auto length = takeNumber(text);
  if (!length) return text.empty() ? Error::LinkCut : Error::LinkAltered;
  if (text.size() < *length && *length <= kMostShareText)
    return {Error::LinkCut, std::to_string(*length - text.size()) + " characters are missing"};
  if (text.size() != *length) return Error::LinkAltered;
  const auto packed = version < kFirstOnCurves ? packedFirst(text) : packedIn(text);
  if (!packed) return Error::LinkAltered;
  return unpackJson(*packed, version);
}

Result<Document> readText(std::string_view text, ReadNotes* notes, const CopiedPhotos& photos) {
  Result<Json> json = jsonOf(text);
  if (!json.ok()) return json.failure();
  return documentOf(std::move(json).value(), versionOf(text), notes, photos);
}

/// A picture file that anybody may decode: its header says that it is small.
bool isSmallPhoto(const std::optional<std::vector<std::uint8_t>>& file) {
  if (!file) return false;
  const Result<PictureInfo> info = probePicture(*file);
  if (!info.ok()) return false;
  const auto [format, size, orientation] = info.value();
  return (format == PictureFormat::Webp || format == PictureFormat::Jpeg) && std::min(size.width, size.height) > 0 &&
         std::max(size.width, size.height) <= kMostSharedSide;
}

Result<PhotoCopies> copiesIn(std::string_view text) {
  Result<Json> json = jsonOf(text);
  if (!json.ok()) return json.failure();
  PhotoCopies copies;
  if (const Json* pictures = listOf(json.value(), kPicturesKey)) {
    for (const Json& picture : *pictures) {
      if (!picture.is_object() || !picture.contains(kPhotoKey) || !picture[kPhotoKey].is_string()) continue;
      auto copy = picture[kPhotoKey].get<std::string>();
      if (isSmallPhoto(toBytes(copy))) copies.emplace(idOf(picture), std::move(copy));
    }
  }
  return copies;
}

/// About so many quarters of a bit numbers of the grid take, from the third one on.
std::size_t listCost(std::span<const double> numbers, double step) {
  std::vector<std::int64_t> whole;
  for (const double number : numbers) whole.push_back(std::llround(std::clamp(number / step, -1e15, 1e15)));
  std::uint64_t all = 0;
  for (const std::int64_t number : whole) all |= static_cast<std::uint64_t>(number);
  const int zeros = all == 0 ? 0 : std::countr_zero(all);
  for (std::int64_t& number : whole) number /= std::int64_t{1} << zeros;
  std::size_t least = std::numeric_limits<std::size_t>::max();
  for (const Mode& mode : kModes) {
    std::size_t sum = 0;
    for (std::size_t i = 2; i < whole.size(); ++i) {
      const std::int64_t off = whole[i] - foretold(mode, std::span(whole).first(i), whole.size());
      sum += off == 0 ? 4 : 8 + 5 * static_cast<std::size_t>(std::bit_width(static_cast<std::uint64_t>(std::abs(off))));
    }
    least = std::min(least, sum);
  }
  return least;
}

}  // namespace

double shareStep(image::Size picture) {
  const int side = std::max({picture.width, picture.height, 1024});
  return std::exp2(std::floor(std::log2(side / 1024.0))) / 4;
}

std::size_t lineCost(const std::vector<PicturePoint>& line, image::Size picture) {
  std::vector<double> numbers;
  for (const PicturePoint p : line) numbers.insert(numbers.end(), {p.x, p.y});
  return listCost(numbers, shareStep(picture));
}

std::size_t endsCost(const document::LoftRecipe& recipe, image::Size picture) {
  const Grid grid(picture);
  document::LoftRecipe told = recipe;
  TracedRibs traced;
  tellEnds(told, grid, traced);
  std::vector<double> along, out;
  for (const ribs::EndEdit& end : told.edits.ends) {
    along.push_back(end.along);
    out.push_back(end.out);
  }
  return listCost(along, grid.alone()) + listCost(out, grid.alone());
}

std::vector<PicturePoint> keptLine(const std::vector<PicturePoint>& line, image::Size picture) {
  return Grid(picture)(line);
}

document::Document shareable(const Document& document) {
  Result<Document> read = documentOf(keptJson(document), kShareVersion, nullptr);
  return read.ok() ? std::move(read).value() : Document{};
}

std::string sealShareText(std::vector<std::uint8_t> packed) {
  while (!packed.empty() && packed.back() == 0) packed.pop_back();
  const std::uint32_t sum = crc32(packed);
  for (std::size_t shift = 0; shift < 8 * kSumBytes; shift += 8)
    packed.insert(packed.begin(), static_cast<std::uint8_t>(sum >> shift));
  std::string body = toText(packed);
  while (body.ends_with(kDigits64[0])) body.pop_back();
  std::string text(1, static_cast<char>('0' + kShareVersion));
  appendNumber(text, body.size());
  return text + body;
}

Result<std::string> writeShareText(const Document& document, const PhotoCopies& copies) {
  Result<std::vector<std::uint8_t>> packed = packJson(keptJson(document, copies));
  if (!packed.ok()) return packed.failure();
  return sealShareText(std::move(packed).value());
}

bool isShareText(std::string_view text) {
  return text.size() >= 2 && text.front() >= '1' && text.front() <= '9' &&
         std::ranges::all_of(text, [](char c) { return digitOf(c) >= 0; });
}

std::optional<std::string_view> textOfLink(std::string_view link) {
  const std::size_t mark = link.rfind(kLinkMark);
  if (mark != std::string_view::npos) {
    const std::string_view text = link.substr(mark + kLinkMark.size());
    return text.substr(0, text.find('&'));  // what follows is about its looks (a poster)
  }
  return isShareText(link) ? std::optional(link) : std::nullopt;
}

Result<Document> readShareText(std::string_view text, ReadNotes* notes, const CopiedPhotos& photos) {
  try {
    return readText(text, notes, photos);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

Result<PhotoCopies> photosInShareText(std::string_view text) {
  try {
    return copiesIn(text);
  } catch (const std::bad_alloc&) {
    return Error::OutOfMemory;
  }
}

}  // namespace spineloft::io
