#include "app/empty_hint.h"

#include "app/document.h"

#include <QtWidgets>

namespace chiaro::app {

EmptyHint::EmptyHint(Document& document, QWidget* viewport) : QLabel(viewport), m_document(document) {
    setAlignment(Qt::AlignCenter);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setObjectName("empty-hint");
    viewport->installEventFilter(this);
    connect(&document, &Document::changed, this, &EmptyHint::follow);
    follow();
}

bool EmptyHint::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize) follow();
    return QLabel::eventFilter(watched, event);
}

void EmptyHint::follow() {
    const bool needsStrip = m_document.project().samples.empty();
    const bool needsMesh = m_document.project().meshes.empty();
    setText(needsStrip && needsMesh
                ? tr("Drop a strip of paint and a mesh here,\nor open them from the File menu")
            : needsStrip ? tr("Drop a strip of paint here, or open one from the File menu")
                         : tr("Drop a mesh here, or open one from the File menu"));
    adjustSize();
    move(parentWidget()->rect().center() - rect().center());
    // Beside a mesh that has no paint yet the hint moves out of the way.
    if (!needsMesh) move(x(), parentWidget()->height() - height() - 24);
    setVisible(needsStrip || needsMesh);
    raise();
}

}  // namespace chiaro::app
