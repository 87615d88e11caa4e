// The integer arithmetic of the firmware against a separate exact model, bit for bit: tests/support/exact_loops.py
// prints the vectors and says what each line means.
#include "simulation/maths/pi.h"
#include "simulation/maths/transforms.h"
#include "simulation/maths/voltage.h"
#include "support/places.h"

#include <QProcess>
#include <QTest>

#include <array>
#include <charconv>
#include <map>
#include <string_view>

using namespace simulation;

namespace {

constexpr int kPatience_ms = 120000;

/// One line: its letter, its numbers.
struct Vector {
    char kind = 0;
    std::array<std::int64_t, 6> n{};
    std::size_t size = 0;

    explicit Vector(std::string_view line)
        : kind(line.empty() ? '\0' : line.front())
    {
        const char *at = line.data() + 1;
        const char *const end = line.data() + line.size();
        while (at < end && size < n.size()) {
            const auto [next, error] = std::from_chars(at + 1, end, n[size]);
            if (error != std::errc{})
                break;
            ++size;
            at = next;
        }
    }
    std::int16_t s16(std::size_t i) const { return static_cast<std::int16_t>(n[i]); }
    std::int32_t s32(std::size_t i) const { return static_cast<std::int32_t>(n[i]); }
};

/// What the firmware's arithmetic says to the vectors; the controller lives from one line to the next.
class Judge {
public:
    /// False: a different answer, or a line of no known kind.
    bool agrees(const Vector &v)
    {
        switch (v.kind) {
        case 'T':
            return v.size == 3 && trig(v.s16(0)) == Trig{v.s16(1), v.s16(2)};
        case 'C':
            return v.size == 4 && clarke({v.s16(0), v.s16(1)}) == AlphaBeta{v.s16(2), v.s16(3)};
        case 'P':
            return v.size == 6
                && park({v.s16(0), v.s16(1)}, {v.s16(2), v.s16(3)}) == Qd{v.s16(4), v.s16(5)};
        case 'R':
            return v.size == 6
                && reversePark({v.s16(0), v.s16(1)}, {v.s16(2), v.s16(3)})
                == AlphaBeta{v.s16(4), v.s16(5)};
        case 'L':
            return v.size == 5
                && circleLimit({v.s16(0), v.s16(1)}, circleOf(static_cast<std::uint16_t>(v.n[2])))
                == Qd{v.s16(3), v.s16(4)};
        default:
            return controllerAgrees(v);
        }
    }

private:
    bool controllerAgrees(const Vector &v)
    {
        switch (v.kind) {
        case 'N':
            m_pi = Pi({v.s16(0), v.s16(1), v.s32(2), v.s32(3)});
            return v.size == 4;
        case 'I':
            m_pi.setIntegralLimits({v.s32(0), v.s32(1)});
            return v.size == 2;
        case 'O':
            m_pi.setOutputLimits({v.s32(0), v.s32(1)});
            return v.size == 2;
        case 'V':
            m_pi.setIntegral(v.s32(0));
            return v.size == 1;
        case 'H':
            m_pi.setKiShift(v.s32(0));
            return v.size == 1;
        case 'E':
            return v.size == 3 && m_pi.step(v.s32(0)) == v.n[1] && m_pi.integral() == v.n[2];
        default:
            return false;
        }
    }

    Pi m_pi;
};

} // namespace

class TestMathsExact : public QObject {
    Q_OBJECT

private slots:
    void everyVectorOfTheExactModelIsMet();
    void aWrongDigitIsSeen();
};

void TestMathsExact::everyVectorOfTheExactModelIsMet()
{
    const QString python = QStringLiteral("python3");
    QProcess model;
    model.start(python, {support::sourceFile(QStringLiteral("tests/support/exact_loops.py"))});
    QVERIFY2(model.waitForFinished(kPatience_ms),
        qPrintable(python + QStringLiteral(": ") + model.errorString()));
    const QByteArray complaint = model.readAllStandardError();
    QVERIFY2(
        model.exitStatus() == QProcess::NormalExit && model.exitCode() == 0, complaint.constData());

    const QByteArray text = model.readAllStandardOutput();
    Judge judge;
    std::map<char, int> counted;
    std::string_view rest(text.constData(), static_cast<std::size_t>(text.size()));
    while (!rest.empty()) {
        const std::size_t length = std::min(rest.find('\n'), rest.size());
        const std::string_view line = rest.substr(0, length);
        const Vector vector(line);
        if (!judge.agrees(vector))
            QFAIL(QByteArray(line.data(), static_cast<qsizetype>(line.size())).constData());
        ++counted[vector.kind];
        rest.remove_prefix(std::min(length + 1, rest.size()));
    }
    QCOMPARE(counted['T'], 65536);
    for (const char kind : {'C', 'P', 'E'})
        QVERIFY2(counted[kind] >= 100000, QByteArray(1, kind).constData());
}

void TestMathsExact::aWrongDigitIsSeen()
{
    Judge judge;
    QVERIFY(judge.agrees(Vector("C 1000 0 1000 -578")));
    QVERIFY(!judge.agrees(Vector("C 1000 0 1000 -577")));
    QVERIFY(judge.agrees(Vector("N 100 50 2 3")));
    QVERIFY(judge.agrees(Vector("E -3 -94 -150")));
    QVERIFY(!judge.agrees(Vector("E -3 -94 -150")));
    QVERIFY(!judge.agrees(Vector("P 1 2 3 4 5")));
    QVERIFY(!judge.agrees(Vector("X")));
    QVERIFY(!judge.agrees(Vector("")));
}

QTEST_GUILESS_MAIN(TestMathsExact)
#include "tst_maths_exact.moc"
