#pragma once

#include "core/base/image_io.h"
#include "core/base/parameters.h"
#include "core/base/task.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <optional>
#include <stop_token>
#include <string>

namespace chiaro::cli {

/// The flags that every command takes.
struct CommonFlags {
    bool json = false;
    bool quiet = false;
    int threads = 0;                  ///< 0: all cores
    std::optional<int> importMemory;  ///< MB; the environment's or the default when not given
    std::optional<int> importSeconds;
    std::uint64_t seed = 1;  ///< of commands whose parameters have no seed of their own
};

/// One run of one command: its flags, its way to report, and its cancellation.
class Session {
public:
    explicit Session(std::stop_token stop) : m_stop(std::move(stop)) {}

    CommonFlags flags;

    /// To be called last: a command whose parameters have a seed keeps that one.
    void addCommonFlags(CLI::App& command);
    /// To be called once the flags are parsed: limits the threads for the rest of the
    /// process, and has files read in helper processes.
    void start();
    int threads() const;

    /// A task that draws a progress bar on stderr when that is a terminal and the work takes longer than a
    /// second.
    Task task(const std::string& label);
    /// Prints the result: the object with --json, else the text unless --quiet.
    void finish(const nlohmann::json& json, const std::string& text);

private:
    void addImportFlags(CLI::App& command);

    std::stop_token m_stop;
};

/// A flag for every parameter of the table, with its help text; values go into `params`, which must outlive
/// the parse.
void addParameterFlags(CLI::App& command, std::span<const ParameterSpec> specs,
                       std::span<const double> defaults,
                       const std::function<void(std::size_t index, double value)>& assign,
                       const std::string& prefix = {});

template <class Params>
void addParameterFlags(CLI::App& command, Params& params) {
    addParameterFlags(command, Params::table().specs(), Params::table().values(params),
                      [&params](std::size_t index, double value) {
                          std::vector<double> values = Params::table().values(params);
                          values[index] = value;
                          Params::table().assign(params, values);
                      });
}

/// "1,2,3" as numbers. Throws CLI::ValidationError naming the flag when there are not exactly `count`.
std::vector<float> numbersFrom(const std::string& flag, const std::string& text, std::size_t count);

/// Runs a check of a flag's value; its Error becomes a CLI::ValidationError naming the flag.
void usageFrom(const std::string& flag, const std::function<void()>& check);

/// Throws Error when an output is one of the inputs, or when two outputs are one file; empty paths don't
/// count.
void refuseOverwriting(const std::vector<std::filesystem::path>& inputs,
                       const std::vector<std::filesystem::path>& outputs);

/// "1:23 left" or "1:02:03 left" of work that a fraction was done of in these seconds; empty as long as that
/// says little.
std::string timeLeft(double seconds, double fraction);

/// What every picture that a command writes carries: version, command, parameters. Nothing that may differ
/// between runs that make the same picture (threads, output names).
ImageMetadata pictureMetadata(const std::string& command, const nlohmann::json& parameters);

/// Seconds since it was made or last asked.
class Stopwatch {
public:
    double lap() {
        const auto now = std::chrono::steady_clock::now();
        const double seconds = std::chrono::duration<double>(now - m_last).count();
        m_last = now;
        return seconds;
    }

private:
    std::chrono::steady_clock::time_point m_last = std::chrono::steady_clock::now();
};

void addSampleCommands(CLI::App& root, Session& session);
void addLevelsCommand(CLI::App& root, Session& session);
void addRenderCommand(CLI::App& root, Session& session);
void addAnimateCommand(CLI::App& root, Session& session);
void addViewsCommand(CLI::App& root, Session& session);
void addMeasureCommand(CLI::App& root, Session& session);
void addCompareCommand(CLI::App& root, Session& session);
void addExportCommand(CLI::App& root, Session& session);
void addFarmCommands(CLI::App& root, Session& session);
void addDemoCommand(CLI::App& root, Session& session);

}  // namespace chiaro::cli
