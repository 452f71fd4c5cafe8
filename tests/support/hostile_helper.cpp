// A helper as bad as a hostile file could make one: it crashes, hangs, eats memory, lies and tries to get
// out.

#include "core/base/error.h"
#include "core/base/helper/helper_pool.h"
#include "core/base/helper/plain_bytes.h"
#include "core/base/helper/service/service.h"
#include "core/base/image_import.h"
#include "core/scene/mesh_import.h"

#include <netinet/in.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>

#include <csignal>
#include <cstdio>
#include <fcntl.h>
#include <thread>
#include <unistd.h>

namespace {

using namespace chiaro;
using namespace chiaro::helper;

Finding crash(PlainReader&, const Task&) {
    std::raise(SIGSEGV);
    return {};
}

Finding hang(PlainReader&, const Task&) {
    for (;;) std::this_thread::sleep_for(std::chrono::hours(1));
}

Finding eatMemory(PlainReader&, const Task&) {
    for (std::size_t size = 1 << 20;; size *= 2) SharedWriter(size).data()[size - 1] = std::byte(1);
}

Finding handOverOpenMemory(PlainReader&, const Task&) {
    const int memory = ::memfd_create("open", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (::ftruncate(memory, 4096) != 0) throw Error("memory", "is not there", "try again");
    return {"open", FileHandle(memory)};
}

/// What of all that it tries it can do.
Finding breakOut(PlainReader& request, const Task&) {
    const std::string folder = request.takeText();
    std::string done;
    const auto note = [&](bool succeeded, const char* what) {
        if (succeeded) done += std::string(what) + " ";
    };
    note(::open((folder + "/new").c_str(), O_WRONLY | O_CREAT, 0600) >= 0, "create");
    note(::open((folder + "/old").c_str(), O_WRONLY) >= 0, "write");
    note(::unlink((folder + "/old").c_str()) == 0, "unlink");
    note(::rename((folder + "/old").c_str(), (folder + "/other").c_str()) == 0, "rename");
    note(::mkdir((folder + "/sub").c_str(), 0700) == 0, "mkdir");
    note(::chmod((folder + "/old").c_str(), 0777) == 0, "chmod");
    note(::truncate((folder + "/old").c_str(), 0) == 0, "truncate");
    note(::socket(AF_INET, SOCK_STREAM, 0) >= 0, "socket");
    note(::kill(::getppid(), 0) == 0, "signal");
    const pid_t child = ::fork();
    if (child == 0) ::_exit(0);
    note(child > 0, "fork");
    char* const arguments[] = {const_cast<char*>("/bin/true"), nullptr};
    ::execv("/bin/true", arguments);
    note(::open((folder + "/old").c_str(), O_RDONLY) < 0, "could-not-even-read");
    return {done};
}

Finding waitABit(PlainReader& request, const Task& task) {
    task.report(0.5);
    std::this_thread::sleep_for(std::chrono::milliseconds(150));
    return {request.takeText()};
}

/// The number at the end of a file's stem: which byte of the answer to change.
std::size_t numberIn(const std::filesystem::path& file) {
    const std::string stem = file.stem().string();
    return std::stoul(stem.substr(stem.find_last_not_of("0123456789") + 1));
}

/// Wraps an honest handler and changes a byte of its answer: of the bytes first, then of the memory behind.
/// Files named crash and hang do that.
template <Finding (*honest)(PlainReader&, const Task&)>
Finding lie(PlainReader& request, const Task& task) {
    PlainReader peek = request;
    const std::filesystem::path file = peek.takeText();
    if (file.stem() == "crash") return crash(request, task);
    if (file.stem() == "hang") return hang(request, task);
    const std::size_t place = numberIn(file);
    Finding finding = honest(request, task);
    if (place < finding.bytes.size()) {
        finding.bytes[place] = char(~finding.bytes[place]);
        return finding;
    }
    const auto memory = SharedBytes(finding.memory);
    std::string bytes(reinterpret_cast<const char*>(memory.bytes().data()), memory.bytes().size());
    if (place - finding.bytes.size() < bytes.size()) {
        char& changed = bytes[place - finding.bytes.size()];
        changed = char(~changed);
    }
    finding.memory = sealed(bytes);
    return finding;
}

/// Plays the program: has a helper hang, tells its process and dies without a word.
int dieWhileHelping(const std::filesystem::path& program) {
    HelperProcess helper(program, {"--memory", "4096"});
    std::printf("%d\n", helper.id());
    std::fflush(stdout);
    PlainWriter request;
    request.addText("hang");
    helper.ask(request.take(), {}, {}, std::chrono::milliseconds(100));
    ::_exit(1);
}

int dieAbruptly(const std::filesystem::path& program) {
    std::thread([] {
        std::this_thread::sleep_for(std::chrono::milliseconds(60));
        ::raise(SIGKILL);
    }).detach();
    return dieWhileHelping(program);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc == 2) return dieAbruptly(argv[0]);
    return serve(4096, {{"crash", crash},
                        {"hang", hang},
                        {"eat memory", eatMemory},
                        {"open memory", handOverOpenMemory},
                        {"break out", breakOut},
                        {"wait", waitABit},
                        {imageRequest, lie<handleImageRequest>},
                        {scene::modelRequest, lie<scene::handleModelRequest>}});
}
