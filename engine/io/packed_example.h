// The example that packJson and unpackJson begin with. Internal to packed_json.cpp.
#pragma once

namespace spineloft::io {

/// For version 1: a usual document, all keys of documents and the words among their values. Texts that were written
/// with it are only read with it: it never changes. Keys that come later are spelled; another version of the text may
/// begin with another example.
inline constexpr const char* kPackedExample =
    R"({"version":2,"name":"Model","lastPictureId":1,"lastPartId":3,"pictures":[{"id":1,"name":"Sketch 1","size":[1024,)"
    R"(768],"sketch":[[3,false,"#1f2430",[300.0,200.0,311.75,202.5,323.5,205.0,335.0,208.25,346.25,212.5,357.5,216.75,)"
    R"(368.75,221.0,380.0,225.0,391.5,228.75,402.5,233.25,413.25,238.75,423.75,244.5,434.5,250.0,445.25,255.5,456.0,)"
    R"(260.75,466.5,266.25,476.75,272.75,486.5,279.75,496.25,286.75,506.0,293.5,516.25,300.0,526.0,306.75,535.5,314.25,)"
    R"(544.25,322.25,553.25,330.5,562.0,338.5,571.25,346.25,580.25,354.0,588.75,362.5,596.75,371.5],[0.5,0.57,0.64,0.7,)"
    R"(0.75,0.78,0.8,0.8,0.77,0.73,0.68,0.61,0.54,0.47,0.39,0.33,0.27,0.23,0.21,0.2,0.21,0.24,0.29,0.35,0.42,0.49,0.56,)"
    R"(0.64,0.7,0.75]],[3,false,"#1f2430",[500.0,300.0,495.0,311.0,489.75,321.75,484.0,332.25,477.5,342.25,470.5,352.0,)"
    R"(464.0,362.0,457.5,372.25,451.25,382.5,444.25,392.25,436.5,401.5,428.75,410.5,420.75,419.5,413.0,428.75,405.5,)"
    R"(438.0,397.5,447.0,389.0,455.5,380.0,463.5,371.0,471.25,362.25,479.5],[]]]}],"parts":[{"id":1,"name":"Part 1",)"
    R"("recipe":{"picture":1,"stroke":[200.0,300.0,239.75,304.0,279.5,308.75,318.75,316.0,357.75,325.75,396.25,336.75,)"
    R"(434.75,346.75,473.75,356.0,512.75,365.25,551.0,376.5,588.5,390.5,625.5,406.0],"spine":{"ribs":40}}},{"id":2,)"
    R"("name":"Part 2","look":{"textured":false,"colour":"#ec9e5c"},"recipe":{"picture":1,"stroke":[400.0,350.0,416.25,)"
    R"(375.25,432.0,400.75,446.0,427.25,458.25,454.75,470.0,482.25,482.0,509.75,494.75,537.0,507.5,564.0,518.75,592.0],)"
    R"("spine":{"ribs":40},"edits":{"ends":[["left",0.0,0.0,40.0,0,false],["left",0.052734375,1.5,42.25,0,false],)"
    R"(["left",0.105224609375,-0.5,44.25,0,false],["left",0.157958984375,-1.5,45.5,0,false],["left",0.21044921875,0.75,)"
    R"(46.0,0,false],["left",0.26318359375,1.25,45.5,0,false],["left",0.315673828125,-1.0,44.0,0,false],["left",)"
    R"(0.368408203125,-1.0,42.0,0,false],["left",0.421142578125,1.25,39.75,0,false],["left",0.4736328125,0.5,37.25,0,)"
    R"(false],["left",0.5263671875,-1.5,35.5,0,false],["left",0.578857421875,-0.25,34.25,0,false],["left",)"
    R"(0.631591796875,1.5,34.0,0,false],["left",0.684326171875,-0.25,34.75,0,false],["left",0.73681640625,-1.5,36.25,0,)"
    R"(false],["left",0.78955078125,0.5,38.25,0,false],["left",0.842041015625,1.25,40.75,0,false],["left",)"
    R"(0.894775390625,-1.0,43.0,0,false],["left",0.947265625,-1.0,44.75,0,false],["left",1.0,1.25,45.75,0,false],)"
    R"(["right",0.0,0.0,40.0,0,false],["right",0.052734375,1.5,42.25,0,false],["right",0.105224609375,-0.5,44.25,0,)"
    R"(false],["right",0.157958984375,-1.5,45.5,0,false],["right",0.21044921875,0.75,46.0,0,false],["right",)"
    R"(0.26318359375,1.25,45.5,0,false],["right",0.315673828125,-1.0,44.0,0,false],["right",0.368408203125,-1.0,42.0,0,)"
    R"(false],["right",0.421142578125,1.25,39.75,0,false],["right",0.4736328125,0.5,37.25,0,false],["right",)"
    R"(0.5263671875,-1.5,35.5,0,false],["right",0.578857421875,-0.25,34.25,0,false],["right",0.631591796875,1.5,34.0,0,)"
    R"(false],["right",0.684326171875,-0.25,34.75,0,false],["right",0.73681640625,-1.5,36.25,0,false],["right",)"
    R"(0.78955078125,0.5,38.25,0,false],["right",0.842041015625,1.25,40.75,0,false],["right",0.894775390625,-1.0,43.0,)"
    R"(0,false],["right",0.947265625,-1.0,44.75,0,false],["right",1.0,1.25,45.75,0,false]]},)"
    R"("loft":{"sections":[{"shape":{"preset":"square"}}],"startCap":"flat"}}},{"id":3,"name":"Part 3","kind":"puff",)"
    R"("recipe":{"region":{"picture":1,"contours":[[300.0,200.0,311.75,202.5,323.5,205.0,335.0,208.25,346.25,212.5,)"
    R"(357.5,216.75,368.75,221.0,380.0,225.0,391.5,228.75,402.5,233.25,413.25,238.75,423.75,244.5,434.5,250.0,445.25,)"
    R"(255.5,456.0,260.75,466.5,266.25,476.75,272.75,486.5,279.75,496.25,286.75,506.0,293.5,516.25,300.0,526.0,306.75,)"
    R"(535.5,314.25,544.25,322.25,553.25,330.5,562.0,338.5,571.25,346.25,580.25,354.0,588.75,362.5,596.75,371.5]]}},)"
    R"("placement":{"pivot":[400,300,0],"move":[10,-20,30]}}],"words":{"ribs":null,"minSpacing":null,"smoothness":null,)"
    R"("learnedWeight":null,"proximityWeight":null,"doubt":null,"weight":null,"stiffness":null,"leastTrust":null,)"
    R"("corner":null,"outlier":null,"levels":null,"maxLevelShare":null,"neighbourWeight":null,"neighbourFreedom":null,)"
    R"("neighbourCap":null,"oppositeWeight":null,"leanCost":null,"evidence":null,"fairing":null,"ends":null,)"
    R"("added":null,"removed":null,"stroke":null,"depth":null,"coilTurns":null,"coilRadius":null,"closed":null,)"
    R"("preset":null,"contours":null,"kind":null,"custom":null,"at":null,"shape":null,"blend":null,"sections":null,)"
    R"("twist":null,"squash":null,"tilt":null,"bulge":null,"startCap":null,"endCap":null,"sectionPoints":null,)"
    R"("capRings":null,"centring":null,"picture":null,"spine":null,"edits":null,"ignored":null,"pose":null,"loft":null,)"
    R"("ribbon":null,"open":null,"height":null,"sides":null,"points":null,"thickness":null,"edge":null,"edgeSize":null,)"
    R"("region":null,"puff":null,"sheet":null,"axisFrom":null,"axisTo":null,"turn":null,"wall":null,"lathe":null,)"
    R"("textured":null,"colour":null,"paint":null,"second":null,"faceted":null,"inked":null,"pivot":null,"move":null,)"
    R"("scale":null,"mirrored":null,"id":null,"name":null,"recipe":null,"look":null,"visible":null,"placement":null,)"
    R"("mirror":null,"group":null,"part":null,"step":null,"side":null,"operands":null,"opening":null,"ownLook":null,)"
    R"("size":null,"photo":null,"sketch":null,"pictures":null,"parts":null,"steps":null,"groups":null,)"
    R"("lastPictureId":null,"lastPartId":null,"lastStepId":null,"lastGroupId":null,"version":null},"terms":["circle",)"
    R"("ellipse","square","rounded-square","triangle","hexagon","star","half-round","d","heart","plank","gear","round",)"
    R"("flat","pointed","open","left","right","both","front","back","sharp","bevel","plain","two-tone","clay","glaze",)"
    R"("metal","join","cut","hollow","common","start","end","up","down","none","loft","puff","sheet","lathe","blend",)"
    R"("kind","linear","smooth","step","hold","custom","ease","Model","Part","Sketch 1","Picture 1"]})";

/// From version 5 on besides: the keys and words that documents have had since.
inline constexpr const char* kPackedWords =
    R"({"words":{"across":null,"add":null,"axis":null,"bones":null,"detail":null,"drop":null,"factor":null,"heights)"
    R"(":null,"to":null,"caps":null,"corners":null,"curves":null,"follow":null,"from":null,"lines":null,"middle":nu)"
    R"(ll,"mode":null,"of":null,"drawing":null,"drawings":null,"folds":null,"hidden":null,"lastDrawingId":null,"las)"
    R"(tLineId":null,"line":null,"orders":null,"over":null,"pins":null,"runs":null,"under":null,"z":null,"origin":n)"
    R"(ull,"outlines":null,"planes":null,"primitive":null,"profile":null,"rail":null,"ratio":null,"reach":null,"sec)"
    R"(tion":null,"shift":null,"slices":null,"stack":null,"through":null,"view":null,"width":null,"startFan":null,")"
    R"(endFan":null},"terms":["ball","egg","box","cylinder","capsule","cone","pyramid","half-ball","length","share")"
    R"(,"kept","back","top","all","stack","shape","element"]})";

/// And from version 6 on. Pictures that come from a phone or a browser are often called like the last ones.
inline constexpr const char* kPackedLaterWords =
    R"({"words":{"amount":null,"as":null,"base":null,"first":null,"keepDrawn":null,"last":null,"patterns":null,")"
    R"(rough":null,"seed":null,"spacing":null,"times":null},"terms":["IMG","photo","picture","image"]})";

}  // namespace spineloft::io
