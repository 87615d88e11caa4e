// Every model of the program under QAbstractItemModelTester, in the real window on simulated boards, through all that
// makes models change: connecting, editing, refusal, another motor, another board, a cable that is pulled.
#include "support/places.h"
#include "support/window_rig.h"
#include "widgets/registers/panel.h"
#include "widgets/scope/cursor_actions.h"
#include "widgets/scope/view.h"

#include <QAbstractItemModelTester>
#include <QAbstractItemView>
#include <QAbstractProxyModel>
#include <QCheckBox>
#include <QDirIterator>
#include <QDockWidget>
#include <QFile>
#include <QPointer>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

using facts::WindowRig;
using State = widgets::RegisterModel::EditState;

namespace {

/// All models that the window shows or owns, and what stands behind them.
QSet<QAbstractItemModel *> modelsOf(WindowRig &rig)
{
    QSet<QAbstractItemModel *> models{&rig.workbench.registers()};
    for (QAbstractItemModel *model : rig.window.findChildren<QAbstractItemModel *>())
        models.insert(model);
    for (const QAbstractItemView *view : rig.window.findChildren<QAbstractItemView *>())
        for (QAbstractItemModel *model = view->model(); model != nullptr;) {
            models.insert(model);
            const auto *proxy = qobject_cast<QAbstractProxyModel *>(model);
            model = proxy != nullptr ? proxy->sourceModel() : nullptr;
        }
    return models;
}

/// Class and base of every model that the sources of the window define.
QList<std::pair<QString, QString>> modelClasses()
{
    static const QRegularExpression definition(
        QStringLiteral("^class (?!RowTable\\b)(\\w+)(?: final)? : public (Q\\w+Model|RowTable)\\b"),
        QRegularExpression::MultilineOption);
    QList<std::pair<QString, QString>> classes;
    QDirIterator files(support::sourceFile(QStringLiteral("widgets")),
        {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
        QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly))
            return {};
        for (auto found = definition.globalMatch(QString::fromUtf8(file.readAll()));
             found.hasNext();) {
            const QRegularExpressionMatch match = found.next();
            classes.append({match.captured(1), match.captured(2)});
        }
    }
    return classes;
}

struct Bench {
    WindowRig rig;
    widgets::Device &device = rig.workbench.device();
    widgets::RegisterModel &registers = rig.workbench.registers();
    QSet<QString> names;
    QList<QPointer<QAbstractItemModel>> tested;
    static constexpr auto reporting = QAbstractItemModelTester::FailureReportingMode::QtTest;

    Bench()
    {
        for (QDockWidget *dock : rig.window.findChildren<QDockWidget *>())
            dock->show();
        rig.window.scope()
            ->cursorActions()
            .toggle(); // their table is made when they are first shown
        for (QAbstractItemModel *model : modelsOf(rig)) {
            const QString name = QString::fromLatin1(model->metaObject()->className());
            if (!name.startsWith(QStringLiteral("widgets::"))
                && qobject_cast<QAbstractProxyModel *>(model) == nullptr)
                continue; // a combo box's own list, a file dialog's: Qt's business
            names.insert(name);
            test(model);
        }
    }
    /// Walks all of a model at every change of its shape. A tester walks it at every change of a value, too, which
    /// keeps a slow window from answering until its arming is refused: values get a check of their range instead,
    /// and each step of the test ends with a walk.
    void test(QAbstractItemModel *model)
    {
        auto *tester = new QAbstractItemModelTester(model, reporting, &rig.window);
        QObject::disconnect(model, &QAbstractItemModel::dataChanged, tester, nullptr);
        QObject::connect(model, &QAbstractItemModel::dataChanged, tester,
            [model](const QModelIndex &first, const QModelIndex &last) {
                constexpr auto rules = QAbstractItemModel::CheckIndexOption::IndexIsValid;
                QVERIFY(model->checkIndex(first, rules) && model->checkIndex(last, rules));
                QVERIFY(first.parent() == last.parent());
                QVERIFY(first.row() <= last.row() && first.column() <= last.column());
            });
        tested.append(model);
    }
    void walk() const
    {
        for (const auto &model : tested)
            if (model != nullptr)
                const QAbstractItemModelTester walked(model, reporting);
    }
    void open(const char *profile, int motors)
    {
        session::Endpoint endpoint;
        endpoint.board = profile;
        endpoint.boardMotors = motors;
        device.open(endpoint);
    }
    bool connected() const { return device.answering() && device.identified().has_value(); }
    catalog::RegisterId id(const char *name) const
    {
        return device.catalog()->resolve(name).value_or(0);
    }
    bool type(const char *name, const QString &text)
    {
        return registers.setData(
            registers.indexOf(id(name), widgets::RegisterModel::ValueColumn), text);
    }
};

} // namespace

class TestModels : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void everyModelKeepsItsWordWhateverTheBoardDoes()
    {
        Bench bench;
        const auto classes = modelClasses();
        QVERIFY(classes.size() >= 9);
        for (const auto &[name, base] : classes) // one in a .cpp file goes by its base's name
            QVERIFY2(bench.names.contains(QStringLiteral("widgets::") + name)
                    || bench.names.contains(base),
                qPrintable(name + QStringLiteral(" is not tested here")));

        bench.open("mcsdk-6.4", 2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.connected(), 10000);
        QTRY_VERIFY_WITH_TIMEOUT(bench.registers.known(bench.id("SPEED_KP")).has_value(), 10000);
        bench.walk();
        // Made late by a slow start or a walk, an act does not arm: the next one does.
        QCheckBox *arm = bench.rig.find<QCheckBox>("arm");
        const auto arms = [&] {
            if (!bench.device.armed() && !arm->isChecked())
                QTest::keyClick(arm, Qt::Key_Space);
            return bench.device.armed();
        };
        QTRY_VERIFY_WITH_TIMEOUT(arms(), 10000);
        bench.rig.boards.act(judge::Act::Kind::Arm);
        QVERIFY(bench.type("SPEED_KP", QStringLiteral("77")));
        QVERIFY(bench.type("SPEED_KI", QStringLiteral("78")));
        // Not in this build, which is not known yet: the board will refuse it.
        const bool asked = bench.registers.setPending(bench.id("FF_2"), std::int64_t{3});
        bench.rig.boards.act(judge::Act::Kind::Input);
        bench.rig.workbench.edits().apply();
        QTRY_VERIFY_WITH_TIMEOUT(!bench.rig.workbench.edits().underWay(), 20000);
        QTRY_VERIFY(bench.registers.editState(bench.id("SPEED_KP")) == State::Verified
            || bench.registers.editState(bench.id("SPEED_KP")) == State::None);
        QVERIFY(!asked || bench.registers.editState(bench.id("FF_2")) == State::Refused);
        bench.walk();

        bench.device.setMotor(2);
        QTRY_VERIFY_WITH_TIMEOUT(bench.registers.known(bench.id("SPEED_KP@2")).has_value(), 10000);
        bench.registers.togglePinned(bench.id("SPEED_KP@2"));
        bench.rig.window.findChild<widgets::RegisterPanel *>()->setColumns({QStringLiteral("hex")});
        QVERIFY(bench.type("SPEED_KP@2", QStringLiteral("5")));
        bench.rig.workbench.edits().revert();
        bench.walk();

        bench.open("six-step", 1); // another board on the same port
        QTRY_VERIFY_WITH_TIMEOUT(
            bench.connected() && bench.device.identified()->identity.motors == 1, 10000);
        bench.device.portChanged(session::PortState::Closed,
            {session::PortProblem::Unplugged, QStringLiteral("pulled")});
        QVERIFY(!bench.device.portOpen());
        bench.walk();
    }
};

QTEST_MAIN(TestModels)
#include "tst_models.moc"
