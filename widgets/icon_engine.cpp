#include "widgets/icon_engine.h"

#include <QtSvg>
#include <QtWidgets>

namespace chiaro::widgets {

namespace {

constexpr double disabledOpacity = 0.3;

IconColors& chosenColors() {
    static IconColors colors{QColor(0xd4, 0xd4, 0xd4), QColor(0xd8, 0xb2, 0x7a), QColor(0xf0, 0xa0, 0x8c)};
    return colors;
}

class IconEngine : public QIconEngine {
public:
    explicit IconEngine(QString path) : m_path(std::move(path)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        painter->save();
        if (mode == QIcon::Disabled) painter->setOpacity(painter->opacity() * disabledOpacity);
        QSvgRenderer(inked()).render(painter, rect);
        painter->restore();
    }
    /// `size` is in the pixels of the screen.
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        const QString key = QString("%1 %2x%3 %4 %5")
                                .arg(m_path)
                                .arg(size.width())
                                .arg(size.height())
                                .arg(int(mode == QIcon::Disabled))
                                .arg(iconColors().plain.name());
        QPixmap pixmap;
        if (QPixmapCache::find(key, &pixmap)) return pixmap;
        pixmap = QPixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        painter.end();
        QPixmapCache::insert(key, pixmap);
        return pixmap;
    }
    QIconEngine* clone() const override { return new IconEngine(*this); }

private:
    QByteArray inked() const {
        QFile file(m_path);
        if (!file.open(QIODevice::ReadOnly)) return {};
        QByteArray drawing = file.readAll();
        drawing.replace("#d4d4d4", iconColors().plain.name().toLatin1());
        drawing.replace("#d8b27a", iconColors().note.name().toLatin1());
        drawing.replace("#f0a08c", iconColors().error.name().toLatin1());
        return drawing;
    }

    QString m_path;
};

}  // namespace

void setIconColors(const IconColors& colors) {
    chosenColors() = colors;
}

const IconColors& iconColors() {
    return chosenColors();
}

QIcon themedIcon(const QString& path) {
    return QIcon(new IconEngine(path));
}

}  // namespace chiaro::widgets
