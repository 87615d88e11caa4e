#include "session/files/limits_file.h"
#include "widgets/window/own_limits.h"
#include "widgets/window/settings.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using widgets::Settings;

namespace {
drive::UserLimits stored(const QString &path)
{
    const auto limits = session::loadLimits(path);
    return limits && *limits ? **limits : drive::UserLimits{-1.0, -1.0};
}
} // namespace

class TestSettings : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void whatIsSavedIsLoaded()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("deep/er/settings.json"));
        Settings settings;
        settings.geometry = QByteArray("\x01\x02\xff", 3);
        settings.port = QStringLiteral("/dev/ttyACM0");
        settings.typedPorts = {QStringLiteral("/dev/board"), QStringLiteral("COM3")};
        settings.baud = 115200;
        settings.theme = widgets::Theme::Dark;
        settings.pinned = {QStringLiteral("I_A")};
        settings.inertias = {{QStringLiteral("A motor"), 5e-5}, {QStringLiteral("\u00e9"), 1e-7}};
        settings.workspace.traceColors = {
            {QStringLiteral("I_A"), 7}, {QStringLiteral("\u00e9"), 0}};
        settings.currentScales = {{QStringLiteral("ST MC SDK|5.4.3|/dev/ttyUSB0#1"), 60.175}};
        settings.maxSpeedRpm = 1500.0;
        settings.maxCurrentAmps = 2.5;
        settings.samplesOnDiskGB = 20.5;
        settings.firstStepsDone = true;
        settings.workspace.formulas = {{QStringLiteral("M1"), QStringLiteral("I_A + 1"), false},
            {QStringLiteral("M2"), QStringLiteral("[I_A (2)]"), true}};
        settings.workspace.notes = QStringLiteral("a note");
        settings.recentFiles = {QStringLiteral("/b.pcapng"), QStringLiteral("/a.csv")};
        QCOMPARE(widgets::saveSettings(settings, path), QString());
        QString problem;
        QCOMPARE(widgets::loadSettings(path, &problem), settings);
        QCOMPARE(problem, QString());
    }

    void aDamagedFileIsPutAsideAndTold()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("settings.json"));
        QString problem;
        QCOMPARE(widgets::loadSettings(path, &problem), Settings{});
        QCOMPARE(problem, QString()); // there was none
        Settings settings;
        settings.workspace.notes = QStringLiteral("a note");
        const QByteArray cut = widgets::toJson(settings).chopped(4);
        for (const QByteArray &content : {QByteArray("earlier"), cut}) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
            file.close();
            problem.clear();
            QCOMPARE(widgets::loadSettings(path, &problem), Settings{});
            QVERIFY2(problem.contains(QStringLiteral("settings.json.bad")), qPrintable(problem));
            QVERIFY(!QFile::exists(path));
        }
        QCOMPARE(widgets::saveSettings(Settings{}, path), QString());
        QFile aside(path + QStringLiteral(".bad"));
        QVERIFY(aside.open(QIODevice::ReadOnly));
        QCOMPARE(aside.readAll(), cut); // whatever was saved since
    }

    void aMissingOrDamagedFileGivesTheDefaultsButNoLimitIsLostWithIt()
    {
        QTemporaryDir other;
        const QString limits = other.filePath(QStringLiteral("limits.json"));
        QCOMPARE(session::saveLimits({1500.0, 2.5}, limits), QString());

        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("settings.json"));
        QCOMPARE(widgets::loadSettings(path), Settings{});
        const QByteArray whole = widgets::toJson(Settings{});
        for (qsizetype cut = 0; cut < whole.size() - 3; ++cut) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(whole.left(cut));
            file.close();
            QCOMPARE(widgets::loadSettings(path), Settings{});
            widgets::Device device;
            widgets::OwnLimits own(device, limits);
            own.load();
            QVERIFY(device.userLimits() == (drive::UserLimits{1500.0, 2.5}));
        }
    }

    void ownLimitsAreStoredWhenTheyAreSet()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("deep/er/limits.json"));
        widgets::Device device;
        widgets::OwnLimits own(device, path);
        own.load();
        QVERIFY(!QFile::exists(path)); // none was set
        device.setUserLimits({1200.0, 1.5});
        QVERIFY(stored(path) == (drive::UserLimits{1200.0, 1.5})); // and no end of the program
        device.setUserLimits({1200.0, 0.0});
        QVERIFY(stored(path) == (drive::UserLimits{1200.0, 0.0}));
        device.setUserLimits({});
        QVERIFY(stored(path) == drive::UserLimits{}); // none: that was said, too
    }

    void theFileOfTheLimitsCountsNotTheCopyInTheSettings()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("limits.json"));
        for (const drive::UserLimits limits :
            {drive::UserLimits{800.0, 1.0}, drive::UserLimits{}}) {
            QCOMPARE(session::saveLimits(limits, path), QString());
            widgets::Device device;
            device.setUserLimits({2000.0, 0.0}); // as at the last clean end
            widgets::OwnLimits own(device, path);
            own.load();
            QVERIFY(device.userLimits() == limits);
        }
        QVERIFY(QFile::remove(path)); // from before it had a file, or lost
        widgets::Device device;
        device.setUserLimits({2000.0, 0.0});
        widgets::OwnLimits own(device, path);
        own.load();
        QVERIFY(stored(path) == (drive::UserLimits{2000.0, 0.0}));
    }

    void limitsThatCannotBeReadAreToldAndNeverTakenForNone()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("limits.json"));
        QCOMPARE(session::saveLimits({1500.0, 2.5}, path), QString());
        QFile whole(path);
        QVERIFY(whole.open(QIODevice::ReadOnly));
        const QByteArray good = whole.readAll();
        QList<QByteArray> bad{"[]", R"({"maxSpeedRpm": -1, "maxCurrentAmps": 2})",
            R"({"maxSpeedRpm": "1500", "maxCurrentAmps": 2})", R"({"maxSpeedRpm": 1500})",
            QByteArray(100'000, ' ')};
        for (qsizetype cut = 0; cut < good.size() - 2; ++cut)
            bad.append(good.left(cut));
        for (const QByteArray &content : bad) {
            QFile file(path);
            QVERIFY(file.open(QIODevice::WriteOnly));
            file.write(content);
            file.close();
            for (const double copy : {0.0, 900.0}) {
                widgets::Device device;
                device.setUserLimits({copy, 0.0});
                widgets::OwnLimits own(device, path);
                QSignalSpy told(&own, &widgets::OwnLimits::told);
                own.load();
                QCOMPARE(told.size(), 1);
                QCOMPARE(told[0][0].toString().contains(QStringLiteral("NO limit")), copy == 0.0);
                QCOMPARE(device.userLimits().maxSpeedRpm, copy);
            }
        }
    }

    void limitsThatCannotBeStoredAreTold()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("file"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        widgets::Device device;
        widgets::OwnLimits own(device, path + QStringLiteral("/limits.json"));
        own.load();
        QSignalSpy told(&own, &widgets::OwnLimits::told);
        device.setUserLimits({1200.0, 0.0});
        QCOMPARE(told.size(), 1);
        QCOMPARE(device.userLimits().maxSpeedRpm, 1200.0);
    }

    void fieldsOfTheWrongKindKeepTheirDefaults()
    {
        const Settings read = widgets::settingsFromJson(
            R"({"port": 5, "baud": "fast", "theme": [], "pinned": "x", "firstStepsDone": 1,
                "maxSpeedRpm": -3, "maxCurrentAmps": "2", "samplesOnDiskGB": -5})");
        QCOMPARE(read, Settings{});
    }

    void anUnwritableFolderIsToldAndChangesNothing()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("file"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        const QString why =
            widgets::saveSettings(Settings{}, path + QStringLiteral("/settings.json"));
        QVERIFY2(why.contains(QStringLiteral("cannot be saved")), qPrintable(why));
    }
};

QTEST_MAIN(TestSettings)
#include "tst_settings.moc"
