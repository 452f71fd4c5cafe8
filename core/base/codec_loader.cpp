#include "core/base/codec/codec.h"
#include "core/base/module.h"

namespace chiaro {

const ImageCodec& imageCodec() {
    static const ImageCodec& codec =
        *reinterpret_cast<const ImageCodec* (*)()>(moduleFunction("chiaro_codec", "chiaroImageCodec"))();
    return codec;
}

}  // namespace chiaro
