#include "engine/base/result.h"

#include <array>

namespace spineloft {
namespace {

struct ErrorText {
  Error error;
  std::string_view name;
  std::string_view sentence;
};

constexpr std::array kTexts = {
    ErrorText{Error::StrokeTooShort, "StrokeTooShort",
              "That line is too short. Draw a longer line along the middle of the object."},
    ErrorText{Error::StrokeNotFinite, "StrokeNotFinite", "The line has a point without a place. Draw it again."},
    ErrorText{Error::StrokeOutsidePicture, "StrokeOutsidePicture",
              "The line lies outside the picture. Draw it on the object in the picture."},
    ErrorText{Error::StrokeLoops, "StrokeLoops",
              "The line crosses itself. Draw one line through the object without a loop."},
    ErrorText{Error::PictureEmpty, "PictureEmpty", "That file is empty. Choose a photo or a drawing."},
    ErrorText{Error::PictureUnreadable, "PictureUnreadable",
              "That file is not a picture I can read. Choose a PNG or JPEG picture."},
    ErrorText{Error::PictureTruncated, "PictureTruncated",
              "That picture is damaged or cut off. Choose another copy of it."},
    ErrorText{Error::PictureTooSmall, "PictureTooSmall",
              "That picture is too small to find anything in. Choose one of at least 16 by 16 "
              "pixels."},
    ErrorText{Error::PictureTooLarge, "PictureTooLarge",
              "That picture is too large to open. Choose one of at most 120 megapixels."},
    ErrorText{Error::RegionEmpty, "RegionEmpty",
              "That outline is too small to make a part of. Draw a larger one round the thing."},
    ErrorText{Error::RegionOutside, "RegionOutside",
              "That outline lies outside the picture. Draw it round the thing in the picture."},
    ErrorText{Error::RegionTooFine, "RegionTooFine",
              "That outline is too tangled to make a part of. Draw a simpler one."},
    ErrorText{Error::ProfileOnAxis, "ProfileOnAxis",
              "That line lies on its axis, so there is nothing to turn. Draw it beside the dashed line."},
    ErrorText{Error::NothingCutOut, "NothingCutOut", "I found no clear thing there. Draw a line round it instead."},
    ErrorText{Error::NotABone, "NotABone", "This part has no bone and no ribs. Choose one that was drawn with a line."},
    ErrorText{Error::NotARegion, "NotARegion",
              "This part was drawn with a bone. Choose a puff, a flat piece or a spun part."},
    ErrorText{Error::NotAStack, "NotAStack", "This part has no layers. Choose one that was drawn with Layers."},
    ErrorText{Error::NotAShape, "NotAShape", "This part is no shape. Choose a ball, a block or another shape."},
    ErrorText{Error::NotAPiece, "NotAPiece",
              "This part is no piece of a line drawing. Choose one that was drawn with Lines."},
    ErrorText{Error::TakesNoSide, "TakesNoSide",
              "This part takes no outline from the side. Choose a puff, or a part that was drawn with a line."},
    ErrorText{Error::TooFewRibs, "TooFewRibs",
              "The part has fewer than two ribs. Draw a longer line through the object."},
    ErrorText{Error::SectionInvalid, "SectionInvalid",
              "That slice does not work here. Choose another one, or draw a closed shape with at least "
              "three corners."},
    ErrorText{Error::StackInvalid, "StackInvalid", "These slices do not make a solid yet."},
    ErrorText{Error::ShapeInvalid, "ShapeInvalid", "These outlines do not make a shape yet."},
    ErrorText{Error::NotABridge, "NotABridge", "This part is no bridge. Choose one that joins two places."},
    ErrorText{Error::BridgeInvalid, "BridgeInvalid",
              "There is no room for a bridge there. Move its ends apart, or make them smaller."},
    ErrorText{Error::HostGone, "HostGone",
              "A part that this bridge stands on has no solid, or is gone. Mend it, undo, or delete the bridge."},
    ErrorText{Error::HostIsBridge, "HostIsBridge",
              "A bridge cannot stand on another bridge. Begin and end it on other parts."},
    ErrorText{Error::BridgeFollows, "BridgeFollows",
              "A bridge stays where the parts are that it joins. Choose those parts too."},
    ErrorText{Error::ViewInvalid, "ViewInvalid",
              "That picture cannot be a side of this one. Choose another picture that is no side itself."},
    ErrorText{Error::MeshInvalid, "MeshInvalid",
              "A part is not a closed solid, so it cannot be saved. Undo the last change."},
    ErrorText{Error::NothingToExport, "NothingToExport",
              "There is no part to save. Draw a line through an object first, or show a part that is hidden."},
    ErrorText{Error::NoSuchPart, "NoSuchPart", "That part is not there any more. Choose another one from the list."},
    ErrorText{Error::NoSuchPicture, "NoSuchPicture", "That picture is not there any more. Open it again."},
    ErrorText{Error::NoSuchStep, "NoSuchStep", "That solid is not there any more. Choose another one from the list."},
    ErrorText{Error::NoSuchLine, "NoSuchLine", "That line is not there any more. Choose another one."},
    ErrorText{Error::AlreadyUsed, "AlreadyUsed",
              "That part is inside another solid already. Break that solid apart first."},
    ErrorText{Error::ValueOutOfRange, "ValueOutOfRange",
              "That value is out of range. Choose one within the limits shown."},
    ErrorText{Error::NothingToUndo, "NothingToUndo", "There is nothing to undo."},
    ErrorText{Error::NothingToRedo, "NothingToRedo", "There is nothing to redo."},
    ErrorText{Error::SolidEmpty, "SolidEmpty",
              "Nothing is left of that solid. Move its parts so that they overlap, or break it apart."},
    ErrorText{Error::WallTooThick, "WallTooThick",
              "The wall is too thick for that part: there is no room inside, or none at the opening. Choose a "
              "thinner wall or another opening."},
    ErrorText{Error::PartCrossesItself, "PartCrossesItself",
              "A part goes through itself in a way that cannot be mended. Bend its bone less or make its ribs "
              "shorter there."},
    ErrorText{Error::SolidFailed, "SolidFailed",
              "That solid could not be made. Undo the last change or break the solid apart."},
    ErrorText{Error::SolverStopped, "SolverStopped",
              "Putting the parts together was interrupted. Nothing is lost: change a part or press \"Try "
              "again\"."},
    ErrorText{Error::SolverUnreachable, "SolverUnreachable",
              "What puts parts together could not be loaded. Nothing is lost: check the connection and press \"Try "
              "again\"."},
    ErrorText{Error::FileUnreadable, "FileUnreadable", "The file cannot be read. Check its name and try again."},
    ErrorText{Error::FileUnwritable, "FileUnwritable",
              "The file cannot be written. Check the folder and the free space."},
    ErrorText{Error::JsonInvalid, "JsonInvalid", "The file is not the JSON that was expected. Check its content."},
    ErrorText{Error::ProjectInvalid, "ProjectInvalid", "That model file is damaged. Open another copy of it."},
    ErrorText{Error::ProjectTooNew, "ProjectTooNew",
              "That model was made with a newer SpineLoft. Reload the page to get the newest one, "
              "then open it again."},
    ErrorText{Error::NoProjectInside, "NoProjectInside",
              "There is no model of SpineLoft in that file, so there is nothing to edit inside. Open a "
              ".spineloft file or a GLB saved here."},
    ErrorText{Error::LinkForeign, "LinkForeign",
              "There is no model of SpineLoft in that link. Copy the whole link again and open it."},
    ErrorText{Error::LinkCut, "LinkCut", "The end of that link is missing. Copy the whole link again and open it."},
    ErrorText{Error::LinkAltered, "LinkAltered",
              "That link has been changed on its way. Copy the whole link again and open it."},
    ErrorText{Error::Cancelled, "Cancelled", "Cancelled; nothing was changed."},
    ErrorText{Error::OutOfMemory, "OutOfMemory",
              "There is not enough memory for that. Close other pages or use a smaller picture."},
};
static_assert(kTexts.size() == static_cast<std::size_t>(Error::kCount), "every Error needs a name and a sentence");

const ErrorText& textOf(Error error) {
  for (const ErrorText& text : kTexts) {
    if (text.error == error) return text;
  }
  assert(false && "Error without a text");
  return kTexts.back();
}

}  // namespace

std::string_view errorSentence(Error error) { return textOf(error).sentence; }
std::string_view errorName(Error error) { return textOf(error).name; }

std::string failureSentence(const Failure& failure) {
  std::string sentence(errorSentence(failure.error));
  if (!failure.detail.empty()) sentence += " (" + failure.detail + ")";
  return sentence;
}

}  // namespace spineloft
