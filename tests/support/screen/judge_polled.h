// Whether the scope draws what is read in turn as the board gave it: in some columns of a picture that follows, a trace
// lies within what the board gave at that time, give or take what a value needs to come here; is there where values
// came one after the other; and is not where none came for as long as one holds.
#pragma once

#include "support/screen/judged_register.h"
#include "support/screen/picture_ink.h"
#include "support/screen/screen_moment.h"
#include "widgets/scope/cursors.h"
#include "widgets/scope/drawing/stale_mark.h"

#include <map>
#include <set>

namespace support {

class PolledJudge {
public:
    static constexpr Duration kJitter = 400ms; ///< from the line to the picture
    static constexpr Duration kHolds = 2s; ///< a value, where no newer one comes
    static constexpr Duration kInTurn = 600ms; ///< between two values of what is drawn, at most
    static constexpr Duration kLater = 20ms; ///< besides three times what is usual
    static constexpr Duration kBegins = 2s; ///< until what is put on the scope is read in turn
    static constexpr int kLoose = 3; ///< rows by which a value may be off
    static constexpr int kTries = 3; ///< a frame apart

    explicit PolledJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    void look()
    {
        const auto *view = m_moment.find<widgets::ScopeView>("scope");
        const TimePoint now = m_moment.world().now();
        if (view == nullptr || !view->isVisible() || !m_moment.heard || !m_moment.answers()
            || m_moment.more > Duration{} || !view->staleMark().why().isEmpty())
            return m_since.clear();
        std::map<QString, TimePoint> since;
        for (const capture::ChannelId channel : view->channels()) {
            const auto known = m_since.find(view->nameOf(channel));
            since[view->nameOf(channel)] = known == m_since.end() ? now : known->second;
        }
        m_since = std::move(since);
        for (const auto &[name, at] : m_since) // also while the picture stands
            if (const auto known = judgedRegister(m_moment.world(),
                    name.section(QLatin1Char('@'), 0, 0).toStdString(),
                    name.contains(QLatin1Char('@')) ? name.section(QLatin1Char('@'), 1).toInt() : 1,
                    false))
                isStreamed(known->id);
        const auto *mode = m_moment.find<QComboBox>("triggerMode");
        const bool rolls = mode == nullptr || mode->currentText() == QLatin1String("Roll");
        for (int i = 0; i < kTries && view->running() && view->time().following() && rolls; ++i) {
            const std::string wrong = theTracesAre(*view);
            if (wrong.empty())
                return;
            if (i + 1 == kTries)
                m_moment.finds(QStringLiteral("the picture"), QString::fromStdString(wrong),
                    "what is read in turn was otherwise");
            letItPaint();
        }
    }

private:
    using Values = std::deque<judge::GivenValues::Value>;

    /// @return what is not so
    std::string theTracesAre(const widgets::ScopeView &view)
    {
        std::optional<PictureInk> ink;
        m_labels = view.cursors().visible();
        for (const capture::ChannelId channel : view.channels()) {
            const PictureTrace trace(view, channel);
            const int motor = trace.motor(1);
            const auto known = judgedRegister(m_moment.world(), trace.registerName(), motor, false);
            if (!known || trace.plot.width() < 100 || isStreamed(known->id))
                continue;
            const Values values = m_moment.world().given(known->id);
            if (values.empty())
                continue;
            if (!ink)
                ink.emplace(view);
            const auto range = view.visibleRange();
            const double looked =
                (range.to - range.from) * (PictureInk::kAround + 1) / trace.plot.width();
            const Duration around = m_moment.world().drift() + kJitter
                + std::chrono::duration_cast<Duration>(std::chrono::duration<double>(looked));
            if (toSeconds(around) > (range.to - range.from) / 3.0)
                return {};
            for (const PictureInk::Column &column : ink->columnsOf(trace)) {
                const TimePoint at(
                    std::chrono::duration_cast<Duration>(std::chrono::duration<double>(range.from
                        + (range.to - range.from) * column.x / double(trace.plot.width()))));
                const std::string wrong =
                    columnIs(trace, column, values, at, around, known->factor);
                if (!wrong.empty()) {
                    const QString folder = qEnvironmentVariable("ROTORSCOPE_PICTURES");
                    if (!folder.isEmpty()) // to look at it
                        ink->picture().save(
                            folder + QStringLiteral("/untrue-%1.png").arg(m_moment.statements));
                    return wrong;
                }
            }
        }
        return {};
    }

    std::string columnIs(const PictureTrace &trace, const PictureInk::Column &column,
        const Values &values, TimePoint at, Duration around, double factor)
    {
        judge::Extremes near, held, newest; // given around this time, and the two before it
        TimePoint first{}, last{}; // of those around it, with one on each side
        Duration most{};
        int count = 0;
        for (const auto &value : values) {
            const bool before = value.at < at - around;
            if (!before) {
                most = std::max(most, value.at - last);
                ++count;
            }
            if (before)
                first = value.at;
            last = value.at;
            if (value.at > at + around)
                break;
            if (!before) {
                near.include(value.number * factor);
            } else if (value.at >= at - around - kHolds) { // the newest may be lost with a reset
                held = newest;
                newest = {};
                newest.include(value.number * factor);
            }
        }
        held.include(newest);
        // A value that comes much later than usual may have been lost, and what was lost is a gap.
        const bool inTurn =
            count > 1 && most <= kInTurn && most <= 3 * (last - first) / count + kLater;
        judge::Extremes all = near;
        all.include(held);
        // What the judge did not hear from its beginning on it does not know.
        if (values.front().at > at - around - kHolds || at > m_moment.world().now())
            return {};
        ++m_moment.statements;
        const std::string where =
            trace.name.toStdString() + " at column " + std::to_string(column.x);
        if (all.empty())
            return column.top < 0 ? "" : where + ": drawn, and the board gave nothing";
        const int height = trace.plot.height();
        const int top = trace.rowOf(all.greatest), bottom = trace.rowOf(all.least);
        if (column.top >= 0
            && (column.top < std::min(top, height - 1) - kLoose
                || column.bottom > std::max(bottom, 0) + kLoose))
            return where + ": drawn in rows " + std::to_string(column.top) + " to "
                + std::to_string(column.bottom) + ", given in " + std::to_string(top) + " to "
                + std::to_string(bottom);
        const bool sure = inTurn && !near.empty() && last > at + around
            && m_since[trace.name] + kBegins < at - around
            && m_moment.world().linkChanged() + kBegins < at - around;
        if (sure && !m_labels && bottom > kLoose && top < height - kLoose
            && !column.inkedWithin(top - kLoose, bottom + kLoose))
            return where + ": not drawn, and the board gave it";
        return {};
    }

    /// It is, or was: then it is not all in the values.
    bool isStreamed(std::uint16_t id)
    {
        const bool now = m_moment.world().mcp()
            && m_moment.world().ofBoard(
                [id](const judge::McpBoard &board) { return board.sampledAt(id).has_value(); });
        if (now)
            m_streamed.insert(id);
        return m_streamed.contains(id);
    }

    ScreenMoment &m_moment;
    std::map<QString, TimePoint> m_since; ///< from when on each trace has been on the scope
    std::set<std::uint16_t> m_streamed; ///< at any time
    bool m_labels = false; ///< those of the cursors cover a part of the traces
};

} // namespace support
