#include "core/base/helper/service/service.h"
#include "core/base/image_import.h"
#include "core/scene/mesh_import.h"

#include <cstdio>
#include <cstdlib>
#include <string_view>

/// Reads the files that the studio and the command line open, shut off from all else. They start it
/// themselves.
int main(int argc, char** argv) {
    const bool isCalledRight = argc == 3 && std::string_view(argv[1]) == "--memory";
    const long megabytes = isCalledRight ? std::strtol(argv[2], nullptr, 10) : 0;
    int status = 2;
    if (megabytes > 0)
        status = chiaro::helper::serve(std::size_t(megabytes),
                                       {{chiaro::imageRequest, chiaro::handleImageRequest},
                                        {chiaro::imageMetadataRequest, chiaro::handleImageMetadataRequest},
                                        {chiaro::scene::modelRequest, chiaro::scene::handleModelRequest}});
    if (status == 2)
        std::fputs("chiaro-import: reads files for chiaro and chiaro-studio; start one of those instead\n",
                   stderr);
    return status;
}
