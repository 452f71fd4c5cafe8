#pragma once

#include <QWidget>

class QListWidget;
class QTextBrowser;

namespace chiaro::app {

/// The pages of resources/help, a list of them beside the one that is read. In the language of the studio
/// where a page is written in it, else in English.
class HelpWindow : public QWidget {
    Q_OBJECT

public:
    /// The names of the pages, "start" first.
    static QStringList pageNames();
    /// The page about what has the focus: its dock's, else "navigation".
    static QString pageOf(const QWidget* focus);

    explicit HelpWindow(QWidget* parent = nullptr);

    /// Shows a page, and the window if it is not there yet.
    void open(const QString& page);
    QString page() const;
    QTextBrowser* browser() const { return m_browser; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void showPage(const QString& page);

    QListWidget* m_contents = nullptr;
    QTextBrowser* m_browser = nullptr;
};

}  // namespace chiaro::app
