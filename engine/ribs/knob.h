#pragma once
#include <cstdlib>
namespace spineloft::ribs { inline double knobValue(const char* n, double d){ const char* v=getenv(n); return v? atof(v):d; } }
#define KNOB(name, def) ([]{ static const double kV = ::spineloft::ribs::knobValue(name, def); return kV; }())
