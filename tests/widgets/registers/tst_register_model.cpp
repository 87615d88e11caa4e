#include "support/window_facts.h"
#include "widgets/base/register_texts.h"
#include "widgets/registers/model.h"
#include "widgets/scope/view.h"

#include <QAbstractItemModelTester>
#include <QJsonArray>
#include <QJsonDocument>
#include <QMimeData>
#include <QSignalSpy>
#include <QSortFilterProxyModel>
#include <QTest>

using namespace std::chrono_literals;
using widgets::RegisterModel;

class TestRegisterModel : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init()
    {
        m_model = std::make_unique<RegisterModel>();
        m_tester = std::make_unique<QAbstractItemModelTester>(
            m_model.get(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        m_model->setPinned({QStringLiteral("BUS_VOLTAGE")});
        m_model->setCatalog(facts::smallCatalog(), 1);
    }
    void cleanup()
    {
        m_tester.reset();
        m_model.reset();
    }

    void groupsComeInTheTablesOrderThePinnedOnesFirst()
    {
        QStringList groups;
        for (int row = 0; row < m_model->rowCount(); ++row)
            groups.append(m_model->index(row, 0).data().toString());
        QCOMPARE(groups,
            QStringList({QStringLiteral("Pinned"), QStringLiteral("Speed loop"),
                QStringLiteral("Current loop"), QStringLiteral("Observer"),
                QStringLiteral("Measurements"), QStringLiteral("Board")}));
        QCOMPARE(m_model->rowCount(m_model->index(0, 0)), 1);
    }

    void stubsAreNotShown() { QVERIFY(!m_model->indexOf(0x999).isValid()); }

    void aValueIsShownInItsUnitAndRaw()
    {
        m_model->accept({facts::reading(facts::kCurrentA, std::int64_t{500})}, 0ms);
        QCOMPARE(shown(facts::kCurrentA), QStringLiteral("1.000\u202fA"));
        QCOMPARE(m_model->indexOf(facts::kCurrentA, RegisterModel::RawColumn).data().toString(),
            QStringLiteral("500"));
        QCOMPARE(m_model->shownValue(facts::kCurrentA), std::optional(1.0));
    }

    void flagsAreShownByName()
    {
        m_model->accept({facts::reading(facts::kFlags, std::int64_t{0x00020041})}, 0ms);
        QCOMPARE(
            shown(facts::kFlags), QStringLiteral("now: OVER_VOLT; past: DURATION | OVER_CURR"));
        m_model->accept({facts::reading(facts::kFlags, std::int64_t{0})}, 0ms);
        QCOMPARE(shown(facts::kFlags), QStringLiteral("none"));
    }

    void aPinnedRegisterChangesInBothPlaces()
    {
        QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        m_model->accept({facts::reading(facts::kVoltage, std::int64_t{24})}, 0ms);
        QCOMPARE(changed.size(), 2);
        QCOMPARE(
            m_model->index(0, RegisterModel::ValueColumn, m_model->index(0, 0)).data().toString(),
            QStringLiteral("24\u202fV"));
    }

    void whatComesTogetherIsOneChangeAGroup()
    {
        QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        m_model->accept({facts::reading(facts::kCurrentB, std::int64_t{7}),
                            facts::reading(facts::kCurrentA, std::int64_t{5})},
            0ms);
        QCOMPARE(changed.size(), 1);
        for (const auto id : {facts::kCurrentA, facts::kCurrentB}) {
            const QModelIndex mine = m_model->indexOf(id);
            const auto from = changed.at(0).at(0).toModelIndex();
            const auto to = changed.at(0).at(1).toModelIndex();
            QVERIFY(mine.parent() == from.parent() && from.row() <= mine.row()
                && mine.row() <= to.row());
        }
    }

    void aValueOlderThanThreePeriodsIsStale()
    {
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{1500})}, 1000ms);
        m_model->refresh(1300ms);
        QVERIFY(!stale(facts::kSpeed));
        m_model->refresh(1301ms);
        QVERIFY(stale(facts::kSpeed));
        QVERIFY(!m_model->shownValue(facts::kSpeed));
        QVERIFY(m_model->indexOf(facts::kSpeed, RegisterModel::ValueColumn)
                    .data(Qt::ForegroundRole)
                    .isValid());
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{1506})}, 1400ms);
        QVERIFY(!stale(facts::kSpeed));
    }

    void aSlowLinkIsGivenThePeriodThatItReaches()
    {
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{1})}, 0ms);
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{2})}, 400ms);
        m_model->refresh(1500ms);
        QVERIFY(!stale(facts::kSpeed));
        m_model->refresh(1700ms);
        QVERIFY(stale(facts::kSpeed));
    }

    void timeInWhichNobodyAskedIsNoPeriod()
    {
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{1})}, 0ms);
        m_model->refresh(400ms);
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{2})}, 9000ms);
        m_model->refresh(9300ms);
        QVERIFY(!stale(facts::kSpeed));
        m_model->refresh(9400ms);
        QVERIFY(stale(facts::kSpeed));
    }

    void aSilentLinkMakesEverythingStaleAtOnce()
    {
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{1500})}, 0ms);
        const auto heading = [this] {
            return m_model->headerData(widgets::RegisterModel::ValueColumn, Qt::Horizontal)
                .toString();
        };
        QCOMPARE(heading(), QStringLiteral("Value"));
        QSignalSpy headings(m_model.get(), &QAbstractItemModel::headerDataChanged);
        m_model->setBelieved(false);
        QCOMPARE(heading(), QStringLiteral("Last value")); // said where one looks
        QCOMPARE(headings.size(), 1);
        QVERIFY(stale(facts::kSpeed));
    }

    void whatTheBoardDoesNotHaveSaysSo()
    {
        drive::Reading refused = facts::reading(facts::kVoltage, std::int64_t{0});
        refused.status = drive::ReadStatus::NotSupported;
        m_model->accept({refused}, 0ms);
        QCOMPARE(shown(facts::kVoltage), QStringLiteral("not supported"));
        QVERIFY(!m_model->pollable(facts::kVoltage));
    }

    void aRegisterForTheScopeOnlyIsNotPolled()
    {
        QVERIFY(m_model->indexOf(facts::kAngle).isValid());
        QVERIFY(!m_model->pollable(facts::kAngle));
    }

    void readingsOfUnknownRegistersChangeNothing()
    {
        QSignalSpy changed(m_model.get(), &QAbstractItemModel::dataChanged);
        m_model->accept({facts::reading(0xFFFFFFFF, std::int64_t{1})}, 0ms);
        QVERIFY(changed.isEmpty());
    }

    void aDragCarriesTheIds()
    {
        std::unique_ptr<QMimeData> data(m_model->mimeData(
            {m_model->indexOf(facts::kCurrentA), m_model->indexOf(facts::kCurrentB)}));
        QVERIFY(data);
        const auto ids =
            QJsonDocument::fromJson(data->data(QString::fromLatin1(widgets::kRegisterMimeType)))
                .array();
        QCOMPARE(ids, QJsonArray({double(facts::kCurrentA), double(facts::kCurrentB)}));
    }

    void textCannotBeDraggedToTheScope()
    {
        QVERIFY(!(m_model->indexOf(facts::kName).flags() & Qt::ItemIsDragEnabled));
        QVERIFY(m_model->indexOf(facts::kCurrentA).flags() & Qt::ItemIsDragEnabled);
    }

    void searchingKeepsTheGroupOfWhatIsFound()
    {
        QSortFilterProxyModel proxy;
        proxy.setRecursiveFilteringEnabled(true);
        proxy.setFilterRole(RegisterModel::SearchRole);
        proxy.setFilterCaseSensitivity(Qt::CaseInsensitive);
        proxy.setSourceModel(m_model.get());
        proxy.setFilterFixedString(QStringLiteral("i_b"));
        QCOMPARE(proxy.rowCount(), 1);
        QCOMPARE(proxy.index(0, 0).data().toString(), QStringLiteral("Current loop"));
        QCOMPARE(proxy.rowCount(proxy.index(0, 0)), 1);
    }

    void anotherBoardReplacesEverything()
    {
        m_model->accept({facts::reading(facts::kSpeed, std::int64_t{1500})}, 0ms);
        m_model->setCatalog(nullptr, 1);
        QCOMPARE(m_model->rowCount(), 0);
        m_model->setCatalog(facts::smallCatalog(), 1);
        QVERIFY(!m_model->shownValue(facts::kSpeed));
    }

private:
    QString shown(catalog::RegisterId id) const
    {
        return m_model->indexOf(id, RegisterModel::ValueColumn).data().toString();
    }
    bool stale(catalog::RegisterId id) const
    {
        return m_model->indexOf(id).data(RegisterModel::StaleRole).toBool();
    }

    std::unique_ptr<RegisterModel> m_model;
    std::unique_ptr<QAbstractItemModelTester> m_tester;
};

QTEST_MAIN(TestRegisterModel)
#include "tst_register_model.moc"
