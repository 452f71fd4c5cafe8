#define TINYGLTF_IMPLEMENTATION
#include "core/scene/tinygltf.h"
