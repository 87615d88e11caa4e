#include "widgets/lab/experiments.h"

#include "widgets/base/device_text.h"
#include "widgets/control/motion_allowed.h"
#include "widgets/lab/text.h"

#include <algorithm>

namespace widgets {

Experiments::Experiments(Device &device, std::shared_ptr<session::RecordingTap> tap,
    session::Clock clock, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_tap(std::move(tap))
    , m_clock(std::move(clock))
{
    connect(m_tap.get(), &session::RecordingTap::told, this, &Experiments::accept,
        Qt::QueuedConnection);
    connect(&device, &Device::armedStateChanged, this, [this](bool armed) {
        if (!armed)
            forgetAgreement();
    });
    connect(&device, &Device::identityChanged, this, &Experiments::forgetAgreement);
    connect(&device, &Device::motorChanged, this, &Experiments::forgetAgreement);
}

void Experiments::forgetAgreement()
{
    m_agreed.clear();
    Q_EMIT agreementEnded();
}

Result<lab::Subject, QString> Experiments::subject(bool pollable) const
{
    if (!m_device.answering() || !m_device.identified())
        return fail(motionAllowed(m_device, drive::Feature::SpeedRamp).why);
    const auto find = pollable ? lab::pollableSubjectOf : lab::subjectOf;
    auto found = find(*m_device.identified(), m_device.motor());
    if (!found)
        return fail(labText(found.error()));
    return *found;
}

QString Experiments::obstacle(bool pollable) const
{
    if (running())
        return tr("An experiment is running.");
    const auto motor = subject(pollable);
    if (!motor)
        return motor.error();
    if (!m_device.expert(m_device.motor()) && !drive::gapsIn(motor->limits).empty())
        return tr("This board does not tell all limits of the motor: start it by hand once, and "
                  "agree to expert mode.");
    if (const MotionAllowed can = motionAllowed(m_device, drive::Feature::SpeedRamp); !can.yes)
        return can.why;
    using drive::MotorState;
    const MotorState state = m_device.status(m_device.motor()).state;
    if (drive::hasFault(state))
        return tr("Acknowledge the faults first.");
    if (state != MotorState::Idle && state != MotorState::Running)
        return tr("The motor has to rest or to run.");
    return {};
}

bool Experiments::agreed(const lab::Experiment &experiment, double before_rpm) const
{
    const lab::Agreement wanted = lab::agreementTo(experiment, before_rpm);
    return std::any_of(m_agreed.begin(), m_agreed.end(),
        [&](const lab::Agreement &agreed) { return lab::covers(agreed, wanted); });
}

void Experiments::agree(const lab::Experiment &experiment, double before_rpm)
{
    if (m_device.armed())
        m_agreed.push_back(lab::agreementTo(experiment, before_rpm));
}

void Experiments::begin(std::vector<Part> parts, double before_rpm)
{
    if (running() || parts.empty())
        return;
    m_run = std::make_shared<Run>();
    m_run->startSeconds = m_tap->startSeconds();
    m_restorer = std::make_unique<recorded::Restorer>(m_run->capture);
    m_parts = std::move(parts);
    m_part = 0;
    m_before_rpm = before_rpm;
    m_soFar = {};
    const TimePoint now = m_clock();
    Q_EMIT began();
    if (const auto made = m_device.madeAt(); made && now - *made > drive::kWishExpiresAfter)
        return end({lab::End::Refused, drive::kTooLate, now});
    m_tap->switchOn(++m_number, session::RecordingTap::Content::Samples);
    beginPart(now);
}

void Experiments::beginPart(TimePoint now)
{
    note(now, m_parts[m_part].plan);
    const lab::Experiment next = m_parts[m_part].experiment; // a refusal at once ends all parts
    Q_EMIT wished(next);
}

void Experiments::note(TimePoint at, const recorded::Happening &what)
{
    const capture::Nanos nanos = at.time_since_epoch().count();
    m_run->happenings.emplace_back(nanos, what);
    auto told = std::make_shared<session::Told>();
    told->at = nanos;
    told->entries.emplace_back(what);
    m_run->told.push_back(std::move(told));
    Q_EMIT noted(nanos, what);
}

void Experiments::accept(const session::ToldPtr &told)
{
    m_tap->release(told->bytes);
    if (!running() || told->recording != m_number)
        return;
    m_run->told.push_back(told);
    for (const recorded::Entry &entry : told->entries) {
        if (const auto *happening = std::get_if<recorded::Happening>(&entry))
            m_run->happenings.emplace_back(told->at, *happening);
        else
            m_restorer->accept(entry);
    }
    Q_EMIT progressed();
}

void Experiments::end(const lab::Outcome &outcome)
{
    if (!running())
        return;
    note(outcome.at, lab::entryOfEnd(outcome));
    const bool more = m_part + 1 < m_parts.size();
    m_soFar = lab::inRow(m_soFar, outcome, more);
    if (more && m_soFar.end == lab::End::Complete) {
        ++m_part;
        if (agreed(m_parts[m_part].experiment, m_before_rpm))
            return beginPart(m_clock());
        m_soFar.end = lab::End::Interrupted;
        lab::addReason(m_soFar, "what comes next is not agreed to any more");
    }
    m_tap->switchOff();
    m_run->outcome = m_soFar;
    m_restorer.reset();
    m_parts.clear();
    const RunPtr run = std::move(m_run);
    Q_EMIT ended(run);
}

} // namespace widgets
