#pragma once

#include <QLabel>

namespace chiaro::app {

class Document;

/// Says over an empty viewport what to begin with.
class EmptyHint : public QLabel {
    Q_OBJECT

public:
    /// Lies over `viewport` and lets the pointer through.
    EmptyHint(Document& document, QWidget* viewport);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();

    Document& m_document;
};

}  // namespace chiaro::app
