// The room for samples in the window: what is asked, what it says, and what becomes of it.
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/files/sample_room.h"
#include "widgets/files/sample_room_dialog.h"

#include <QAction>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace std::chrono_literals;
using widgets::SampleRoom;
using widgets::SampleRoomDialog;

class TestSampleRoom : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init()
    {
        m_place = std::make_unique<QTemporaryDir>();
        m_archive = std::make_shared<session::DiskArchive>(session::DiskArchive::Config{
            m_place->filePath(QStringLiteral("samples")), 0, 0, kPiece});
        m_capture = capture::Capture({.maxBytes = 4'000'000, .archive = m_archive});
        m_tick = 0;
    }

    void theBudgetIsWhatIsWanted()
    {
        SampleRoom room(m_capture, *m_archive);
        QCOMPARE(m_archive->budget(), session::usualArchiveBudget(m_archive->folder()));
        room.setWanted(2.5);
        QCOMPARE(m_archive->budget(), std::uint64_t(2'500'000'000));
        room.setWanted(0.0);
        QCOMPARE(m_archive->budget(), std::uint64_t(0));
        QCOMPARE(room.wanted(), 0.0);
    }

    void theMeaningIsInHoursAtThePresentRate()
    {
        SampleRoom room(m_capture, *m_archive);
        // Nothing comes: five signals at 16 kHz take 180 kB/s, 20 GB last 30.9 hours.
        QCOMPARE(room.meaningText(20.0),
            QStringLiteral("20 GB on disk: about 31 hours of five signals at 16 kHz (180 kB/s)."));
        record(16'000); // a second of one signal
        room.refresh(1000ms);
        QCOMPARE(room.meaningText(20.0),
            QStringLiteral("20 GB on disk: about 154 hours at the present 36 kB/s."));
        QCOMPARE(room.meaningText(0.04),
            QStringLiteral("0.04 GB on disk: about 19 minutes at the present 36 kB/s."));
        QVERIFY(room.meaningText(0.0).startsWith(QStringLiteral("Memory only, ")));
        room.refresh(2000ms); // it has stopped
        QVERIFY(room.meaningText(20.0).contains(QStringLiteral("five signals")));
    }

    void whatIsHeldAndWhatWouldGoIsSaid()
    {
        SampleRoom room(m_capture, *m_archive);
        room.setWanted(1.0);
        QVERIFY(room.lessText(0.0).isEmpty());
        QTRY_VERIFY((record(70'000), m_capture.archivedBytes() > 2'000'000));
        QVERIFY(room.heldText().startsWith(QStringLiteral("Samples: 0.00 GB in memory, 0.0")));
        QVERIFY(!room.lessText(0.0).isEmpty());
        QVERIFY(room.lessText(1.0).isEmpty());
        QVERIFY(room.fullText().contains(QStringLiteral("1.0 GB on disk")));
        room.setWanted(0.0);
        record(140'000);
        QCOMPARE(m_capture.archivedBytes(), std::uint64_t(0));
        QVERIFY(!room.fullText().contains(QStringLiteral("on disk")));
    }

    void aDiskThatTakesNothingIsToldOnceInWords()
    {
        QFile inTheWay(m_place->filePath(QStringLiteral("samples")));
        QVERIFY(inTheWay.open(QIODevice::WriteOnly));
        SampleRoom room(m_capture, *m_archive);
        room.setWanted(1.0);
        QSignalSpy said(&room, &SampleRoom::said);
        QTRY_VERIFY((record(100'000), said.size() == 1));
        const QString sentence = said.front().at(1).toString();
        QVERIFY2(sentence.contains(m_archive->folder()), qPrintable(sentence));
        record(3'000'000);
        QCOMPARE(said.size(), 1);
    }

    void theWindowAsksAndRemembers()
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.samplesOnDiskGB = 3.0;
        facts::WindowRig rig(settings);
        QCOMPARE(rig.workbench.archive()->budget(), std::uint64_t(3'000'000'000));
        auto *size = open(rig);
        QCOMPARE(size->text(), QStringLiteral("3"));
        auto *ok = rig.find<SampleRoomDialog>("sampleRoomDialog")
                       ->findChild<QDialogButtonBox *>()
                       ->button(QDialogButtonBox::Ok);
        for (const char *wrong : {"-1", "1e3", "1.000,5", "many", "999999999"}) {
            size->setText(QLatin1String(wrong));
            QVERIFY2(!ok->isEnabled(), wrong);
        }
        size->setText(QStringLiteral("4,5"));
        QVERIFY(
            rig.find<QLabel>("roomMeaning")->text().startsWith(QStringLiteral("4.5 GB on disk")));
        QTest::mouseClick(ok, Qt::LeftButton);
        QCOMPARE(rig.workbench.archive()->budget(), std::uint64_t(4'500'000'000));
        QCOMPARE(rig.window.settings().samplesOnDiskGB, 4.5);
    }

    void anEmptyFieldIsWhatIsUsual()
    {
        facts::WindowRig rig;
        const std::uint64_t usual = rig.workbench.archive()->budget();
        // Half of what is free, and others write to the disk meanwhile.
        const auto now = static_cast<double>(session::usualArchiveBudget(session::archiveFolder()));
        QVERIFY(std::abs(static_cast<double>(usual) - now) < 0.05 * now);
        auto *size = open(rig);
        QVERIFY(size->text().isEmpty());
        QTest::keyClick(size, Qt::Key_Return);
        QVERIFY(rig.window.settings().samplesOnDiskGB < 0.0);
        QTRY_VERIFY(!rig.find<SampleRoomDialog>("sampleRoomDialog"));
        size = open(rig);
        size->setText(QStringLiteral("0"));
        QTest::keyClick(size, Qt::Key_Escape);
        QVERIFY(rig.window.settings().samplesOnDiskGB < 0.0);
    }

private:
    static constexpr std::size_t kPiece = 524288;

    static QLineEdit *open(facts::WindowRig &rig)
    {
        rig.find<QAction>("sampleRoom")->trigger();
        return rig.find<QLineEdit>("roomSize");
    }

    void record(capture::Tick samples)
    {
        if (m_tick == 0)
            m_capture.begin({1, 16000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
        for (const capture::Tick end = m_tick + samples; m_tick < end; m_tick += 1000)
            m_capture.append({1, m_tick, 1000, std::vector<std::int16_t>(1000, 7), {}, 0});
    }

    std::unique_ptr<QTemporaryDir> m_place;
    std::shared_ptr<session::DiskArchive> m_archive;
    capture::Capture m_capture;
    capture::Tick m_tick = 0;
};

QTEST_MAIN(TestSampleRoom)
#include "tst_sample_room.moc"
