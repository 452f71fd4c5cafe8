#include "app/cli/command_line.h"

#include "app/cli/session.h"
#include "core/base/error.h"
#include "core/base/memory_reserve.h"

#include <csignal>
#include <cstdio>
#include <new>
#include <thread>

namespace chiaro::cli {

namespace {

/// Turns Ctrl+C and a polite kill into a stop request, on a thread of its own so that nothing runs inside a
/// signal handler.
class InterruptWatch {
public:
    InterruptWatch() {
        sigset_t signals = watched();
        pthread_sigmask(SIG_BLOCK, &signals, nullptr);
        m_thread = std::jthread([this] {
            const sigset_t awaited = watched();
            int signal = 0;
            sigwait(&awaited, &signal);
            if (signal != SIGUSR2) m_stop.request_stop();
        });
    }
    ~InterruptWatch() { pthread_kill(m_thread.native_handle(), SIGUSR2); }
    InterruptWatch(const InterruptWatch&) = delete;
    InterruptWatch& operator=(const InterruptWatch&) = delete;

    std::stop_token token() const { return m_stop.get_token(); }

private:
    static sigset_t watched() {
        sigset_t signals;
        sigemptyset(&signals);
        for (const int signal : {SIGINT, SIGTERM, SIGUSR2}) sigaddset(&signals, signal);
        return signals;
    }

    std::stop_source m_stop;
    std::jthread m_thread;
};

int fail(const char* message, int status) {
    std::fprintf(stderr, "chiaro: %s\n", message);
    return status;
}

/// One line, whatever a library put into its message.
std::string singleLine(std::string message) {
    std::replace(message.begin(), message.end(), '\n', ' ');
    return message;
}

}  // namespace

int run(int argc, const char* const* argv) {
    keepMemoryReserve();
    std::signal(SIGXFSZ, SIG_IGN);  // a file beyond what the user may write fails as on a full disk
    InterruptWatch interrupts;
    Session session(interrupts.token());
    CLI::App root("Shades 3D meshes with an artist's own paint.", "chiaro");
    root.set_version_flag("--version", std::string("chiaro ") + CHIARO_VERSION);
    root.require_subcommand(1);
    addSampleCommands(root, session);
    addLevelsCommand(root, session);
    addRenderCommand(root, session);
    addAnimateCommand(root, session);
    addViewsCommand(root, session);
    addMeasureCommand(root, session);
    addCompareCommand(root, session);
    addExportCommand(root, session);
    addFarmCommands(root, session);
    addDemoCommand(root, session);
    try {
        root.parse(argc, argv);
        return 0;
    } catch (const CLI::Success& help) {
        return root.exit(help);
    } catch (const CLI::ParseError& error) {
        return fail((singleLine(error.what()) + " (--help tells more)").c_str(), 2);
    } catch (const Cancelled&) {
        return fail("interrupted", 130);
    } catch (const Error& error) {
        return fail(singleLine(error.what()).c_str(), 1);
    } catch (const std::bad_alloc&) {
        return fail("out of memory; choose a smaller size or free some memory", 1);
    } catch (const std::exception& error) {
        return fail(singleLine(error.what()).c_str(), 1);
    }
}

}  // namespace chiaro::cli
