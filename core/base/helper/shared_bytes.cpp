#include "core/base/helper/shared_bytes.h"

#include "core/base/helper/handler.h"

#include <sys/mman.h>
#include <sys/stat.h>

#include <cstring>
#include <fcntl.h>
#include <new>
#include <stdexcept>

namespace chiaro::helper {

Mapping::Mapping(int descriptor, std::size_t size, bool writable) : m_size(size) {
    if (size == 0) return;
    // Every page is touched anyway, and asking for all at once costs less.
    void* const mapped = ::mmap(nullptr, size, writable ? PROT_READ | PROT_WRITE : PROT_READ,
                                writable ? MAP_SHARED : MAP_SHARED | MAP_POPULATE, descriptor, 0);
    if (mapped == MAP_FAILED) throw std::bad_alloc();
    m_data = static_cast<std::byte*>(mapped);
}

Mapping::~Mapping() {
    if (m_data) ::munmap(m_data, m_size);
}

Mapping::Mapping(Mapping&& other) noexcept
    : m_data(std::exchange(other.m_data, nullptr)), m_size(std::exchange(other.m_size, 0)) {}

Mapping& Mapping::operator=(Mapping&& other) noexcept {
    std::swap(m_data, other.m_data);
    std::swap(m_size, other.m_size);
    return *this;
}

SharedWriter::SharedWriter(std::size_t size) {
    m_file = FileHandle(::memfd_create("chiaro-import", MFD_CLOEXEC | MFD_ALLOW_SEALING));
    if (!m_file || ::ftruncate(m_file.get(), off_t(size)) != 0) throw std::bad_alloc();
    m_mapping = Mapping(m_file.get(), size, true);
}

FileHandle SharedWriter::seal() {
    m_mapping = Mapping();
    if (::fcntl(m_file.get(), F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE) != 0)
        throw std::runtime_error("the memory could not be sealed");
    return std::move(m_file);
}

FileHandle sealed(const std::string& bytes) {
    SharedWriter memory(bytes.size());
    if (!bytes.empty()) std::memcpy(memory.data(), bytes.data(), bytes.size());
    return memory.seal();
}

SharedBytes::SharedBytes(const FileHandle& sealed) {
    constexpr int needed = F_SEAL_SHRINK | F_SEAL_WRITE;
    struct stat status {};
    const int seals = ::fcntl(sealed.get(), F_GET_SEALS);
    if (seals < 0 || (seals & needed) != needed || ::fstat(sealed.get(), &status) != 0)
        throw std::runtime_error("the memory is not sealed");
    m_mapping = Mapping(sealed.get(), std::size_t(status.st_size), false);
}

}  // namespace chiaro::helper
