// What the user types into a register, strictly read, and the editors it is typed into.
#include "catalog/names.h"
#include "support/edit_bench.h"
#include "widgets/registers/delegate.h"
#include "widgets/registers/entry_edit.h"

#include <QAbstractItemModelTester>
#include <QAbstractProxyModel>
#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QLineEdit>
#include <QListWidget>
#include <QPointer>
#include <QTest>
#include <QTranslator>
#include <QWheelEvent>

using catalog::Value;
using facts::EditBench;
using widgets::EntryError;
using widgets::RegisterModel;

namespace {

const QList<QLocale> kLocales{
    QLocale::c(), QLocale(QLocale::German), QLocale(QLocale::Turkish), QLocale(QLocale::Arabic)};

void turnWheel(QWidget *widget, int notches)
{
    const QPointF at = QRectF(widget->rect()).center();
    QWheelEvent wheel(at, widget->mapToGlobal(at), {}, {0, notches * 120}, Qt::NoButton,
        Qt::NoModifier, Qt::NoScrollPhase, false);
    QCoreApplication::sendEvent(widget, &wheel);
}

/// Any character; QTest knows the keys of ASCII only.
void typeText(QWidget *widget, const QString &text)
{
    for (const QChar c : text) {
        QKeyEvent press(QEvent::KeyPress, Qt::Key_unknown, Qt::NoModifier, QString(c));
        QCoreApplication::sendEvent(widget, &press);
    }
}

} // namespace

class TestRegisterEntry : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void init() { QLocale::setDefault(QLocale::c()); }

    void aStepTakesNoSelectionAway()
    {
        catalog::RegisterInfo info;
        info.type = catalog::ValueType::S16;
        info.access = catalog::Access::ReadWrite;
        QWidget window;
        widgets::EntryEdit edit(
            [&info] {
                return widgets::EntryRules{&info, {}, {-1000.0, 1000.0}};
            },
            widgets::EntryEdit::As::Shown, &window);
        edit.setText(QStringLiteral("150"));
        edit.setFocus();
        edit.selectAll();
        QTest::keyClick(&edit, Qt::Key_Up);
        QCOMPARE(edit.selectedText(), QStringLiteral("151"));
        QTest::keyClicks(&edit, QStringLiteral("26"));
        QCOMPARE(edit.text(), QStringLiteral("26"));
    }

    void textIsReadTheSameInEveryLocale_data()
    {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        QTest::addColumn<bool>("ok");
        QTest::addColumn<qint64>("raw");
        const auto good = [](const char *name, const char *text, qint64 raw) {
            QTest::addRow("%s %s", name, text)
                << QString::fromLatin1(name) << QString::fromUtf8(text) << true << raw;
        };
        const auto bad = [](const char *name, const char *text) {
            QTest::addRow("%s %s", name, text)
                << QString::fromLatin1(name) << QString::fromUtf8(text) << false << qint64(0);
        };
        good("SPEED_KP", "1500", 1500);
        good("SPEED_KP", "-32768", -32768);
        good("SPEED_KP", "\u22125", -5);
        good("SPEED_KP", "1500.4", 1500);
        good("SPEED_REF", "600", 600);
        good("SPEED_REF", "600 rpm", 600);
        good("SPEED_REF", "600RPM", 600);
        good("FLUXWK_BUS", "55,4", 55);
        good("CONTROL_MODE", "torque", 4);
        good("CONTROL_MODE", "Torque", 4);
        good("CONTROL_MODE", "3", 3);
        good("LOWSIDE_MODULATION", "step 1 | step 3", 5);
        good("LOWSIDE_MODULATION", "0x3F", 0x3F);
        good("LOWSIDE_MODULATION", "none", 0);
        good("OPENLOOP", "yes", 1);
        good("OPENLOOP", "0", 0);
        for (const char *text : {"", " ", "1e3", "1.234,5", "1,234,567", "1'000", "1 000", "nan",
                 "inf", "-inf", "0x", "--5", "-", ".", "5 V", "1_0", "32768", "-32769",
                 "99999999999", "\u0661\u0662", "NaN(7)", "+-3", "1 rpm rpm"})
            bad("SPEED_KP", text);
        for (const char *text : {"torq", "8", "-1", "0x105", "3.5", "nan", "3 4"})
            bad("CONTROL_MODE", text);
        for (const char *text : {"0x40", "64", "step 9", "step 1 |", "-1"})
            bad("LOWSIDE_MODULATION", text);
        bad("OPENLOOP", "2");
        bad("OPENLOOP", "maybe");
        bad("SPEED_KP_DIV", "16");
    }
    void textIsReadTheSameInEveryLocale()
    {
        QFETCH(QString, name);
        QFETCH(QString, text);
        QFETCH(bool, ok);
        QFETCH(qint64, raw);
        EditBench bench;
        for (const QLocale &locale : kLocales) {
            QLocale::setDefault(locale);
            const auto read = bench.model.readEntry(
                bench.id(name.toStdString()), RegisterModel::ValueColumn, text);
            QCOMPARE(read.has_value(), ok);
            if (ok)
                QVERIFY(*read == Value(raw));
        }
    }

    void rawDigitsAndHexadecimalOnesAreRead()
    {
        EditBench bench;
        const auto read = [&](const char *name, const char *text) {
            return bench.model.readEntry(
                bench.id(name), RegisterModel::RawColumn, QString::fromLatin1(text));
        };
        QVERIFY(read("SPEED_KP", "0xFFFF").value() == Value(std::int64_t{-1}));
        QVERIFY(read("SPEED_KP", "0x7fff").value() == Value(std::int64_t{0x7FFF}));
        QVERIFY(!read("SPEED_KP", "0x10000"));
        QVERIFY(!read("SPEED_KP", "1.5"));
        QVERIFY(!read("SPEED_KP", "0xG"));
        QVERIFY(!read("SC_CURRENT", "0x10"));
        QVERIFY(read("SC_CURRENT", "1,5").value() == Value(1.5));
        QVERIFY(read("REVUP_DATA", "00 01 fe").value() == Value(Bytes{0, 1, 0xFE}));
        QVERIFY(read("REVUP_DATA", "0").error() == EntryError::NotBytes);
        QVERIFY(read("REVUP_DATA", "zz").error() == EntryError::NotBytes);
    }

    void whatAnEditorBeginsWithReadsBackAsTheSameValue()
    {
        EditBench bench;
        support::Random random(7);
        for (const QLocale &locale : kLocales) {
            QLocale::setDefault(locale);
            for (const auto &info : bench.device.catalog()->registers()) {
                const auto id = bench.device.catalog()->withMotor(info, 1);
                const auto rules = bench.model.rulesOf(id);
                if (!rules || catalog::widthOf(info.type) == 0)
                    continue;
                for (int i = 0; i < 20; ++i) {
                    const double part = static_cast<double>(random.below(1000001)) / 1e6;
                    const double raw =
                        rules->limits.least * (1.0 - part) + rules->limits.greatest * part;
                    const Value value = catalog::isInteger(info.type)
                        ? Value(static_cast<std::int64_t>(raw))
                        : Value(static_cast<double>(static_cast<float>(part * 1000.0)));
                    if (!catalog::refuseValue(info, value).empty())
                        continue;
                    const auto shown = bench.model.readEntry(
                        id, RegisterModel::ValueColumn, widgets::shownEntryText(value, *rules));
                    QVERIFY2(shown && *shown == value, info.name.c_str());
                    const auto digits = bench.model.readEntry(
                        id, RegisterModel::RawColumn, widgets::rawEntryText(value));
                    QVERIFY2(digits && *digits == value, info.name.c_str());
                }
            }
        }
    }

    void aValueThatArrivesDoesNotReplaceWhatIsTyped()
    {
        EditBench bench;
        auto *editor = open<widgets::EntryEdit>(bench, "SPEED_KP");
        QVERIFY(editor);
        QTest::keyClicks(editor, QStringLiteral("15"));
        bench.model.accept({facts::reading(bench.id("SPEED_KP"), std::int64_t{4711})}, bench.ms());
        QCOMPARE(editor->text(), QStringLiteral("15"));
        QCOMPARE(bench.edits.pendingCount(), 0); // nothing leaves while the user types
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(bench.edits.pendingCount(), 1);
        QVERIFY(bench.model.pending().front().value == Value(std::int64_t{15}));
    }

    void anEditorLeftUntouchedIsNoEdit()
    {
        EditBench bench;
        auto *editor = open<widgets::EntryEdit>(bench, "SPEED_KP");
        bench.model.accept({facts::reading(bench.id("SPEED_KP"), std::int64_t{4711})}, bench.ms());
        const QPointer<QWidget> open = editor;
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_VERIFY(!open);
        QCOMPARE(bench.edits.pendingCount(), 0);
    }

    void enterDoesNotTakeATextThatIsNotGood()
    {
        EditBench bench;
        auto *editor = open<widgets::EntryEdit>(bench, "SPEED_KP");
        QTest::keyClicks(editor, QStringLiteral("1.234,5"));
        QTest::keyClick(editor, Qt::Key_Return);
        QVERIFY(editor->isVisible());
        QVERIFY(!editor->problem().isEmpty());
        QVERIFY(!bench.model.hasEdits());
    }

    void namesAreChosenFromAList()
    {
        EditBench bench;
        auto *box = open<QComboBox>(bench, "CONTROL_MODE");
        QVERIFY(box);
        QVERIFY(box->findText(QStringLiteral("torque")) >= 0);
        box->setCurrentText(QStringLiteral("torque"));
        bench.panel.findChild<QTreeView *>()->setFocus();
        QTRY_COMPARE(bench.edits.pendingCount(), 1);
        QVERIFY(bench.model.pending().front().value == Value(std::int64_t{4}));
        const QModelIndex cell =
            bench.model.indexOf(bench.id("CONTROL_MODE"), RegisterModel::ValueColumn);
        QCOMPARE(cell.data().toString(), QStringLiteral("torque"));
    }

    void namesAreInThePersonsLanguageAndTypedInEnglishToo()
    {
        QTranslator german;
        QVERIFY(german.load(QStringLiteral(":/i18n/registers_de.qm")));
        QCoreApplication::installTranslator(&german);
        simulation::BoardOptions options;
        options.profile = "six-step";
        EditBench bench(options);
        auto *box = open<QComboBox>(bench, "CONTROL_MODE");
        QVERIFY(box && box->findText(QStringLiteral("torque")) < 0);
        QVERIFY(box->currentIndex() >= 0); // what the board holds is among them
        box->setCurrentText(QStringLiteral("Drehmoment"));
        bench.panel.findChild<QTreeView *>()->setFocus();
        QTRY_COMPARE(bench.edits.pendingCount(), 1);
        QVERIFY(bench.model.pending().front().value == Value(std::int64_t{4}));
        const QModelIndex cell =
            bench.model.indexOf(bench.id("CONTROL_MODE"), RegisterModel::ValueColumn);
        QCOMPARE(cell.data().toString(), QStringLiteral("Drehmoment"));
        const drive::RegisterId steps = bench.id("LOWSIDE_MODULATION");
        for (const char *typed : {"step 2 | Schritt 4", "SCHRITT 2, step 4"}) {
            const auto read =
                bench.model.readEntry(steps, RegisterModel::ValueColumn, QLatin1String(typed));
            QVERIFY2(read && *read == Value(std::int64_t{0x0A}), typed);
        }
        QVERIFY(bench.type("LOWSIDE_MODULATION", QStringLiteral("10")));
        QCOMPARE(bench.model.indexOf(steps, RegisterModel::ValueColumn).data().toString(),
            QStringLiteral("Schritt 2 | Schritt 4"));
    }

    void keysAndTheFocusedWheelStepWithinTheLimits()
    {
        EditBench bench;
        auto *editor = open<widgets::EntryEdit>(bench, "SPEED_KP_DIV");
        editor->setText(QStringLiteral("14"));
        QTest::keyClick(editor, Qt::Key_Up);
        QCOMPARE(editor->text(), QStringLiteral("15"));
        QTest::keyClick(editor, Qt::Key_PageUp);
        QCOMPARE(editor->text(), QStringLiteral("15"));
        turnWheel(editor, -1);
        QCOMPARE(editor->text(), QStringLiteral("14"));
        widgets::EntryEdit aside([&bench] { return bench.model.rulesOf(bench.id("SPEED_KP")); },
            widgets::EntryEdit::As::Shown, &bench.panel);
        aside.setText(QStringLiteral("5"));
        turnWheel(&aside, 1);
        QCOMPARE(aside.text(), QStringLiteral("5"));
    }

    void registersAreCopiedAsText()
    {
        EditBench bench;
        open<widgets::EntryEdit>(bench, "SPEED_KP");
        bench.type("SPEED_KP", QStringLiteral("21"));
        bench.panel.copySelected();
        QCOMPARE(QGuiApplication::clipboard()->text(), QStringLiteral("SPEED_KP\t21\t21"));
    }

    void whateverIsTypedNothingOutsideTheLimitsIsWritten_data()
    {
        QTest::addColumn<std::string>("profile");
        QTest::newRow("field-oriented control") << std::string("mcsdk-6.4");
        QTest::newRow("six-step control, with flags") << std::string("six-step");
    }
    void whateverIsTypedNothingOutsideTheLimitsIsWritten();

private:
    /// The editor of a cell in the real tree.
    template <class Editor>
    static Editor *open(EditBench &bench, const char *name, int column = RegisterModel::ValueColumn)
    {
        return qobject_cast<Editor *>(openCell(bench, bench.id(name), column));
    }
    static QWidget *openCell(EditBench &bench, drive::RegisterId id, int column)
    {
        bench.panel.resize(420, 600);
        bench.panel.show();
        bench.panel.activateWindow();
        if (!QTest::qWaitForWindowActive(&bench.panel))
            return nullptr;
        QTreeView *tree = bench.panel.findChild<QTreeView *>();
        const QModelIndex source =
            bench.model.indexOf(id, static_cast<RegisterModel::Column>(column));
        const auto *proxy = qobject_cast<QAbstractProxyModel *>(tree->model());
        const QModelIndex cell = proxy->mapFromSource(source);
        if (!cell.flags().testFlag(Qt::ItemIsEditable))
            return nullptr;
        tree->expand(cell.parent());
        tree->scrollTo(cell);
        tree->setCurrentIndex(cell);
        bench.panel.editCurrent();
        return tree->indexWidget(cell);
    }
};

void TestRegisterEntry::whateverIsTypedNothingOutsideTheLimitsIsWritten()
{
    QFETCH(std::string, profile);
    const int rounds = qEnvironmentVariableIntValue("ROTORSCOPE_LONG") != 0 ? 10000 : 100;
    const auto seed =
        static_cast<std::uint64_t>(qEnvironmentVariableIntValue("ROTORSCOPE_SEED")) + 1;
    support::Random random(seed);
    const char *texts[] = {"nan", "NaN", "inf", "-inf", "1e999", "1e3", "1.234,5", "1'000", "1.234",
        "1,5", "-1", "0", "-0", "0x7FFF", "0xFFFF", "0xFFFFFFFF", "99999999999999999999", "65536",
        "-32769", "4294967296", "\u0661\u0662\u0663", "yes", "torque", "step 1 | step 2", "none",
        "3.5 A", "600 rpm", "600 V", "", " ", "+", "\u221212", "1\n2", "=1+1", "1\u00a0000", "1e",
        "0.1", "15", "16", "255", "256", "ff 00 ff", "I", "\u0131", "\u0130NF"};
    const QList<QLocale> locales{QLocale::c(), QLocale(QLocale::German), QLocale(QLocale::Turkish)};
    simulation::BoardOptions options;
    options.profile = profile;
    EditBench bench(options);
    QAbstractItemModelTester tester(
        &bench.model, QAbstractItemModelTester::FailureReportingMode::QtTest);
    bench.answerYes = true;
    bench.arm();
    std::vector<drive::RegisterId> ids;
    for (const auto &[id, value] : bench.readAll())
        if (bench.model.editable(id, RegisterModel::RawColumn))
            ids.push_back(id);
    int opened = 0, lists = 0;
    for (int round = 0; round < rounds; ++round) {
        QLocale::setDefault(locales[static_cast<qsizetype>(random.below(3))]);
        const auto id = ids[random.below(ids.size())];
        QWidget *editor = openCell(
            bench, id, random.chance(0.5) ? RegisterModel::ValueColumn : RegisterModel::RawColumn);
        if (!editor)
            continue;
        ++opened;
        auto *flags = qobject_cast<QListWidget *>(editor);
        lists += flags != nullptr ? 1 : 0;
        for (std::uint64_t act = 0; act < 1 + random.below(4); ++act) {
            const QString text = QString::fromUtf8(texts[random.below(std::size(texts))]);
            switch (random.below(5)) {
            case 0:
                typeText(editor, text.simplified());
                break;
            case 1:
                QGuiApplication::clipboard()->setText(text);
                QTest::keySequence(editor, QKeySequence::Paste);
                break;
            case 2:
                turnWheel(editor, static_cast<int>(random.below(41)) - 20);
                break;
            case 3:
                QTest::keyClick(editor, random.chance(0.5) ? Qt::Key_PageUp : Qt::Key_Down);
                break;
            default:
                if (flags != nullptr) {
                    flags->setCurrentRow(
                        static_cast<int>(random.below(static_cast<std::uint64_t>(flags->count()))));
                    QTest::keyClick(flags, Qt::Key_Space);
                }
                if (auto *edit = qobject_cast<QLineEdit *>(editor))
                    edit->setText(
                        QString::number(static_cast<qint64>(random.next() >> random.below(64))));
                break;
            }
        }
        if (random.chance(0.7))
            QTest::keyClick(editor, Qt::Key_Return);
        // What is good is taken over, what is not is told.
        bench.panel.findChild<QTreeView *>()->setFocus();
        QCoreApplication::processEvents();
        for (const drive::RegisterWrite &write : bench.model.pending())
            QVERIFY2(
                catalog::refuseValue(*bench.device.catalog()->find(write.id), write.value).empty(),
                qPrintable(QStringLiteral("seed %1 round %2").arg(seed).arg(round)));
        if (random.chance(0.5)) {
            QVERIFY2(bench.apply(),
                qPrintable(QStringLiteral("seed %1 round %2: %3, link %4, questions %5")
                               .arg(seed)
                               .arg(round)
                               .arg(bench.edits.writeHint())
                               .arg(static_cast<int>(bench.link.link))
                               .arg(bench.questions)));
            bench.model.forgetEdits();
        } else if (random.chance(0.2)) {
            bench.edits.undo();
            QVERIFY(bench.settle());
        }
        for (const drive::Write &write : std::exchange(bench.writes, {}))
            for (const drive::RegisterWrite &one : write.writes) {
                const auto rules = bench.model.rulesOf(one.id);
                const double raw = std::holds_alternative<std::int64_t>(one.value)
                    ? static_cast<double>(std::get<std::int64_t>(one.value))
                    : std::holds_alternative<double>(one.value) ? std::get<double>(one.value)
                                                                : rules->limits.least;
                QVERIFY2(std::isfinite(raw) && rules->limits.holds(raw),
                    qPrintable(QStringLiteral("seed %1 round %2").arg(seed).arg(round)));
            }
    }
    QVERIFY(opened > rounds / 2);
    QVERIFY(lists > 0 || profile != "six-step");
    QVERIFY(bench.edits.steps().count() > 0);
}

QTEST_MAIN(TestRegisterEntry)
#include "tst_register_entry.moc"
