#include "app/export_dialog.h"

#include "app/replace_question.h"
#include "core/base/image_io.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

QSpinBox* makeSizeField(int value, const QString& name) {
    auto* field = new QSpinBox;
    field->setRange(16, 16384);
    field->setValue(value);
    field->setSuffix(" px");
    field->setAccessibleName(name);
    return field;
}

bool holdsAlpha(const QString& path) {
    const QString extension = QFileInfo(path).suffix().toLower();
    return extension != "jpg" && extension != "jpeg";
}

}  // namespace

ExportDialog::ExportDialog(const PictureSettings& suggestion, QWidget* parent)
    : QDialog(parent), m_suggestion(suggestion) {
    setWindowTitle(tr("Export Picture"));
    m_width = makeSizeField(suggestion.width, tr("Width"));
    m_height = makeSizeField(suggestion.height, tr("Height"));
    m_transparent = new QCheckBox(tr("Transparent background"));
    m_transparent->setChecked(suggestion.transparent);
    m_keepsScale = new QCheckBox(tr("Strokes as large as in the window"));
    m_keepsScale->setChecked(suggestion.keepsScale);
    m_keepsScale->setToolTip(
        tr("On: the picture looks as the viewport does, at any size.\n"
           "Off: strokes are as many pixels wide as in the strip."));
    m_path = new QLineEdit(QString::fromStdString(suggestion.path.string()));
    m_path->setMinimumWidth(320);
    m_path->setAccessibleName(tr("File"));
    auto* browseButton = new QPushButton(tr("Choose…"));

    auto* size = new QHBoxLayout;
    size->addWidget(m_width);
    size->addWidget(new QLabel("×"));
    size->addWidget(m_height);
    size->addStretch(1);
    auto* file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(browseButton);
    auto* form = new QFormLayout;
    form->addRow(tr("Size"), size);
    form->addRow(tr("File"), file);
    form->addRow(QString(), m_transparent);
    form->addRow(QString(), m_keepsScale);

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(14);
    layout->addLayout(form);
    layout->addWidget(buttons);

    connect(browseButton, &QPushButton::clicked, this, &ExportDialog::browse);
    connect(m_path, &QLineEdit::textChanged, this, &ExportDialog::showFile);
    connect(buttons, &QDialogButtonBox::accepted, this, &ExportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showFile();
}

PictureSettings ExportDialog::settings() const {
    PictureSettings settings = m_suggestion;
    settings.path = m_path->text().toStdString();
    settings.width = m_width->value();
    settings.height = m_height->value();
    settings.transparent = m_transparent->isChecked() && m_transparent->isEnabled();
    settings.keepsScale = m_keepsScale->isChecked();
    return settings;
}

void ExportDialog::accept() {
    if (mayReplace(*this, {settings().path})) QDialog::accept();
}

void ExportDialog::browse() {
    const QString path =
        QFileDialog::getSaveFileName(this, tr("Export Picture"), m_path->text(),
                                     tr("Pictures (*.png *.tif *.tiff *.jpg *.jpeg *.webp *.exr)"), nullptr,
                                     QFileDialog::DontConfirmOverwrite);
    if (!path.isEmpty()) m_path->setText(path);
}

void ExportDialog::showFile() {
    m_transparent->setEnabled(holdsAlpha(m_path->text()));
    m_export->setEnabled(isWritableImage(m_path->text().toStdString()));
}

}  // namespace chiaro::app
