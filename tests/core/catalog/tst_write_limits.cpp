// What may be written to a register: the rules of the table, without a board, and with one whose limits are nonsense.
#include "catalog/catalog.h"
#include "catalog/limits.h"
#include "catalog/names.h"
#include "drive/mcp/limits.h"
#include "drive/mcp/scales.h"
#include "drive/set_point_check.h"
#include "support/link_pair.h"

#include <QTest>

#include <limits>

using namespace catalog;

namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInf = std::numeric_limits<double>::infinity();

std::vector<RegisterInfo> currentTable(std::string_view family)
{
    return readTable(builtInTable("mcp"), family, 0x060402).value();
}

std::shared_ptr<const Catalog> standard()
{
    return std::make_shared<const Catalog>(
        currentTable("std"), 1, std::vector<Scales>{{.ampsPerDigit = 0.001}});
}

bool takes(const char *name, const Value &value)
{
    static const auto kCatalog = standard();
    return refuseValue(*kCatalog->find(std::string_view(name)), value).empty();
}

Caution caution(
    const char *name, std::optional<Value> old, const Value &wanted, bool running = true)
{
    static const auto kCatalog = standard();
    return cautionOf(*kCatalog->find(std::string_view(name)), old, wanted, running);
}

} // namespace

class TestWriteLimits : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void aRangeOfTheTableBoundsAWrite();
    void onlyValuesThatMeanSomethingAreTaken();
    void whatIsNotFiniteIsNeverTaken();
    void noRegisterTakesMoreThanItsTypeHolds();
    void everyWritableEnumerationHasNames();
    void dangerousRegistersAreAskedAbout();
    void aGainThatMoreThanDoublesIsAskedAboutWhileAMotorRuns();
    void limitsThatAreNonsenseRefuseEverySetPoint();
    void theCoreSendsNothingBeyondARange();
};

void TestWriteLimits::aRangeOfTheTableBoundsAWrite()
{
    QVERIFY(takes("SPEED_KP_DIV", std::int64_t{15}));
    QVERIFY(!takes("SPEED_KP_DIV", std::int64_t{16}));
    QVERIFY(!takes("SPEED_KP_DIV", std::int64_t{-1}));
    QVERIFY(takes("OPENLOOP_DC_FILTER", std::int64_t{1})); // an exponent
    QVERIFY(takes("OPENLOOP_DC_FILTER", std::int64_t{12}));
    QVERIFY(!takes("OPENLOOP_DC_FILTER", std::int64_t{0}));
    QVERIFY(!takes("OPENLOOP_DC_FILTER", std::int64_t{13}));
    QVERIFY(takes("SPEED_KP", std::int64_t{-32768}));
    QVERIFY(!takes("SPEED_KP", std::int64_t{32768}));
    QVERIFY(takes("SPEED_KP", 12.0));
    QVERIFY(!takes("SPEED_KP", 12.5));
    QVERIFY(!takes("SPEED_KP", std::string("12")));
    QVERIFY(takes("SC_CURRBANDWIDTH", 0.5));
    QVERIFY(!takes("SC_CURRBANDWIDTH", -0.5));
    QVERIFY(takes("REVUP_DATA", Bytes(40)));
    QVERIFY(!takes("REVUP_DATA", std::int64_t{1}));
}

void TestWriteLimits::onlyValuesThatMeanSomethingAreTaken()
{
    QVERIFY(takes("CONTROL_MODE", std::int64_t{4}));
    QVERIFY(!takes("CONTROL_MODE", std::int64_t{8}));
    QVERIFY(takes("LOWSIDE_MODULATION", std::int64_t{0x3F}));
    QVERIFY(!takes("LOWSIDE_MODULATION", std::int64_t{0x40}));
    QVERIFY(takes("OPENLOOP", std::int64_t{1}));
    QVERIFY(!takes("OPENLOOP", std::int64_t{2}));
}

void TestWriteLimits::whatIsNotFiniteIsNeverTaken()
{
    for (const char *family : {"std", "hso"})
        for (const RegisterInfo &info : currentTable(family))
            for (const double bad : {kNan, kInf, -kInf})
                QVERIFY2(!refuseValue(info, bad).empty(), info.name.c_str());
}

void TestWriteLimits::noRegisterTakesMoreThanItsTypeHolds()
{
    for (const char *family : {"std", "hso"})
        for (const RegisterInfo &info : currentTable(family)) {
            const Limits limits = writeLimits(info);
            QVERIFY2(limits.least <= limits.greatest, info.name.c_str());
            const double beyond = info.type == ValueType::F32 ? 4e38 : limits.greatest + 1.0;
            QVERIFY2(!refuseValue(info, beyond).empty(), info.name.c_str());
        }
}

void TestWriteLimits::everyWritableEnumerationHasNames()
{
    for (const char *family : {"std", "hso"})
        for (const RegisterInfo &info : currentTable(family)) {
            const bool writable = info.writable() && !info.stub;
            if (info.meaning == Meaning::Enumeration && writable)
                QVERIFY2(!namedValues(info.name).empty(), info.name.c_str());
            if (info.meaning == Meaning::Flags && writable)
                QVERIFY2(!namedFlags(info.name).empty(), info.name.c_str());
        }
}

void TestWriteLimits::dangerousRegistersAreAskedAbout()
{
    const Value one = std::int64_t{1};
    QVERIFY(caution("SPEED_REF", one, one, false) == Caution::Dangerous);
    QVERIFY(caution("I_Q_REF", one, one) == Caution::Dangerous);
    QVERIFY(caution("SC_CURRENT", one, one) == Caution::None);
}

void TestWriteLimits::aGainThatMoreThanDoublesIsAskedAboutWhileAMotorRuns()
{
    const auto gain = [](std::int64_t from, std::int64_t to, bool running = true) {
        return caution("SPEED_KP", Value(from), Value(to), running);
    };
    QVERIFY(gain(1000, 2000) == Caution::None);
    QVERIFY(gain(1000, 2001) == Caution::GainJump);
    QVERIFY(gain(1000, 500) == Caution::None);
    QVERIFY(gain(1000, 499) == Caution::GainJump);
    QVERIFY(gain(1000, -1000) == Caution::GainJump);
    QVERIFY(gain(0, 1) == Caution::GainJump);
    QVERIFY(gain(1, 0) == Caution::GainJump);
    QVERIFY(gain(0, 0) == Caution::None);
    QVERIFY(gain(-1000, -32768) == Caution::GainJump);
    QVERIFY(gain(1, 30000, false) == Caution::None);
    QVERIFY(caution("SPEED_KP", std::nullopt, std::int64_t{1}) == Caution::GainJump);
    QVERIFY(caution("SPEED_KP_DIV", Value(std::int64_t{4}), std::int64_t{5}) == Caution::None);
    QVERIFY(caution("SPEED_KP_DIV", Value(std::int64_t{4}), std::int64_t{6}) == Caution::GainJump);
    QVERIFY(caution("SPEED_KP_DIV", Value(std::int64_t{4}), std::int64_t{2}) == Caution::GainJump);
}

void TestWriteLimits::limitsThatAreNonsenseRefuseEverySetPoint()
{
    for (const double nonsense : {0.0, -1.0, kNan, kInf, 1e300}) {
        drive::McpMotorDescription motor;
        motor.application.emplace();
        const auto narrow = static_cast<float>(nonsense);
        motor.application->maxReadableAmps = narrow;
        motor.application->nominalAmps = narrow;
        drive::McpFacts board;
        board.identified = true;
        board.catalog = standard();
        board.scales = {Scales{.ampsPerDigit = 0.001}};
        board.limits = {drive::limitsOf(motor)};
        for (const char *name : {"SPEED_REF", "I_Q_REF", "I_D_REF"}) {
            const drive::RegisterWrite write{*board.catalog->resolve(name), std::int64_t{1}};
            QVERIFY(!drive::refuseWriteOf(board, write, drive::Reach::References).empty());
        }
        QVERIFY(!drive::refuseSpeed(board, 1, kNan).empty());
        QVERIFY(!drive::refuseCurrent(board, 1, kInf).empty());
    }
}

void TestWriteLimits::theCoreSendsNothingBeyondARange()
{
    support::Session session;
    const std::size_t before = support::count(session.requests, mcp::CommandId::SetRegister);
    const drive::WishId write = session.submit(drive::Write{{
        {session.id("SPEED_KP_DIV"), std::int64_t{16}},
        {session.id("CONTROL_MODE"), std::int64_t{8}},
        {session.id("SPEED_KP"), kNan},
        {session.id("SPEED_KI"), std::int64_t{70000}},
    }});
    QVERIFY(session.runUntilEnded(write));
    for (const drive::WriteResult &result : session.ended[write].front().writes) {
        QVERIFY(result.outcome == drive::Outcome::Refused);
        QVERIFY(!result.reason.empty());
    }
    QCOMPARE(support::count(session.requests, mcp::CommandId::SetRegister), before);
}

QTEST_APPLESS_MAIN(TestWriteLimits)
#include "tst_write_limits.moc"
