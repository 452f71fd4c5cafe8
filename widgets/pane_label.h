#pragma once

#include <QFrame>

#include <string>
#include <vector>

class QActionGroup;
class QLabel;
class QToolButton;

namespace chiaro::widgets {

/// A method as an artist chooses it.
struct NamedMethod {
    std::string key;
    QString label;
};

/// Lies in the corner of a picture: names the method that made it, lets another be chosen, and tells figures.
class PaneLabel : public QFrame {
    Q_OBJECT

public:
    /// `name` is the pane's, for screen readers: "First picture".
    PaneLabel(const QString& name, const std::vector<NamedMethod>& methods, QWidget* parent);

    /// `isActive` marks the method whose parameters are edited.
    void setMethod(const std::string& key, bool isActive);
    void setFigures(const QStringList& figures);
    QString text() const;  ///< all that it says, on one line
    /// That the method's name needs.
    int leastWidth() const;
    /// As wide as what it says, at most this; returns its size then.
    QSize fit(int width);

Q_SIGNALS:
    void methodChosen(const QString& key);

private:
    QString m_name;
    QToolButton* m_button = nullptr;
    QActionGroup* m_methods = nullptr;
    QLabel* m_label = nullptr;
    QStringList m_figures;
};

}  // namespace chiaro::widgets
