#include "core/base/codec/codec.h"
#include "core/base/codec/image_decode.h"
#include "core/base/codec/image_encode.h"

extern "C" const chiaro::ImageCodec* chiaroImageCodec() {
    static constexpr chiaro::ImageCodec codec{chiaro::decodeImage, chiaro::decodeMetadata,
                                              chiaro::encodeImage};
    return &codec;
}
