#include "app/animation_dialog.h"

#include "app/replace_question.h"
#include "core/export/video.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

QSpinBox* sizeField(const char* key, int value, const QString& name) {
    auto* field = new QSpinBox;
    field->setObjectName(key);
    field->setRange(16, 16384);
    field->setValue(value);
    field->setSuffix(" px");
    field->setAccessibleName(name);
    return field;
}

}  // namespace

AnimationDialog::AnimationDialog(const project::Animation& animation, const AnimationSettings& suggestion,
                                 QWidget* parent)
    : QDialog(parent), m_animation(animation), m_suggestion(suggestion) {
    setWindowTitle(tr("Render Animation"));
    auto* frames = new QLabel(
        tr("%1 to %2, %3 a second").arg(animation.firstFrame).arg(animation.lastFrame).arg(animation.rate));
    frames->setToolTip(tr("Set in the Timeline dock"));
    m_width = sizeField("width", suggestion.width, tr("Width"));
    m_height = sizeField("height", suggestion.height, tr("Height"));
    m_transparent = new QCheckBox(tr("Transparent background"));
    m_transparent->setChecked(suggestion.transparent);
    m_withValues = new QCheckBox(tr("Also light, ids, depth, normals, motion and texture"));
    m_withValues->setObjectName("values");
    m_withValues->setToolTip(
        tr("As OpenEXR pictures, ids as PNG, in a folder beside the frames, for compositing"));
    m_withValues->setChecked(suggestion.withValues);
    m_resume = new QCheckBox(tr("Keep frames that are finished"));
    m_resume->setObjectName("resume");
    m_resume->setToolTip(
        tr("Goes on after an interruption: frames that are there already, whole and of just these settings,\n"
           "are not made again. All others are replaced."));
    m_resume->setChecked(suggestion.resume);
    m_path = new QLineEdit(QString::fromStdString(suggestion.output.string()));
    m_path->setObjectName("output");
    m_path->setMinimumWidth(340);
    m_path->setAccessibleName(tr("Files"));
    m_path->setToolTip(
        tr("Pictures: name.####.png, where #### becomes the frame's number. A video: .mp4, .webm, "
           "or .mkv, which loses nothing."));
    m_problem = new QLabel;
    m_problem->setObjectName("problem");
    m_problem->setProperty("note", true);
    m_problem->setWordWrap(true);
    auto* choose = new QPushButton(tr("Choose…"));
    auto* size = new QHBoxLayout;
    size->addWidget(m_width);
    size->addWidget(new QLabel("×"));
    size->addWidget(m_height);
    size->addStretch(1);
    auto* file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(choose);
    auto* form = new QFormLayout;
    form->addRow(tr("Frames"), frames);
    form->addRow(tr("Size"), size);
    form->addRow(tr("Files"), file);
    form->addRow(QString(), m_problem);
    form->addRow(QString(), m_transparent);
    form->addRow(QString(), m_withValues);
    form->addRow(QString(), m_resume);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_render = buttons->addButton(tr("Render"), QDialogButtonBox::AcceptRole);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(14);
    layout->addLayout(form);
    layout->addWidget(buttons);
    connect(choose, &QPushButton::clicked, this, &AnimationDialog::browse);
    connect(m_path, &QLineEdit::textChanged, this, &AnimationDialog::showOutput);
    connect(buttons, &QDialogButtonBox::accepted, this, &AnimationDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showOutput();
}

AnimationSettings AnimationDialog::settings() const {
    AnimationSettings settings = m_suggestion;
    settings.output = m_path->text().toStdString();
    settings.width = m_width->value();
    settings.height = m_height->value();
    settings.transparent = m_transparent->isChecked() && m_transparent->isEnabled();
    settings.withValues = m_withValues->isChecked() && m_withValues->isEnabled();
    settings.resume = m_resume->isChecked() && m_resume->isEnabled();
    return settings;
}

void AnimationDialog::accept() {
    if (settings().resume || mayReplace(*this, outputOf(m_animation, settings()).files())) QDialog::accept();
}

void AnimationDialog::browse() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Render Animation"), m_path->text(),
                                     tr("Pictures (*.png *.tif *.exr);;Videos (*.mp4 *.webm *.mkv)"), nullptr,
                                     QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty()) return;
    const QFileInfo file(path);
    const bool needsNumber = !path.contains('#') && !exporting::isWritableVideo(path.toStdString());
    m_path->setText(needsNumber ? file.path() + "/" + file.completeBaseName() + ".####." + file.suffix()
                                : path);
}

void AnimationDialog::showOutput() {
    const std::filesystem::path output = m_path->text().toStdString();
    QString problem;
    try {
        project::checkAnimationPath(output);
    } catch (const std::exception& error) {
        problem = QString::fromStdString(error.what());
    }
    m_problem->setText(problem);
    m_problem->setVisible(!problem.isEmpty());
    m_render->setEnabled(problem.isEmpty());
    for (QCheckBox* ofPictures : {m_transparent, m_withValues, m_resume})
        ofPictures->setEnabled(!exporting::isWritableVideo(output));
}

}  // namespace chiaro::app
