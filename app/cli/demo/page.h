#pragma once

#include <glm/glm.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace chiaro::cli::demo {

/// How wide a plate hangs on the page; plates of one width that follow each other share a row.
enum class Width { Full, Half, Third, Small };

/// A page of pictures that lie in its folder: HTML that needs nothing but them. Texts are plain; what has a
/// meaning in HTML is escaped.
class Page {
public:
    Page(std::filesystem::path folder, std::string title)
        : m_folder(std::move(folder)), m_title(std::move(title)) {}

    void section(const std::string& title, const std::string& text);
    /// The command line that made what follows.
    void command(const std::string& line);
    /// `file` is relative to the folder.
    void picture(const std::string& file, const std::string& caption, Width width);
    void video(const std::string& file, const std::string& caption, Width width);
    /// A strip with its gradient below it; colours display-referred.
    void strip(const std::string& file, const std::vector<glm::vec3>& gradient, const std::string& caption);
    void table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
               const std::string& caption);
    /// A file to open or take along, with its size.
    void file(const std::string& file, const std::string& what);
    /// What couldn't be made.
    void problem(const std::string& text);

    int pictures() const { return m_pictures; }
    std::string html(const std::string& style, const std::string& foot) const;

private:
    void figure(const std::string& content, const std::string& caption, Width width);
    /// Ends a row of plates or a list, and begins another when `group` is not empty.
    void group(const std::string& open, const std::string& close);

    std::filesystem::path m_folder;
    std::string m_title;
    std::string m_contents;  ///< the links to the sections
    std::string m_body;
    std::string m_open, m_close;  ///< of the row or list that is open
    int m_sections = 0;
    int m_pictures = 0;
};

}  // namespace chiaro::cli::demo
