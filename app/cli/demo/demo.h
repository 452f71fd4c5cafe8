#pragma once

#include "app/cli/demo/page.h"
#include "app/cli/demo/studio_set.h"
#include "app/cli/session.h"

namespace chiaro::cli::demo {

/// Makes the built-in scene through every command and hangs what comes out on a page. A part that fails is
/// said there and leaves the others be.
class Demo {
public:
    Demo(std::filesystem::path folder, Session& session);

    /// Throws Cancelled, and Error when a part failed, once everything else is made.
    void run();

private:
    using Words = std::vector<std::string>;
    struct Part {
        const char* title;
        const char* text;
        double share;  ///< of the time, against the other parts'
        void (Demo::*make)();
    };
    static std::vector<Part> parts();

    /// Runs `chiaro` with these words in the folder and hangs the line on the page; what --json tells. Throws
    /// Error, Cancelled.
    nlohmann::json chiaro(Words words);
    /// Writes a picture that no command makes.
    void write(const std::string& file, const ColorImage& picture, const std::string& what) const;
    /// A file of the demo's own as the commands are given it.
    std::string input(const std::string& relative) const;
    /// A mesh, a strip, how large, and what lies behind.
    Words scene(const std::string& size) const;
    void makePart(const Part& part, const Task& task);
    void animate(const std::string& file, const std::string& caption, const Words& how);

    void makeScene();
    void makeStrips();
    void makeSeparation();
    void makeLevels();
    void makeMethods();
    void makeAnimations();
    void makeEverything();
    void makeViews();
    void makeMeasures();
    void makeStudy();
    void makeComparison();
    void makeExports();

    std::filesystem::path m_folder;
    Session& m_session;
    StudioSet m_set;
    Page m_page;
    Task m_task;  ///< of the part that is made
    std::vector<std::string> m_problems;
};

}  // namespace chiaro::cli::demo
