#include "app/cli/demo/demo.h"

#include "app/cli/child_process.h"
#include "app/cli/farm/job.h"
#include "core/base/atomic_file.h"
#include "core/base/error.h"
#include "core/base/resources.h"

#include <spdlog/fmt/fmt.h>

#include <cstdio>
#include <memory>
#include <unistd.h>

namespace chiaro::cli {

namespace fs = std::filesystem;

namespace demo {

Demo::Demo(fs::path folder, Session& session)
    : m_folder(std::move(folder)),
      m_session(session),
      m_set(session.flags.seed),
      m_page(m_folder, "Chiaro: the demo") {}

void Demo::run() {
    m_session.start();
    checkOutputs({m_folder / "index.html"}, true);
    fs::create_directories(m_folder);
    m_folder = fs::canonical(m_folder);
    Stopwatch stopwatch;
    const std::vector<Part> all = parts();
    double total = 0, done = 0;
    for (const Part& part : all) total += part.share;
    const Task task = m_session.task("demo");
    for (const Part& part : all) {
        makePart(part, task.part(done / total, (done + part.share) / total));
        done += part.share;
        task.report(done / total);
    }
    const double seconds = stopwatch.lap();
    writeFileAtomically(
        m_folder / "index.html",
        m_page.html(readFile(resourceFolder() / "demo" / "page.css", 1 << 20),
                    "Made by Chiaro " CHIARO_VERSION ". Everything above is a file in this folder."));
    m_session.finish({{"pictures", m_page.pictures()},
                      {"folder", m_folder.string()},
                      {"problems", m_problems},
                      {"seconds", seconds}},
                     fmt::format("{} pictures in {:.0f} s; open {}", m_page.pictures(), seconds,
                                 (m_folder / "index.html").string()));
    if (!m_problems.empty())
        throw Error(m_folder.string(), fmt::format("{}", fmt::join(m_problems, "; and ")),
                    "everything else is there");
}

void Demo::makePart(const Part& part, const Task& task) {
    m_task = task;
    m_page.section(part.title, part.text);
    Stopwatch stopwatch;
    std::string outcome;
    try {
        (this->*part.make)();
        outcome = fmt::format("{:.1f} s", stopwatch.lap());
    } catch (const std::exception& error) {
        m_page.problem(error.what());
        m_problems.push_back(fmt::format("\"{}\" could not be made ({})", part.title, error.what()));
        outcome = error.what();
    }
    // A terminal has the bar.
    const bool isTold = !m_session.flags.quiet && !m_session.flags.json && !isatty(STDERR_FILENO);
    if (isTold) std::printf("%-36s %s\n", part.title, outcome.c_str());
    std::fflush(stdout);
}

nlohmann::json Demo::chiaro(Words words) {
    const auto shortened = [this](std::string word) {
        const std::string inputs = (resourceFolder() / "demo").string() + "/";
        const std::string outputs = m_folder.string() + "/";
        for (const std::string& folder : {inputs, outputs})
            if (const std::size_t at = word.find(folder); at != std::string::npos)
                word.erase(at, folder == inputs ? word.rfind('/') + 1 - at : folder.size());
        return farm::quoted(word);
    };
    std::string line = "chiaro";
    for (const std::string& word : words) line += " " + shortened(word);
    m_page.command(line);
    words.insert(words.begin(), fs::read_symlink("/proc/self/exe").string());
    words.push_back("--json");
    words.push_back(fmt::format("--seed={}", m_session.flags.seed));
    if (m_session.flags.threads > 0) words.push_back(fmt::format("--threads={}", m_session.flags.threads));
    const Ended ended = runProgram(words, m_task);
    if (ended.status == 0) return nlohmann::json::parse(ended.out, nullptr, false);
    std::string reason = ended.error.substr(0, ended.error.find('\n'));
    if (reason.starts_with("chiaro: ")) reason.erase(0, 8);
    throw std::runtime_error(reason.empty() ? fmt::format("{} ended with status {}", words[1], ended.status)
                                            : reason);
}

void Demo::write(const std::string& file, const ColorImage& picture, const std::string& what) const {
    writeImage(m_folder / file, picture,
               pictureMetadata("demo", {{"picture", what}, {"seed", m_session.flags.seed}}));
}

std::string Demo::input(const std::string& relative) const {
    return (resourceFolder() / "demo" / relative).string();
}

}  // namespace demo

void addDemoCommand(CLI::App& root, Session& session) {
    CLI::App* command = root.add_subcommand(
        "demo", "Send the built-in scene through every command; a page index.html shows what comes out");
    auto folder = std::make_shared<fs::path>();
    command
        ->add_option(
            "-o,--output", *folder,
            "Folder for index.html and all that it shows; what an earlier demo left there is replaced")
        ->required();
    session.addCommonFlags(*command);
    command->callback([folder, &session] { demo::Demo(*folder, session).run(); });
}

}  // namespace chiaro::cli
