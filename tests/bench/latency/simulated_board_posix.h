// rotorscope-sim as a process of its own, from its start to the end of this object. POSIX only.
//
// A real board and a real line do not wait for the scheduler of a PC. Late, the simulated one finds a header and its
// payload in one read, and loses the payload as firmware does when the pause between them is missing: so it runs at
// real-time priority where that is allowed.
#pragma once

#include "bench/latency/tapped_line_posix.h"

#include <QProcess>
#include <QTemporaryDir>

namespace bench {

class SimulatedBoard {
public:
    SimulatedBoard()
    {
        m_process.start(QStringLiteral(ROTORSCOPE_BIN "/rotorscope-sim"),
            {QStringLiteral("mcp"), QStringLiteral("--link"), port()});
        m_started = m_process.waitForReadyRead(kPatience_ms);
        m_realTime = makeRealTime(static_cast<pid_t>(m_process.processId()));
    }
    SimulatedBoard(const SimulatedBoard &) = delete;
    SimulatedBoard &operator=(const SimulatedBoard &) = delete;
    ~SimulatedBoard()
    {
        m_process.terminate();
        m_process.waitForFinished(kPatience_ms);
    }

    bool started() const { return m_started; }
    bool realTime() const { return m_realTime; }
    QString port() const { return m_folder.filePath(QStringLiteral("board")); }

private:
    static constexpr int kPatience_ms = 10'000;
    QTemporaryDir m_folder;
    QProcess m_process;
    bool m_started = false, m_realTime = false;
};

} // namespace bench
