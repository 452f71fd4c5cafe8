#pragma once

#include "app/change.h"

#include <QObject>

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;

namespace chiaro::app {

class Document;

/// The methods as actions of which one is checked, on the keys 1, 2, ... in the order of
/// project::renderMethods(). Choosing one is an edit of the document.
class MethodSwitch : public QObject {
    Q_OBJECT

public:
    explicit MethodSwitch(Document& document, QObject* parent = nullptr);

    void addTo(QMenu& menu) const;
    /// As buttons that the keyboard reaches.
    void addTo(QToolBar& bar) const;
    /// "Image-based"; of the document's method.
    QString shownLabel() const;

private:
    void applyChange(Change change);

    Document& m_document;
    QActionGroup* m_actions;  ///< each with its method's key as data
};

}  // namespace chiaro::app
