#include "app/mesh_export_dialog.h"

#include "app/replace_question.h"
#include "widgets/parameter_form.h"

#include <QtWidgets>

namespace chiaro::app {

namespace {

struct Format {
    const char* extension;
    const char* label;
    const char* note;
    bool hasTexture;
};

// In the order of exporting::MeshFormat.
constexpr Format formats[] = {
    {"glb", QT_TRANSLATE_NOOP("chiaro::app::MeshExportDialog", "GLB (glTF)"),
     QT_TRANSLATE_NOOP("chiaro::app::MeshExportDialog",
                       "One file with mesh and paint, for Blender, game engines and the web."),
     true},
    {"obj", QT_TRANSLATE_NOOP("chiaro::app::MeshExportDialog", "OBJ with a picture"),
     QT_TRANSLATE_NOOP("chiaro::app::MeshExportDialog",
                       "Three files: mesh, material and picture. Every program reads them."),
     true},
    {"ply", QT_TRANSLATE_NOOP("chiaro::app::MeshExportDialog", "PLY with vertex colours"),
     QT_TRANSLATE_NOOP("chiaro::app::MeshExportDialog",
                       "No picture: strokes show only on meshes whose faces are smaller than they are."),
     false}};

/// The format of a path; -1 for one that is not written.
int formatOf(const QString& path) {
    const QString extension = QFileInfo(path).suffix().toLower();
    for (int i = 0; i < int(std::size(formats)); ++i)
        if (extension == formats[i].extension) return i;
    return -1;
}

QString withExtension(const QString& path, const char* extension) {
    const QFileInfo file(path);
    const QString stem = formatOf(path) < 0 ? file.fileName() : file.completeBaseName();
    return file.path() + "/" + stem + "." + extension;
}

}  // namespace

MeshExportDialog::MeshExportDialog(const MeshSettings& suggestion, QWidget* parent)
    : QDialog(parent), m_settings(suggestion) {
    setWindowTitle(tr("Export Mesh"));
    m_format = new QComboBox;
    for (const Format& format : formats) m_format->addItem(tr(format.label));
    m_note = new QLabel;
    m_note->setWordWrap(true);
    m_note->setEnabled(false);
    m_path = new QLineEdit(QString::fromStdString(suggestion.path.string()));
    m_path->setMinimumWidth(320);
    m_path->setAccessibleName(tr("File"));
    auto* browseButton = new QPushButton(tr("Choose…"));
    auto* file = new QHBoxLayout;
    file->addWidget(m_path, 1);
    file->addWidget(browseButton);
    auto* form = new QFormLayout;
    form->addRow(tr("Format"), m_format);
    form->addRow(QString(), m_note);
    form->addRow(tr("File"), file);
    m_texture = makeForm({0, 1, 3});

    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel);
    m_export = buttons->addButton(tr("Export"), QDialogButtonBox::AcceptRole);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(14);
    layout->addLayout(form);
    layout->addWidget(makeForm({2}));
    layout->addWidget(m_texture);
    layout->addStretch(1);
    layout->addWidget(buttons);

    connect(m_format, &QComboBox::activated, this, &MeshExportDialog::setFormat);
    connect(browseButton, &QPushButton::clicked, this, &MeshExportDialog::browse);
    connect(m_path, &QLineEdit::textChanged, this, &MeshExportDialog::showFile);
    connect(buttons, &QDialogButtonBox::accepted, this, &MeshExportDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    showFile();
}

widgets::ParameterForm* MeshExportDialog::makeForm(const std::vector<int>& indices) {
    const auto& table = project::MeshExportParams::table();
    std::vector<ParameterSpec> specs;
    std::vector<double> defaults, values;
    for (const int index : indices) {
        specs.push_back(table.specs()[std::size_t(index)]);
        defaults.push_back(table.values({})[std::size_t(index)]);
        values.push_back(table.values(m_settings.params)[std::size_t(index)]);
    }
    auto* form = new widgets::ParameterForm(specs, defaults);
    form->setValues(values);
    connect(form, &widgets::ParameterForm::valueEdited, this,
            [this, form, indices, &table](int row, double value) {
                std::vector<double> all = table.values(m_settings.params);
                all[std::size_t(indices[std::size_t(row)])] = value;
                table.assign(m_settings.params, all);
                std::vector<double> shown;
                for (const int index : indices) shown.push_back(all[std::size_t(index)]);
                form->setValues(shown);
            });
    return form;
}

MeshSettings MeshExportDialog::settings() const {
    MeshSettings settings = m_settings;
    settings.path = m_path->text().toStdString();
    return settings;
}

void MeshExportDialog::accept() {
    if (mayReplace(*this, exporting::filesOf(settings().path))) QDialog::accept();
}

void MeshExportDialog::browse() {
    const QString path =
        QFileDialog::getSaveFileName(this, windowTitle(), m_path->text(), tr("Meshes (*.glb *.obj *.ply)"),
                                     nullptr, QFileDialog::DontConfirmOverwrite);
    if (path.isEmpty()) return;
    m_path->setText(formatOf(path) < 0 ? withExtension(path, formats[m_format->currentIndex()].extension)
                                       : path);
}

void MeshExportDialog::setFormat(int format) {
    m_path->setText(withExtension(m_path->text(), formats[format].extension));
}

void MeshExportDialog::showFile() {
    const int format = formatOf(m_path->text());
    m_export->setEnabled(format >= 0);
    if (format < 0) return;
    m_format->setCurrentIndex(format);
    m_note->setText(tr(formats[format].note));
    m_texture->setEnabled(formats[format].hasTexture);
}

}  // namespace chiaro::app
