#!/usr/bin/env python3
"""Shows that the judges of the wire (tests/support/ms_rules.h) and of the screen (tests/support/screen/screen_judge.h) find what
they are there for: each defect below is put into the product, one test is built and run, and the rule named with it has to
speak. Prints a table.

    tests/mutation/seeded_defects.py --build build/dev [--only NAME] [--jobs N]

The source is edited in place and put back, also when it is interrupted: run it in a copy of the tree. A defect whose text
is no longer in the source is an error: the table would claim what was not tried.
"""
import argparse
import os
import pathlib
import re
import subprocess
import sys
import threading
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]

CAMPAIGN = "tst_mcp_drive_faults underRandomFaultsEachWishEndsOnceAndTheLinkComesBack"

# Name, test (with functions), rule that has to speak, edits: (file, text, text instead).
DEFECTS = [
    ("a Stop does not disarm", CAMPAIGN, "armed|asked for|stop first", [
        ("core/drive/wish_drive.cpp", "    m_workedAt = now;\n    setArmed(false);\n", "    m_workedAt = now;\n"),
        ("core/drive/task_drive.h", 'm_wishes.cut("stopped", m_wish);', "")]),
    ("a start is repeated when its answer is lost", CAMPAIGN, "asked for", [
        ("core/drive/act_task.h", "        this->endLost(executed);\n", "        static_cast<void>(executed);\n")]),
    ("writes pass unarmed", CAMPAIGN, "armed", [
        ("core/drive/write_task.h", "WishTask<P>(id, Permission::Armed)", "WishTask<P>(id, Permission::Always)")]),
    ("a Stop is not repeated", "tst_mcp_drive_stop", "stop in time", [
        ("core/drive/stop_sequence.cpp", "motor->nextStop = now + kRepeat;", "motor->nextStop = now + 100 * kRepeat;")]),
    ("no STOP without a link", "tst_mcp_drive_stop", "stop in time", [
        ("core/drive/stop_sequence.cpp", "    if (!connected && !blind(now))\n        return std::nullopt;",
         "    if (!connected)\n        return std::nullopt;"),
        ("core/drive/stop_sequence.cpp", "if (due && !connected && std::max(*due, now) >= blindUntil())", "if (due && !connected && now.time_since_epoch().count() > 0)")]),
    ("motor 0", CAMPAIGN, "motors that are there", [
        ("core/mcp/request.cpp", "<< 3 | (motor & 7U);", "<< 3 | (motor & 0U);")]),
    ("speeds beyond the limit", CAMPAIGN, "bounded", [
        ("core/drive/set_point_check.cpp", "    if (std::abs(value) > bound.most)\n", "    if (std::abs(value) > 100 * bound.most)\n")]),
    ("a second request in flight", "tst_mcp_drive", "one in flight", [
        ("core/aspep/controller.cpp", "    return m_state == State::Connected && m_step == Step::None && !m_urgent;",
         "    return m_state == State::Connected && !m_urgent;"),
        ("core/drive/task_drive.h", "m_link.canSend() && m_task == nullptr && !m_stopUnderWay;", "m_link.canSend() && !m_stopUnderWay;")]),
    ("a question follows a Stop without its answer", "tst_legacy_drive_faults", "one in flight", [
        ("core/fcp/client.cpp", "        m_deadline = now + kAnswerTime + m_config.patience;\n}", "        m_deadline = now + kSettle;\n}"),
        ("core/fcp/client.cpp", "        if (m_owed > 0)\n            return answerTimeOver(now);\n", "")]),
    ("what the servo was not ready for leaves after the connection", "tst_mcb_sessions", "armed", [
        ("core/drive/mcb/drive.cpp", "recalled = m_link.recall(now);", "recalled = now == TimePoint{};")]),
    ("what travels with the frames goes on during a Stop", "tst_mcb_set_points", "stop first", [
        ("core/drive/mcb/drive.cpp", "    if (stopping)\n        return restSetPoints();\n", "    if (stopping)\n        return;\n")]),
    ("what travels with the frames leaves when it is too late", "tst_mcb_sessions", "asked for", [
        ("core/drive/mcb/drive.cpp", "    asked.leaveBy = leaveBy;\n    m_link.send", "    m_link.send")]),
    ("what travels with the frames outlives a reset", "tst_mcb_set_points", "armed|asked for", [
        ("core/drive/mcb/drive.cpp", "    m_stream.ended();\n    endSetPoints();\n    m_faulty = false;", "    m_stream.ended();\n    m_faulty = false;")]),
    ("what travels with the frames drops when it is disarmed", "tst_mcb_set_points", "asked for|armed", [
        ("core/drive/mcb/drive.cpp", "    if (stopping)\n        return restSetPoints();", "    if (stopping || !armed())\n        restSetPoints();\n    if (stopping)\n        return;")]),
    ("heartbeats unarmed", "tst_mcp_drive_watchdog", "heartbeats", [
        ("core/drive/mcp/drive.cpp", "m_heartbeat.setWanted(!m_stop.active() && armed());", "m_heartbeat.setWanted(true);")]),
    ("the alarm is never raised", "tst_mcp_drive_stop", "alarm", [
        ("core/drive/stop_sequence.cpp", "            tell(motor, StopWord::NotConfirmed, now);", "            continue;")]),
    ("pressing again puts off the alarm", "tst_mcp_drive_stop", "alarm", [
        ("core/drive/stop_sequence.cpp", "        motor.nextStop = std::min(motor.nextStop, now); //",
         "        motor.nextStop = motor.begun = now; //")]),
    ("a motor that becomes known during a Stop is not stopped", "tst_mcp_drive_stop", "stop in time|stop first", [
        ("core/drive/stop_sequence.cpp", "    m_count = count;\n    if (count == Count::Exactly)", "    motors = 0;\n    m_count = Count::Exactly;\n    if (count == Count::Exactly && motors > 0)")]),
    ("a lost link leaves it armed", CAMPAIGN, "armed", [
        ("core/drive/task_drive.h", "    setArmed(false);\n    forgetLink(\"link lost\");", "    forgetLink(\"link lost\");")]),
    ("no pause before a payload", CAMPAIGN, "payload pause", [
        ("core/aspep/controller.h", "payloadPause = std::chrono::microseconds(1500);", "payloadPause = std::chrono::microseconds(100);")]),
    ("other reads go on during a Stop", "tst_mcp_drive_stop", "stop first", [
        ("core/drive/wish_drive.h", "return m_stop.exclusive() && (!m_stop.alarmed() || m_stop.blind(now));", "return now == TimePoint{};")]),
    ("one reading is enough for \"drive idle\", a running one too", "tst_mcp_drive_stop", "true words", [
        ("core/drive/stop_sequence.cpp", "{ return rests(status.state) || ", "{ return rests(status.state) || status.state == MotorState::Running || ")]),
    ("the older protocol stops motor 0", "tst_legacy_drive_faults", "motors that are there", [
        ("core/drive/fcp/drive.cpp", "request = stopOf(motor);", "request = stopOf(motor & 0);")]),
    ("late wishes are sent", "tst_late_wishes", "asked for", [
        ("core/drive/task.h", "return m_fresh + kWishExpiresAfter;", "return m_fresh + 100 * kWishExpiresAfter;")]),
    ("a restore writes what moves a motor", "tst_what_may_be_written", "asked for", [
        ("core/snapshots/restore.cpp", "&& !info->stub && !info->restorable();", "&& info->stub;"),
        ("core/snapshots/restore.cpp", "if (moves || !entry.tunable)", "if (moves)"),
        ("core/snapshots/snapshot.cpp", "return info.restorable();", "return info.readable() && info.writable() && !info.stub;"),
        ("core/drive/write_check.cpp", "    if (reach == Reach::Parameters)\n        return", "    if (reach == Reach::Parameters && info.stub)\n        return")]),
    ("a list of parameters may hold a set-point", CAMPAIGN, "asked for", [
        ("core/drive/write_check.cpp", "    if (reach == Reach::Parameters)\n        return", "    if (reach == Reach::Parameters && info.stub)\n        return")]),
    ("a start after a Stop is not asked about", "tst_motion_gate", "first starts are asked", [
        ("widgets/control/motion_gate.cpp", "        forgetStarts(); // what the board still holds may surprise: the next start is asked about\n", "")]),
    ("what disarming ended goes on", "tst_mcb_not_ready", "asked for", [
        ("core/drive/task_drive.h", "    if (m_wish != nullptr && which(*m_wish) && m_cutAfterAnswer.empty())\n        m_cutAfterAnswer = reason;\n", "")]),
    ("a repetition puts off the first STOP", "tst_mcp_drive_faults seedsThatFailedOnceStayWell", "stop in time", [
        ("core/drive/mcp/drive.cpp", "        if (m_link.urgentWaits())\n            return TimePoint::max();", "        //")]),
    # What the judge of the screen finds.
    ("short faults are in no list", "tst_monkey@1-40", "untrue", [
        ("widgets/files/event_recorder.cpp", "        if (met && !has(before.faultsPast, fault)", "        if (!met && !has(before.faultsPast, fault)")]),
    ("a state of before a silence is shown as live", "tst_monkey@1-40", "untrue", [
        ("widgets/control/state_box.cpp", "m_device.statusIsNow(m_device.motor());", "m_device.identified().has_value();")]),
    ("the choice of the motor goes back by itself", "tst_monkey@25-25", "untrue", [
        ("widgets/window/connect_bar.cpp", "    m_motor->setCurrentIndex(m_device.motor() - 1); //", "    //")]),
    ("words of rest stay beside a motor that turns", "tst_monkey@24-24", "untrue", [
        ("widgets/control/panel.cpp", "        m_words->hide(); // they told of", "        m_words->show(); // they told of")]),
    ("a pulled cable is called a disconnection", "tst_monkey@9-9", "untrue", [
        ("widgets/files/event_recorder.cpp", "        error.problem != session::PortProblem::None)\n        noteLoss(Trouble::Port",
         "        error.problem == session::PortProblem::TakenOver)\n        noteLoss(Trouble::Port")]),
    ("a port without a board is called a lost link", "tst_monkey@1-40", "untrue", [
        ("widgets/base/messages.cpp", "LinkState::Lost && !met;", "LinkState::Closed && !met;")]),
    ("the last board is named at a closed port", "tst_monkey@1-40", "untrue", [
        ("widgets/window/connect_bar.cpp", "    if (!identified || m_device.link().state == drive::LinkState::Closed\n", "    if (!identified\n")]),
    ("Apply writes gains that are not shown any more", "tst_monkey@1-40", "untrue", [
        ("widgets/forms/gains_form.cpp", "    if (m_edits.underWay())\n        return;\n    if (!m_previewed", "    if (m_lab->isVisible() || m_edits.underWay())\n        return;\n    if (!m_previewed")]),
    ("all boards have the steps of one", "tst_monkey@1-40", "untrue", [
        ("core/drive/event.h", "double speedStepRpm = 1.0;", "double speedStepRpm = 6.0;")]),
    ("the currents of a board that comes back are not drawn", "tst_monkey@13-21", "untrue", [
        ("core/capture/capture.cpp", "(!best || kind == Kind::Polled || entry.touched >= best->touched))",
         "(!best || kind == Kind::Polled || entry.channel != nullptr))")]),
    ("values stay unmarked when the link is silent or closed", "tst_monkey@9-9", "untrue", [
        ("widgets/registers/model.cpp", "    if (std::exchange(m_believed, believed) != believed)\n", "    believed = believed || !m_rows.empty();\n    if (std::exchange(m_believed, believed) != believed)\n"),
        ("widgets/registers/model.cpp", "holds = m_believed && now", "holds = m_believed || now")]),
    ("fields of forms do not mark old values", "tst_register_field", "untrue|FAIL", [
        ("widgets/registers/field.cpp", "} else if (index.data(RegisterModel::StaleRole).toBool()) {", "} else if (index.data(RegisterModel::StaleRole).isNull()) {")]),
    ("the trigger misses faults", "tst_monkey@6-36", "untrue", [
        ("widgets/window/workbench.cpp", "kind == EventKind::Fault ? Kind::Fault : Kind::StateChange", "kind == EventKind::Fault ? Kind::RegisterWrite : Kind::StateChange")]),
    ("the trigger misses set-points", "tst_monkey@6-36", "untrue", [
        ("widgets/window/workbench.cpp", "m_trigger.event(Kind::SetPoint, sent.seconds,", "m_trigger.event(Kind::RegisterWrite, sent.seconds,")]),
    ("traces are drawn lower than they are", "tst_monkey@1-13", "untrue", [
        ("widgets/scope/drawing/drawn_trace.h", "return {range.upper, height / range.size()};", "return {range.upper + range.size() / 8, height / range.size()};")]),
    ("traces of what is not there", "tst_monkey@1-13", "untrue", [
        ("widgets/scope/drawing/drawn_trace.cpp", "        if (!column.empty()) {\n            strokes.columns.set(x,", "        if (x % 64 > 32) {\n            strokes.columns.set(x, view.height / 4, view.height / 2);\n        } else if (!column.empty()) {\n            strokes.columns.set(x,")]),
    ("a picture that moved lacks a column", "tst_scope_roll", "picture", [
        ("widgets/scope/drawing/drawn_trace.h", "int reach() const { return 4 * thickness; }", "int reach() const { return 0; }")]),
    ("a picture does not see other records behind it", "tst_scope_roll", "picture", [
        ("widgets/scope/drawing/waveform_plottable.cpp", "return ratio == before.ratio && ghosts == before.ghosts &&", "return ratio == before.ratio &&")]),
    ("stripes of what is new do not go on", "tst_scope_roll", "picture", [
        ("widgets/scope/drawing/waveform_plottable.cpp", "kStripeWidth * view.thickness, view.first);", "kStripeWidth * view.thickness, view.left);")]),
    ("the legend tells other values", "tst_monkey@1-13", "untrue", [
        ("widgets/scope/trace_legend.cpp", "valueLabel(*value, step, locale) :", "valueLabel(*value * 1.5 + 3.0, step, locale) :")]),
    ("the state of a silent board of the older protocol stays", "tst_monkey@8-16", "untrue", [
        ("widgets/control/state_box.cpp", "const bool believed = m_device.statusIsNow(m_device.motor());", "const bool believed = m_device.portOpen();")]),
    ("the bus voltage of the older protocol is another", "tst_monkey@2-4", "untrue", [
        ("core/drive/fcp/requests.cpp", "        reading.value = std::move(value).value_or(Value());\n",
         "        reading.value = std::move(value).value_or(Value());\n        if (auto *digits = std::get_if<std::int64_t>(&reading.value); digits && fcpNumber(reading.id) == 0x19)\n            *digits += 3;\n")]),
    ("speeds of an MCB drive are told by another unit", "tst_monkey@5-5", "untrue", [
        ("core/drive/mcb/catalog.cpp", "if (info.unit == \"rev/s\" && scalar)", "if (info.unit == \"rev/s2\" && scalar)")]),
    ("what is read in turn is drawn lower than it is", "tst_monkey@5-5", "untrue", [
        ("widgets/scope/drawing/drawn_trace.h", "return {range.upper, height / range.size()};", "return {range.upper + range.size() / 8, height / range.size()};")]),
    ("the legend keeps values that count no more", "tst_monkey@185-185", "untrue", [
        ("widgets/scope/trace_legend.cpp", "isOld(trace, m_capture) ? std::nullopt : last", "last")]),
    ("the legend has no values", "tst_monkey@1-13", "untrue", [
        ("widgets/scope/trace_legend.cpp", "isOld(trace, m_capture) ? std::nullopt : last", "std::nullopt")]),
    ("a CSV holds other samples", "tst_monkey@7-15", "untrue", [
        ("core/capture/csv_export.cpp", "static_cast<float>(m_channel.toShown(code));", "static_cast<float>(m_channel.toShown(code / 2 * 2));")]),
    ("a recording holds other values", "tst_monkey@7-15", "untrue", [
        ("core/recorded/entry_codec.cpp", "out.u32(value.id).s64(value.at).f64(value.value);", "out.u32(value.id).s64(value.at).f64(value.value + 1.0);")]),
    ("each connection is called a reset", "tst_monkey@1-13", "untrue", [
        ("widgets/window/link_news.cpp", "link.state == drive::LinkState::Connected && link.reason == drive::LinkReason::BoardReset", "link.state == drive::LinkState::Connected && link.reason != drive::LinkReason::BoardReset")]),
    ("a recording's size is told wrong", "tst_monkey@7-31", "untrue", [
        ("widgets/files/recording_control.cpp", "constexpr double kMega = 1e6;", "constexpr double kMega = 5e5;")]),
    ("a file is not named in the title", "tst_monkey@14-31", "untrue", [
        ("widgets/window/main_window.cpp", "    else if (m_workbench.signalPlan().showsFile())\n", "    else if (m_workbench.signalPlan().showsFile() && m_device.portOpen())\n")]),
    ("an experiment holds no bound of speed", "tst_experiment_faults@1-600", "MS28", [
        ("core/lab/envelope.cpp", "if (m_caps.mostRpm == m_caps.leastRpm)", "if (m_caps.mostRpm >= m_caps.leastRpm)")]),
    ("an experiment holds no bound of current", "tst_experiment_faults@1-600", "MS28", [
        ("core/lab/envelope.cpp", "return m_caps.mostAmps > 0.0 && std::abs(amps) > m_caps.mostAmps", "return m_caps.mostAmps < 0.0 && std::abs(amps) > m_caps.mostAmps")]),
    ("what an experiment borrowed is not given back", "tst_experiment_faults@1-600", "MS32", [
        ("core/lab/runner.cpp", "    if (m_lent)\n        m_restores", "    if (std::exchange(m_lent, false) && m_old.empty())\n        m_restores")]),
    ("a torque that nobody asked for stays in force unsaid", "tst_experiment_faults@1-600", "MS32", [
        ("core/lab/runner.cpp", "m_byTorque = m_byTorque || torque;", "m_byTorque = (m_byTorque || torque) && !m_asked_rpm;")]),
    ("a torque outlives its experiment", "tst_experiment_faults@1-600", "MS28", [
        ("core/lab/runner.cpp", "m_stop = needsEnvelope();", "m_stop = false;")]),
    ("a rotor that turns the other way is started", "tst_mechanical", "FAIL", [
        ("core/lab/runner.cpp", "(late && !turnsBack(*m_status, m_experiment))", "late")]),
    ("a running motor is taken through zero", "tst_mechanical", "FAIL", [
        ("core/lab/experiment.cpp", "if (before_rpm * conditions.firstRpm < 0.0 &&", "if (before_rpm * conditions.firstRpm < -1e9 &&")]),
    ("an experiment is left to itself when its port goes", "tst_session_experiment_faults@1-100", "MS29|MS32", [
        ("core/session/link/session.cpp", 'm_experiment->lose("the port was lost");', 'm_experiment->interrupt("the port was lost");')]),
    ("what an experiment has borrowed is written over", "tst_session_experiment", "FAIL", [
        ("core/session/link/session.cpp", "if (m_experiment && writesLent(", "if (m_experiment && false && writesLent(")]),
    ("what was not read back is told as verified", "tst_register_edits", "FAIL", [
        ("widgets/registers/model_edits.cpp", "result.verified ? EditState::Verified", "true ? EditState::Verified")]),
    ("the command line tells no loss", "tst_cli_truth_posix", "untrue", [
        ("app/cli/command_capture.cpp", 'QStringLiteral("lost_ticks"), static_cast<qint64>(m_recorder.lostTicks())', 'QStringLiteral("lost_ticks"), static_cast<qint64>(m_recorder.lostTicks() / 1000)')]),
    ("a Stop goes down with its link", "tst_mcp_drive_stop", "stop in time", [
        ("core/drive/mcp/drive.cpp", "        m_stop.stopFailed(m_stopMotor, now);", "        //")]),
]


def run(command, seconds, **more):
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", **more)
    try:
        done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, timeout=seconds)
    except subprocess.TimeoutExpired as late:
        return 1, (late.stdout or b"").decode(errors="replace")
    return done.returncode, (done.stdout + done.stderr).decode(errors="replace")


def until(command, words, seconds, **more):
    """Runs a program until it says so: a session that has failed would then look for its cause for a minute."""
    environment = dict(os.environ, QT_QPA_PLATFORM="offscreen", **more)
    said = []
    with subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          text=True, errors="replace") as program:
        late = threading.Timer(seconds, program.kill)
        late.start()
        for line in program.stdout:
            said.append(line)
            if words in line:
                program.kill()
                break
        late.cancel()
    return program.returncode, "".join(said)


def judged(build, jobs, test):
    """A test by its name, of a campaign with its seeds (@FIRST-LAST), and if wanted its functions."""
    name, *functions = test.split()
    name, _, seeds = name.partition("@")
    code, text = run(["cmake", "--build", build, "--target", name, "-j", jobs], 1800)
    if code != 0:
        return None, text[-2000:]
    if seeds:
        return until([f"{build}/tests/{name}"], "the judge: ", 900, ROTORSCOPE_SEED=seeds)
    return run([f"{build}/tests/{name}", *functions], 900)


def try_one(defect, build, jobs):
    name, test, rule, edits = defect
    kept = {}
    try:
        for file, old, new in edits:
            path = ROOT / file
            source = path.read_text()
            kept.setdefault(path, source)
            if source.count(old) != 1:
                return "NO LONGER THERE", file
            path.write_text(source.replace(old, new))
        code, text = judged(build, jobs, test)
    finally:
        for path, source in kept.items():
            path.write_text(source)
    if code is None:
        return "DOES NOT BUILD", text
    spoke = re.search(rf"the judge: (({rule}): .*)", text, re.M)
    if code == 0:
        return "SURVIVED", ""
    if spoke:
        return "found", spoke.group(1)[:150].strip()
    other = re.search(r"^(?:FAIL!|QFATAL).*", text, re.M)
    return "NOT BY THE JUDGE", other.group(0) if other else text[-200:].replace("\n", " ")


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--build", default="build/dev", help="folder of a finished build")
    options.add_argument("--only", help="the defects whose names match this expression")
    options.add_argument("--jobs", default="2")
    given = options.parse_args()
    wrong = 0
    print("| defect | test | result | the rule's words |\n|---|---|---|---|", flush=True)
    for defect in DEFECTS:
        if given.only and not re.search(given.only, defect[0]):
            continue
        begun = time.monotonic()
        result, words = try_one(defect, given.build, given.jobs)
        wrong += result != "found"
        seconds = round(time.monotonic() - begun)
        print(f"| {defect[0]} | {defect[1].split()[0]} | {result}, {seconds} s | {words.splitlines()[0] if words else ''} |", flush=True)
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
