#pragma once

#include "app/change.h"
#include "app/docks/dock.h"

class QListWidget;
class QListWidgetItem;
class QToolButton;

namespace chiaro::widgets {
class SampleView;
class StripView;
}  // namespace chiaro::widgets

namespace chiaro::app {

class Document;
class Paints;

/// The document's samples, and the selected one's scan, crop and strip. It says which sample is selected;
/// others follow.
class SampleDock : public Dock {
    Q_OBJECT

public:
    SampleDock(Document& document, Paints& paints);

    /// -1 while the document has none.
    int currentSample() const { return m_current; }
    void selectSample(int sample);
    widgets::SampleView* sampleView() const { return m_sampleView; }

Q_SIGNALS:
    void currentSampleChanged(int sample);
    void addWanted();

private:
    QWidget* makeList();
    void applyChange(Change change);
    void showList();
    void showScan(int sample);
    void showStrip(int sample);
    void showRecoloring(int sample);
    void showCurrent();
    void showSwatch(int sample);
    void rename(QListWidgetItem* item);

    Document& m_document;
    Paints& m_paints;
    QListWidget* m_list = nullptr;
    QToolButton* m_wear = nullptr;
    QToolButton* m_remove = nullptr;
    widgets::SampleView* m_sampleView = nullptr;
    widgets::StripView* m_stripView = nullptr;
    int m_current = -1;
};

}  // namespace chiaro::app
