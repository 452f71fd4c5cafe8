#include "app/lock_file.h"

namespace chiaro::app {

std::unique_ptr<QLockFile> lockAt(const std::filesystem::path& file) {
    auto lock = std::make_unique<QLockFile>(QString::fromStdString(file.string()));
    lock->setStaleLockTime(0);
    return lock;
}

}  // namespace chiaro::app
