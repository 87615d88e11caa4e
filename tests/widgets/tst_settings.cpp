#include "widgets/window/settings.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using widgets::Settings;

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
        settings.baud = 115200;
        settings.theme = widgets::Theme::Dark;
        settings.pinned = {QStringLiteral("I_A")};
        settings.inertias = {{QStringLiteral("A motor"), 5e-5}, {QStringLiteral("\u00e9"), 1e-7}};
        settings.traceColors = {{QStringLiteral("I_A"), 7}, {QStringLiteral("\u00e9"), 0}};
        settings.currentScales = {{QStringLiteral("ST MC SDK|5.4.3|/dev/ttyUSB0#1"), 60.175}};
        settings.maxSpeedRpm = 1500.0;
        settings.maxCurrentAmps = 2.5;
        settings.samplesOnDiskGB = 20.5;
        settings.firstStepsDone = true;
        settings.formulas = {{QStringLiteral("M1"), QStringLiteral("I_A + 1"), false},
            {QStringLiteral("M2"), QStringLiteral("[I_A (2)]"), true}};
        QVERIFY(widgets::saveSettings(settings, path));
        QCOMPARE(widgets::loadSettings(path), settings);
    }

    void aMissingOrDamagedFileGivesTheDefaults()
    {
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
        }
    }

    void fieldsOfTheWrongKindKeepTheirDefaults()
    {
        const Settings read = widgets::settingsFromJson(
            R"({"port": 5, "baud": "fast", "theme": [], "pinned": "x", "firstStepsDone": 1, "maxSpeedRpm": -3, "maxCurrentAmps": "2", "samplesOnDiskGB": -5})");
        QCOMPARE(read, Settings{});
    }

    void anUnwritableFolderIsToldAndChangesNothing()
    {
        QTemporaryDir folder;
        const QString path = folder.filePath(QStringLiteral("file"));
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        QVERIFY(!widgets::saveSettings(Settings{}, path + QStringLiteral("/settings.json")));
    }
};

QTEST_MAIN(TestSettings)
#include "tst_settings.moc"
