// What the register browser shows and how it is edited beyond numbers: columns, flags by name, two motors.
#include "mcb/dictionary.h"
#include "support/edit_bench.h"
#include "support/window_rig.h"

#include "widgets/registers/delegate.h"
#include "widgets/scope/view.h"

#include <QAbstractProxyModel>
#include <QApplication>
#include <QHelpEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QPainter>
#include <QRegularExpression>
#include <QTest>
#include <QToolTip>
#include <QTranslator>

#include <bit>
#include <set>

using facts::EditBench;
using widgets::RegisterModel;
using State = RegisterModel::EditState;

namespace {

QModelIndex cellOf(const EditBench &bench, std::string_view name, RegisterModel::Column column)
{
    return bench.model.indexOf(bench.id(name), column);
}

QString textOf(const EditBench &bench, std::string_view name, RegisterModel::Column column)
{
    return cellOf(bench, name, column).data().toString();
}

/// Selects a register in the tree, as a click on its value does.
void select(EditBench &bench, std::string_view name)
{
    QTreeView *tree = bench.panel.findChild<QTreeView *>();
    const auto *proxy = qobject_cast<const QAbstractProxyModel *>(tree->model());
    const QModelIndex cell = proxy->mapFromSource(cellOf(bench, name, RegisterModel::ValueColumn));
    tree->expand(cell.parent());
    tree->scrollTo(cell);
    tree->setCurrentIndex(cell);
}

simulation::BoardOptions twoMotors()
{
    simulation::BoardOptions options;
    options.motors = 2;
    return options;
}

} // namespace

class TestRegisterBrowser : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void namesThatAreCutStayDifferent()
    {
        EditBench bench;
        const auto *tree = bench.panel.findChild<QTreeView *>();
        const auto drawn = [&](std::string_view name) {
            QStyleOptionViewItem option;
            option.initFrom(tree);
            option.widget = tree;
            option.textElideMode = tree->textElideMode();
            option.rect = QRect(0, 0, 54, 20);
            QImage image(option.rect.size(), QImage::Format_RGB32);
            image.fill(Qt::white);
            QPainter painter(&image);
            tree->itemDelegate()->paint(
                &painter, option, cellOf(bench, name, RegisterModel::NameColumn));
            return image;
        };
        QVERIFY(tree->fontMetrics().horizontalAdvance(QStringLiteral("SPEED_KP")) > 54);
        QVERIFY(drawn("SPEED_KP") != drawn("SPEED_KI"));
        QVERIFY(drawn("SPEED_KP") == drawn("SPEED_KP"));
        QStyleOptionViewItem narrow;
        narrow.initFrom(tree);
        narrow.widget = tree;
        narrow.rect = QRect(0, 0, 54, 20);
        QHelpEvent pointed(QEvent::ToolTip, QPoint(10, 10), QPoint(10, 10));
        tree->itemDelegate()->helpEvent(&pointed, bench.panel.findChild<QTreeView *>(), narrow,
            cellOf(bench, "SPEED_KP", RegisterModel::NameColumn));
        QVERIFY2(
            QToolTip::text().startsWith(QStringLiteral("SPEED_KP")), qPrintable(QToolTip::text()));
        QToolTip::hideText();
    }

    /// Whole families begin and end alike: what is cut out must not be what tells them apart.
    void namesOfAFamilyStayDifferentToo()
    {
        widgets::NameElision elision;
        QStringList names;
        for (const mcb::Entry &entry : mcb::dictionary())
            names.append(QString::fromStdString(entry.name));
        names.removeDuplicates();
        QVERIFY(names.size() > 250);
        elision.setNames(names);
        const QFontMetrics metrics(QGuiApplication::font());
        int wide = 0;
        const auto cutTo = [&](const char *room, const QStringList &some) {
            const int width = metrics.horizontalAdvance(QLatin1String(room));
            QStringList texts;
            for (const QString &name : some)
                texts.append(elision.text(name, metrics, width));
            for (const QString &text : std::as_const(texts))
                wide += metrics.horizontalAdvance(text) > width ? 1 : 0;
            return texts;
        };
        const QStringList setPoints =
            names.filter(QRegularExpression(QStringLiteral("^CL_(CUR|VOL)_._SET_POINT$")));
        QCOMPARE(setPoints.size(), 6);
        QStringList texts = cutTo("CL_CUR_D_SET_P", setPoints);
        QCOMPARE(texts.removeDuplicates(), 0);
        QCOMPARE(texts.size(), 6);
        for (const QString &text : std::as_const(texts))
            QVERIFY2(text.contains(QChar(0x2026)), qPrintable(text));
        texts = cutTo("CL_POS_SET_POINT_VALUE", names); // of all, but for a few
        QVERIFY2(texts.size() == names.size() && texts.removeDuplicates() < 6,
            qPrintable(QString::number(texts.size())));
        QCOMPARE(cutTo("DRV_PROT_USER_UNDER_VOLT", setPoints), setPoints); // they are whole
        QCOMPARE(wide, 0);
    }

    /// Where the names of a board are long; those of another one leave the numbers their place.
    void namesAreReadBeforeRawNumbers()
    {
        EditBench bench;
        const auto *tree = bench.panel.findChild<QTreeView *>();
        bench.panel.resize(300, 500);
        bench.panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        const auto hasRaw = [tree] { return !tree->isColumnHidden(RegisterModel::RawColumn); };
        QTRY_VERIFY(hasRaw());
        std::vector<catalog::RegisterInfo> registers;
        std::set<std::string> names;
        for (const mcb::Entry &entry : mcb::dictionary())
            if (names.insert(entry.name).second)
                registers.push_back(facts::makeRegister(entry.address, entry.name, "Set-points"));
        const auto before = bench.model.catalog();
        bench.model.setCatalog(std::make_shared<const catalog::Catalog>(
                                   std::move(registers), 1, std::vector<catalog::Scales>{{}}),
            1);
        QVERIFY(!hasRaw());
        bench.panel.resize(460, 500);
        QTRY_VERIFY(hasRaw());
        bench.panel.resize(300, 500);
        QTRY_VERIFY(!hasRaw());
        bench.model.setCatalog(before, 1);
        QVERIFY(hasRaw());
    }

    void aNumberIsShownAsDigitsAndInHexadecimal()
    {
        EditBench bench;
        bench.arm();
        bench.type("SPEED_KP", QStringLiteral("-2"));
        QCOMPARE(textOf(bench, "SPEED_KP", RegisterModel::ValueColumn), QStringLiteral("-2"));
        QCOMPARE(textOf(bench, "SPEED_KP", RegisterModel::RawColumn), QStringLiteral("-2"));
        QCOMPARE(textOf(bench, "SPEED_KP", RegisterModel::HexColumn), QStringLiteral("0xFFFE"));
        QCOMPARE(textOf(bench, "SPEED_KP", RegisterModel::AccessColumn), QStringLiteral("RW"));
        QVERIFY(!textOf(bench, "SPEED_KP", RegisterModel::HelpColumn).isEmpty());
        QCOMPARE(textOf(bench, "SPEED_MEAS", RegisterModel::AccessColumn), QStringLiteral("R"));
        QVERIFY(!bench.model.editable(bench.id("SPEED_KP"), RegisterModel::HexColumn));
        QVERIFY(!bench.model.editable(bench.id("SPEED_KP"), RegisterModel::HelpColumn));
    }

    /// Cut off it would say less than it does with fewer digits: no unit, no power of ten.
    void aFloatIsRoundedToTheRoomOfItsColumn()
    {
        struct Seen : widgets::RegisterDelegate {
            using RegisterDelegate::initStyleOption;
            using RegisterDelegate::RegisterDelegate;
        };
        EditBench bench;
        const catalog::RegisterId power = bench.id("MOTOR_POWER");
        const auto shown = [&](RegisterModel::Column column, int width) {
            const Seen delegate(bench.model);
            QStyleOptionViewItem option;
            option.widget = bench.panel.findChild<QTreeView *>();
            option.font = bench.panel.font();
            option.rect = QRect(0, 0, width, 20);
            delegate.initStyleOption(&option, bench.model.indexOf(power, column));
            return option.text;
        };
        bench.model.accept({{power, drive::ReadStatus::Ok, 0.005509190, {}, {}}}, bench.ms());
        const QString whole = textOf(bench, "MOTOR_POWER", RegisterModel::ValueColumn);
        // measured: so many digits mean something
        QCOMPARE(whole, QStringLiteral("0.005509\u202fW"));
        const int wide = bench.panel.fontMetrics().horizontalAdvance(whole) + 20;
        const int digit = bench.panel.fontMetrics().horizontalAdvance(QLatin1Char('1'));
        QCOMPARE(shown(RegisterModel::ValueColumn, wide), whole);
        QCOMPARE(shown(RegisterModel::ValueColumn, wide - 20 - digit + 6),
            QStringLiteral("0.00551\u202fW"));
        QCOMPARE(shown(RegisterModel::ValueColumn, 10), QStringLiteral("0.00551\u202fW"));
        QCOMPARE(shown(RegisterModel::RawColumn, 10), QStringLiteral("0.0055"));
    }

    void theColumnsThatAreShownAreRemembered()
    {
        widgets::Settings settings = facts::WindowRig::quietSettings();
        settings.registerColumns = {QStringLiteral("hex"), QStringLiteral("access")};
        const facts::WindowRig rig(settings);
        widgets::RegisterPanel &panel = *rig.window.findChild<widgets::RegisterPanel *>();
        QVERIFY(panel.findChild<QTreeView *>()->isColumnHidden(RegisterModel::ValueColumn));
        QVERIFY(!panel.findChild<QTreeView *>()->isColumnHidden(RegisterModel::HexColumn));
        QVERIFY(!panel.findChild<QTreeView *>()->isColumnHidden(RegisterModel::NameColumn));
        auto *value = panel.columnsMenu()->findChild<QAction *>(QStringLiteral("value"));
        QVERIFY(value != nullptr);
        value->trigger();
        QVERIFY(!panel.findChild<QTreeView *>()->isColumnHidden(RegisterModel::ValueColumn));
        QCOMPARE(rig.window.settings().registerColumns,
            (QStringList{
                QStringLiteral("value"), QStringLiteral("hex"), QStringLiteral("access")}));
        QCOMPARE(widgets::settingsFromJson(widgets::toJson(rig.window.settings())).registerColumns,
            rig.window.settings().registerColumns);
    }

    void whatARegisterIsCanBeReadWithoutAMouse()
    {
        EditBench bench;
        bench.panel.resize(300, 600);
        bench.panel.show();
        const auto *details = bench.panel.findChild<QLabel *>(QStringLiteral("registerDetails"));
        QVERIFY(details->isHidden());
        select(bench, "SPEED_KP");
        QVERIFY(details->isVisible());
        QVERIFY2(
            details->text().startsWith(QStringLiteral("SPEED_KP \u00b7 RW \u00b7 -32768 to 32767")),
            qPrintable(details->text()));
        QVERIFY(details->text().contains(QLatin1Char('\n'))); // and its help
    }

    void aRegisterIsExplainedAndFoundInGermanAndFoundInEnglish()
    {
        QTranslator german;
        QVERIFY(german.load(QStringLiteral(":/i18n/registers_de.qm")));
        QCoreApplication::installTranslator(&german);
        EditBench bench;
        const auto *details = bench.panel.findChild<QLabel *>(QStringLiteral("registerDetails"));
        select(bench, "SPEED_KP");
        const QString word = QStringLiteral("Drehzahlregler");
        const QString help = textOf(bench, "SPEED_KP", RegisterModel::HelpColumn);
        QVERIFY2(help.contains(word), qPrintable(help));
        QVERIFY2(help.endsWith(QLatin1String("2^SPEED_KP_DIV")), qPrintable(help)); // all of it
        QVERIFY2(details->text().contains(word), qPrintable(details->text()));
        const QModelIndex cell = cellOf(bench, "SPEED_KP", RegisterModel::ValueColumn);
        QVERIFY(cell.data(Qt::ToolTipRole).toString().contains(word));
        auto *search = bench.panel.findChild<QLineEdit *>(QStringLiteral("registerSearch"));
        QVERIFY(search != nullptr);
        const auto *proxy = qobject_cast<const QAbstractProxyModel *>(
            bench.panel.findChild<QTreeView *>()->model());
        for (const char *typed : {"drehzahlregler", "speed regulator"}) {
            search->setText(QLatin1String(typed));
            QVERIFY2(proxy->mapFromSource(cell).isValid(), typed);
            QVERIFY2(!proxy->mapFromSource(cellOf(bench, "I_Q_KP", RegisterModel::ValueColumn))
                          .isValid(),
                typed);
        }
    }

    void theSearchTakesWordsGroupsAndGoesToTheBestHit()
    {
        EditBench bench;
        bench.panel.show();
        auto *search = bench.panel.findChild<QLineEdit *>(QStringLiteral("registerSearch"));
        auto *tree = bench.panel.findChild<QTreeView *>();
        const auto current = [tree] {
            return tree->currentIndex().siblingAtColumn(0).data().toString();
        };
        const auto found = [&](const char *name) {
            const auto *proxy = qobject_cast<const QAbstractProxyModel *>(tree->model());
            return proxy->mapFromSource(cellOf(bench, name, RegisterModel::ValueColumn)).isValid();
        };
        search->setText(QStringLiteral("id meas"));
        QVERIFY(found("I_D_MEAS"));
        QVERIFY(!found("I_Q_MEAS"));
        search->setText(QStringLiteral("speed loop")); // a group
        QVERIFY(found("SPEED_KP"));
        QVERIFY(!found("I_Q_KP"));
        search->setText(QStringLiteral("speed_kp")); // SPEED_KP_DIV has it, too
        QCOMPARE(current(), QStringLiteral("SPEED_KP"));
        search->setText(QStringLiteral("I_Q_K"));
        QVERIFY2(current().startsWith(QStringLiteral("I_Q_K")), qPrintable(current()));
        QTest::keyClick(search, Qt::Key_Down);
        QVERIFY(tree->currentIndex().siblingAtColumn(0).data(RegisterModel::IdRole).isValid());
    }

    void aRegisterIsPinnedByAKey()
    {
        EditBench bench;
        select(bench, "SPEED_KD");
        QVERIFY(!bench.model.pinned().contains(QStringLiteral("SPEED_KD")));
        bench.panel.actions().pin->trigger();
        QVERIFY(bench.model.pinned().contains(QStringLiteral("SPEED_KD")));
    }

    void flagsAreEditedAsNamesWithCheckBoxes()
    {
        simulation::BoardOptions options;
        options.profile = "six-step";
        EditBench bench(options);
        bench.panel.resize(400, 700);
        bench.panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&bench.panel));
        bench.arm();
        const auto before = std::get<std::int64_t>(bench.held("LOWSIDE_MODULATION"));
        select(bench, "LOWSIDE_MODULATION");
        bench.panel.editCurrent();
        auto *flags = bench.panel.findChild<QListWidget *>(QStringLiteral("registerFlags"));
        QVERIFY(flags != nullptr);
        QVERIFY(flags->count() >= 6);
        int checked = 0;
        for (int row = 0; row < flags->count(); ++row)
            checked += flags->item(row)->checkState() == Qt::Checked ? 1 : 0;
        QCOMPARE(checked, int(std::popcount(static_cast<std::uint64_t>(before))));
        flags->setCurrentRow(1);
        QTest::keyClick(flags, Qt::Key_Space);
        QTest::keyClick(flags, Qt::Key_Return);
        QTRY_VERIFY(bench.model.editState(bench.id("LOWSIDE_MODULATION")) == State::Pending);
        bench.answerYes = true;
        QVERIFY(bench.apply());
        QCOMPARE(std::get<std::int64_t>(bench.held("LOWSIDE_MODULATION")), before ^ 2);
    }

    void flagsThatNobodyTouchedAreNoEdit()
    {
        simulation::BoardOptions options;
        options.profile = "six-step";
        EditBench bench(options);
        bench.panel.show();
        select(bench, "LOWSIDE_MODULATION");
        bench.panel.editCurrent();
        auto *flags = bench.panel.findChild<QListWidget *>(QStringLiteral("registerFlags"));
        QVERIFY(flags != nullptr);
        QTest::keyClick(flags, Qt::Key_Return);
        QCoreApplication::processEvents();
        QVERIFY(!bench.model.hasEdits());
    }

    void inTheWindowTheSpaceBarSwitchesAFlagAndNotThePicture()
    {
        facts::WindowRig rig;
        QVERIFY(QTest::qWaitForWindowActive(&rig.window));
        session::Endpoint endpoint;
        endpoint.board = "six-step";
        rig.workbench.device().open(endpoint);
        QTRY_VERIFY_WITH_TIMEOUT(rig.workbench.device().identified().has_value(), 10000);
        widgets::RegisterModel &model = rig.workbench.registers();
        const auto id = *model.idOf("LOWSIDE_MODULATION");
        widgets::RegisterPanel &panel = *rig.window.findChild<widgets::RegisterPanel *>();
        panel.focusSearch();
        QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("LOWSIDE_MOD"));
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_Down);
        QCOMPARE(panel.findChild<QTreeView *>()
                     ->currentIndex()
                     .siblingAtColumn(0)
                     .data(RegisterModel::IdRole)
                     .toUInt(),
            quint32(id));
        QTRY_VERIFY_WITH_TIMEOUT(model.known(id).has_value(), 10000);
        // Keys that go through rows are the tree's, too, though the scope has them elsewhere.
        auto *tree = panel.findChild<QTreeView *>();
        const QModelIndex here = tree->currentIndex();
        panel.findChild<QLineEdit *>()->clear();
        QTRY_VERIFY(tree->model()->rowCount() > 5);
        const QModelIndex top = tree->model()->index(0, 0);
        for (const Qt::Key key : {Qt::Key_PageDown, Qt::Key_End}) {
            tree->setCurrentIndex(top);
            QTest::keyClick(tree, key);
            QVERIFY2(tree->currentIndex() != top, qPrintable(QKeySequence(key).toString()));
        }
        tree->setCurrentIndex(here);
        QTest::keyClick(QApplication::focusWidget(), Qt::Key_F2);
        auto *flags = qobject_cast<QListWidget *>(QApplication::focusWidget());
        QVERIFY(flags != nullptr);
        const Qt::CheckState before = flags->item(0)->checkState();
        const bool running = rig.window.scope()->running();
        QTest::keyClick(flags, Qt::Key_Space);
        QVERIFY(flags->item(0)->checkState() != before);
        QCOMPARE(rig.window.scope()->running(), running);
        QTest::keyClick(flags, Qt::Key_Return);
        QTRY_VERIFY(model.editState(id) == State::Pending);
    }

    void flagsThatWereNeverReadAreTypedAsAWhole()
    {
        simulation::BoardOptions options;
        options.profile = "six-step";
        EditBench bench(options);
        bench.panel.show();
        bench.model.setCatalog(nullptr, 1);
        bench.model.setCatalog(bench.device.catalog(), 1);
        QVERIFY(!bench.model.known(bench.id("LOWSIDE_MODULATION")));
        select(bench, "LOWSIDE_MODULATION");
        bench.panel.editCurrent();
        QVERIFY(bench.panel.findChild<QListWidget *>(QStringLiteral("registerFlags")) == nullptr);
        QVERIFY(bench.panel.findChild<QLineEdit *>(QStringLiteral("registerEntry")) != nullptr);
    }

    void editsOfTheOtherMotorWaitAndAreNamed()
    {
        EditBench bench(twoMotors());
        QObject::connect(&bench.device, &widgets::Device::motorChanged, &bench.panel,
            [&bench] { bench.model.setCatalog(bench.device.catalog(), bench.device.motor()); });
        bench.arm();
        const auto *told = bench.panel.findChild<QLabel *>(QStringLiteral("editsTold"));
        const auto two = std::get<std::int64_t>(bench.held("SPEED_KP@2"));
        QVERIFY(bench.type("SPEED_KP@1", QStringLiteral("71")));
        QVERIFY(!told->text().contains(QStringLiteral("not shown")));
        bench.device.setMotor(2);
        QCOMPARE(bench.edits.pendingCount(), 1);
        QVERIFY2(told->text().contains(QStringLiteral("not shown: SPEED_KP@1")),
            qPrintable(told->text()));
        QVERIFY(bench.type("SPEED_KI@2", QStringLiteral("72")));
        bench.device.setMotor(1);
        QCOMPARE(textOf(bench, "SPEED_KP@1", RegisterModel::RawColumn), QStringLiteral("71"));
        QVERIFY(bench.model.editState(bench.id("SPEED_KP@1")) == State::Pending);
        QVERIFY(told->text().contains(QStringLiteral("not shown: SPEED_KI@2")));
        QVERIFY(bench.apply()); // both, and no other
        QCOMPARE(std::get<std::int64_t>(bench.held("SPEED_KP@1")), 71);
        QCOMPARE(std::get<std::int64_t>(bench.held("SPEED_KI@2")), 72);
        QCOMPARE(std::get<std::int64_t>(bench.held("SPEED_KP@2")), two);
        QVERIFY(!told->text().contains(QStringLiteral("not shown")));
        bench.device.setMotor(2);
        bench.edits.undo();
        QVERIFY(bench.settle());
        QVERIFY(std::get<std::int64_t>(bench.held("SPEED_KP@1")) != 71);
    }

    void whatCannotBeSeenIsNotPolled()
    {
        facts::WindowRig rig;
        rig.workbench.device().open({});
        QTRY_VERIFY_WITH_TIMEOUT(rig.workbench.device().identified().has_value(), 10000);
        const auto &watch = rig.workbench.watchList();
        const auto id = rig.workbench.device().catalog()->resolve("SPEED_KD").value_or(0);
        const auto polled = [&] {
            return std::find(watch.registers().begin(), watch.registers().end(), id)
                != watch.registers().end();
        };
        QTRY_VERIFY(!watch.registers().empty());
        QVERIFY(!polled()); // its group is closed
        widgets::RegisterPanel &panel = *rig.window.findChild<widgets::RegisterPanel *>();
        const auto *proxy =
            qobject_cast<const QAbstractProxyModel *>(panel.findChild<QTreeView *>()->model());
        const QModelIndex cell = proxy->mapFromSource(rig.workbench.registers().indexOf(id));
        panel.findChild<QTreeView *>()->expand(cell.parent());
        panel.findChild<QTreeView *>()->scrollTo(cell);
        QTRY_VERIFY(polled());
        panel.findChild<QTreeView *>()->collapse(cell.parent());
        QTRY_VERIFY(!polled());
        panel.findChild<QTreeView *>()->expand(cell.parent());
        QTRY_VERIFY(polled());
        panel.window()->hide();
        panel.hide();
        QTRY_VERIFY(!polled());
    }
};

QTEST_MAIN(TestRegisterBrowser)
#include "tst_register_browser.moc"
