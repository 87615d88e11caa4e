#include "session/files/motor_file.h"
#include "simulation/plant/presets.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>

using session::MotorFile;
using session::MotorFileError;

namespace {

bool near(std::optional<double> is, double wanted, double tolerance = 1e-9)
{
    return is && std::abs(*is - wanted) <= tolerance * std::abs(wanted);
}

/// A surface magnet motor as the profiler writes it.
QByteArray profiled(const char *replaced = "", const char *by = "")
{
    QByteArray text = R"({"id": "M1", "label": "Gimbal 2804", "hardwareFamily": "MOTOR",
 "polePairs": 7, "nominalDCVoltage": 12.3, "nominalCurrent": 0.8, "maxRatedSpeed": 1500,
 "rs": 5.4, "ls": 0.00105, "magneticStructure": {"type": "SM-PMSM"}, "BEmfConstant": 4.9,
 "inertia": 29.1, "friction": 9.37})";
    if (*replaced != '\0') {
        Q_ASSERT(text.contains(replaced));
        text.replace(replaced, by);
    }
    return text;
}

bool has(const MotorFile &file, MotorFile::Note note)
{
    return std::find(file.notes.begin(), file.notes.end(), note) != file.notes.end();
}

} // namespace

class TestMotorFile : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aProfilersFileIsReadInItsOwnUnits()
    {
        const auto file = session::readMotor(profiled());
        QVERIFY(file.has_value());
        QVERIFY(file->origin == MotorFile::Origin::St);
        QVERIFY(file->notes.empty());
        const auto sheet = file->sheet();
        QCOMPARE(sheet.name, std::string("Gimbal 2804"));
        QVERIFY(near(sheet.polePairs, 7));
        QVERIFY(near(sheet.rs_ohm, 5.4));
        QVERIFY(near(sheet.ld_h, 1.05e-3));
        QVERIFY(near(sheet.lq_h, 1.05e-3));
        // 4.9 V rms between terminals at 1000 rpm: 4.9 sqrt(2/3) / (7 * 104.72 rad/s)
        QVERIFY(near(sheet.flux_wb, 4.9 * std::sqrt(2.0 / 3.0) / (7 * 104.719755), 1e-6));
        QVERIFY(near(sheet.nominalCurrent_a, 0.8));
        QVERIFY(near(sheet.maxSpeed_rpm, 1500));
        QVERIFY(near(sheet.bus_v, 12.3));
        QVERIFY(near(sheet.inertia_kgm2, 29.1e-6));
        QVERIFY(near(sheet.viscous_nms, 9.37e-6));
    }

    void millihenryOfTheLibraryAreTold()
    {
        const auto file = session::readMotor(profiled("0.00105", "1.05"));
        QVERIFY(file.has_value());
        QVERIFY(near(file->sheet().lq_h, 1.05e-3));
        QVERIFY(has(*file, MotorFile::Note::InductanceInMillihenry));
        // A small, slow winding: 18 uH at 0.11 Ohm, as the library has it.
        const auto small =
            session::readMotor(R"({"polePairs": 7, "rs": 0.11, "ls": 0.018, "BEmfConstant": 0.4})");
        QVERIFY(small.has_value());
        QVERIFY(near(small->sheet().lq_h, 18e-6));
    }

    void aRatioMakesTwoInductancesAndSaysThatOneWasMeasured()
    {
        const auto file = session::readMotor(
            profiled(R"({"type": "SM-PMSM"})", R"({"type": "I-PMSM", "ld_lq_ratio": 0.8})"));
        QVERIFY(file.has_value());
        QVERIFY(near(file->sheet().lq_h, 1.05e-3));
        QVERIFY(near(file->sheet().ld_h, 0.84e-3));
        QVERIFY(has(*file, MotorFile::Note::OneInductanceOnly));
    }

    void whatWasNotMeasuredIsNotThere()
    {
        const auto file = session::readMotor(R"({"polePairs": 4, "rs": 0.3, "inertia": 0})");
        QVERIFY(file.has_value());
        const auto sheet = file->sheet();
        QVERIFY(near(sheet.rs_ohm, 0.3));
        QVERIFY(!sheet.inertia_kgm2 && !sheet.lq_h && !sheet.flux_wb && !sheet.bus_v);
        QVERIFY(sheet.name.empty());
    }

    void aHighSupplyMakesAMachineThatSeesIt()
    {
        const auto file = session::readMotor(profiled("12.3", "325"));
        QVERIFY(file.has_value());
        QCOMPARE(simulation::impossibleParameter(file->machine), std::string_view());
        const auto own = session::readMotor(R"({"inverter": {"supply_v": 400}})");
        QVERIFY(own.has_value());
        QCOMPARE(simulation::impossibleParameter(own->machine), std::string_view());
    }

    void damagedFilesAreOneErrorWithItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("sentence");
        const auto row = [](const char *name, const QByteArray &text, const char *sentence) {
            QTest::newRow(name) << text << QByteArray(sentence);
        };
        row("empty", "", "F: line 1: no JSON (");
        row("cut", profiled().left(200), "F: line 3: no JSON (");
        row("a list", "[]", "F: must be an object of preset, motor");
        row("a number", "7", "F: line 1: no JSON (");
        row("half a pole pair", profiled("\"polePairs\": 7", "\"polePairs\": 3.5"),
            "F: polePairs: must be a whole number from 1 to 64");
        row("text for a number", profiled("5.4", "\"5.4\""), "F: rs: must be a number from 1e-04");
        row("negative", profiled("4.9", "-4.9"), "F: BEmfConstant: must be a number");
        row("huge", profiled("5.4", "1e308"), "F: rs: must be a number");
        row("beyond all numbers", profiled("5.4", "1e999"), "F: ");
        row("a yes", profiled("0.00105", "true"), "F: ls: must be a number");
        row("odd ratio", profiled(R"({"type": "SM-PMSM"})", R"({"ld_lq_ratio": 0})"),
            "F: magneticStructure.ld_lq_ratio: must be");
        row("no pole pairs", R"({"rs": 1, "BEmfConstant": 4})", "F: polePairs: is missing");
        row("own key", R"({"motor": {"rs": 1}})", "F: motor: there is no key \"rs\"; there are");
        row("own section", R"({"motors": {}})", "F: there is no key \"motors\"; there are preset");
        row("own value", R"({"motor": {"rs_ohm": 0}})",
            "F: motor.rs_ohm: must be a number from 1e-04 to 1000");
        row("range", R"({"inverter": {"supply_v": 48, "busRange_v": 40}})",
            "F: inverter.busRange_v: must not be below supply_v");
    }
    void damagedFilesAreOneErrorWithItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, sentence);
        const auto file = session::readMotor(text);
        QVERIFY(!file.has_value());
        const QByteArray said =
            QByteArray::fromStdString(session::motorFileErrorText("F", file.error()));
        QVERIFY2(said.startsWith(sentence), said.constData());
    }

    void noCutOfAFileIsTakenForAMotor()
    {
        const QByteArray whole = profiled();
        for (qsizetype i = 0; i < whole.size(); ++i)
            QVERIFY2(!session::readMotor(whole.left(i)).has_value(), whole.left(i).constData());
        QVERIFY(session::readMotor(whole).has_value());
    }

    void everyPresetComesBackFromItsOwnFile()
    {
        for (const simulation::Preset &preset : simulation::presets()) {
            const auto named = session::readMotor(
                QByteArray("{\"preset\": \"") + std::string(preset.name).c_str() + "\"}");
            QVERIFY(named.has_value());
            const auto sheet = named->sheet();
            QVERIFY(sheet.inertia_kgm2 && sheet.bus_v && !sheet.name.empty());
            const auto again = session::readMotor(session::motorJson(sheet));
            QVERIFY(again.has_value());
            QCOMPARE(again->sheet().name, sheet.name);
            for (const auto &row : motor::compareMotors(sheet, again->sheet(), 1e-6)) {
                QVERIFY(row.here && row.there);
                QVERIFY(!row.differs);
            }
            QCOMPARE(session::motorJson(again->sheet()), session::motorJson(sheet));
        }
    }

    void aFileWithoutAPresetSaysOnlyWhatItNames()
    {
        const auto file = session::readMotor(R"({"motor": {"rs_ohm": 0.5}})");
        QVERIFY(file.has_value());
        QVERIFY(near(file->sheet().rs_ohm, 0.5));
        QVERIFY(!file->sheet().polePairs);
        QCOMPARE(motor::compareMotors({}, file->sheet()).size(), 1U);
    }

    void whatNoMachineCanHaveIsNotWritten()
    {
        motor::MotorSheet sheet;
        sheet.rs_ohm = 0.0;
        sheet.ld_h = std::nan("");
        sheet.polePairs = 3.5;
        sheet.lq_h = 1e-3;
        sheet.name = "A motor with a name that is too long for a board";
        const QByteArray text = session::motorJson(sheet);
        const auto again = session::readMotor(text);
        QVERIFY2(again.has_value(), text.constData());
        QVERIFY(again->sheet().lq_h && !again->sheet().rs_ohm && !again->sheet().polePairs);
    }

    void floatsOfABoardAreWrittenShort()
    {
        motor::MotorSheet sheet;
        sheet.rs_ohm = static_cast<double>(0.35F);
        QVERIFY(session::motorJson(sheet).contains("\"rs_ohm\": 0.35\n"));
    }

    void filesAreReadWithABound()
    {
        const QTemporaryDir folder;
        QFile large(folder.filePath(QStringLiteral("large.json")));
        QVERIFY(large.open(QIODevice::WriteOnly));
        QVERIFY(large.resize(qint64{2} << 20));
        large.close();
        QVERIFY(session::readMotorFile(large.fileName()).error().kind
            == MotorFileError::Kind::TooLarge);
        QVERIFY(session::readMotorFile(folder.filePath(QStringLiteral("none.json"))).error().kind
            == MotorFileError::Kind::Unreadable);
        QVERIFY(
            session::readMotorFile(folder.path()).error().kind == MotorFileError::Kind::Unreadable);
    }

    void figuresCloserThanTheToleranceDoNotDiffer()
    {
        motor::MotorSheet here, there;
        here.rs_ohm = 0.35;
        there.rs_ohm = 0.3501;
        here.lq_h = 1e-3;
        there.lq_h = 1.1e-3;
        here.bus_v = 24;
        const auto rows = motor::compareMotors(here, there);
        QCOMPARE(rows.size(), 3U);
        QVERIFY(!rows[0].differs);
        QVERIFY(rows[1].differs);
        QVERIFY(!rows[2].differs && !rows[2].there);
    }
};

QTEST_GUILESS_MAIN(TestMotorFile)
#include "tst_motor_file.moc"
