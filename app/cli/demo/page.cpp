#include "app/cli/demo/page.h"

#include "core/base/color.h"

#include <spdlog/fmt/fmt.h>

namespace chiaro::cli::demo {

namespace fs = std::filesystem;

namespace {

std::string escaped(const std::string& text) {
    std::string result;
    for (const char letter : text) switch (letter) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += letter;
        }
    return result;
}

std::string sizeText(std::uintmax_t bytes) {
    if (bytes < 1024) return fmt::format("{} bytes", bytes);
    if (bytes < 1024 * 1024) return fmt::format("{:.0f} kB", double(bytes) / 1024);
    return fmt::format("{:.1f} MB", double(bytes) / (1024 * 1024));
}

const char* className(Width width) {
    switch (width) {
        case Width::Full:
            return "full";
        case Width::Half:
            return "half";
        case Width::Third:
            return "third";
        case Width::Small:
            return "small";
    }
    return "";
}

}  // namespace

void Page::group(const std::string& open, const std::string& close) {
    if (open == m_open) return;
    m_body += m_close + open;
    m_open = open;
    m_close = close;
}

void Page::section(const std::string& title, const std::string& text) {
    group("", "");
    if (m_sections++ > 0) m_body += "</section>\n";
    m_body += fmt::format("<section id=\"part-{0}\">\n<h2>{1}</h2>\n<p>{2}</p>\n", m_sections, escaped(title),
                          escaped(text));
    m_contents += fmt::format("<li><a href=\"#part-{}\">{}</a></li>\n", m_sections, escaped(title));
}

void Page::command(const std::string& line) {
    group("<div class=\"commands\">\n", "</div>\n");
    m_body += fmt::format("<code>{}</code>\n", escaped(line));
}

void Page::figure(const std::string& content, const std::string& caption, Width width) {
    group(fmt::format("<div class=\"plates {}\">\n", className(width)), "</div>\n");
    m_body += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", content, escaped(caption));
    ++m_pictures;
}

void Page::picture(const std::string& file, const std::string& caption, Width width) {
    figure(fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a>", escaped(file), escaped(caption)),
           caption, width);
}

void Page::video(const std::string& file, const std::string& caption, Width width) {
    figure(fmt::format("<video src=\"{}\" autoplay loop muted playsinline controls></video>", escaped(file)),
           caption, width);
}

void Page::strip(const std::string& file, const std::vector<glm::vec3>& gradient,
                 const std::string& caption) {
    constexpr std::size_t stops = 24;
    std::string colors;
    for (std::size_t i = 0; i <= stops && !gradient.empty(); ++i)
        colors += (colors.empty() ? "" : ",") + hexFromColor(gradient[i * (gradient.size() - 1) / stops]);
    figure(fmt::format("<a href=\"{0}\"><img src=\"{0}\" alt=\"{1}\"></a><div class=\"gradient\" "
                       "style=\"background:linear-gradient(to right,{2})\"></div>",
                       escaped(file), escaped(caption), colors),
           caption, Width::Third);
}

void Page::table(const std::vector<std::string>& header, const std::vector<std::vector<std::string>>& rows,
                 const std::string& caption) {
    group("", "");
    m_body +=
        fmt::format("<div class=\"table\"><table>\n<caption>{}</caption>\n<thead><tr>", escaped(caption));
    for (const std::string& cell : header) m_body += fmt::format("<th scope=\"col\">{}</th>", escaped(cell));
    m_body += "</tr></thead>\n<tbody>\n";
    for (const std::vector<std::string>& row : rows) {
        m_body += "<tr>";
        for (std::size_t i = 0; i < row.size(); ++i)
            m_body += i == 0 ? fmt::format("<th scope=\"row\">{}</th>", escaped(row[i]))
                             : fmt::format("<td>{}</td>", escaped(row[i]));
        m_body += "</tr>\n";
    }
    m_body += "</tbody></table></div>\n";
}

void Page::file(const std::string& file, const std::string& what) {
    group("<ul class=\"files\">\n", "</ul>\n");
    std::error_code missing;
    const std::uintmax_t bytes = fs::file_size(m_folder / file, missing);
    const std::string name = escaped(file);
    m_body += fmt::format("<li>{} <span>{}</span> <small>{}</small></li>\n",
                          missing ? name : fmt::format("<a href=\"{0}\">{0}</a>", name), escaped(what),
                          missing ? "not made" : sizeText(bytes));
}

void Page::problem(const std::string& text) {
    group("", "");
    m_body += fmt::format("<p class=\"problem\">This part could not be made: {}</p>\n", escaped(text));
}

std::string Page::html(const std::string& style, const std::string& foot) const {
    return fmt::format(R"(<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
{style}</style>
</head>
<body>
<header>
<h1>{title}</h1>
<p>3D meshes, shaded with an artist's own paint.</p>
<nav><ol>
{contents}</ol></nav>
</header>
<main>
{body}{close}{end}</main>
<footer><p>{foot}</p></footer>
</body>
</html>
)",
                       fmt::arg("title", escaped(m_title)), fmt::arg("style", style),
                       fmt::arg("contents", m_contents), fmt::arg("body", m_body), fmt::arg("close", m_close),
                       fmt::arg("end", m_sections > 0 ? "</section>\n" : ""),
                       fmt::arg("foot", escaped(foot)));
}

}  // namespace chiaro::cli::demo
