#pragma once

#include <opencv2/core.hpp>

#include <new>
#include <utility>

namespace chiaro {

/// Does work with OpenCV, whose own error for a lack of memory becomes std::bad_alloc, as everybody else's
/// is.
template <class Work>
auto withOpenCv(Work&& work) {
    try {
        return std::forward<Work>(work)();
    } catch (const cv::Exception& error) {
        if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
        throw;
    }
}

}  // namespace chiaro
