// The user tells the window the current scale of a board that does not: the refused set-point says so, the control
// panel asks, units follow at once, and the board gets its scale back when it is met again.
#include "support/window_rig.h"
#include "widgets/base/banner.h"
#include "widgets/control/panel.h"
#include "widgets/scope/signals/selection.h"
#include "widgets/window/connect_bar.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QToolButton>

#include <cmath>

class TestCurrentScale : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theScaleIsAskedForUsedAndRemembered();
    void whatWasTypedByTheScaleBeforeIsForgotten();
    void aBoardThatTellsItsScaleIsNotAskedFor();
    void nonsenseIsNotTaken();

private:
    static void connectTo(facts::WindowRig &rig, const char *path, const char *protocol)
    {
        auto *bar = rig.find<widgets::ConnectBar>("connectBar");
        bar->setEndpoint(QLatin1String(path), 115200);
        bar->setProtocol(QLatin1String(protocol));
        QTest::mouseClick(rig.find<QPushButton>("connect"), Qt::LeftButton);
        QTRY_VERIFY_WITH_TIMEOUT(
            rig.workbench.device().answering() && rig.workbench.device().identified(), 20000);
    }
    static std::string unitOf(facts::WindowRig &rig, const char *name)
    {
        const auto catalog = rig.workbench.device().catalog();
        return catalog->readScale(*catalog->resolve(name)).unit;
    }
    static QString goHint(facts::WindowRig &rig)
    {
        rig.find<QComboBox>("setpointMode")->setCurrentIndex(2); // currents
        return rig.find<QPushButton>("go")->toolTip().simplified();
    }
    static bool openDialog(facts::WindowRig &rig)
    {
        QTest::mouseClick(rig.find<QToolButton>("changeCurrentScale"), Qt::LeftButton);
        return rig.find<QDialog>("currentScaleDialog") != nullptr;
    }
    static QPushButton *ok(facts::WindowRig &rig)
    {
        return rig.find<QDialog>("currentScaleDialog")
            ->findChild<QDialogButtonBox *>()
            ->button(QDialogButtonBox::Ok);
    }
    static bool say(facts::WindowRig &rig, const char *amps)
    {
        if (!openDialog(rig))
            return false;
        rig.find<QLineEdit>("fullScaleCurrent")->setText(QLatin1String(amps));
        QTest::mouseClick(ok(rig), Qt::LeftButton);
        return true;
    }
};

void TestCurrentScale::theScaleIsAskedForUsedAndRemembered()
{
    widgets::Settings settings = facts::WindowRig::quietSettings();
    {
        facts::WindowRig rig(settings);
        connectTo(rig, "sim:legacy", "legacy");
        QVERIFY2(goHint(rig).contains(QLatin1String("current scale")), qPrintable(goHint(rig)));
        QVERIFY(rig.find<QToolButton>("changeCurrentScale")->isVisible());
        QVERIFY(rig.find<QLabel>("limits")->text().contains(QLatin1String("Current scale: not")));
        QVERIFY(unitOf(rig, "I_Q_REF") != "A");
        // The unit of files and of the command line, in words.
        const auto &registers = rig.workbench.registers();
        const auto iqRef = *rig.workbench.device().catalog()->resolve("I_Q_REF");
        QCOMPARE(unitOf(rig, "I_Q_REF"), std::string("s16A"));
        QCOMPARE(registers.describe(iqRef, std::int64_t{100}), QStringLiteral("100\u202fdigits"));
        QVERIFY(
            registers.details(iqRef).contains(QLatin1String("32768 digits are the full scale")));
        QVERIFY(registers.indexOf(iqRef)
                    .data(Qt::ToolTipRole)
                    .toString()
                    .contains(QLatin1String("32768 digits are the full scale")));
        const auto typed = registers.readEntry(
            iqRef, widgets::RegisterModel::ValueColumn, QStringLiteral("100 digits"));
        QVERIFY(typed && *typed == catalog::Value(std::int64_t{100}));
        const auto iq = *rig.workbench.device().catalog()->resolve("I_Q_MEAS");
        rig.window.selection()->add(iq, 0);
        auto &capture = rig.workbench.capture();
        QTRY_VERIFY(capture.find(iq).has_value());
        const auto inDigits = *capture.find(iq);

        // By the measuring circuit of the simulated board.
        QVERIFY(openDialog(rig));
        const std::pair<const char *, const char *> circuit[] = {
            {"shunt", "3"}, {"amplifierGain", "9.14"}, {"converterReference", "3.3"}};
        for (const auto &[field, text] : circuit)
            QTest::keyClicks(rig.find<QLineEdit>(field), QLatin1String(text));
        QCOMPARE(rig.find<QLineEdit>("fullScaleCurrent")->text(), QStringLiteral("60.1751"));
        QVERIFY(rig.find<QLabel>("scaleSays")->text().contains(QLatin1String("544.5")));
        QTest::mouseClick(ok(rig), Qt::LeftButton);
        QTRY_COMPARE(unitOf(rig, "I_Q_REF"), std::string("A"));
        QVERIFY(std::abs(rig.workbench.device().fullScaleAmps(1) - 60.1751) < 1e-6);
        QVERIFY(!goHint(rig).contains(QLatin1String("current scale")));
        QVERIFY(rig.find<QLabel>("limits")->text().contains(QLatin1String("60.18")));

        // The trace goes on in A, as another one than that in digits.
        QTRY_VERIFY(capture.find(iq) != inDigits);
        QCOMPARE(capture.info(*capture.find(iq))->unit, std::string("A"));
        QTRY_COMPARE(rig.window.settings().currentScales.size(), 1);
        settings = rig.window.settings();
    }
    facts::WindowRig again(settings);
    connectTo(again, "sim:legacy", "legacy");
    QTRY_COMPARE(unitOf(again, "I_Q_REF"), std::string("A"));
    QTRY_VERIFY(
        again.window.findChild<widgets::Banner *>()->text().contains(QLatin1String("60.18")));
    QVERIFY(say(again, "")); // and it can be taken back
    QTRY_VERIFY(unitOf(again, "I_Q_REF") != "A");
    QTRY_VERIFY(again.window.settings().currentScales.isEmpty());
}

void TestCurrentScale::whatWasTypedByTheScaleBeforeIsForgotten()
{
    facts::WindowRig rig;
    connectTo(rig, "sim:legacy", "legacy");
    auto &registers = rig.workbench.registers();
    const auto iq = *rig.workbench.device().catalog()->resolve("I_Q_REF");
    const auto kp = *rig.workbench.device().catalog()->resolve("SPEED_KP");
    QVERIFY(say(rig, "60"));
    QTRY_COMPARE(unitOf(rig, "I_Q_REF"), std::string("A"));
    QVERIFY(registers.setPending(iq, std::int64_t{500}));
    QVERIFY(registers.setPending(kp, std::int64_t{1234}));
    QVERIFY(say(rig, "30"));
    QTRY_COMPARE(rig.workbench.device().fullScaleAmps(1), 30.0);
    QVERIFY(registers.wanted(iq) != catalog::Value(std::int64_t{500}));
    QCOMPARE(registers.wanted(kp), std::optional(catalog::Value(std::int64_t{1234})));
}

void TestCurrentScale::aBoardThatTellsItsScaleIsNotAskedFor()
{
    facts::WindowRig rig;
    connectTo(rig, "sim", "mcp");
    QVERIFY(!rig.find<QToolButton>("changeCurrentScale")->isVisible());
    QVERIFY(!goHint(rig).contains(QLatin1String("current scale")));
}

void TestCurrentScale::nonsenseIsNotTaken()
{
    facts::WindowRig rig;
    connectTo(rig, "sim:powerpc", "powerpc");
    QVERIFY(openDialog(rig));
    for (const char *text : {"-3", "0", "1e2", "sixty", "20000", "5001", "0.00001"}) {
        rig.find<QLineEdit>("fullScaleCurrent")->setText(QLatin1String(text));
        QVERIFY2(!ok(rig)->isEnabled(), text);
        QVERIFY(rig.find<QLabel>("scaleSays")->text().contains(QStringLiteral("to 5000 A")));
    }
    rig.find<QLineEdit>("fullScaleCurrent")->setText(QStringLiteral("60,5")); // a decimal comma
    QVERIFY(ok(rig)->isEnabled());
}

QTEST_MAIN(TestCurrentScale)
#include "tst_current_scale.moc"
