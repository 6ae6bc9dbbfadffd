#define TINYGLTF_IMPLEMENTATION
#include "tests/support/gltf_reader.h"
