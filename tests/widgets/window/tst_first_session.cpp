// The first session of a user, through the real window, the real session thread and the simulated board: connect,
// arm, start, drag two signals, see samples move, change the speed, stop, export, compare the file with the capture.
#include "support/window_rig.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/control/panel.h"
#include "widgets/control/readout_box.h"
#include "widgets/control/stop_words.h"
#include "widgets/registers/panel.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/scope/view.h"
#include "widgets/window/connect_bar.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QSortFilterProxyModel>
#include <QTemporaryDir>
#include <QToolButton>

#include <cmath>

using drive::MotorState;

class TestFirstSession : public QObject {
    /// Of a screen of 720 lines, under a title bar.
    Q_OBJECT static constexpr int kHeight = 700;

private Q_SLOTS:
    void initTestCase()
    {
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->sayYesToMotion();
        m_rig->window.resize(1280, kHeight);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
    }
    void cleanupTestCase() { m_rig.reset(); }

    void oneClickConnectsToTheSimulatedBoard()
    {
        QCOMPARE(m_rig->find<QComboBox>("port")->currentText(), QStringLiteral("Simulated board"));
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY(device().answering() && device().identified());
        QVERIFY(!m_rig->find<QLabel>("firmware")->text().isEmpty());
        QVERIFY(!device().armed());
        QTRY_COMPARE(state(), MotorState::Idle);
    }

    void fourSignalsAreOnTheScopeAtOnce()
    {
        QTRY_COMPARE(m_rig->window.scope()->channels().size(), 4);
        QTRY_VERIFY(samplesOf("I_A") > 1000);
    }

    void theTreeShowsLiveValues()
    {
        const auto voltage = idOf("BUS_VOLTAGE");
        QTRY_VERIFY(m_rig->workbench.registers().shownValue(voltage).value_or(0.0) > 1.0);
    }

    void aDraggedRegisterJoinsTheScope()
    {
        for (const char *name : {"I_D_MEAS", "SPEED_MEAS"}) {
            drop(name);
            QTRY_COMPARE(m_rig->window.scope()->plotOf(channelOf(name)), 0);
        }
        // One is recorded by the board, the other is read one by one and says so.
        const auto &capture = m_rig->workbench.capture();
        QVERIFY(capture.info(channelOf("I_D_MEAS"))->kind == capture::ChannelInfo::Kind::Fast);
        QVERIFY(capture.info(channelOf("SPEED_MEAS"))->kind == capture::ChannelInfo::Kind::Polled);
        for (const char *name : {"I_D_MEAS", "SPEED_MEAS"}) {
            const auto before = samplesOf(name);
            QTRY_VERIFY(samplesOf(name) > before + 3);
        }
        QVERIFY(device().answering());
    }

    void enterAddsWhatIsSelected()
    {
        const int before = int(m_rig->window.scope()->channels().size());
        QTreeView *tree =
            m_rig->window.findChild<widgets::RegisterPanel *>()->findChild<QTreeView *>();
        m_rig->find<QLineEdit>("registerSearch")->setText(QStringLiteral("I_ALPHA_MEAS"));
        const auto *proxy = qobject_cast<QSortFilterProxyModel *>(tree->model());
        const auto index =
            proxy->mapFromSource(m_rig->workbench.registers().indexOf(idOf("I_ALPHA_MEAS")));
        QVERIFY(index.isValid());
        tree->setCurrentIndex(index);
        QTest::keyClick(tree, Qt::Key_Return);
        QTRY_COMPARE(int(m_rig->window.scope()->channels().size()), before + 1);
        m_rig->find<QLineEdit>("registerSearch")->clear();
        m_rig->window.selection()->remove(idOf("I_ALPHA_MEAS"));
        QTRY_COMPARE(int(m_rig->window.scope()->channels().size()), before);
    }

    void aSearchWithoutHitsSaysSo()
    {
        auto *search = m_rig->find<QLineEdit>("registerSearch");
        auto *details = m_rig->find<QLabel>("registerDetails");
        search->setText(QStringLiteral("no such thing"));
        QVERIFY(details->isVisible());
        QVERIFY(details->text().contains(QStringLiteral("\"no such thing\"")));
        search->clear();
        QVERIFY(!details->text().contains(QStringLiteral("no such thing")));
    }

    void withoutArmStartDoesNothing()
    {
        QVERIFY(!m_rig->find<QPushButton>("start")->isEnabled());
        QTest::keyClick(&m_rig->window, Qt::Key_Return, Qt::ControlModifier);
        QCOMPARE(state(), MotorState::Idle);
    }

    void armedItStartsAndRuns()
    {
        QTest::keyClick(m_rig->find<QCheckBox>("arm"), Qt::Key_Space);
        QTRY_VERIFY(device().armed());
        QTRY_VERIFY(m_rig->find<QPushButton>("start")->isEnabled());
        QTest::mouseClick(m_rig->find<QPushButton>("start"), Qt::LeftButton);
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Running, 15000);
        QCOMPARE(m_rig->questions, 1); // the first start of a session
    }

    void theTracesMove()
    {
        const auto channel = channelOf("I_A");
        const auto range = m_rig->window.scope()->visibleRange();
        // The newest stays in view.
        QTRY_VERIFY(m_rig->window.scope()->visibleRange().to > range.to + 0.2);
        const auto &capture = m_rig->workbench.capture();
        const auto span = capture.timeSpan(channel);
        QVERIFY(span.has_value());
        const auto extremes = capture.extremes(channel, span->to - 0.5, span->to);
        QVERIFY(extremes.max - extremes.min > 0.05f);
    }

    void aNewSetPointIsReached()
    {
        auto *speed = m_rig->window.findChild<widgets::ControlPanel *>()->speed();
        speed->setText(QStringLiteral("1200"));
        QTest::keyClick(speed, Qt::Key_Return);
        QTRY_VERIFY_WITH_TIMEOUT(
            std::abs(
                m_rig->workbench.registers().shownValue(idOf("SPEED_MEAS")).value_or(0.0) - 1200.0)
                < 60.0,
            15000);
    }

    void escapeStopsIt()
    {
        QTest::keyClick(&m_rig->window, Qt::Key_Escape);
        QVERIFY(!device().armed());
        QTRY_COMPARE_WITH_TIMEOUT(state(), MotorState::Idle, 5000);
        const auto *words =
            m_rig->window.findChild<widgets::ControlPanel *>()->findChild<widgets::StopWords *>();
        QTRY_VERIFY_WITH_TIMEOUT(
            words->text().contains(QStringLiteral("speed not measurable")), 10000);
        QCOMPARE(m_rig->window.height(), kHeight);
        // With the words of the stop and a message over them.
        QVERIFY(m_rig->find<QWidget>("banner")->isVisible());
        const auto *panel = m_rig->window.findChild<widgets::ControlPanel *>();
        for (const QWidget *seen : {static_cast<const QWidget *>(m_rig->find<QWidget>("stop")),
                 static_cast<const QWidget *>(panel->findChild<widgets::ReadoutBox *>())})
            QTRY_COMPARE(seen->visibleRegion().boundingRect().size(), seen->size());
        m_rig->find<QWidget>("banner")->findChild<QToolButton *>()->click();
        const auto *scroll = m_rig->find<QScrollArea>("controlScroll");
        QTRY_COMPARE(scroll->verticalScrollBar()->maximum(), 0); // the readouts stay in view
    }

    void nothingWasLost()
    {
        QCOMPARE(device().counters().streamLostTicks, 0U);
        QCOMPARE(device().counters().badPackets, 0U);
        const auto &refused = m_rig->workbench.capture().refused();
        QCOMPARE(
            refused.otherStream + refused.malformed + refused.backwards + refused.notFinite, 0U);
    }

    void theExportedFileIsWhatWasRecorded()
    {
        // Nothing more is added.
        QTest::mouseClick(m_rig->find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY(!device().portOpen());
        QTemporaryDir folder;
        m_rig->files.answer = folder.filePath(QStringLiteral("capture.csv"));
        m_rig->window.findChild<widgets::Exporting *>()->ask();
        m_rig->find<QComboBox>("exportRange")->setCurrentIndex(1);
        QTest::mouseClick(m_rig->find<QPushButton>("exportSave"), Qt::LeftButton);
        QVERIFY(m_rig->files.asked.suggestedName.endsWith(QStringLiteral("_motor_capture.csv")));
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(m_rig->files.answer), 20000);
        QTRY_VERIFY(
            m_rig->find<QLabel>("bannerText")->text().contains(QStringLiteral("capture.csv")));
        compareWithCapture(m_rig->files.answer);
    }

private:
    widgets::Device &device() { return m_rig->workbench.device(); }
    MotorState state() { return device().status(1).state; }
    catalog::RegisterId idOf(const char *name) { return *device().catalog()->resolve(name); }
    capture::ChannelId channelOf(const char *name)
    {
        return m_rig->workbench.capture().find(idOf(name)).value_or(0);
    }
    std::uint64_t samplesOf(const char *name)
    {
        return m_rig->workbench.capture().size(channelOf(name));
    }

    void drop(const char *name)
    {
        auto &model = m_rig->workbench.registers();
        std::unique_ptr<QMimeData> data(model.mimeData({model.indexOf(idOf(name))}));
        QVERIFY(data);
        widgets::ScopeView *scope = m_rig->window.scope();
        const QPoint at(scope->width() / 2, scope->height() / 4);
        QDragEnterEvent enter(at, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(scope, &enter);
        QVERIFY(enter.isAccepted());
        QDragMoveEvent move(at, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(scope, &move);
        QDropEvent dropped(at, Qt::CopyAction, data.get(), Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(scope, &dropped);
        QVERIFY(dropped.isAccepted());
    }

    /// Every value of I_A in the file is the capture's at that time; the rows are as many as its samples.
    void compareWithCapture(const QString &path)
    {
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QList<QByteArray> heading = file.readLine().trimmed().split(',');
        QCOMPARE(heading.at(0), QByteArray("time [s]"));
        const auto column = heading.indexOf(QByteArray("I_A [A]"));
        QVERIFY(column > 0);
        const auto &capture = m_rig->workbench.capture();
        const auto channel = channelOf("I_A");
        const auto span = capture.timeSpan(channel);
        const auto samples = capture.channel(channel)->samples(
            span->from, span->to + 1.0, capture.size(channel) * 2);
        std::vector<double> recorded;
        for (const capture::Sample &sample : samples)
            if (std::isfinite(sample.value)) // gaps have no row
                recorded.push_back(sample.value);
        QCOMPARE(recorded.size(), capture.size(channel));

        std::size_t row = 0;
        double lastTime = -1.0;
        while (!file.atEnd()) {
            const QList<QByteArray> cells = file.readLine().trimmed().split(',');
            QCOMPARE(cells.size(), heading.size());
            const double time = cells.at(0).toDouble();
            QVERIFY(time > lastTime);
            lastTime = time;
            if (cells.at(column).isEmpty())
                continue;
            QVERIFY(row < recorded.size());
            if (std::abs(cells.at(column).toDouble() - recorded[row]) > 1e-6)
                QCOMPARE(cells.at(column).toDouble(), recorded[row]);
            ++row;
        }
        QCOMPARE(row, recorded.size());
        QVERIFY(row > 10000);
    }

    std::unique_ptr<facts::WindowRig> m_rig;
};

QTEST_MAIN(TestFirstSession)
#include "tst_first_session.moc"
