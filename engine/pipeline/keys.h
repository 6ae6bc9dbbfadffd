// What keys the caches: a hash of everything that a stage depends on. Every member of every recipe
// is either part of a key or named as left out, so that a new one does not compile until somebody
// has decided.
#pragma once

#include "engine/base/cache_key.h"
#include "engine/document/document.h"

namespace spineloft::pipeline {

/// Of the ignored edges of one part: the picture's content, and the marks of both.
IgnoredKey ignoredKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry);

/// Of spine and generated ribs: the picture's content, ignored edges, stroke, SpineParams and
/// RibParams.
TraceKey traceKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry);

/// Of a line drawing with its pieces; names are no part of it.
DrawingKey drawingKey(const descriptive::Drawing& drawing);

/// Of the texture of a part of that shape, on which so much ink does not show (outline_ink.h).
TextureKey textureKey(ShapeKey shape, const std::vector<ribs::IgnoreMark>& ink);

/// Of a whole shape of any kind, and of what its picture and its recipe say of its texture.
/// `entry`: the part's own picture, one of the document's, which says how others look at it.
ShapeKey shapeKey(const document::Part& part, const document::PictureEntry& entry, const document::Document& document);
/// The same before its relief.
ShapeKey smoothKey(const document::Part& part, const document::PictureEntry& entry, const document::Document& document);
ShapeKey shapeKey(const document::Recipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document);

/// Of a lofted one: the trace's, the edits, the pose and the loft.
ShapeKey shapeKey(const document::LoftRecipe& recipe, const document::PictureEntry& entry);

/// Of what is made of a region: the region, the picture's size, the parameters.
ShapeKey shapeKey(const document::InflateRecipe& recipe, const document::PictureEntry& entry);
ShapeKey shapeKey(const document::ExtrudeRecipe& recipe, const document::PictureEntry& entry);
ShapeKey shapeKey(const document::LatheRecipe& recipe, const document::PictureEntry& entry);

/// Of a shape before its pulls. `part`: which it is, for a piece of a line drawing.
ShapeKey unpulledKey(const document::Recipe& recipe, const document::PictureEntry& entry,
                     const document::Document& document, PartId part);
/// Of what a pull reaches on the shape that was there before it: all of it but the height.
ReachKey reachKey(ShapeKey before, const pull::Pull& pull);
/// Of that shape pulled by a share of the way.
ShapeKey pulledKey(ShapeKey before, const pull::Pull& pull, double share = 1);

/// Of what a relief finds on a shape. `entry`: the picture that gives it, the part's own or the one laid on it.
HeightsKey heightsKey(ShapeKey before, const relief::Relief& relief, const document::PictureEntry& entry);
/// Of what it raises the mesh by, for a height of 1.
RaisedKey raisedKey(HeightsKey heights, const relief::Relief& relief);
/// Of the shape with it.
ShapeKey reliefKey(RaisedKey raised, const relief::Relief& relief);

/// Of the skeleton and the fields of a puff with a slice: the region, the picture's size, the edits, the places of the
/// slices, how fine they are. What the slices look like is not part of it.
InteriorKey interiorKey(const document::InflateRecipe& recipe, const document::PictureEntry& entry);

/// Of a stack: the picture, the planes, the rail and how it is finished.
ShapeKey shapeKey(const document::StackRecipe& recipe, const document::PictureEntry& entry);

/// Of a shape: the picture, the primitive, the outlines and the views that they are drawn in.
ShapeKey shapeKey(const document::ShapeRecipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document);

/// Of a bridge: the rims, the shapes and the places of the parts it stands on; those that it cannot stand on count as
/// missing.
ShapeKey shapeKey(const document::BridgeRecipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document);

/// Of a piece of a line drawing: the picture, the whole drawing, and which piece it is. `part`: the one that it is, or
/// whose place it takes; none: that of a piece with such outlines.
ShapeKey shapeKey(const document::ElementRecipe& recipe, const document::PictureEntry& entry,
                  const document::Document& document, PartId part = {});

}  // namespace spineloft::pipeline
