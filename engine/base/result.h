// Result<T>: a value, or the reason why there is none.
//
// Three kinds of failure are never mixed in this engine: a bug of ours is an assert; an expected
// failure (bad stroke, bad file, cancelled work) is a Result with one of the Errors below; a file
// with small faults is repaired and reported. Nothing throws across an engine header.
#pragma once

#include <cassert>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace spineloft {

/// Every expected failure of the engine. `errorSentence` puts each into words for a visitor.
enum class Error {
  // strokes
  StrokeTooShort,        ///< fewer than 2 distinct points
  StrokeNotFinite,       ///< NaN or infinite coordinates
  StrokeOutsidePicture,  ///< no part of the stroke lies on the picture
  StrokeLoops,           ///< the stroke crosses itself in a loop that is more than a pen hook
  // pictures
  PictureEmpty,       ///< zero bytes, or zero pixels
  PictureUnreadable,  ///< not a picture format that we know
  PictureTruncated,   ///< begins like a picture, but its data end too early or are damaged
  PictureTooSmall,    ///< shorter than kMinPictureSide on a side
  PictureTooLarge,    ///< header declares more pixels than we accept; refused before decoding
  // shapes
  RegionEmpty,      ///< an outline without an area, or with less than a few pixels
  RegionOutside,    ///< no part of a region lies on its picture
  RegionTooFine,    ///< an outline with more detail than a solid can be made of
  ProfileOnAxis,    ///< a profile without an area beside its axis
  NothingCutOut,    ///< no thing was found where a hint said
  NotABone,         ///< only for parts that were lofted along a spine
  NotARegion,       ///< only for parts that are made of a region
  NotAStack,        ///< only for parts that are drawn slice by slice
  NotAShape,        ///< only for parts that are shapes
  NotAPiece,        ///< only for parts that are pieces of a line drawing
  TakesNoSide,      ///< only for lofts and puffs, which take an outline from the side
  TooFewRibs,       ///< a loft needs at least 2 ribs
  SectionInvalid,   ///< cross-section with fewer than 3 distinct points, or not finite
  StackInvalid,     ///< planes or curves of a stack that make no solid
  ShapeInvalid,     ///< outlines of a shape that make no solid
  NotABridge,       ///< only for parts that are bridges
  BridgeInvalid,    ///< rims between which there is no bridge
  HostGone,         ///< a part that a bridge stands on is not there, or has no solid
  HostIsBridge,     ///< a bridge that is to stand on a bridge
  BridgeFollows,    ///< a bridge stands where its parts do, and nowhere else
  ViewInvalid,      ///< a picture as the side of one that is none it can be the side of
  MeshInvalid,      ///< a mesh given for export breaks a mesh law
  NothingToExport,  ///< no part to write
  // document
  NoSuchPart,
  NoSuchPicture,
  NoSuchStep,
  NoSuchLine,       ///< a line of a line drawing, or the drawing
  AlreadyUsed,      ///< a part or solid that is inside another solid already
  ValueOutOfRange,  ///< a parameter outside the range of the parameter table
  NothingToUndo,
  NothingToRedo,
  // solids of steps
  SolidEmpty,         ///< nothing is left of it
  WallTooThick,       ///< no room inside for a hollow, or none at its opening
  PartCrossesItself,  ///< a part goes through itself in a way that cannot be mended
  SolidFailed,        ///< the solver refused it
  SolverStopped,      ///< the solver's worker died
  SolverUnreachable,  ///< the solver's worker could not be loaded
  // files and work
  FileUnreadable,   ///< cannot be opened or read
  FileUnwritable,   ///< cannot be written
  JsonInvalid,      ///< not the JSON that was asked for
  ProjectInvalid,   ///< a project file that is damaged
  ProjectTooNew,    ///< a project file of a later version of this program
  NoProjectInside,  ///< a 3D file without an editable model inside
  LinkForeign,      ///< a text that is no shared model
  LinkCut,          ///< a shared model whose end is missing
  LinkAltered,      ///< a shared model with wrong characters in it
  Cancelled,        ///< the work was cancelled; nothing changed
  OutOfMemory,
  kCount  ///< number of errors, for tables and tests
};

/// One sentence for a person, in plain words: what happened and what to do. Never empty.
std::string_view errorSentence(Error error);

/// The error's name as in the enum ("StrokeTooShort"), for reports and tests.
std::string_view errorName(Error error);

/// The reason of a failure: an error and, where it helps, a detail such as a file name.
struct Failure {
  Error error = Error::Cancelled;
  std::string detail;
  bool operator==(const Failure&) const = default;
};

/// The failure in words, with its detail where there is one.
std::string failureSentence(const Failure& failure);

/// A T, or a Failure. Construct it from either; ask with `ok()` before you take `value()`.
template <class T>
class [[nodiscard]] Result {
 public:
  Result(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Result(Failure failure) : state_(std::in_place_index<1>, std::move(failure)) {}
  Result(Error error, std::string detail = {}) : state_(std::in_place_index<1>, Failure{error, std::move(detail)}) {}

  bool ok() const { return state_.index() == 0; }
  explicit operator bool() const { return ok(); }

  const T& value() const& {
    assert(ok() && "value() of a failed Result");
    return *std::get_if<0>(&state_);
  }
  T& value() & {
    assert(ok() && "value() of a failed Result");
    return *std::get_if<0>(&state_);
  }
  T&& value() && {
    assert(ok() && "value() of a failed Result");
    return std::move(*std::get_if<0>(&state_));
  }
  const Failure& failure() const {
    assert(!ok() && "failure() of a Result that succeeded");
    return *std::get_if<1>(&state_);
  }
  Error error() const { return failure().error; }

 private:
  std::variant<T, Failure> state_;
};

/// For functions that only succeed or fail.
struct Done {
  bool operator==(const Done&) const = default;
};
using Status = Result<Done>;

}  // namespace spineloft
