#include "core/base/codec/image_encode.h"

#include "core/base/error.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <spdlog/fmt/fmt.h>

namespace chiaro {

namespace {

OIIO::TypeDesc typeOf(EncodeRequest::Values values) {
    switch (values) {
        case EncodeRequest::Values::Bits8:
            return OIIO::TypeDesc::UINT8;
        case EncodeRequest::Values::Bits16:
            return OIIO::TypeDesc::UINT16;
        default:
            return OIIO::TypeDesc::FLOAT;
    }
}

void describe(OIIO::ImageSpec& spec, const EncodeRequest& request) {
    const ImageFormat format = request.format;
    // Writers stamp the time unless told one: the same picture must give the same bytes.
    spec.attribute("DateTime", "");
    const bool anyKey = format == ImageFormat::Png || format == ImageFormat::OpenExr;
    std::string lines;
    for (const auto& [key, value] : request.metadata) {
        if (anyKey || key == "Software") spec.attribute(key, value);
        std::string oneLine = value;
        std::replace(oneLine.begin(), oneLine.end(), '\n', ' ');
        lines += (lines.empty() ? "" : "\n") + key + ": " + oneLine;
    }
    if (!anyKey && !lines.empty()) spec.attribute("ImageDescription", lines);
    if (format == ImageFormat::Jpeg) {
        spec.attribute("CompressionQuality", request.quality);
        spec.attribute("jpeg:subsampling", "4:4:4");
    }
    if (format == ImageFormat::OpenExr || format == ImageFormat::Tiff) spec.attribute("compression", "zip");
}

}  // namespace

std::string encodeImage(const EncodeRequest& request) {
    const OIIO::TypeDesc type = typeOf(request.type);
    OIIO::ImageSpec spec(request.width, request.height, request.channels, type);
    if (request.channels == 1) spec.channelnames = {"Y"};
    if (request.channels == 2) spec.channelnames = {"X", "Y"};
    if (request.channels == 4 && request.format != ImageFormat::OpenExr)
        spec.attribute("oiio:UnassociatedAlpha", 1);
    describe(spec, request);
    // In memory, so that the disk is written by code that checks every write.
    OIIO::Filesystem::IOVecOutput memory;
    OIIO::Filesystem::IOProxy* proxy = &memory;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);

    const auto failure = [&](const std::string& reason) {
        return Error(request.path.string(),
                     fmt::format("could not be encoded as {} ({})", displayName(request.format), reason),
                     "choose another format");
    };
    const auto output = OIIO::ImageOutput::create(codecName(request.format));
    if (!output) throw failure("no such encoder on this machine");
    const bool complete = output->open(request.path.filename().string(), spec) &&
                          output->write_image(type, request.values) && output->close();
    if (!complete) throw failure(output->geterror());
    const std::vector<unsigned char>& bytes = memory.buffer();
    return std::string(bytes.begin(), bytes.end());
}

}  // namespace chiaro
