#pragma once

#include "app/change.h"

#include <QAbstractTableModel>

namespace chiaro::app {

class Document;

/// The scene as a list: its objects, then its lights. Two columns: the name, which can be edited, with an
/// icon of what it is; and an eye, checked where it is shown.
class SceneModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Eye, ColumnCount };

    explicit SceneModel(Document& document, QObject* parent = nullptr);

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role = Qt::DisplayRole) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role = Qt::EditRole) override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;

    int objectCount() const { return m_objects; }
    int lightCount() const { return m_lights; }
    bool isLight(int row) const { return row >= m_objects; }
    /// Of a row of its kind: the index in the project's objects or lights.
    int objectAt(int row) const { return row; }
    int lightAt(int row) const { return row - m_objects; }
    int rowOfLight(int light) const { return m_objects + light; }
    /// What the artist reads: lights without a name are numbered.
    QString name(int row) const;
    /// Shows or hides several rows in one step.
    void setVisible(const std::vector<int>& rows, bool visible);
    bool isVisible(int row) const;

private:
    void applyChange(Change change);
    /// False for what the document has no more though the views were not told yet.
    bool isThere(int row) const;
    void rename(int row, const QString& name);

    Document& m_document;
    int m_objects = 0;  ///< as the views know them
    int m_lights = 0;
};

}  // namespace chiaro::app
