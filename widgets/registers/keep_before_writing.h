// KeepBeforeWriting: what keeps a board's values before a list of registers is written (AutoSnapshots in the program).
#pragma once

#include <QObject>

namespace widgets {

class KeepBeforeWriting : public QObject {
    Q_OBJECT
public:
    using QObject::QObject;

    virtual void take() = 0; ///< taken() or broken() follows; nothing while one is under way

Q_SIGNALS:
    void taken(); ///< it is in memory: writing may begin
    void broken(const QString &sentence); ///< the board could not be read
    void told(const QString &sentence); ///< something is missing that does not stop a write
};

} // namespace widgets
