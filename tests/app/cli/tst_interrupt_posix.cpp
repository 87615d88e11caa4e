// A program that is asked to end and stays, because the user wants it to, hears the next signal as well.
#include "app/cli/interrupt.h"

#include <QSignalSpy>
#include <QtTest>

#include <csignal>

class TestInterrupt : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachSignalIsHeardAndTheFirstCounts()
    {
        const cli::Interrupt interrupt;
        QSignalSpy raised(&interrupt, &cli::Interrupt::raised);
        QCOMPARE(interrupt.number(), 0);
        int heard = 0;
        for (const int signal : {SIGTERM, SIGINT, SIGTERM}) {
            std::raise(signal);
            ++heard;
            QTRY_COMPARE(raised.size(), heard);
            QCOMPARE(interrupt.number(), SIGTERM);
        }
    }
};

QTEST_GUILESS_MAIN(TestInterrupt)
#include "tst_interrupt_posix.moc"
