#include "widgets/viewport/picture_view.h"

#include "widgets/viewport/cpu_view.h"
#include "widgets/viewport/gl_view.h"

#include <QVBoxLayout>

namespace chiaro::widgets {

PictureView::PictureView(ViewState& state, QWidget* parent) : QWidget(parent), m_state(state) {
    setAttribute(Qt::WA_TransparentForMouseEvents);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    if (openGlSupport().usable) makeGlView();
}

PictureView::~PictureView() {
    // They read the state, so they go while it is there.
    delete m_glView;
    delete m_cpuView;
}

void PictureView::makeGlView() {
    m_glView = new GlView(m_state, this);
    layout()->addWidget(m_glView);
    connect(m_glView, &GlView::frameDrawn, this, &PictureView::frameDrawn);
    connect(m_glView, &GlView::failed, this, [this] {
        m_glView->deleteLater();
        m_glView = nullptr;
        refresh();
    });
}

void PictureView::makeCpuView() {
    m_cpuView = new CpuView(m_state, this);
    m_cpuView->hide();
    layout()->addWidget(m_cpuView);
    connect(m_cpuView, &CpuView::frameDrawn, this, &PictureView::frameDrawn);
}

bool PictureView::usesOpenGl() const {
    return m_glView && m_state.scene().occlusion.isOff();
}

QString PictureView::note() const {
    if (usesOpenGl()) return {};
    return m_glView ? tr("Shadows: these are the CPU renderer's pictures.")
                    : tr("No OpenGL here: these are the CPU renderer's pictures.");
}

void PictureView::refresh() {
    const bool byCpu = !usesOpenGl();
    if (byCpu && !m_cpuView) makeCpuView();
    if (m_cpuView && m_cpuView->isHidden() == byCpu) {
        if (m_glView) m_glView->setVisible(!byCpu);
        m_cpuView->setVisible(byCpu);
        layout()->activate();  // who asks for the picture now gets one of the whole size
        Q_EMIT rendererChanged();
    }
    if (byCpu)
        m_cpuView->refresh();
    else
        m_glView->update();
}

void PictureView::recompose() {
    if (usesOpenGl())
        m_glView->update();
    else
        m_cpuView->recompose();
}

void PictureView::fadeTexture() {
    if (m_glView) m_glView->fadeTexture();
}

QImage PictureView::picture() {
    return usesOpenGl() ? m_glView->picture() : m_cpuView->picture();
}

const std::vector<double>& PictureView::methodTimes() const {
    return usesOpenGl() ? m_glView->methodTimes() : m_cpuView->methodTimes();
}

}  // namespace chiaro::widgets
