#include "app/scene_model.h"

#include "app/document.h"
#include "widgets/tool_button.h"

#include <QtWidgets>

namespace chiaro::app {

SceneModel::SceneModel(Document& document, QObject* parent)
    : QAbstractTableModel(parent), m_document(document) {
    connect(&document, &Document::changed, this, &SceneModel::applyChange);
    applyChange({});
}

int SceneModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_objects + m_lights;
}

int SceneModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : ColumnCount;
}

QString SceneModel::name(int row) const {
    const project::Project& project = m_document.project();
    if (!isLight(row)) return QString::fromStdString(project.objects[std::size_t(objectAt(row))].name);
    const std::string& name = project.lights[std::size_t(lightAt(row))].name;
    if (!name.empty()) return QString::fromStdString(name);
    return m_lights == 1 ? tr("Light") : tr("Light %1").arg(lightAt(row) + 1);
}

bool SceneModel::isVisible(int row) const {
    const project::Project& project = m_document.project();
    return isLight(row) ? project.lights[std::size_t(lightAt(row))].visible
                        : project.objects[std::size_t(objectAt(row))].visible;
}

bool SceneModel::isThere(int row) const {
    const project::Project& project = m_document.project();
    return isLight(row) ? lightAt(row) < int(project.lights.size())
                        : objectAt(row) < int(project.objects.size());
}

QVariant SceneModel::data(const QModelIndex& index, int role) const {
    // Amid a change the document may have fewer already than the views know of.
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || !isThere(index.row())) return {};
    const int row = index.row();
    if (index.column() == Eye) {
        if (role == Qt::DecorationRole) return widgets::icon(isVisible(row) ? "eye" : "eye-off");
        if (role == Qt::ToolTipRole) return isVisible(row) ? tr("Hide (H)") : tr("Show (H)");
        if (role == Qt::AccessibleTextRole) return isVisible(row) ? tr("shown") : tr("hidden");
        return {};
    }
    switch (role) {
        case Qt::DisplayRole:
        case Qt::EditRole:
            return name(row);
        case Qt::ToolTipRole:
            return isLight(row) ? tr("A light; F2 renames it") : tr("An object; F2 renames it");
        case Qt::DecorationRole: {
            if (!isLight(row)) return widgets::icon("mesh");
            const scene::Light& light = m_document.project().lights[std::size_t(lightAt(row))];
            return widgets::icon(light.kind == scene::Light::Kind::Point ? "light-point" : "light-sun");
        }
        case Qt::ForegroundRole:
            if (isVisible(row)) return {};
            return QApplication::palette().brush(QPalette::Disabled, QPalette::Text);
        default:
            return {};
    }
}

bool SceneModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || role != Qt::EditRole || index.column() != Name)
        return false;
    const QString name = value.toString().simplified();
    if (name.isEmpty()) return false;
    if (name != this->name(index.row())) rename(index.row(), name);
    return true;
}

void SceneModel::rename(int row, const QString& name) {
    m_document.finishEdit();
    if (isLight(row)) {
        std::vector<scene::Light> lights = m_document.project().lights;
        lights[std::size_t(lightAt(row))].name = name.toStdString();
        m_document.editLights(lights, tr("Rename Light"));
    } else {
        std::vector<project::ObjectSettings> objects = m_document.project().objects;
        objects[std::size_t(objectAt(row))].name = name.toStdString();
        m_document.editObjects(std::move(objects), tr("Rename Object"));
    }
    m_document.finishEdit();
}

void SceneModel::setVisible(const std::vector<int>& rows, bool visible) {
    std::vector<project::ObjectSettings> objects = m_document.project().objects;
    std::vector<scene::Light> lights = m_document.project().lights;
    for (const int row : rows)
        (isLight(row) ? lights[std::size_t(lightAt(row))].visible
                      : objects[std::size_t(objectAt(row))].visible) = visible;
    const QString text = visible ? tr("Show") : tr("Hide");
    m_document.finishEdit();
    QUndoStack& undo = m_document.undoStack();
    const bool isMixed = objects != m_document.project().objects && lights != m_document.project().lights;
    if (isMixed) undo.beginMacro(text);
    m_document.editObjects(std::move(objects), text);
    m_document.editLights(lights, text);
    if (isMixed) undo.endMacro();
    m_document.finishEdit();
}

Qt::ItemFlags SceneModel::flags(const QModelIndex& index) const {
    if (!index.isValid()) return QAbstractTableModel::flags(index);
    const Qt::ItemFlags flags = QAbstractTableModel::flags(index) | Qt::ItemNeverHasChildren;
    return index.column() == Name ? flags | Qt::ItemIsEditable : flags;
}

void SceneModel::applyChange(Change change) {
    using Kind = Change::Kind;
    const bool concerns = change.kind == Kind::Everything || change.kind == Kind::Objects ||
                          change.kind == Kind::Samples || change.kind == Kind::Mesh ||
                          change.kind == Kind::Lights;
    if (!concerns) return;
    const int objects = int(m_document.project().objects.size());
    const int lights = int(m_document.project().lights.size());
    if (change.kind != Kind::Everything && objects == m_objects && lights == m_lights) {
        if (rowCount() > 0) Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
        return;
    }
    beginResetModel();
    m_objects = objects;
    m_lights = lights;
    endResetModel();
}

}  // namespace chiaro::app
