// ActTask: how an act ends that leaves nothing to be asked. No board, no line.
#include "core/drive/toy_drive.h"

#include <QTest>

using namespace drive;
using namespace std::chrono_literals;

namespace {

constexpr TimePoint kGiven{10s};

/// Its plan is empty: the board has what was wanted.
class Nothing final : public ActTask<support::toy::Protocol> {
public:
    using ActTask::ActTask;

private:
    std::string refuse() const override { return {}; }
    std::string plan() override { return {}; }
};

} // namespace

class TestActTask : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void whatHasNothingToAskIsDone();
};

void TestActTask::whatHasNothingToAskIsDone()
{
    const BoardFacts board;
    Nothing act(1, Command{MotorAction::StopMotor}, board);
    QVERIFY(!act.nextRequest(kGiven));
    QVERIFY(act.finished());
    QVERIFY(act.ended().outcome == Outcome::Ok);
    act.cut("stopped"); // too late: it ends once
    QVERIFY(act.ended().outcome == Outcome::Ok);
}

QTEST_APPLESS_MAIN(TestActTask)
#include "tst_act_task.moc"
