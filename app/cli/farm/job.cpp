#include "app/cli/farm/job.h"

#include "core/base/atomic_file.h"
#include "core/base/error.h"

#include <nlohmann/json.hpp>
#include <spdlog/fmt/fmt.h>

#include <fstream>

namespace chiaro::cli::farm {

namespace fs = std::filesystem;
using exporting::FrameRange;

namespace {

constexpr std::uintmax_t largestJob = 64 << 20;

std::string textOf(FrameRange range) {
    return fmt::format("{}-{}", range.first, range.last);
}

fs::path noteFile(const Job& job, int chunk) {
    return job.folder / "state" / std::to_string(chunk);
}

nlohmann::json jsonOf(const Job& job) {
    nlohmann::json json{{"farm", 1},
                        {"engine", job.engine},
                        {"number", job.number},
                        {"program", job.program.string()},
                        {"workplace", job.workplace.string()},
                        {"pattern", job.pattern.string()},
                        {"arguments", job.arguments},
                        {"threads", job.threads},
                        {"tries", job.tries},
                        {"rate", job.rate}};
    for (const FrameRange chunk : job.chunks) json["chunks"].push_back(textOf(chunk));
    return json;
}

/// The command that every chunk begins with, quoted.
std::string commonCommand(const Job& job) {
    std::string command = quoted(job.program.string()) + " animate";
    for (const std::string& argument : job.arguments) command += " " + quoted(argument);
    return command;
}

}  // namespace

fs::path Job::log(int chunk) const {
    return folder / "logs" / fmt::format("{}.log", chunk);
}

fs::path jobFolder(const fs::path& pattern) {
    const std::string name = pattern.filename().string();
    const std::size_t end = name.find_first_of("#");
    std::string stem = name.substr(0, end);
    while (!stem.empty() && (stem.back() == '.' || stem.back() == '_' || stem.back() == '-')) stem.pop_back();
    return fs::absolute(pattern).parent_path() / ((stem.empty() ? "frames" : stem) + ".farm");
}

std::vector<FrameRange> chunksOf(FrameRange range, int size, int every) {
    size = (size + every - 1) / every * every;
    std::vector<FrameRange> chunks;
    for (int first = range.first; first <= range.last;) {
        const int next = ((first - 1) / every * every) + size + 1;
        chunks.push_back({first, std::min(next - 1, range.last)});
        first = next;
    }
    return chunks;
}

void writeJob(const Job& job) {
    std::error_code ignored;
    fs::remove_all(job.folder / "state", ignored);
    fs::remove_all(job.folder / "logs", ignored);
    for (const char* folder : {"state", "logs"}) {
        std::error_code error;
        fs::create_directories(job.folder / folder, error);
        if (error)
            throw Error((job.folder / folder).string(), "could not be made (" + error.message() + ")",
                        "choose a folder you may write to with --job");
    }
    writeFilesAtomically({{job.script(), chunkScript(job)}, {job.folder / "job.json", jsonOf(job).dump(1)}});
}

void writeNumber(const Job& job) {
    writeFileAtomically(job.folder / "job.json", jsonOf(job).dump(1));
}

Job readJob(const fs::path& folder) {
    const fs::path file = folder / "job.json";
    const std::string text = readFile(file, largestJob);
    try {
        const nlohmann::json json = nlohmann::json::parse(text);
        Job job{.folder = fs::canonical(folder),
                .engine = json.at("engine"),
                .number = json.at("number"),
                .program = json.at("program").get<std::string>(),
                .workplace = json.at("workplace").get<std::string>(),
                .pattern = json.at("pattern").get<std::string>(),
                .arguments = json.at("arguments"),
                .chunks = {},
                .threads = json.at("threads"),
                .tries = json.at("tries"),
                .rate = json.at("rate")};
        for (const auto& chunk : json.at("chunks"))
            job.chunks.push_back(FrameRange::parse(chunk.get<std::string>()));
        if (!job.chunks.empty()) return job;
    } catch (const nlohmann::json::exception&) {
    } catch (const Error&) {
    }
    throw Error(file.string(), "is not what farm submit writes", "submit the animation again");
}

std::string chunkScript(const Job& job) {
    std::string frames;
    for (const FrameRange chunk : job.chunks) frames += " " + textOf(chunk);
    return fmt::format(R"(#!/bin/bash
# Paints one chunk of {pattern}: bash chunk.sh NUMBER [TRY], the first being 1.
# How it went is noted in state/, what it said in logs/. Frames that are finished stay.
frames=({frames} )
number=$1
try=${{2:-1}}
folder={folder}
note() {{ echo "$*" > "$folder/state/$number.new" && mv "$folder/state/$number.new" "$folder/state/$number"; }}
if ! [ "$number" -ge 1 ] || [ "$number" -gt ${{#frames[@]}} ]; then
    echo "chunk.sh: there is no chunk \"$number\"; choose 1..${{#frames[@]}}" >&2
    exit 2
fi
cd {workplace} || exit 1
note running "$try" 0
{command} \
    --frames="${{frames[number - 1]}}" --threads={threads} --resume >> "$folder/logs/$number.log" 2>&1
status=$?
if [ $status -eq 0 ]; then note done "$try" 0; else note failed "$try" $status; fi
exit $status
)",
                       fmt::arg("pattern", job.pattern.filename().string()), fmt::arg("frames", frames),
                       fmt::arg("folder", quoted(job.folder.string())),
                       fmt::arg("workplace", quoted(job.workplace.string())),
                       fmt::arg("command", commonCommand(job)), fmt::arg("threads", job.threads));
}

std::string commandLine(const Job& job, int chunk) {
    return fmt::format("{} --frames={} --threads={} --resume", commonCommand(job),
                       textOf(job.chunks[std::size_t(chunk) - 1]), job.threads);
}

std::string quoted(const std::string& word) {
    static const std::string plain =
        "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_=+./,:@%";
    if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
    std::string result = "'";
    for (const char letter : word) letter == '\'' ? result += "'\\''" : result += letter;
    return result + "'";
}

std::optional<Note> noteOf(const Job& job, int chunk) {
    std::ifstream stream(noteFile(job, chunk));
    std::string kind;
    Note note{};
    if (!(stream >> kind >> note.tries >> note.status)) return std::nullopt;
    note.kind = kind == "done"     ? Note::Kind::Done
                : kind == "failed" ? Note::Kind::Failed
                                   : Note::Kind::Running;
    return note;
}

}  // namespace chiaro::cli::farm
