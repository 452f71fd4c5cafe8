#include "app/cli/session.h"

#include "core/base/error.h"
#include "core/base/import.h"

#include <spdlog/fmt/fmt.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <thread>
#include <unistd.h>

namespace chiaro::cli {

std::string timeLeft(double seconds, double fraction) {
    if (fraction >= 1 || fraction < 0.02 || seconds < 3) return {};
    const auto left = std::int64_t(std::ceil(seconds * (1 - fraction) / fraction));
    if (left >= 3600) return fmt::format("{}:{:02}:{:02} left", left / 3600, left / 60 % 60, left % 60);
    return fmt::format("{}:{:02} left", left / 60, left % 60);
}

void Session::addCommonFlags(CLI::App& command) {
    command.add_flag("--json", flags.json, "Print one JSON object on stdout instead of text");
    command.add_flag("--quiet", flags.quiet, "Print nothing but errors");
    if (!command.get_option_no_throw("--seed"))
        command.add_option("--seed", flags.seed, "Seed of every random choice (default 1)")
            ->check(CLI::Range(0.0, 0x1p53));
    command
        .add_option("--threads", flags.threads,
                    "Threads; the result never depends on them (default: all cores)")
        ->check(CLI::Range(0, 1024));
    addImportFlags(command);
}

void Session::addImportFlags(CLI::App& command) {
    const auto& specs = ImportSettings::table().specs();
    const std::vector<double> defaults = ImportSettings::table().values({});
    std::optional<int>* const values[] = {&flags.importMemory, &flags.importSeconds};
    for (std::size_t i = 0; i < specs.size(); ++i)
        command
            .add_option("--import-" + specs[i].key, *values[i],
                        fmt::format("{} ({}; default {}, or CHIARO_IMPORT_{})", specs[i].tooltip,
                                    specs[i].rangeText(), specs[i].valueText(defaults[i]),
                                    i == 0 ? "MEMORY" : "SECONDS"))
            ->check(CLI::Range(int(specs[i].minimum), int(specs[i].maximum)));
}

void Session::start() {
    static std::unique_ptr<tbb::global_control> limit;
    limit = std::make_unique<tbb::global_control>(tbb::global_control::max_allowed_parallelism,
                                                  std::size_t(threads()));
    ImportSettings limits = ImportSettings::fromEnvironment();
    if (flags.importMemory) limits.megabytes = *flags.importMemory;
    if (flags.importSeconds) limits.seconds = *flags.importSeconds;
    importInHelpers(limits, m_stop);
}

int Session::threads() const {
    return flags.threads > 0 ? flags.threads : int(std::max(1u, std::thread::hardware_concurrency()));
}

Task Session::task(const std::string& label) {
    if (flags.quiet || !isatty(STDERR_FILENO)) return Task(m_stop);
    const auto begin = std::chrono::steady_clock::now();
    return Task(m_stop, [label, begin](double fraction) {
        constexpr int width = 32;
        const double seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        if (seconds < 1) return;
        const int filled = int(fraction * width);
        std::fprintf(stderr, "\r%-12s [%s%s] %3d%%  %-14s%s", label.c_str(),
                     std::string(std::size_t(filled), '#').c_str(),
                     std::string(std::size_t(width - filled), ' ').c_str(), int(fraction * 100),
                     timeLeft(seconds, fraction).c_str(), fraction >= 1 ? "\n" : "");
    });
}

void Session::finish(const nlohmann::json& json, const std::string& text) {
    if (flags.json)
        std::cout << json.dump() << std::endl;
    else if (!flags.quiet)
        std::cout << text << std::endl;
}

void addParameterFlags(CLI::App& command, std::span<const ParameterSpec> specs,
                       std::span<const double> defaults,
                       const std::function<void(std::size_t, double)>& assign, const std::string& prefix) {
    for (std::size_t i = 0; i < specs.size(); ++i) {
        const ParameterSpec& spec = specs[i];
        const std::string help =
            fmt::format("{} ({}; default {})", spec.tooltip, spec.rangeText(), spec.valueText(defaults[i]));
        command
            .add_option_function<std::string>(
                "--" + prefix + spec.key,
                [spec, assign, i](const std::string& text) {
                    try {
                        assign(i, spec.parse(text));
                    } catch (const Error& error) {
                        throw CLI::ValidationError(std::string("--") + error.what());
                    }
                },
                help)
            ->type_name("");
    }
}

std::vector<float> numbersFrom(const std::string& flag, const std::string& text, std::size_t count) {
    std::vector<float> numbers;
    std::stringstream stream(text);
    std::string part;
    bool valid = true;
    while (std::getline(stream, part, ',')) {
        char* end = nullptr;
        numbers.push_back(std::strtof(part.c_str(), &end));
        valid = valid && !part.empty() && *end == '\0' && std::isfinite(numbers.back());
    }
    if (!valid || numbers.size() != count)
        throw CLI::ValidationError(
            fmt::format("{}: is \"{}\"; write {} numbers with commas between them", flag, text, count));
    return numbers;
}

void usageFrom(const std::string& flag, const std::function<void()>& check) {
    try {
        check();
    } catch (const Error& error) {
        throw CLI::ValidationError(flag + ": " + error.what());
    }
}

void refuseOverwriting(const std::vector<std::filesystem::path>& inputs,
                       const std::vector<std::filesystem::path>& outputs) {
    const auto same = [](const std::filesystem::path& a, const std::filesystem::path& b) {
        std::error_code ignored;
        return !a.empty() && !b.empty() &&
               std::filesystem::weakly_canonical(a, ignored) == std::filesystem::weakly_canonical(b, ignored);
    };
    for (std::size_t i = 0; i < outputs.size(); ++i) {
        const auto is = [&](const std::filesystem::path& other) { return same(outputs[i], other); };
        if (std::any_of(inputs.begin(), inputs.end(), is))
            throw Error(outputs[i].string(), "is an input too", "write to another file");
        if (std::any_of(outputs.begin(), outputs.begin() + std::ptrdiff_t(i), is))
            throw Error(outputs[i].string(), "is to hold two outputs", "give each a file of its own");
    }
}

ImageMetadata pictureMetadata(const std::string& command, const nlohmann::json& parameters) {
    return {{"Software", std::string("Chiaro ") + CHIARO_VERSION},
            {"chiaro:command", command},
            {"chiaro:parameters", parameters.dump()}};
}

}  // namespace chiaro::cli
