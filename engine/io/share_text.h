// A whole model as a text, for links and QR codes. Pictures on paper go along as their strokes. Of a photo its size
// does, and where there is room a small copy (publish/share_model.h says what stands for it otherwise).
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/base/result.h"
#include "engine/document/document.h"
#include "engine/io/project_file.h"

namespace spineloft::io {

/// What texts are written as, or as the version before where that is shorter; 1 … this are read.
inline constexpr int kShareVersion = 6;
/// Longest text that is read, characters.
inline constexpr std::size_t kMostShareText = std::size_t{1} << 20;

/// What a text keeps of a document: places on pictures as multiples of ¼ pixel of a picture of 1024 pixels (2ⁿ/4 of
/// larger ones), strokes without the points that lie on the line between others to within half of that; rib ends that
/// were put somewhere as multiples of ½ pixel: at a rib along its curve and beside it (ribs/edit/end_curves.h), else
/// (and behind the first 20,000 ribs) in the frame of the spine. So these are not off by more than ¼ pixel of a picture
/// of 1024 pixels in either direction. Outlines of ends are told in steps of a pixel out of their rib and of two along
/// them (share_ends.h): ½ pixel off across. Places along a spine are multiples of 1/4096, or at the rib that is within
/// half of that of one; other numbers have 7 digits. A photo is a white picture of its size.
document::Document shareable(const document::Document& document);

/// The grid of places on a picture of this size, picture pixels.
double shareStep(image::Size picture);
/// An open line on a picture as a text keeps it; kept again it stays as it is.
std::vector<PicturePoint> keptLine(const std::vector<PicturePoint>& line, image::Size picture);

/// About so many quarters of a bit a line takes in a text: few where its points are evenly spaced and turn evenly, or
/// are on a coarse grid.
std::size_t lineCost(const std::vector<PicturePoint>& line, image::Size picture);

/// Longest side of the copy of a photo in a text, pixels.
inline constexpr int kMostSharedSide = 512;
/// Copies of photos by their pictures: WebP or JPEG files of at most kMostSharedSide pixels a side, as base64url (RFC
/// 4648, section 5) without padding.
using PhotoCopies = std::map<PictureId, std::string>;
/// What copies show.
using CopiedPhotos = std::map<PictureId, std::shared_ptr<const image::Picture>>;

/// Only letters, digits, '-' and '_'. Equal documents and copies give equal texts; reading gives shareable(document),
/// with the photos that are given to it. Error: OutOfMemory (a document with millions of numbers).
Result<std::string> writeShareText(const document::Document& document, const PhotoCopies& copies = {});
/// The text of what packJson wrote as this version, 3 … kShareVersion: version, length, checksum.
std::string sealShareText(std::vector<std::uint8_t> packed, int version = kShareVersion);

/// Whether it begins as a text of any version.
bool isShareText(std::string_view text);
/// What stands in front of the text in a link: behind the '#', which no browser sends to a server.
inline constexpr std::string_view kLinkMark = "#m=";
/// The text in a link, or what stands for one; a text alone is one too. None in anything else.
std::optional<std::string_view> textOfLink(std::string_view link);
/// Mended as by readDocument. Errors: LinkForeign, LinkCut (with how many characters are missing), LinkAltered,
/// ProjectTooNew, OutOfMemory (longer than kMostShareText, or with more in it than kMostPacked).
/// A picture has the photo that `photos` has for it, if its sides are in the proportion of the picture's to within a
/// pixel. Where a text has a copy and `photos` has none, the picture is white and the parts on it have their colours.
Result<document::Document> readShareText(std::string_view text, ReadNotes* notes = nullptr,
                                         const CopiedPhotos& photos = {});
/// The copies in a text, whoever wrote it: what is no such file by its header is left out. Errors: as readShareText.
Result<PhotoCopies> photosInShareText(std::string_view text);

}  // namespace spineloft::io
