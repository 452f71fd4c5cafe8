#pragma once

#include "core/base/codec/codec.h"

namespace chiaro {

/// The bytes of the picture's file. Throws Error naming the request's path.
std::string encodeImage(const EncodeRequest& request);

}  // namespace chiaro
