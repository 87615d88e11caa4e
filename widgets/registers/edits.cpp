#include "widgets/registers/edits.h"

#include "widgets/base/device_text.h"

#include <QUndoCommand>

#include <algorithm>
#include <utility>

namespace widgets {
namespace {

constexpr int kMostSteps = 500;

struct Change {
    catalog::RegisterId id = 0;
    catalog::Value before, after;
};

/// One applied step. It does nothing by itself: the list moves only when the board has taken the write.
class EditStep : public QUndoCommand {
public:
    EditStep(std::vector<Change> changes, const QString &text)
        : QUndoCommand(text)
        , m_changes(std::make_unique<std::vector<Change>>(std::move(changes)))
    {
    }
    std::vector<Change> &changes() const { return *m_changes; }

private:
    std::unique_ptr<std::vector<Change>> m_changes; // what is left of a step that half went back
};

const EditStep *stepAt(const QUndoStack &stack, int index)
{
    return static_cast<const EditStep *>(stack.command(index));
}

bool took(const drive::Ended &ended, catalog::RegisterId id)
{
    return std::any_of(ended.writes.begin(), ended.writes.end(), [id](const auto &result) {
        return result.id == id && result.outcome == drive::Outcome::Ok && result.verified != false;
    });
}

} // namespace

RegisterEdits::RegisterEdits(Device &device, RegisterModel &model, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_model(model)
{
    m_steps.setUndoLimit(kMostSteps);
    connect(&device, &Device::wishEnded, this, &RegisterEdits::end);
    connect(&device, &Device::linkStateChanged, this, &RegisterEdits::linkChanged);
    connect(&device, &Device::identityChanged, this, &RegisterEdits::linkChanged);
    connect(&device, &Device::portStateChanged, this, &RegisterEdits::linkChanged);
    connect(&device, &Device::armedStateChanged, this, [this](bool armed) {
        m_disarmed = m_disarmed || !armed;
        Q_EMIT changed();
    });
    connect(&model, &RegisterModel::editsChanged, this, &RegisterEdits::changed);
    connect(&m_steps, &QUndoStack::indexChanged, this, &RegisterEdits::changed);
}

void RegisterEdits::keepBeforeWriting(KeepBeforeWriting &snapshots)
{
    m_snapshots = &snapshots;
    connect(&snapshots, &KeepBeforeWriting::made, this, &RegisterEdits::kept);
    connect(&snapshots, &KeepBeforeWriting::broken, this, &RegisterEdits::notKept);
    connect(&snapshots, &KeepBeforeWriting::told, this, [this](const QString &sentence) {
        if (underWay())
            m_aside.append(sentence); // the end of the write would take its place at once
        else
            Q_EMIT told(sentence, false);
    });
}

QString RegisterEdits::writeHint() const
{
    if (!m_device.answering() || !m_device.identified())
        return tr("No board is answering.");
    if (const auto write = m_device.capability(drive::Feature::WriteRegisters); !write.available)
        return deviceText(write.reason);
    if (!m_device.armed())
        return tr("Arm first: nothing is written to a board that is not armed.");
    if (m_stage == Stage::Sending || m_stage == Stage::Keeping)
        return tr("The last write is still under way.");
    if (m_stage == Stage::Asking)
        return tr("A question is open.");
    return {};
}

QString RegisterEdits::applyHint() const
{
    return pendingCount() == 0 ? tr("Nothing was edited.") : writeHint();
}

QString RegisterEdits::undoHint() const
{
    return m_steps.canUndo() ? writeHint() : tr("Nothing to undo.");
}

QString RegisterEdits::redoHint() const
{
    return m_steps.canRedo() ? writeHint() : tr("Nothing to redo.");
}

void RegisterEdits::apply()
{
    if (applyHint().isEmpty())
        begin(Verb::Apply, m_model.pending());
}

void RegisterEdits::write(const QString &text, std::vector<drive::RegisterWrite> writes)
{
    if (!writeHint().isEmpty())
        return;
    m_text = text;
    begin(Verb::Write, std::move(writes));
}

void RegisterEdits::undo()
{
    if (undoHint().isEmpty())
        begin(Verb::Undo, stepWrites(Verb::Undo));
}

void RegisterEdits::redo()
{
    if (redoHint().isEmpty())
        begin(Verb::Redo, stepWrites(Verb::Redo));
}

/// What takes a step back, in the opposite order, or writes it again.
std::vector<drive::RegisterWrite> RegisterEdits::stepWrites(Verb verb) const
{
    const bool back = verb == Verb::Undo;
    const auto &changes = stepAt(m_steps, m_steps.index() - (back ? 1 : 0))->changes();
    std::vector<drive::RegisterWrite> writes;
    writes.reserve(changes.size());
    for (const Change &change : changes)
        writes.push_back({change.id, back ? change.before : change.after});
    if (back)
        std::reverse(writes.begin(), writes.end());
    return writes;
}

drive::HeldValues RegisterEdits::facts() const
{
    return {[this](catalog::RegisterId id) { return m_model.known(id); },
        [this](int motor) {
            return motor > 0 ? !drive::rests(m_device.status(motor).state) : !m_device.allIdle();
        }};
}

QList<WriteLine> RegisterEdits::cautious(const std::vector<drive::RegisterWrite> &writes) const
{
    QList<WriteLine> lines;
    const auto catalog = m_device.catalog();
    if (!catalog)
        return lines;
    const auto cautions = drive::cautionsOf(writes, *catalog, facts());
    for (std::size_t i = 0; i < writes.size(); ++i) {
        if (cautions[i] == catalog::Caution::None)
            continue;
        const catalog::RegisterId id = writes[i].id;
        const catalog::RegisterInfo &info = *catalog->find(id);
        const auto old = m_model.known(id);
        lines.append({deviceText(info.name), old ? m_model.describe(id, *old) : QString(),
            m_model.describe(id, writes[i].value), info.perMotor ? catalog->motorOf(id) : 0,
            cautions[i], info.effect != catalog::Effect::Kept});
    }
    return lines;
}

void RegisterEdits::begin(Verb verb, std::vector<drive::RegisterWrite> writes)
{
    if (writes.empty())
        return;
    m_verb = verb;
    const auto catalog = m_device.catalog();
    m_writes =
        catalog ? drive::pairsTogether(std::move(writes), *catalog, facts()) : std::move(writes);
    m_confirmed = false;
    const QList<WriteLine> lines = cautious(m_writes);
    if (lines.isEmpty())
        return keepOrSend();
    m_stage = Stage::Asking;
    Q_EMIT changed();
    Q_EMIT asked(lines);
}

void RegisterEdits::confirm()
{
    if (m_stage != Stage::Asking)
        return;
    m_stage = Stage::Idle;
    if (const QString hint = writeHint(); !hint.isEmpty()) {
        notSent(hint);
    } else {
        m_confirmed = true;
        keepOrSend();
    }
}

void RegisterEdits::decline()
{
    if (m_stage != Stage::Asking)
        return;
    m_stage = Stage::Idle;
    Q_EMIT changed();
    Q_EMIT declined();
    if (!m_aside.isEmpty())
        tellEnd({}, false);
}

void RegisterEdits::keepOrSend()
{
    if (m_snapshots == nullptr || m_writes.size() < 2)
        return send();
    m_stage = Stage::Keeping;
    m_disarmed = false;
    Q_EMIT changed();
    m_snapshots->make();
}

void RegisterEdits::kept()
{
    if (m_stage != Stage::Keeping)
        return;
    m_stage = Stage::Idle;
    if (const QString hint = writeHint(); !hint.isEmpty())
        return notSent(hint);
    if (m_disarmed) // it was armed again for something else
        return notSent(tr("Nothing was written: the board was disarmed meanwhile."));
    // The motor may have started meanwhile.
    const QList<WriteLine> lines = m_confirmed ? QList<WriteLine>() : cautious(m_writes);
    if (lines.isEmpty())
        return send();
    m_stage = Stage::Asking;
    Q_EMIT changed();
    Q_EMIT asked(lines);
}

void RegisterEdits::notKept(const QString &sentence)
{
    if (m_stage != Stage::Keeping)
        return;
    m_stage = Stage::Idle;
    notSent(sentence);
}

/// The end of a list of which nothing has left.
void RegisterEdits::notSent(const QString &why)
{
    drive::Ended ended;
    ended.outcome = drive::Outcome::NotSent;
    WriteReport report =
        writeReport(ended, m_writes, m_device.catalog().get(), WriteSense::Forward);
    report.text = m_verb == Verb::Write ? m_text : QString();
    report.sentence = why;
    Q_EMIT changed();
    tellEnd(why, false);
    Q_EMIT reported(report);
}

void RegisterEdits::send()
{
    m_stage = Stage::Sending;
    if (m_verb == Verb::Apply)
        m_model.markSending(m_writes);
    // What comes from a form or a file holds parameters only; what nothing bounds takes the yes to the question.
    using drive::Reach;
    const Reach reach = m_verb == Verb::Write ? Reach::Parameters
        : m_confirmed                         ? Reach::Everything
                                              : Reach::References;
    m_wish = m_device.submit(drive::Write{m_writes, reach});
    Q_EMIT changed();
}

void RegisterEdits::end(const drive::Ended &ended)
{
    if (m_stage != Stage::Sending || ended.id != m_wish)
        return;
    m_stage = Stage::Idle;
    m_wish = 0;
    m_model.onResults(ended.writes);
    m_model.markNotSent(); // what the answer does not name
    if (m_device.answering())
        keep(ended);
    Q_EMIT changed();
    tell(ended);
}

/// Brings the list of steps to what the board has taken.
void RegisterEdits::keep(const drive::Ended &ended)
{
    if (m_verb == Verb::Apply || m_verb == Verb::Write) {
        std::vector<Change> changes;
        for (const drive::WriteResult &result : ended.writes)
            if (result.outcome == drive::Outcome::Ok && result.before && result.readBack
                && *result.before != *result.readBack)
                changes.push_back({result.id, *result.before, *result.readBack});
        if (changes.empty())
            return;
        const QString name = deviceText(m_device.catalog()->nameOf(changes.front().id));
        const QString text = m_verb == Verb::Write && !m_text.isEmpty() ? m_text
            : changes.size() == 1
            ? name
            : tr("%n register(s)", "how many were written", static_cast<int>(changes.size()));
        m_steps.push(new EditStep(std::move(changes), text));
        return;
    }
    const bool back = m_verb == Verb::Undo;
    auto &changes = stepAt(m_steps, m_steps.index() - (back ? 1 : 0))->changes();
    const auto isTaken = [&](const Change &change) { return took(ended, change.id); };
    const auto taken = std::count_if(changes.begin(), changes.end(), isTaken);
    if (taken == 0)
        return;
    const bool all = taken == static_cast<std::ptrdiff_t>(changes.size());
    // A step that went half way stays in the list with the half that the board still holds as applied.
    if (!all && back)
        std::erase_if(changes, isTaken);
    else if (!all)
        std::erase_if(changes, [&](const Change &change) { return !isTaken(change); });
    if (back && all)
        m_steps.undo();
    else if (!back)
        m_steps.redo();
}

void RegisterEdits::tell(const drive::Ended &ended)
{
    const auto catalog = m_device.catalog();
    WriteReport report = writeReport(ended, m_writes, catalog.get(),
        m_verb == Verb::Undo ? WriteSense::Back : WriteSense::Forward);
    report.text = m_verb == Verb::Write ? m_text : QString();
    tellEnd(report.sentence, report.good());
    Q_EMIT reported(report);
}

/// How it ended and, behind it, what was told on the way: one sentence takes the place of the last.
void RegisterEdits::tellEnd(const QString &sentence, bool good)
{
    QStringList sentences = std::exchange(m_aside, {});
    good = good && sentences.isEmpty();
    if (!sentence.isEmpty())
        sentences.prepend(sentence);
    Q_EMIT told(sentences.join(QLatin1Char(' ')), good);
}

void RegisterEdits::linkChanged()
{
    using drive::LinkState;
    const drive::LinkChanged link = m_device.link();
    if (!m_device.portOpen() || !m_device.identified() || link.state == LinkState::Lost
        || link.state == LinkState::Closed || link.reason == drive::LinkReason::BoardReset)
        forget();
    Q_EMIT changed();
}

void RegisterEdits::forget()
{
    if (m_stage == Stage::Sending && !m_device.portOpen()) {
        m_stage = Stage::Idle; // whose end will not be told
        m_model.markNotSent();
        tell({.id = m_wish, .outcome = drive::Outcome::Unknown, .reason = {}, .writes = {}});
    }
    if (m_steps.count() == 0)
        return;
    m_steps.clear();
    Q_EMIT told(tr("Undo is not available after a reconnect."), false);
}

} // namespace widgets
