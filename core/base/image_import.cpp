#include "core/base/image_import.h"

#include "core/base/codec/codec.h"
#include "core/base/helper/file_request.h"

#include <optional>

namespace chiaro {

namespace fs = std::filesystem;

using helper::PlainReader;
using helper::PlainWriter;

DecodedImage importImage(helper::HelperPool& helpers, const fs::path& path, const ImageLimits& limits,
                         const Task& task) {
    PlainWriter request = helper::fileRequest(imageRequest, path);
    request.add(limits);
    const helper::Answer answer = helpers.ask(request.take(), path, task);
    return helper::understood(path, [&] {
        const auto stored = PlainReader(answer.bytes).take<StoredImage>();
        return decodedFrom(stored, answer.memory.bytes(), path, limits);
    });
}

ImageMetadata importImageMetadata(helper::HelperPool& helpers, const fs::path& path, const Task& task) {
    const helper::Answer answer =
        helpers.ask(helper::fileRequest(imageMetadataRequest, path).take(), path, task);
    return helper::understood(path, [&] {
        PlainReader reader(answer.memory.bytes());
        ImageMetadata metadata;
        while (!reader.atEnd()) {
            std::string key = reader.takeText();
            metadata[std::move(key)] = reader.takeText();
        }
        return metadata;
    });
}

helper::Finding handleImageRequest(PlainReader& request, const Task&) {
    const fs::path path = request.takeText();
    const auto limits = request.take<ImageLimits>();
    std::optional<helper::SharedWriter> values;
    const StoredImage stored = imageCodec().read(
        path, limits, [&](std::size_t size) { return static_cast<void*>(values.emplace(size).data()); });
    PlainWriter bytes;
    bytes.add(stored);
    return {bytes.take(), values ? values->seal() : helper::FileHandle()};
}

helper::Finding handleImageMetadataRequest(PlainReader& request, const Task&) {
    PlainWriter bytes;
    for (const auto& [key, value] : imageCodec().readMetadata(request.takeText())) {
        bytes.addText(key);
        bytes.addText(value);
    }
    return {{}, helper::sealed(bytes.take())};
}

}  // namespace chiaro
