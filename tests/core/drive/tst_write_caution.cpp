// Which writes of a list the user is asked about: the two halves of a gain count as one number.
#include "catalog/catalog.h"
#include "drive/write_caution.h"

#include <QTest>

#include <map>

using catalog::Catalog;
using catalog::Caution;
using catalog::RegisterId;
using drive::RegisterWrite;

namespace {

struct CautionBoard {
    Catalog catalog{
        catalog::readTable(catalog::builtInTable("mcp"), "std", 0x060400).value(), 2, {{}, {}}};
    std::map<RegisterId, std::int64_t> held;
    int runningMotor = 1;

    RegisterId id(const char *name) const { return catalog.resolve(name).value(); }
    RegisterWrite write(const char *name, std::int64_t value) const { return {id(name), value}; }
    drive::HeldValues facts() const
    {
        return {[this](RegisterId one) -> std::optional<catalog::Value> {
                    const auto found = held.find(one);
                    return found == held.end() ? std::nullopt
                                               : std::optional(catalog::Value(found->second));
                },
            [this](int motor) { return motor == 0 || motor == runningMotor; }};
    }
    std::vector<Caution> cautions(const std::vector<RegisterWrite> &writes) const
    {
        return drive::cautionsOf(writes, catalog, facts());
    }
    std::vector<std::string> order(const std::vector<RegisterWrite> &writes) const
    {
        std::vector<std::string> names;
        for (const RegisterWrite &one : drive::pairsTogether(writes, catalog, facts()))
            names.push_back(catalog.nameOf(one.id));
        return names;
    }
};

} // namespace

class TestWriteCaution : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void theHalvesOfAGainFindEachOther()
    {
        const CautionBoard board;
        for (const auto &[one, other] : {std::pair("SPEED_KP", "SPEED_KP_DIV"),
                 std::pair("I_Q_KI@2", "I_Q_KI_DIV@2"), std::pair("FLUXWK_KP", "FLUXWK_KP_DIV")}) {
            QVERIFY(drive::otherHalf(board.catalog, board.id(one)) == board.id(other));
            QVERIFY(drive::otherHalf(board.catalog, board.id(other)) == board.id(one));
        }
        for (const char *alone : {"STOPLL_C1", "SPEED_REF", "FAULTS_FLAGS"})
            QVERIFY(!drive::otherHalf(board.catalog, board.id(alone)));
    }

    void everyExponentOfTheTableHasANumerator()
    {
        const CautionBoard board;
        int exponents = 0;
        for (const catalog::RegisterInfo &info : board.catalog.registers()) {
            if (info.gain != catalog::Gain::Exponent)
                continue;
            ++exponents;
            QVERIFY2(drive::otherHalf(board.catalog, board.catalog.withMotor(info, 1)),
                info.name.c_str());
        }
        QVERIFY(exponents >= 14);
    }

    void fourTimesTheNumeratorOverTwoMoreIsNoChange()
    {
        CautionBoard board;
        board.held = {{board.id("SPEED_KP"), 1000}, {board.id("SPEED_KP_DIV"), 8}};
        QVERIFY(board.cautions({board.write("SPEED_KP", 4000), board.write("SPEED_KP_DIV", 10)})
            == std::vector(2, Caution::None));
        QVERIFY(board.cautions({board.write("SPEED_KP_DIV", 10), board.write("SPEED_KP", 4000)})
            == std::vector(2, Caution::None));
        // Each alone would be a jump, and so is more than the double of the quotient.
        QVERIFY(board.cautions({board.write("SPEED_KP", 4000)}) == std::vector{Caution::GainJump});
        QVERIFY(
            board.cautions({board.write("SPEED_KP_DIV", 10)}) == std::vector{Caution::GainJump});
        QVERIFY(board.cautions({board.write("SPEED_KP", 8004), board.write("SPEED_KP_DIV", 10)})
            == std::vector(2, Caution::GainJump));
        QVERIFY(board.cautions({board.write("SPEED_KP", 1500), board.write("SPEED_KP_DIV", 10)})
            == std::vector(2, Caution::GainJump)); // the half of the half
        QVERIFY(board.cautions({board.write("SPEED_KP", -4000), board.write("SPEED_KP_DIV", 10)})
            == std::vector(2, Caution::GainJump)); // turned round
    }

    void twoSmallStepsInOneDirectionAreAJump()
    {
        CautionBoard board;
        board.held = {{board.id("SPEED_KP"), 1000}, {board.id("SPEED_KP_DIV"), 8}};
        // Neither is by more than the double, both are.
        QVERIFY(board.cautions({board.write("SPEED_KP", 2000)}) == std::vector{Caution::None});
        QVERIFY(board.cautions({board.write("SPEED_KP", 2000), board.write("SPEED_KP_DIV", 7)})
            == std::vector(2, Caution::GainJump));
    }

    void whatIsNotKnownIsAJump()
    {
        CautionBoard board;
        board.held = {{board.id("SPEED_KP"), 1000}};
        QVERIFY(board.cautions({board.write("SPEED_KP", 1001), board.write("SPEED_KP_DIV", 8)})
            == std::vector(2, Caution::GainJump));
    }

    void atRestAndOfAnotherMotorNobodyIsAsked()
    {
        CautionBoard board;
        QVERIFY(board.cautions({board.write("SPEED_KP@2", 1), board.write("SPEED_KP_DIV@2", 1)})
            == std::vector(2, Caution::None));
        board.held = {{board.id("SPEED_KP@2"), 1000}, {board.id("SPEED_KP_DIV"), 8}};
        QVERIFY(board.cautions({board.write("SPEED_KP@2", 4000), board.write("SPEED_KP_DIV", 10)})
            == (std::vector{Caution::None, Caution::GainJump})); // halves of different gains
        board.runningMotor = 0;
        QVERIFY(board.cautions({board.write("SPEED_REF", 1)}) == std::vector{Caution::Dangerous});
    }

    void theHalfThatLowersTheGainGoesFirst()
    {
        CautionBoard board;
        board.held = {{board.id("SPEED_KP"), 1000}, {board.id("SPEED_KP_DIV"), 8}};
        using Names = std::vector<std::string>;
        QVERIFY(board.order({board.write("SPEED_KP", 4000), board.write("I_Q_KP", 1),
                    board.write("SPEED_KP_DIV", 10)})
            == (Names{"SPEED_KP_DIV@1", "SPEED_KP@1", "I_Q_KP@1"}));
        QVERIFY(board.order({board.write("I_Q_KP", 1), board.write("SPEED_KP_DIV", 6),
                    board.write("SPEED_KP", 250)})
            == (Names{"I_Q_KP@1", "SPEED_KP@1", "SPEED_KP_DIV@1"}));
        QVERIFY(board.order({board.write("SPEED_KP", 1), board.write("SPEED_KP_DIV@2", 9)})
            == (Names{"SPEED_KP@1", "SPEED_KP_DIV@2"}));
    }
};

QTEST_APPLESS_MAIN(TestWriteCaution)
#include "tst_write_caution.moc"
