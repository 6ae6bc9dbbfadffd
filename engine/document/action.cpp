#include "engine/document/action.h"

#include "engine/base/one_of_members.h"

template struct spineloft::OneOf<spineloft::document::AnyAction>;
template struct spineloft::Movers<spineloft::document::AnyAction>;
