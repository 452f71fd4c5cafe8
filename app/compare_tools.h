#pragma once

#include "app/change.h"
#include "widgets/viewport/composition.h"

#include <QObject>

#include <array>
#include <functional>

class QAction;
class QActionGroup;
class QMenu;
class QToolBar;

namespace chiaro::widgets {
class CompareBar;
class CompareView;
class Viewport;
}  // namespace chiaro::widgets

namespace chiaro::app {

class Document;
class ViewMeasures;

/// Comparing methods in the viewport: side by side, by a wipe, a blend or their difference. Which methods and
/// how is the artist's choice for this and later sessions, and no edit of the document. When the document's
/// own method becomes one that is not seen, it takes the first place.
class CompareTools : public QObject {
    Q_OBJECT

public:
    using Mode = widgets::Composition::Mode;

    CompareTools(Document& document, widgets::Viewport& viewport, ViewMeasures& measures, QObject* parent);

    /// What the viewport shows.
    const widgets::Composition& composition() const { return m_composition; }
    void setMode(Mode mode);
    /// Puts a method in the place of one that is seen; where it is seen already the two change places.
    void setMethod(int picture, const std::string& key);
    void setPaneCount(int count);
    widgets::CompareView& view() { return *m_view; }
    /// "Image-based / View-aligned"; empty while nothing is compared.
    QString shownLabel() const;

    /// As a submenu.
    void addTo(QMenu& menu);
    /// The modes as buttons that the keyboard reaches, and the numbers of the one that is on.
    void addTo(QToolBar& bar);

private:
    void makeModes();
    void makeSteps();
    QAction* addStep(const char* name, const QString& text, const QKeySequence& keys, const QString& tooltip,
                     std::function<widgets::Composition(widgets::Composition)> step);
    void addMethods(QMenu& menu);
    void restore();
    void keep() const;
    void applyChange(Change change);
    void keepDocumentsMethod();
    void edit(const widgets::Composition& composition);
    void show();
    void showFigures();

    Document& m_document;
    widgets::Viewport& m_viewport;
    ViewMeasures& m_measures;
    widgets::Composition m_composition;                                  ///< as shown
    std::array<std::string, widgets::Composition::mostPanes> m_methods;  ///< by their place, none twice
    int m_paneCount = 2;
    std::string m_documentsMethod;  ///< as met last
    widgets::CompareView* m_view = nullptr;
    widgets::CompareBar* m_bar = nullptr;
    QActionGroup* m_modes = nullptr;
    std::vector<QActionGroup*> m_choices;  ///< of the methods, one a place
    std::vector<QAction*> m_steps;
    QAction* m_swap = nullptr;
};

}  // namespace chiaro::app
