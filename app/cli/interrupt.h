// Interrupt: Ctrl-C and the signals that ask a program to end, as an event in the event loop instead of a sudden end.
// Up to four at once, each in its own thread.
#pragma once

#include <QObject>

#include <array>

namespace cli {

class Interrupt : public QObject {
    Q_OBJECT
public:
    explicit Interrupt(QObject *parent = nullptr);
    ~Interrupt() override;

    /// A sentence for the help: what Ctrl-C does on this system.
    static const char *help();

    /// The first signal that came; 0: none yet.
    int number() const { return m_number; }

Q_SIGNALS:
    void raised(); ///< at each of them

private:
    void raise(int number);

    int m_number = 0;
    std::array<int, 2> m_pipe{-1, -1}; ///< where there are signals
};

} // namespace cli
