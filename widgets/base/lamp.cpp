#include "widgets/base/lamp.h"

#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"

#include <QHBoxLayout>
#include <QPainter>

namespace widgets {

class Lamp::Dot : public QWidget {
public:
    explicit Dot(Lamp *lamp)
        : QWidget(lamp)
        , m_lamp(lamp)
    {
        setFixedSize(12, 12);
    }

protected:
    void paintEvent(QPaintEvent *) override
    {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QColor color = colorOf(m_lamp->light(), palette());
        const QRectF circle = QRectF(rect()).adjusted(1.5, 1.5, -1.5, -1.5);
        painter.setPen(QPen(color, 1.6));
        switch (m_lamp->light()) {
        case Light::Off:
            painter.drawEllipse(circle);
            break;
        case Light::On:
            painter.setBrush(color);
            painter.drawEllipse(circle);
            break;
        case Light::Waiting:
            painter.drawEllipse(circle);
            painter.setBrush(color);
            painter.drawPie(circle, 90 * 16, 180 * 16);
            break;
        case Light::Bad:
            painter.setPen(QPen(color, 2.2));
            painter.drawLine(circle.topLeft(), circle.bottomRight());
            painter.drawLine(circle.topRight(), circle.bottomLeft());
            break;
        }
    }

private:
    Lamp *m_lamp;
};

Lamp::Lamp(const QString &name, QWidget *parent)
    : QWidget(parent)
    , m_dot(new Dot(this))
    , m_text(new SteadyLabel(this))
    , m_name(name)
{
    auto *layout = bare(new QHBoxLayout(this), kHalfGrid);
    layout->addWidget(m_dot);
    layout->addWidget(m_text);
    setAccessibleName(name);
}

void Lamp::show(Light light, const QString &text)
{
    m_light = light;
    m_text->setText(text);
    setAccessibleName(m_name + QStringLiteral(": ") + text);
    m_dot->update();
}

void Lamp::setRoomFor(const QStringList &texts) { m_text->setRoomFor(texts); }

QString Lamp::text() const { return m_text->text(); }

QColor Lamp::colorOf(Light light, const QPalette &palette)
{
    const bool dark = palette.color(QPalette::Window).lightness() < 128;
    switch (light) {
    case Light::Off:
        break;
    case Light::On:
        return dark ? QColor(0x35, 0xc9, 0xa0) : QColor(0x00, 0x80, 0x60);
    case Light::Waiting:
        return dark ? QColor(0xf0, 0xb4, 0x3c) : QColor(0x9a, 0x62, 0x00);
    case Light::Bad:
        return dark ? QColor(0xff, 0x7b, 0x6b) : QColor(0xb7, 0x1c, 0x1c);
    }
    return palette.color(QPalette::Disabled, QPalette::WindowText);
}

Lamp::Light Lamp::lightOf(drive::LinkState state)
{
    using drive::LinkState;
    return state == LinkState::Connected ? Light::On
        : state == LinkState::Lost       ? Light::Bad
        : state == LinkState::Closed     ? Light::Off
                                         : Light::Waiting;
}

} // namespace widgets
