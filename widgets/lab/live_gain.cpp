#include "widgets/lab/live_gain.h"

#include "drive/values.h"
#include "widgets/base/device_text.h"

#include <QKeyEvent>
#include <QTimer>

#include <algorithm>
#include <cmath>

namespace widgets {
namespace {

constexpr double kNotch = 1.05;

} // namespace

LiveGain::LiveGain(RegisterModel &model, RegisterEdits &edits, const char *name, QWidget *parent)
    : EntryEdit([this] { return id() ? m_model.rulesOf(*id()) : std::nullopt; }, As::Raw, parent)
    , m_model(model)
    , m_edits(edits)
    , m_name(name)
{
    setObjectName(QStringLiteral("live_") + QLatin1String(name));
    setMaxLength(12);
    setEmptyAllowed(true);
    connect(&model, &RegisterModel::catalogSet, this, [this] {
        m_wanted.reset();
        m_sent.reset();
        follow();
    });
    connect(&model, &QAbstractItemModel::dataChanged, this,
        [this](const QModelIndex &from, const QModelIndex &to) {
            for (const auto &mine : {id(), divisor()}) {
                const QModelIndex at = mine ? m_model.indexOf(*mine) : QModelIndex();
                if (at.isValid() && at.parent() == from.parent() && at.row() >= from.row()
                    && at.row() <= to.row())
                    return follow();
            }
        });
    connect(&edits, &RegisterEdits::changed, this, &LiveGain::follow);
    // Behind the end of the write that tells it: the next one must not begin inside of it.
    connect(&edits, &RegisterEdits::changed, this, &LiveGain::send, Qt::QueuedConnection);
    follow();
}

std::optional<catalog::RegisterId> LiveGain::id() const { return m_model.idOf(m_name); }

std::optional<catalog::RegisterId> LiveGain::divisor() const
{
    return m_model.idOf(m_name + "_DIV");
}

std::optional<std::int64_t> LiveGain::digits() const { return knownWhole(m_model, m_name); }

std::optional<std::int64_t> LiveGain::exponent() const
{
    return knownWhole(m_model, m_name + "_DIV");
}

std::optional<double> LiveGain::gain() const
{
    const auto held = m_wanted ? m_wanted : digits();
    if (!held)
        return std::nullopt;
    constexpr std::int64_t kMostExponent = 31;
    const std::int64_t power = std::clamp<std::int64_t>(exponent().value_or(0), 0, kMostExponent);
    return static_cast<double>(*held) / std::exp2(static_cast<double>(power));
}

/// 5 % a notch, and at least one digit.
void LiveGain::stepBy(int steps)
{
    const auto rules = this->rules();
    const auto from = m_wanted ? m_wanted : digits();
    if (!rules || !from || isReadOnly())
        return;
    std::int64_t next = std::llround(static_cast<double>(*from) * std::pow(kNotch, steps));
    if (next == *from)
        next += steps > 0 ? 1 : -1;
    const double least = *from >= 0 ? std::max(rules->limits.least, 0.0) : rules->limits.least;
    const double inside = std::clamp(static_cast<double>(next), least, rules->limits.greatest);
    want(std::llround(inside));
}

void LiveGain::want(std::int64_t digits)
{
    m_wanted = digits;
    setFollowed(QString::number(digits));
    setModified(false);
    showProblem();
    send();
    Q_EMIT changed();
}

void LiveGain::send()
{
    if (m_sent && !m_edits.underWay()) { // it has ended, well or not
        const bool newer = m_wanted && *m_wanted != *m_sent;
        m_sent.reset();
        if (!newer)
            m_wanted.reset();
        show();
        Q_EMIT changed();
    }
    if (!m_wanted || m_sent || m_edits.underWay())
        return;
    const auto gain = id();
    if (!gain || !m_edits.writeHint().isEmpty() || digits() == m_wanted) {
        m_wanted.reset();
        show();
        Q_EMIT changed();
        return;
    }
    m_sent = m_wanted;
    m_edits.write(
        QStringLiteral("%1 %2").arg(QString::fromStdString(m_name), QString::number(*m_wanted)),
        {{*gain, catalog::Value(*m_wanted)}});
}

void LiveGain::follow()
{
    show();
    const std::pair now(digits(), exponent());
    if (std::exchange(m_told, now) != now)
        Q_EMIT changed();
}

void LiveGain::show()
{
    const QString why = m_edits.underWay() ? QString() : m_edits.writeHint();
    setReadOnly(!why.isEmpty());
    setEnabled(id() && digits() && (why.isEmpty() || hasFocus())); // a hiccup takes no focus away
    setToolTip(plainToolTip(why.isEmpty()
            ? tr("Arrow keys or the wheel: 5 % a notch, written at once. Undo takes it back.")
            : why));
    const auto held = m_wanted ? m_wanted : digits();
    if (hasFocus() && isModified())
        return; // it is being typed
    setFollowed(held ? QString::number(*held) : QString());
    showProblem();
}

void LiveGain::keyPressEvent(QKeyEvent *event)
{
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (!enter || event->modifiers() & Qt::ControlModifier)
        return EntryEdit::keyPressEvent(event);
    event->accept();
    const auto typed = value();
    const auto *whole = typed ? std::get_if<std::int64_t>(&*typed) : nullptr;
    if (whole && isModified() && !isReadOnly() && !event->isAutoRepeat())
        want(*whole);
}

/// What was typed and not entered is dropped: nothing is written by walking past a field.
void LiveGain::focusOutEvent(QFocusEvent *event)
{
    EntryEdit::focusOutEvent(event);
    setModified(false);
    show();
}

} // namespace widgets
