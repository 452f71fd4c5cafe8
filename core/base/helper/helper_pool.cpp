#include "core/base/helper/helper_pool.h"

#include "core/base/helper/file_request.h"
#include "core/base/module.h"

#include <spdlog/fmt/fmt.h>

#include <system_error>
#include <thread>

namespace chiaro::helper {

namespace fs = std::filesystem;

namespace {

constexpr const char* programName = "chiaro-import";

/// The helper's sentence, with the file's name as it was given.
Error refusal(const fs::path& file, std::string sentence) {
    const std::string subject = fs::absolute(file).string() + ": ";
    const std::size_t remedy = sentence.find("; ", std::min(subject.size(), sentence.size()));
    if (!sentence.starts_with(subject) || remedy == sentence.npos) return nonsense(file);
    for (char& c : sentence) c = c >= 0 && c < ' ' ? ' ' : c;
    return Error(file.string(), sentence.substr(subject.size(), remedy - subject.size()),
                 sentence.substr(remedy + 2));
}

}  // namespace

HelperPool::HelperPool(ImportSettings settings, std::stop_token stop)
    : m_settings(std::move(settings)),
      m_stop(std::move(stop)),
      m_maximum(std::clamp(std::thread::hardware_concurrency(), 2u, 4u)) {
    ImportSettings::table().check(m_settings);
}

HelperPool::~HelperPool() = default;

std::unique_ptr<HelperProcess> HelperPool::startHelper() const {
    const fs::path program = m_settings.program.empty() ? companionFile(programName) : m_settings.program;
    std::string problem = "is not there";
    std::error_code ignored;
    if (fs::is_regular_file(program, ignored)) {
        try {
            return std::make_unique<HelperProcess>(
                program, std::vector{std::string("--memory"), std::to_string(m_settings.megabytes)});
        } catch (const std::system_error& error) {
            problem = "can't be started (" + error.code().message() + ")";
        }
    }
    throw Error(program.string(), problem + ", and files are not opened without it", "install Chiaro again");
}

std::unique_ptr<HelperProcess> HelperPool::takeHelper(const Task& task) {
    std::unique_lock lock(m_mutex);
    while (m_busy >= m_maximum) {
        if (task.cancelled() || m_stop.stop_requested() || ImportsOfTask::cancelled()) throw Cancelled();
        m_returned.wait_for(lock, std::chrono::milliseconds(20));
    }
    ++m_busy;
    if (m_idle.empty()) return nullptr;
    auto helper = std::move(m_idle.back());
    m_idle.pop_back();
    return helper;
}

void HelperPool::giveBack(std::unique_ptr<HelperProcess> helper) {
    const std::lock_guard lock(m_mutex);
    --m_busy;
    if (helper && helper->isUsable()) m_idle.push_back(std::move(helper));
    m_returned.notify_one();
}

std::vector<int> HelperPool::idleProcesses() const {
    const std::lock_guard lock(m_mutex);
    std::vector<int> ids;
    for (const auto& helper : m_idle) ids.push_back(helper->id());
    return ids;
}

Answer HelperPool::ask(const std::string& request, const fs::path& file, const Task& task) {
    struct Loan {
        HelperPool& pool;
        std::unique_ptr<HelperProcess> helper;
        ~Loan() { pool.giveBack(std::move(helper)); }
    } loan{*this, takeHelper(task)};
    // One that died while it had nothing to do says nothing about the file.
    for (bool isLastTry = !loan.helper;; isLastTry = true) {
        if (!loan.helper) loan.helper = startHelper();
        auto outcome = loan.helper->ask(request, task, m_stop, std::chrono::seconds(m_settings.seconds));
        if (auto* answer = std::get_if<Answer>(&outcome)) return std::move(*answer);
        const auto& trouble = std::get<Trouble>(outcome);
        if (trouble.kind != Trouble::Kind::NeverBegan || isLastTry) tell(trouble, file);
        loan.helper = nullptr;
    }
}

void HelperPool::tell(const Trouble& trouble, const fs::path& file) const {
    const std::string name = file.string();
    switch (trouble.kind) {
        case Trouble::Kind::Refused:
            throw refusal(file, trouble.text);
        case Trouble::Kind::OutOfMemory:
            throw Error(
                name, fmt::format("takes more memory to read than a file may ({} MB)", m_settings.megabytes),
                "make it smaller, or raise CHIARO_IMPORT_MEMORY if it is sound");
        case Trouble::Kind::OutOfTime:
            throw Error(name, fmt::format("was not read within {} seconds", m_settings.seconds),
                        "it may be damaged; raise CHIARO_IMPORT_SECONDS if it is sound and just large");
        case Trouble::Kind::NeverBegan:
            throw Error(programName, fmt::format("does not run (it {})", trouble.text),
                        "install Chiaro again");
        case Trouble::Kind::Crashed:
            break;
    }
    if (trouble.text.empty()) throw nonsense(file);
    throw Error(name, fmt::format("can't be read: its reader {}", trouble.text),
                "the file may be damaged, so copy it or save it again");
}

}  // namespace chiaro::helper
