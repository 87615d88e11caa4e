// The motor form in the real window on the simulated board, and its parts alone.
#include "session/files/motor_file.h"
#include "support/window_rig.h"
#include "widgets/base/si_text.h"
#include "widgets/forms/motor_converter.h"
#include "widgets/forms/motor_form.h"
#include "widgets/forms/motor_messages.h"

#include <QAbstractItemModelTester>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QFile>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTemporaryDir>
#include <QTreeView>

#include <cmath>

using widgets::MotorModel;

namespace {

const char *const kGimbal = R"({"label": "Gimbal", "polePairs": 7, "nominalDCVoltage": 24,
 "nominalCurrent": 5, "maxRatedSpeed": 1500, "rs": 5.4, "ls": 0.00105,
 "magneticStructure": {"type": "SM-PMSM"}, "BEmfConstant": 4.9})";

QModelIndex rowOf(const MotorModel &model, const QString &group, const QString &key)
{
    for (int i = 0; i < model.rowCount(); ++i) {
        const QModelIndex parent = model.index(i, 0);
        if (parent.data(MotorModel::KeyRole).toString() != group)
            continue;
        for (int j = 0; j < model.rowCount(parent); ++j)
            if (model.index(j, 0, parent).data(MotorModel::KeyRole).toString() == key)
                return model.index(j, 0, parent);
    }
    return {};
}

} // namespace

class TestMotorForm : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QLocale::setDefault(QLocale::c());
        m_rig = std::make_unique<facts::WindowRig>();
        m_rig->window.resize(1280, 720);
        QVERIFY(QTest::qWaitForWindowExposed(&m_rig->window));
        m_tester = std::make_unique<QAbstractItemModelTester>(
            &form().model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
    }
    void cleanupTestCase()
    {
        m_tester.reset();
        m_rig.reset();
    }
    void cleanup() { QLocale::setDefault(QLocale::c()); }

    void anInertiaOfAFileIsKnownToTheForms()
    {
        openFile(R"({"preset": "pm24", "motor": {"name": "Bench motor", "inertia_kgm2": 4.2e-5}})");
        QVERIFY(std::abs(
                    m_rig->window.settings().inertias.value(QStringLiteral("Bench motor")) - 4.2e-5)
            < 1e-12);
        openFile(R"({"preset": "pm24", "motor": {"name": "Bench motor", "inertia_kgm2": 9e-5}})");
        QVERIFY(std::abs(
                    m_rig->window.settings().inertias.value(QStringLiteral("Bench motor")) - 4.2e-5)
            < 1e-12); // what is known stays
        button("motorClose")->click();
    }

    void withoutABoardItSaysSoAndTakesAFile()
    {
        press(Qt::Key_4, Qt::ControlModifier);
        QVERIFY(form().isVisible());
        QVERIFY(label("motorReason").contains(QStringLiteral("Connect to a board")));
        QVERIFY(!button("motorRead")->isEnabled() && !button("motorSave")->isEnabled());
        QVERIFY(!button("convertBoard")->isEnabled()); // and says why
        QVERIFY(button("convertBoard")->toolTip().contains(QStringLiteral("Connect to a board")));
        openFile(kGimbal);
        QCOMPARE(text("comparison", "compare 1", MotorModel::FileColumn),
            widgets::siText(5.4, QStringLiteral("\u03a9")));
        QCOMPARE(
            text("comparison", "compare 1", MotorModel::ValueColumn), QStringLiteral("\u2013"));
        button("motorClose")->click();
        QCOMPARE(form().model().rowCount(), 0);
    }

    void aBoardIsAskedOnceWhenSomebodyLooks()
    {
        QDockWidget *dock = m_rig->find<QDockWidget>("motorDock");
        dock->hide();
        m_rig->find<QPushButton>("connect")->click();
        QTRY_VERIFY(device().answering() && device().identified());
        QCOMPARE(form().model().rowCount(), 0);
        press(Qt::Key_4, Qt::ControlModifier);
        QTRY_COMPARE(text("GLOBAL_CONFIG", "version"), QStringLiteral("6.4.0"));
        QTRY_VERIFY(button("motorRead")->isEnabled());
        QCOMPARE(text("MOTOR_CONFIG", "Rs"), widgets::siText(0.35, QStringLiteral("\u03a9")));
        QCOMPARE(text("MOTOR_CONFIG", "Lq"), QStringLiteral("600\u202f\u00b5H"));
        QCOMPARE(text("MOTOR_CONFIG", "Lq", MotorModel::RawColumn), QStringLiteral("0.0006"));
        QCOMPARE(text("derived", "flux"), QStringLiteral("6.5\u202fmWb"));
        QCOMPARE(text("derived", "kt"), QStringLiteral("39\u202fmN m/A"));
        QCOMPARE(text("APPLICATION_CONFIG", "drive type"), QStringLiteral("FOC"));
        QCOMPARE(text("FOCFW_CONFIG", "flags 1"),
            QStringLiteral("bus voltage sensing, temperature sensing"));
        QCOMPARE(text("FOCFW_CONFIG", "flags 1", MotorModel::RawColumn), QStringLiteral("0x0600"));
        QVERIFY(label("motorWarnings").startsWith(QChar(0x2713)));
        QVERIFY(label("motorReason").isEmpty());
    }

    void everyFieldHasANameAndConfigurationsAreReadOnly()
    {
        const MotorModel &model = form().model();
        QCOMPARE(model.rowCount(), 6);
        for (int i = 0; i < model.rowCount(); ++i) {
            const QModelIndex group = model.index(i, 0);
            const QString remark = group.siblingAtColumn(1).data().toString();
            QVERIFY2(remark.contains(QStringLiteral("read-only"))
                    || remark.contains(QStringLiteral("computed")),
                qPrintable(remark));
            for (int j = 0; j < model.rowCount(group); ++j) {
                const QModelIndex row = model.index(j, 0, group);
                // A name that is the key itself is one that has no words yet.
                QVERIFY2(row.data().toString() != row.data(MotorModel::KeyRole).toString(),
                    qPrintable(row.data().toString()));
                QVERIFY(!row.siblingAtColumn(1).data().toString().isEmpty());
                QVERIFY(!(row.flags() & Qt::ItemIsEditable));
            }
        }
        for (const char *key : {"flux", "kt", "ke", "kv", "tauQ", "tauD", "torque", "baseSpeed"})
            QVERIFY2(rowOf(model, QStringLiteral("derived"), QString::fromLatin1(key))
                         .data(Qt::ToolTipRole)
                         .toString()
                         .contains(QLatin1Char('=')),
                key);
    }

    void aFileBesideTheBoardNamesWhatDiffers()
    {
        openFile(kGimbal);
        QVERIFY2(label("motorTold").contains(QStringLiteral("ST")), qPrintable(label("motorTold")));
        // Of pole pairs, Rs, Ld, Lq, flux, current, speed and voltage: current and voltage agree.
        QCOMPARE(form().model().differences(), 6);
        const auto resistance =
            rowOf(form().model(), QStringLiteral("comparison"), QStringLiteral("compare 1"));
        QVERIFY(resistance.data(MotorModel::DiffersRole).toBool());
        QVERIFY(resistance.siblingAtColumn(MotorModel::FileColumn)
                    .data()
                    .toString()
                    .startsWith(QChar(0x2260)));
        QVERIFY(!rowOf(form().model(), QStringLiteral("comparison"), QStringLiteral("compare 5"))
                     .data(MotorModel::DiffersRole)
                     .toBool());
        QVERIFY(!text("derived", "kt", MotorModel::FileColumn).isEmpty());
        const auto *head = m_rig->find<QTreeView>("motorTree")->header();
        QStringList columns; // what is compared stands side by side
        for (int place = 0; place < head->count(); ++place)
            columns.append(
                form().model().headerData(head->logicalIndex(place), Qt::Horizontal).toString());
        QCOMPARE(columns,
            (QStringList{QStringLiteral("Field"), QStringLiteral("On the board"),
                QStringLiteral("In the file"), QStringLiteral("Raw")}));
    }

    void aDamagedFileLeavesWhatIsShown_data()
    {
        QTest::addColumn<QByteArray>("content");
        QTest::addColumn<QString>("place");
        QTest::newRow("cut") << QByteArray(kGimbal).left(90) << QStringLiteral("Line 2");
        QTest::newRow("text") << QByteArray(R"({"polePairs": "7"})")
                              << QStringLiteral("\u201cpolePairs\u201d");
        QTest::newRow("own") << QByteArray(R"({"motor": {"rs_ohm": -1}})")
                             << QStringLiteral("\u201cmotor.rs_ohm\u201d");
        QTest::newRow("key") << QByteArray(R"({"motor": {"ohm": 1}})")
                             << QStringLiteral("\u201cmotor.ohm\u201d");
    }
    void aDamagedFileLeavesWhatIsShown()
    {
        QFETCH(QByteArray, content);
        QFETCH(QString, place);
        openFile(kGimbal);
        openFile(content.constData());
        QVERIFY2(label("motorTold").contains(place), qPrintable(label("motorTold")));
        QVERIFY(label("motorTold").startsWith(QStringLiteral("\u2716")));
        QVERIFY(label("motorTold").contains(QStringLiteral("was not opened")));
        QCOMPARE(form().model().differences(), 6);
    }

    void whatWasSavedIsTheBoardAgain()
    {
        const QTemporaryDir folder;
        m_rig->files.answer = folder.filePath(QStringLiteral("board.json"));
        button("motorSave")->click();
        QVERIFY(QFile::exists(m_rig->files.answer));
        button("motorOpen")->click();
        QCOMPARE(form().model().differences(), 0);
        QCOMPARE(form().model().compared(), 8);
        QVERIFY(label("motorTold").contains(QStringLiteral("Nothing differs")));
        m_rig->files.answer = folder.path() + QStringLiteral("/no/such/folder.json");
        button("motorSave")->click();
        QVERIFY(label("motorTold").contains(QStringLiteral("was not saved")));
        QVERIFY(label("motorTold").startsWith(QStringLiteral("\u2716")));
        button("motorClose")->click();
        QVERIFY(label("motorTold").isEmpty());
    }

    void rowsAreCopiedAsText()
    {
        auto *tree = m_rig->find<QTreeView>("motorTree");
        const QModelIndex row =
            rowOf(form().model(), QStringLiteral("MOTOR_CONFIG"), QStringLiteral("pole pairs"));
        tree->setFocus();
        tree->setCurrentIndex(row);
        press(Qt::Key_C, Qt::ControlModifier, tree);
        QVERIFY(QApplication::clipboard()->text().startsWith(QStringLiteral("Pole pairs\t4\t")));
    }

    void theConverterBeginsWithTheBoard()
    {
        QVERIFY(button("convertBoard")->isEnabled());
        button("convertBoard")->click();
        QCOMPARE(edit("convertPolePairs")->text(), QStringLiteral("4"));
        QCOMPARE(edit("convertFlux")->text(), QStringLiteral("6.5"));
        QCOMPARE(edit("convertKt")->text(), QStringLiteral("39"));
        QCOMPARE(edit("convertTerminalOhm")->text(), QStringLiteral("0.7"));
        QCOMPARE(edit("convertTerminalHenry")->text(), QStringLiteral("1.2"));
    }

    void eachWayOfGivingTheMagnetsMakesTheOthers_data()
    {
        QTest::addColumn<QLocale>("locale");
        QTest::newRow("C") << QLocale::c();
        QTest::newRow("de") << QLocale(QLocale::German, QLocale::Germany);
        QTest::newRow("tr") << QLocale(QLocale::Turkish, QLocale::Turkey);
    }
    void eachWayOfGivingTheMagnetsMakesTheOthers()
    {
        QFETCH(QLocale, locale);
        QLocale::setDefault(locale);
        widgets::MotorConverter converter;
        const auto field = [&](const char *name) {
            return converter.findChild<QLineEdit *>(QLatin1String(name));
        };
        const auto type = [&](const char *name, const char *typed) {
            field(name)->setFocus();
            field(name)->selectAll();
            QTest::keyClicks(field(name), QString::fromLatin1(typed));
            QTest::keyClick(field(name), Qt::Key_Return);
        };
        const auto value = [&](const char *name) {
            QString shown = field(name)->text();
            return shown.replace(QLatin1Char(','), QLatin1Char('.')).toDouble();
        };
        const auto close = [](double is, double wanted) {
            return std::abs(is - wanted) <= 1e-4 * wanted;
        };
        type("convertPolePairs", "7");
        // 1000 rpm/V: Ke = 1000 / (sqrt(2) KV) = 0.70711 V rms/krpm
        type("convertKv", "1000");
        QVERIFY2(close(value("convertKe"), 0.70711), qPrintable(field("convertKe")->text()));
        const double flux_mwb = 1000.0 / (std::sqrt(3.0) * 1000.0 * 7.0 * M_PI / 30.0);
        QVERIFY(close(value("convertFlux"), flux_mwb));
        QVERIFY(close(value("convertKt"), 1.5 * 7.0 * flux_mwb));
        // Other pole pairs: Ke and Kt stay, the flux does not.
        type("convertPolePairs", "14");
        QVERIFY(close(value("convertKe"), 0.70711));
        QVERIFY(close(value("convertKt"), 1.5 * 7.0 * flux_mwb));
        QVERIFY(close(value("convertFlux"), flux_mwb / 2.0));
        // A point and a comma both are the decimal sign.
        type("convertFlux", "6,5");
        type("convertPolePairs", "4");
        QVERIFY(close(value("convertKt"), 39.0));
        QVERIFY(close(value("convertKe"), 3.33463));
        type("convertKt", "39.0");
        QVERIFY(close(value("convertFlux"), 6.5));
        // A measurement decides.
        type("convertVolts", "2.5");
        type("convertRpm", "500");
        QVERIFY(close(value("convertKe"), 5.0));
        type("convertTerminalOhm", "0.7");
        QVERIFY(close(value("convertPhaseOhm"), 0.35));
        type("convertPhaseHenry", "0.6");
        QVERIFY(close(value("convertTerminalHenry"), 1.2));
    }

    void whatTheBoardTellsIsNotMixedWithWhatIsTyped()
    {
        widgets::MotorConverter converter;
        auto *pairs = converter.findChild<QLineEdit *>(QStringLiteral("convertPolePairs"));
        auto *ohm = converter.findChild<QLineEdit *>(QStringLiteral("convertPhaseOhm"));
        motor::MotorSheet sheet;
        sheet.polePairs = 4.0;
        sheet.rs_ohm = 0.35;
        converter.suggest(sheet);
        pairs->setFocus();
        pairs->selectAll();
        sheet.polePairs = 5.0;
        converter.suggest(sheet);
        QCOMPARE(pairs->selectedText(), QStringLiteral("5"));
        QTest::keyClicks(pairs, QStringLiteral("1"));
        sheet.rs_ohm = 0.5;
        converter.suggest(sheet); // between two digits
        QTest::keyClicks(pairs, QStringLiteral("4"));
        QCOMPARE(pairs->text(), QStringLiteral("14"));
        QCOMPARE(ohm->text(), QStringLiteral("0.35"));
        converter.accept(sheet); // that was asked for
        QCOMPARE(pairs->text(), QStringLiteral("5"));
        QCOMPARE(ohm->text(), QStringLiteral("0.5"));
    }

    void nonsenseIsNotTakenAndSaysWhy()
    {
        widgets::MotorConverter converter;
        auto *ke = converter.findChild<QLineEdit *>(QStringLiteral("convertKe"));
        auto *told = converter.findChild<QLabel *>(QStringLiteral("convertTold"));
        auto *pairs = converter.findChild<QLineEdit *>(QStringLiteral("convertPolePairs"));
        for (const char *typed : {"1.234,5", "1e3", "nan", "-3", "0", "abc", "1 000"}) {
            ke->setText(QString::fromLatin1(typed));
            QTest::keyClick(ke, Qt::Key_Return);
            QVERIFY2(ke->text().isEmpty(), typed);
            QVERIFY2(!told->text().isEmpty(), typed);
        }
        pairs->setText(QStringLiteral("3.5"));
        QTest::keyClick(pairs, Qt::Key_Return);
        QVERIFY(pairs->text().isEmpty());
    }

    void theKeyboardReachesEverything()
    {
        press(Qt::Key_4, Qt::ControlModifier);
        QCOMPARE(QApplication::focusWidget()->objectName(), QStringLiteral("motorTree"));
        QStringList reached;
        for (int i = 0; i < 100; ++i) {
            QWidget *widget = QApplication::focusWidget();
            reached.append(widget->objectName());
            QVERIFY2(!widget->accessibleName().isEmpty() || !qobject_cast<QLineEdit *>(widget),
                qPrintable(widget->objectName()));
            press(Qt::Key_Tab, Qt::NoModifier, widget);
        }
        for (const char *name : {"motorTree", "convertPolePairs", "convertKe", "convertKv",
                 "convertFlux", "convertKt", "convertVolts", "convertRpm", "convertPhaseOhm",
                 "convertTerminalOhm", "convertPhaseHenry", "convertTerminalHenry", "convertBoard",
                 "motorRead", "motorOpen", "motorSave"})
            QVERIFY2(reached.contains(QLatin1String(name)), name);
    }

    void everyWarningSaysWhatToDo()
    {
        using motor::MotorWarning;
        motor::MotorParameters worst;
        worst.ld_h = 2e-3;
        worst.lq_h = 1e-3;
        for (int i = 0; i <= int(MotorWarning::SpeedBeyondBaseSpeed); ++i)
            QVERIFY(widgets::motorWarningText(MotorWarning(i)).contains(QLatin1Char(':')));
        const auto warnings = motor::checkMotor(worst, {});
        QVERIFY(
            std::find(warnings.begin(), warnings.end(), MotorWarning::LdAboveLq) != warnings.end());
    }

    void whatABoardSaidLastStaysAndSaysSo()
    {
        m_rig->find<QPushButton>("connect")->click();
        QTRY_VERIFY(!device().portOpen());
        QTRY_VERIFY(label("motorReason").contains(QStringLiteral("said last")));
        QVERIFY(!button("motorRead")->isEnabled());
        QCOMPARE(text("GLOBAL_CONFIG", "version"), QStringLiteral("6.4.0"));
    }

    void prefixesKeepNumbersShort_data()
    {
        QTest::addColumn<double>("value");
        QTest::addColumn<QString>("unit");
        QTest::addColumn<QString>("text");
        QTest::newRow("H") << 0.6e-3 << QStringLiteral("H") << QStringLiteral("600\u202f\u00b5H");
        QTest::newRow("up") << 0.999999e-3 << QStringLiteral("s") << QStringLiteral("1\u202fms");
        QTest::newRow("0") << 0.0 << QStringLiteral("H") << QStringLiteral("0\u202fH");
        QTest::newRow("nan") << std::nan("") << QStringLiteral("H") << QStringLiteral("\u2013");
        QTest::newRow("rpm") << 12345.0 << QStringLiteral("rpm")
                             << QStringLiteral("12345\u202frpm");
        QTest::newRow("digits") << 0.0018364 << QStringLiteral("A/digit")
                                << QStringLiteral("1.8364\u202fmA/digit");
    }
    void prefixesKeepNumbersShort()
    {
        QFETCH(double, value);
        QFETCH(QString, unit);
        QFETCH(QString, text);
        QCOMPARE(widgets::siText(value, unit), text);
    }

private:
    widgets::MotorForm &form() const
    {
        return *m_rig->window.findChild<widgets::MotorForm *>(QStringLiteral("motorForm"));
    }
    widgets::Device &device() const { return m_rig->workbench.device(); }
    QPushButton *button(const char *name) const { return m_rig->find<QPushButton>(name); }
    QLineEdit *edit(const char *name) const { return m_rig->find<QLineEdit>(name); }
    QString label(const char *name) const { return m_rig->find<QLabel>(name)->text(); }
    QString text(const char *group, const char *key,
        MotorModel::Column column = MotorModel::ValueColumn) const
    {
        return rowOf(form().model(), QString::fromLatin1(group), QString::fromLatin1(key))
            .siblingAtColumn(column)
            .data()
            .toString();
    }
    void press(Qt::Key key, Qt::KeyboardModifiers with, QWidget *where = nullptr)
    {
        QTest::keyClick(where ? where : &m_rig->window, key, with);
    }
    void openFile(const char *content)
    {
        QFile file(m_folder.filePath(QStringLiteral("motor.json")));
        QVERIFY(file.open(QIODevice::WriteOnly) && file.write(content) > 0);
        file.close();
        m_rig->files.answer = file.fileName();
        button("motorOpen")->click();
    }

    QTemporaryDir m_folder;
    std::unique_ptr<facts::WindowRig> m_rig;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

QTEST_MAIN(TestMotorForm)
#include "tst_motor_form.moc"
