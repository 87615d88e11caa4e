// Whether the trigger's state is true: what it waits for did not come while it says "Armed", and what it says it found
// was there. Judged for faults, set-points and edges of a trace; a trigger that the user forced is none that was found.
#pragma once

#include "support/screen/judged_register.h"
#include "support/screen/screen_moment.h"

#include <QLineEdit>

namespace support {

class TriggerJudge {
public:
    static constexpr Duration kTold = 2500ms; ///< until a happening is in the state
    static constexpr Duration kBefore = 1500ms; ///< by which an age in whole seconds may be off
    static constexpr double kNoise = 64.0; ///< digits from least to greatest

    explicit TriggerJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    /// The user asked for a trigger, took one that was not what is waited for, or set it up again.
    void forced() { m_setUpAt = m_moment.world().now(); }

    /// @param unwell  when the board was last not heard, or time jumped
    void look(TimePoint unwell)
    {
        const QString text = m_moment.said("triggerState");
        const QString setUp = chosen("triggerMode") + chosen("triggerType")
            + chosen("triggerSource") + chosen("triggerWay") + level();
        const TimePoint now = m_moment.world().now();
        const bool armed = text.contains(QLatin1String("Armed"));
        const bool waits = armed || text.contains(QLatin1String("Trig'd"));
        if (setUp != m_setUp || !waits || unwell > m_setUpAt) {
            m_setUp = setUp;
            m_setUpAt = std::max(now, unwell);
            return;
        }
        const QString mode = chosen("triggerMode"), type = chosen("triggerType");
        if (mode != QLatin1String("Normal") && mode != QLatin1String("Single"))
            return;
        if (type == QLatin1String("Fault"))
            happenings(text, m_moment.world().faultTimes(m_moment.chosenMotor(), false),
                m_moment.world().faultTimes(m_moment.chosenMotor(), true), "a fault");
        else if (type == QLatin1String("Set-point"))
            happenings(text, m_moment.world().setPointTimes(), m_moment.world().setPointTimes(),
                "a set-point");
        else if (type == QLatin1String("Edge"))
            edges(text, armed);
    }

private:
    QString chosen(const char *name) const
    {
        const auto *box = m_moment.find<QComboBox>(name);
        return box != nullptr && box->isVisible() ? box->currentText() : QString();
    }
    QString level() const
    {
        const auto *edit = m_moment.find<QLineEdit>("triggerLevel");
        return edit != nullptr && edit->isVisible() ? edit->text() : QString();
    }
    /// How old what it found is; none: it has found nothing.
    static std::optional<Duration> ageIn(const QString &text)
    {
        static const QRegularExpression age(QStringLiteral("([0-9.]+) s ago"));
        const auto match = age.match(text);
        if (!match.hasMatch())
            return {};
        return std::chrono::duration_cast<Duration>(
            std::chrono::duration<double>(match.captured(1).toDouble()));
    }

    /// @param must  be found
    /// @param may  be what was found
    void happenings(const QString &text, const std::vector<TimePoint> &must,
        const std::vector<TimePoint> &may, const char *what)
    {
        const TimePoint now = m_moment.world().now();
        const auto age = ageIn(text);
        const TimePoint found = age ? now - *age : TimePoint{};
        // It has found one, and is filling its record, as long as the board's samples take: when that was is told then.
        const bool fills = text.contains(QLatin1String("Trig'd"));
        ++m_moment.statements;
        for (const TimePoint at : must)
            if (!fills && at > m_setUpAt + kBefore && at + kTold < now && found + kBefore < at)
                return m_moment.finds(QStringLiteral("triggerState"), text,
                    std::string(what) + " came since, "
                        + std::to_string(
                            std::chrono::round<std::chrono::milliseconds>(now - at).count())
                        + " ms ago, and it was set up "
                        + std::to_string(
                            std::chrono::round<std::chrono::milliseconds>(now - m_setUpAt).count())
                        + " ms ago");
        if (!age || found < m_setUpAt + kBefore)
            return; // of an earlier setting
        const bool was = std::any_of(may.begin(), may.end(),
            [&](TimePoint at) { return at > found - kBefore && at < found + kBefore; });
        if (!was)
            m_moment.finds(
                QStringLiteral("triggerState"), text, std::string("there was not ") + what);
    }

    void edges(const QString &text, bool armed)
    {
        const QString source = chosen("triggerSource");
        const auto level = ScreenMoment::number(this->level());
        const int motor = source.contains(QLatin1Char('@'))
            ? source.section(QLatin1Char('@'), 1).toInt()
            : m_moment.chosenMotor();
        const auto known = judgedRegister(
            m_moment.world(), source.section(QLatin1Char('@'), 0, 0).toStdString(), motor, false);
        const TimePoint now = m_moment.world().now();
        if (!known || !level || m_setUpAt + kTold + kBefore > now)
            return;
        ++m_moment.statements;
        const TimePoint middle = now - kTold;
        const judge::Extremes all = during(known->id, m_setUpAt, TimePoint::max()),
                              early = during(known->id, m_setUpAt, middle),
                              late = during(known->id, middle - 1s, middle);
        // The hysteresis is not shown; it is of what the source did when it was chosen, and noise of later is less.
        if (all.greatest - all.least < kNoise)
            return;
        const double factor = known->factor;
        const double share = 0.2 * (all.greatest - all.least) * factor;
        const auto spans = [&](const judge::Extremes &part) {
            return !part.empty() && part.least * factor < level->value - share
                && part.greatest * factor > level->value + share;
        };
        const auto age = ageIn(text);
        // Both ways: whichever is waited for has been there.
        if (armed && !age && spans(early) && spans(late))
            m_moment.finds(QStringLiteral("triggerState"), text,
                source.toStdString() + " went through " + this->level().toStdString());
        const bool since = age && now - *age > m_setUpAt + kBefore
            && *age + kBefore + kTold < judge::GivenValues::kKept;
        if (since && !all.empty()
            && (all.least * factor > level->value + factor
                || all.greatest * factor < level->value - factor))
            m_moment.finds(QStringLiteral("triggerState"), text,
                source.toStdString() + " never came to " + this->level().toStdString());
    }

    /// What the board sent of it between two times, or gave where it is read in turn.
    judge::Extremes during(std::uint16_t id, TimePoint from, TimePoint to) const
    {
        judge::Extremes all;
        if (m_moment.world().mcp())
            all = m_moment.world().ofBoard(
                [&](const judge::McpBoard &board) { return board.between(id, from, to); });
        for (const auto &value : m_moment.world().given(id))
            if (value.at >= from && value.at < to)
                all.include(value.number);
        return all;
    }

    ScreenMoment &m_moment;
    QString m_setUp;
    TimePoint m_setUpAt{};
};

} // namespace support
