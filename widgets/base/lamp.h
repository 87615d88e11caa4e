// Lamp: one state as shape, colour and words, so that colours need not be told apart.
#pragma once

#include "drive/event.h"

#include <QWidget>

namespace widgets {

class SteadyLabel;

class Lamp : public QWidget {
    Q_OBJECT
public:
    enum class Light : std::uint8_t {
        Off, ///< hollow circle
        On, ///< filled circle, green
        Waiting, ///< half circle, amber
        Bad, ///< cross, red
    };

    explicit Lamp(const QString &name, QWidget *parent = nullptr);

    void show(Light light, const QString &text);
    void setRoomFor(const QStringList &texts); ///< what it may have to say: it keeps its width
    Light light() const { return m_light; }
    QString text() const;

    static QColor colorOf(Light light, const QPalette &palette);
    static Light lightOf(drive::LinkState state);

private:
    class Dot;
    Dot *m_dot;
    SteadyLabel *m_text;
    QString m_name;
    Light m_light = Light::Off;
};

} // namespace widgets
