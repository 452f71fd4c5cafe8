#include "tests/bench/page/results.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>

namespace chiaro::bench {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t largestFile = 64 << 20;

double secondsOf(const std::string& unit) {
    if (unit == "ns") return 1e-9;
    if (unit == "us") return 1e-6;
    if (unit == "ms") return 1e-3;
    return 1;
}

/// "frame/AVX2/width:512" is the benchmark "frame/AVX2" with options behind it, "frameOf" is not.
bool isRunOf(const std::string& name, const std::string& benchmark) {
    return name.starts_with(benchmark) && (name.size() == benchmark.size() || name[benchmark.size()] == '/');
}

/// What a program wrote; when it was ended early, all that it had told until then. Discarded when that is
/// nothing.
nlohmann::json parsed(const std::string& text) {
    const auto whole = nlohmann::json::parse(text, nullptr, false);
    if (!whole.is_discarded()) return whole;
    const std::string end = "\n    }";  // of a benchmark
    const auto last = text.rfind(end);
    return nlohmann::json::parse(text.substr(0, last == std::string::npos ? 0 : last + end.size()) + "]}",
                                 nullptr, false);
}

Run runOf(const nlohmann::json& entry) {
    Run run{entry.at("name"), {}};
    const double unit = secondsOf(entry.value("time_unit", "s"));
    for (const auto& [key, value] : entry.items())
        if (value.is_number())
            run.figures[key] = value.get<double>() * (key == "real_time" || key == "cpu_time" ? unit : 1.0);
    return run;
}

}  // namespace

Results::Results(const fs::path& folder, std::string instructionSet)
    : m_instructionSet(std::move(instructionSet)) {
    if (!fs::is_directory(folder))
        throw Error(folder.string(), "is no folder", "run the benchmarks first (./dev bench)");
    std::vector<fs::path> files;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    std::ranges::sort(files);
    for (const fs::path& file : files) add(file);
    std::error_code ignored;
    if (fs::exists(folder / "failures.txt", ignored)) {
        std::istringstream lines(readFile(folder / "failures.txt", largestFile));
        for (std::string line; std::getline(lines, line);) m_failures.push_back(line);
    }
}

void Results::add(const fs::path& file) {
    const std::string program = file.stem().string();
    const auto json = parsed(readFile(file, largestFile));
    if (!json.is_object() || !json.contains("benchmarks")) {
        m_failures.push_back(fmt::format("bench_{} ended before it had told anything.", program));
        return;
    }
    addMachine(json.value("context", nlohmann::json::object()));
    std::vector<Run>& runs = m_programs[program];
    for (const nlohmann::json& entry : json["benchmarks"]) {
        if (entry.value("error_occurred", false))
            m_failures.push_back(fmt::format("bench_{}: {} failed ({}).", program,
                                             entry.value("name", "a benchmark"),
                                             entry.value("error_message", "no reason given")));
        else if (entry.value("run_type", "iteration") == "iteration")
            runs.push_back(runOf(entry));
    }
}

void Results::addMachine(const nlohmann::json& context) {
    m_machine.processors = std::max(m_machine.processors, context.value("num_cpus", 0));
    if (context.contains("renderer")) m_machine.renderer = context["renderer"];
    const std::string date = context.value("date", "");
    if (date.empty() || (!m_machine.date.empty() && m_machine.date <= date)) return;
    m_machine.date = date;
    if (const auto load = context.value("load_avg", std::vector<double>{}); !load.empty())
        m_machine.load = load[0];
}

std::string Results::named(const std::string& benchmark) const {
    std::string name = benchmark;
    if (const auto at = name.find("{simd}"); at != std::string::npos) name.replace(at, 6, m_instructionSet);
    return name;
}

std::optional<double> Results::find(const Reading& reading) const {
    for (const Run& run : runs(reading.program, reading.benchmark))
        if (const auto figure = run.figures.find(reading.figure); figure != run.figures.end())
            return figure->second;
    return std::nullopt;
}

std::vector<Run> Results::runs(const std::string& program, const std::string& benchmark) const {
    std::vector<Run> found;
    const std::string name = named(benchmark);
    if (const auto of = m_programs.find(program); of != m_programs.end())
        std::ranges::copy_if(of->second, std::back_inserter(found),
                             [&](const Run& run) { return isRunOf(run.name, name); });
    return found;
}

}  // namespace chiaro::bench
