// The traces of math channels: draws the channels that are to be shown, each in the plot where it was last.
#pragma once

#include "widgets/measuring/math_channels.h"

#include <QColor>
#include <QMap>

namespace widgets {

class ScopeView;

class MathTraces : public QObject {
    Q_OBJECT
public:
    /// All outlive it.
    MathTraces(MathChannels &channels, const capture::Capture &capture, ScopeView &scope,
        QObject *parent = nullptr);

    /// Not valid: not drawn.
    static QColor colorOf(const ScopeView &scope, capture::ChannelId channel);

private:
    struct Place {
        int plot = -1; ///< where it was last; -1: nowhere yet
        QString unit;
    };
    void made(const QString &name, quint32 before);
    void follow();
    void remember();
    void takenOff(quint32 channel);
    void show(const MathChannels::Entry &entry);

    MathChannels &m_channels;
    const capture::Capture &m_capture;
    ScopeView &m_scope;
    QMap<QString, Place> m_places; ///< by name
};

} // namespace widgets
