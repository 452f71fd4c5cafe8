#pragma once

#include <nlohmann/json_fwd.hpp>

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace chiaro::bench {

/// One figure of one benchmark.
struct Reading {
    std::string program;    ///< without "bench_"
    std::string benchmark;  ///< its name up to the options behind it; "{simd}" is the best instruction set
    std::string figure = "real_time";  ///< or another of Google Benchmark's, or a counter; times are seconds
};

/// What one run of one benchmark told.
struct Run {
    std::string name;
    std::map<std::string, double> figures;
};

/// What the benchmark programs wrote into a folder (--benchmark_out), one NAME.json a program.
class Results {
public:
    /// Throws Error when there is no such folder. A program that was
    /// ended early counts for what it had told by then.
    Results(const std::filesystem::path& folder, std::string instructionSet);

    /// Nothing when it was not measured.
    std::optional<double> find(const Reading& reading) const;
    /// The runs of a benchmark with all its arguments, in the order in which they were made.
    std::vector<Run> runs(const std::string& program, const std::string& benchmark) const;
    bool has(const std::string& program) const { return m_programs.contains(program); }
    /// A benchmark's name with the instruction set in it.
    std::string named(const std::string& benchmark) const;

    struct Machine {
        int processors = 0;
        double load = 0;       ///< of the machine over the minute before the first benchmark
        std::string date;      ///< YYYY-MM-DD
        std::string renderer;  ///< of OpenGL; empty when unknown
    };
    const Machine& machine() const { return m_machine; }
    /// Sentences about what failed.
    const std::vector<std::string>& failures() const { return m_failures; }

private:
    void add(const std::filesystem::path& file);
    /// The machine as a program's results tell it; the first of the day tells the load.
    void addMachine(const nlohmann::json& context);

    std::string m_instructionSet;
    std::map<std::string, std::vector<Run>> m_programs;
    Machine m_machine;
    std::vector<std::string> m_failures;
};

}  // namespace chiaro::bench
