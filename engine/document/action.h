// Everything a person can do to a document, as values. Each is a verb of intent.
#pragma once

#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "engine/document/document.h"

namespace spineloft::document {

/// Puts a picture on the board.
struct AddPicture {
  std::string name;
  std::shared_ptr<const image::Picture> picture;
};
/// Takes a picture and the parts drawn on it away.
struct RemovePicture {
  PictureId picture;
};
/// A new part from one stroke (picture pixels of `picture`).
struct DrawSpine {
  PictureId picture;
  std::vector<PicturePoint> stroke;
  loft::SectionPreset section = loft::SectionPreset::Circle;
  loft::CapStyle startCap = loft::CapStyle::Round, endCap = loft::CapStyle::Round;
  Look look = {};
};
/// A new stroke for an existing part; everything else about the part stays.
struct RedrawSpine {
  PartId part;
  std::vector<PicturePoint> stroke;
};
struct SetSection {
  PartId part;
  loft::SectionPreset section = loft::SectionPreset::Circle;
};
struct SetCaps {
  PartId part;
  loft::CapStyle start = loft::CapStyle::Round, end = loft::CapStyle::Round;
};
struct SetLook {
  PartId part;
  Look look = {};
};
/// One entry of the parameter table (params.h).
struct SetParameter {
  PartId part;
  std::string key;
  double value = 0;
};
struct RenamePart {
  PartId part;
  std::string name;
};
struct ShowPart {
  PartId part;
  bool visible = true;
};
struct DeletePart {
  PartId part;
};
struct SetHeight {
  Millimetres height;
};
struct RenameDocument {
  std::string name;
};

using Action =
    std::variant<AddPicture, RemovePicture, DrawSpine, RedrawSpine, SetSection, SetCaps, SetLook,
                 SetParameter, RenamePart, ShowPart, DeletePart, SetHeight, RenameDocument>;

}  // namespace spineloft::document
