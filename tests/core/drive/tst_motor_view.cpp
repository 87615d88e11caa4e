// What a simulated board says of its motor, read through the drive: the same figures as the machine was made of.
#include "drive/motor_view.h"
#include "simulation/plant/presets.h"
#include "support/link_pair.h"

#include <QTest>

#include <set>

using drive::StructureField;
using drive::StructureView;

namespace {

struct Board {
    support::Session link;
    int motor = 1;

    explicit Board(const simulation::BoardOptions &options = {}, int which = 1)
        : link(false, options)
        , motor(which)
    {
        link.submit(drive::Read{drive::motorRegisters(catalog(), motor)});
        link.runFor(std::chrono::milliseconds(300));
    }
    const catalog::Catalog &catalog() const { return *link.identified->catalog; }
    drive::ValueSource source() const
    {
        return [this](drive::RegisterId id) -> std::optional<drive::Value> {
            const auto at = link.values.find(id);
            if (at == link.values.end() || at->second.status != drive::ReadStatus::Ok)
                return std::nullopt;
            return at->second.value;
        };
    }
    drive::MotorFacts facts() const { return drive::motorFacts(catalog(), motor, source()); }
    std::vector<StructureView> structures() const
    {
        return drive::motorStructures(catalog(), motor, source());
    }
    std::optional<StructureField> field(const char *structure, const char *key) const
    {
        for (const StructureView &view : structures())
            for (const StructureField &field : view.fields)
                if (view.name == structure && field.key == key)
                    return field;
        return std::nullopt;
    }
};

double number(const std::optional<StructureField> &field)
{
    const auto *real = field ? std::get_if<double>(&field->value) : nullptr;
    const auto *whole = field ? std::get_if<std::int64_t>(&field->value) : nullptr;
    return real ? *real : whole ? static_cast<double>(*whole) : std::nan("");
}

bool near(double is, double wanted) { return std::abs(is - wanted) <= 1e-6 * std::abs(wanted); }

} // namespace

class TestMotorView : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void factsAreThoseOfTheMachine_data()
    {
        QTest::addColumn<QString>("profile");
        QTest::addColumn<QString>("preset");
        for (const char *profile : {"mcsdk-6.0", "mcsdk-6.1", "mcsdk-6.2", "mcsdk-6.4", "hso"})
            for (const simulation::Preset &preset : simulation::presets())
                QTest::addRow("%s %s", profile, std::string(preset.name).c_str())
                    << QString::fromLatin1(profile)
                    << QString::fromStdString(std::string(preset.name));
    }
    void factsAreThoseOfTheMachine()
    {
        QFETCH(QString, profile);
        QFETCH(QString, preset);
        simulation::BoardOptions options;
        options.profile = profile.toStdString();
        options.motor = preset.toStdString();
        const auto plant = simulation::plantOf(options);
        const Board board(options);
        QVERIFY(board.link.ready);
        const drive::MotorFacts facts = board.facts();
        QVERIFY(near(facts.motor.polePairs, plant->motor.polePairs));
        QVERIFY(near(facts.motor.rs_ohm, plant->motor.rs_ohm));
        QVERIFY(near(facts.motor.lq_h, plant->motor.lq_h));
        QVERIFY(near(facts.motor.ld_h, plant->motor.ld_h));
        QVERIFY2(near(facts.motor.flux_wb, plant->motor.flux_wb),
            qPrintable(QString::number(facts.motor.flux_wb)));
        QVERIFY(near(facts.motor.nominalCurrent_a, plant->motor.nominal_a));
        QVERIFY(near(facts.limits.maxSpeedRpm, plant->motor.maxSpeed_rpm));
        const bool hso = options.profile == "hso"; // its currents are per unit
        QVERIFY(near(facts.ampsPerDigit, hso ? 0.0 : 1.0 / plant->inverter.digitsPerAmp()));
        QCOMPARE(facts.name, plant->motor.name);
        QVERIFY(!facts.sixStep);
        const QString name = QString::fromStdString(plant->motor.name);
        QCOMPARE(QString::fromStdString(facts.angleSensor),
            hso                                          ? QString()
                : name.contains(QLatin1String("servo"))  ? QStringLiteral("encoder")
                : name.contains(QLatin1String("blower")) ? QStringLiteral("Hall")
                                                         : QString());
        QCOMPARE(facts.fluxPerHertz, hso);
        QCOMPARE(board.field("MOTOR_CONFIG", "rated flux")->unit,
            std::string(facts.fluxPerHertz ? "V/Hz" : "V/krpm"));
    }

    void theSensorSaysHowLateTheSpeedUsuallyIs()
    {
        QVERIFY(near(Board().facts().speedDelay_s, 2e-3F)); // half of 64 control periods
        simulation::BoardOptions options;
        options.motor = "servo24";
        QVERIFY(near(Board(options).facts().speedDelay_s, 8e-3F)); // half of 16 periods of 1 kHz
        options.motor = "blower36"; // three edges at a third of 4500 rpm, four pole pairs
        QVERIFY(near(Board(options).facts().speedDelay_s, float(3.0 / (6.0 * 4.0 * 25.0))));
        QCOMPARE(Board().facts().bandwidthGuide_radps, 9000.0); // three shunts
    }

    void membersHaveUnitsAndNames()
    {
        const Board board;
        QCOMPARE(board.field("MOTOR_CONFIG", "Rs")->unit, std::string("\u03a9"));
        QVERIFY(near(number(board.field("MOTOR_CONFIG", "Rs")), 0.35F));
        QCOMPARE(board.field("APPLICATION_CONFIG", "drive type")->names,
            std::vector<std::string>{"FOC"});
        QCOMPARE(board.field("FOCFW_CONFIG", "primary sensor")->names,
            std::vector<std::string>{"observer + PLL"});
        const auto flags = board.field("FOCFW_CONFIG", "flags 1");
        QVERIFY(flags->flags);
        QCOMPARE(
            flags->names, (std::vector<std::string>{"bus voltage sensing", "temperature sensing"}));
        QCOMPARE(board.field("SCALE_CONFIG", "current")->unit, std::string("A/digit"));
        QCOMPARE(board.field("GLOBAL_CONFIG", "version")->names, std::vector<std::string>{"6.4.0"});
        QCOMPARE(board.field("GLOBAL_CONFIG", "flags")->names, std::vector<std::string>{"UART A"});
        std::set<std::string> keys;
        for (const StructureView &view : board.structures()) {
            QVERIFY2(!view.writable, view.name.c_str());
            for (const StructureField &field : view.fields)
                QVERIFY2(keys.insert(field.key).second, field.key.c_str());
        }
    }

    void theShortFormGivesTheNominalCurrentInDigits()
    {
        simulation::BoardOptions options;
        options.profile = "mcsdk-6.1";
        const Board board(options);
        const auto current = board.field("APPLICATION_CONFIG", "nominal current");
        QCOMPARE(current->unit, std::string("digits"));
        QVERIFY(std::holds_alternative<std::int64_t>(current->value));
        QVERIFY(std::abs(board.facts().limits.nominalCurrentAmps - 5.0) < 0.01);
    }

    void sixStepScalesHaveNoUnit()
    {
        simulation::BoardOptions options;
        options.profile = "six-step";
        const Board board(options);
        QVERIFY(board.link.ready);
        QVERIFY(board.facts().sixStep);
        QCOMPARE(board.field("SCALE_CONFIG", "voltage")->unit, std::string());
        QVERIFY(board.field("FOCFW_CONFIG", "drive mode").has_value());
        QVERIFY(!board.field("FOCFW_CONFIG", "auxiliary sensor").has_value());
    }

    void theSecondMotorHasItsOwn()
    {
        simulation::BoardOptions options;
        options.motors = 2;
        const Board first(options), second(options, 2);
        QVERIFY(second.link.ready);
        QVERIFY(first.structures().front().id != second.structures().front().id);
        QVERIFY(second.facts().motor.rs_ohm > 0.0);
    }

    void whatWasNotReadOrHasAnUnknownLengthHasNoMembers()
    {
        const Board board;
        const auto nothing = [](drive::RegisterId) { return std::optional<drive::Value>(); };
        const auto views = drive::motorStructures(board.catalog(), 1, nothing);
        QCOMPARE(views.size(), 5U);
        for (const StructureView &view : views) {
            QVERIFY(view.fields.empty());
            QVERIFY(!view.bytes);
        }
        const auto facts = drive::motorFacts(board.catalog(), 1, nothing);
        QCOMPARE(facts.motor.rs_ohm, 0.0);
        QCOMPARE(facts.limits.maxSpeedRpm, 0.0);

        const auto odd = [](drive::RegisterId) { return drive::Value(Bytes(7)); };
        for (const StructureView &view : drive::motorStructures(board.catalog(), 1, odd)) {
            QVERIFY(view.fields.empty());
            QCOMPARE(view.bytes, std::optional<std::size_t>(7));
        }
        const auto wrong = [](drive::RegisterId) { return drive::Value(std::int64_t{1}); };
        for (const StructureView &view : drive::motorStructures(board.catalog(), 1, wrong))
            QVERIFY(!view.bytes);
    }
};

QTEST_GUILESS_MAIN(TestMotorView)
#include "tst_motor_view.moc"
