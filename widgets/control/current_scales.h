// CurrentScales: what people have said of the current scales of boards that do not tell them, remembered by board and
// port. A board that is met again gets its scale back, and that is told; nothing is ever taken over from another one.
#pragma once

#include "widgets/base/device.h"

#include <QMap>
#include <QString>

namespace widgets {

class CurrentScales : public QObject {
    Q_OBJECT
public:
    /// @param remembered  full-scale currents in A by board, port and motor; outlives this
    CurrentScales(Device &device, QMap<QString, double> &remembered, QObject *parent = nullptr);

    void set(int motor, double fullScaleAmps); ///< the user's word; remembered once it is taken

Q_SIGNALS:
    void told(const QString &sentence);

private:
    void meet();
    void accept(const drive::Ended &ended);
    QString keyOf(int motor) const;

    struct Wished {
        int motor = 0;
        double amps = 0.0;
        QString key;
        bool byPerson = false;
    };
    Device &m_device;
    QMap<QString, double> &m_remembered;
    std::map<drive::WishId, Wished> m_wished;
};

} // namespace widgets
