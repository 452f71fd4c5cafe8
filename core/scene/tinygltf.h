#pragma once

// tinygltf, built into this folder under another namespace. libdraco, which OpenCV and assimp bring into the
// process, exports an older tinygltf under the usual names; the loader would bind the system's libtinygltf to
// it, and the two disagree about the size of their classes. Pictures are passed over, so no decoder comes
// along.
#define tinygltf chiaro_tinygltf
#define TINYGLTF_NO_STB_IMAGE
#define TINYGLTF_NO_STB_IMAGE_WRITE
#define TINYGLTF_NO_EXTERNAL_IMAGE
#define TINYGLTF_NO_INCLUDE_JSON

#include <nlohmann/json.hpp>

#include <tiny_gltf.h>
