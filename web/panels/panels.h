// The panels: free functions that read the document and what is derived from it, and put what the
// visitor wants into the action sink.
#pragma once

#include <imgui.h>

#include "web/commands/action_sink.h"
#include "web/commands/commands.h"
#include "web/edit/hollowing.h"
#include "web/edit/part_pictures.h"
#include "web/ui/fonts.h"

namespace spineloft::panels {

struct PanelEnv {
  app::CommandEnv env;
  const pipeline::Derived& derived;
  const app::Fonts& fonts;
  app::ActionSink& sink;
  app::PartPictures& pictures;
  app::ShownMouth& mouth;

  const document::Document& document() const { return env.studio.document(); }
  app::UiState& ui() const { return env.ui; }
  /// The selected part or null.
  const document::Part* selected() const { return document::findPart(document(), env.ui.selection); }
};

/// Everything above the scene, between ImGui's NewFrame and Render.
void draw(const PanelEnv& env);

// Its pieces.
void drawPictureOverlay(const PanelEnv& env);  ///< spines, ribs, outlines
void drawBones(const PanelEnv& env);           ///< of a puff, over the picture
void drawShapes(const PanelEnv& env);          ///< of the tool Shapes, over the picture
void drawLineDrawing(const PanelEnv& env);     ///< of the tool Lines, over the picture
/// Which shape is next, or from where the picture in view sees the one in hand; `room`: the card is at its upper right.
/// How high it became; 0: there is none.
double shapeCard(const PanelEnv& env, const app::Rect& room);
/// Ready shapes, as small pictures.
struct PrimitiveTiles {
  int columns = 4;
  ImVec2 cell;
  shape::Primitive chosen = shape::Primitive::Ball;
  bool words = true;
  bool next = false;  ///< for the next shape; else for those in hand
};
void primitiveTiles(const PanelEnv& env, const PrimitiveTiles& tiles);
void drawSlicesInSolid(const PanelEnv& env);  ///< lines across it where slices are
void drawSolidOverlay(const PanelEnv& env);   ///< the spine with the handles of its depth, the sheet for layers
void drawBridge(const PanelEnv& env);         ///< the knobs of the bridge in hand, and the line of one that is drawn
void drawPulls(const PanelEnv& env);          ///< the lines of pulls with their knobs, and one that is drawn
void drawSheet(const PanelEnv& env);          ///< the sheet, with the curves of the layers
/// Where the sheet is, as sliders, below the edit bar or, where that is at the foot, above it.
void sheetCard(const PanelEnv& env, const app::Rect& bar, bool atFoot);
void drawFailureInPicture(const PanelEnv& env);  ///< where a solid could not be made
void drawFailureInSolid(const PanelEnv& env);
void drawHollowOverlay(const PanelEnv& env);   ///< where what is scooped out would open
void drawPlaceOverlay(const PanelEnv& env);    ///< the gizmo of the parts in hand
void drawScale(const PanelEnv& env);           ///< how tall the solid is, and a thing beside it
void drawEditBar(const PanelEnv& env);         ///< what the tool in use can be told
void drawViewChrome(const PanelEnv& env);      ///< chips, buttons, legend, splitter
void drawHints(const PanelEnv& env);           ///< what to do next, clear of all of these
void drawSidePanel(const PanelEnv& env);       ///< beside the views, or the strip below them
void drawInk(const PanelEnv& env);             ///< the stroke of pen or eraser in hand
void drawSketchBar(const PanelEnv& env);       ///< pen, eraser, sizes, inks; on paper only
app::Rect sketchBarRect(const PanelEnv& env);  ///< where; empty where there is none

void drawSectionOverlay(const PanelEnv& env);  ///< sections on the spine, a section on its way
void drawSectionBoard(const PanelEnv& env);    ///< the board on which a section is drawn

void partList(const PanelEnv& env, bool tiles);  ///< with `tiles`, what can be made of the parts is below them
void sectionChooser(const PanelEnv& env, float width);
void layersPanel(const PanelEnv& env, const document::Part& part, float width);  ///< of a part made of layers
void regionPanel(const PanelEnv& env, const document::Part& part, float width);  ///< of a puff or flat piece
/// Buttons that take the slices of a part along, and that put copied ones on it.
void slicesToCopy(const PanelEnv& env, float width);
void sectionKeyBar(const PanelEnv& env, float width);  ///< sections along the selected part's spine
void alongPanel(const PanelEnv& env, float width);     ///< twist, depth, lean, front along the spine
void capChooser(const PanelEnv& env, float width);
/// Which sides follow each other, as small pictures.
void sidesTiles(const PanelEnv& env, const document::MirrorPlane& mirror, float width);
void placePanel(const PanelEnv& env, float width);  ///< where the selected part stands, in numbers
void lookPanel(const PanelEnv& env, float width);
void reliefPanel(const PanelEnv& env, float width);  ///< of the part in hand
void sizePanel(const PanelEnv& env, float width);    ///< how tall, and the check for printing

}  // namespace spineloft::panels
