// Rev-ups as files: what was saved is opened again, and what does not fit is refused whole.
#include "session/files/rev_up_json.h"

#include <QJsonDocument>
#include <QTest>

#include <random>

using motor::RevUp;

namespace {

constexpr double kAmps = 60.175 / 32768.0;

using Kind = session::RevUpFileError::Kind;

bool isRead(const char *text, double ampsPerDigit = kAmps)
{
    return session::readRevUpJson(text, ampsPerDigit).has_value();
}

} // namespace

class TestRevUpJson : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatIsSavedIsOpenedAgain()
    {
        std::mt19937 random(3);
        for (int round = 0; round < 500; ++round) {
            RevUp stages(1 + random() % motor::kRevUpStages);
            for (auto &stage : stages)
                stage = {static_cast<std::int32_t>(random() % 65535) - 32767,
                    static_cast<std::int16_t>(random()), static_cast<std::uint16_t>(random())};
            const double scale = random() % 2 == 0 ? kAmps : 0.0;
            const auto read = session::readRevUpJson(session::revUpJson(stages, scale), kAmps);
            QVERIFY(read.has_value());
            QVERIFY(*read == stages);
        }
    }

    void amperesAloneAreEnoughWhereTheScaleIsKnown()
    {
        const char *text =
            R"({"stages": [{"speed_rpm": 1200, "current_a": 2.5, "duration_ms": 1500}], "more": 1})";
        const auto stages = session::readRevUpJson(text, kAmps);
        QVERIFY(stages.has_value());
        QVERIFY((*stages == RevUp{{1200, 1361, 1500}}));
        QVERIFY(!isRead(text, 0.0));
    }

    void whatDoesNotFitIsRefused()
    {
        for (const char *text : {"", "{}", "[]", "{\"stages\": []}", "{\"stages\": 3}",
                 R"({"stages": [{}]})", R"({"stages": [1]})",
                 R"({"stages": [{"speed_rpm": 1.5, "current_digits": 1, "duration_ms": 1}]})",
                 R"({"stages": [{"speed_rpm": 40000, "current_digits": 1, "duration_ms": 1}]})",
                 R"({"stages": [{"speed_rpm": 1, "current_digits": 40000, "duration_ms": 1}]})",
                 R"({"stages": [{"speed_rpm": 1, "current_digits": 1, "duration_ms": -1}]})",
                 R"({"stages": [{"speed_rpm": "1", "current_digits": 1, "duration_ms": 1}]})",
                 R"({"stages": [{"speed_rpm": 1, "current_a": 1e300, "duration_ms": 1}]})",
                 R"({"stages": [{},{},{},{},{},{}]})"})
            QVERIFY2(!isRead(text), text);
        const char *second = R"({"stages": [{"speed_rpm": 1, "current_digits": 1, "duration_ms": 1},
            {"speed_rpm": 1e9, "current_digits": 1, "duration_ms": 1}]})";
        const auto error = session::readRevUpJson(second, kAmps).error();
        QVERIFY(error.kind == Kind::BadStage);
        QCOMPARE(error.stage, 2);
        QVERIFY(session::readRevUpJson("{}", kAmps).error().kind == Kind::NoStages);
        QVERIFY(session::readRevUpJson("{", kAmps).error().kind == Kind::NotJson);
    }
};

QTEST_APPLESS_MAIN(TestRevUpJson)
#include "tst_rev_up_json.moc"
