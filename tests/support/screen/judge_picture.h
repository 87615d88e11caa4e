// Whether the scope draws what the board sent: in some columns of the picture that is on the screen, a trace's pixels
// lie within the least and the greatest of the samples of that time, are there where samples are, and are not where
// none are. Time on the picture and the board's ticks are laid together first: the picture may be a frame old, and its
// zero is told nowhere. Where samples are told apart, or the picture does not follow, nothing is judged. And what
// stands in the legend is what came last.
#pragma once

#include "support/screen/picture_ink.h"
#include "support/screen/screen_moment.h"
#include "support/screen/text_catcher.h"
#include "support/wire/mcp_registers.h"
#include "widgets/scope/cursors.h"
#include "widgets/scope/drawing/stale_mark.h"
#include "widgets/scope/ghosts.h"

#include <cmath>

namespace support {

class PictureJudge {
public:
    static constexpr int kLabels = 24; ///< rows
    static constexpr double kLetters = 0.07; ///< of the width, where references have theirs
    static constexpr int kEdge = 2; ///< rows: there the frame of the plot lies over a trace
    /// Columns by which a time, and rows by which a value may be off.
    static constexpr int kLoose = 3;
    static constexpr int kGap = 10; ///< columns without samples that a gap has at least
    static constexpr Duration kJitter = 400ms; ///< of arrivals, from packet to packet
    static constexpr Duration kLately = 2500ms; ///< as values may be old
    static constexpr Duration kUnderWay = 500ms; ///< from a sample's arrival to its picture
    static constexpr Duration kMends = 1s; ///< until the stream is in step again after a loss
    static constexpr int kTries = 3; ///< a frame apart

    explicit PictureJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    void look()
    {
        const auto *view = m_moment.find<widgets::ScopeView>("scope");
        if (!m_moment.world().mcp() || view == nullptr || !view->isVisible() || !m_moment.heard
            || m_moment.more > Duration{} || !view->staleMark().why().isEmpty())
            return;
        m_traces.clear();
        for (const capture::ChannelId channel : view->channels())
            if (auto trace = traceOf(*view, channel))
                m_traces.push_back(*trace);
        theLegendIs(*const_cast<widgets::ScopeView *>(view));
        const auto *mode = m_moment.find<QComboBox>("triggerMode");
        const bool rolls = mode == nullptr || mode->currentText() == QLatin1String("Roll");
        for (int i = 0; i < kTries && view->running() && view->time().following() && rolls; ++i) {
            const std::string wrong = theColumnsAre(*view);
            if (wrong.empty())
                return;
            if (i + 1 == kTries)
                m_moment.finds(QStringLiteral("the picture"), QString::fromStdString(wrong),
                    "the board sent other samples");
            letItPaint(); // what is laid out may not have been painted yet
            m_traces.clear();
            for (const capture::ChannelId channel : view->channels())
                if (auto trace = traceOf(*view, channel))
                    m_traces.push_back(*trace);
        }
    }

private:
    using Digit = judge::McpRegister::Digit;
    struct Trace : PictureTrace {
        using PictureTrace::PictureTrace;
        std::uint16_t id = 0;
        double factor = 1.0; ///< of a sample's digit
        std::vector<judge::Extremes> sent{}; ///< by column, from m_left on
    };

    std::optional<Trace> traceOf(const widgets::ScopeView &view, capture::ChannelId channel) const
    {
        Trace trace(view, channel);
        const auto *known = judge::findMcpRegister(trace.registerName());
        if (known == nullptr)
            return {};
        trace.id = static_cast<std::uint16_t>(known->bare | trace.motor(1));
        trace.factor = known->digit == Digit::Amps ? m_moment.world().ampsPerDigit()
            : known->digit == Digit::TenthHz       ? 6.0
            : known->digit == Digit::Degrees       ? 360.0 / 65536.0
                                                   : 0.0;
        return trace;
    }

    void theLegendIs(widgets::ScopeView &view)
    {
        if (!m_moment.said("portLamp").contains(QLatin1String("port open")))
            return; // the last values of a closed port; that it is open again was not told yet
        TextCatcher texts(view.shapesSize());
        view.drawShapes(texts);
        const TimePoint now = m_moment.world().now();
        const bool mending = m_moment.world().ofBoard([now](const judge::McpBoard &board) {
            return !board.lost().empty() && board.lost().back().first + kLately > now;
        }) || m_moment.world().linkChanged() + kLately > now;
        for (const Trace &trace : m_traces) {
            const QString begins = trace.name + QStringLiteral("  ");
            for (const QString &text : texts.caught()) {
                if (!text.startsWith(begins))
                    continue;
                const auto shown = ScreenMoment::number(text.mid(begins.size()));
                // What is read for a table beside it is not drawn, but its number may be either.
                const auto came = shown
                    ? m_moment.world().newestOf(trace.id)
                    : m_moment.world().ofBoard(
                        [&](const judge::McpBoard &board) { return board.sampledAt(trace.id); });
                if (came && !mending)
                    m_moment.ages(QStringLiteral("the legend"), text, shown.has_value(), *came);
                if (!shown)
                    continue;
                const auto [sent, read] =
                    m_moment.world().ofBoard([&](const judge::McpBoard &board) {
                        judge::Extremes values;
                        for (const auto &value : board.given().of(trace.id))
                            if (value.at + kLately > now)
                                values.include(value.number);
                        return std::pair(board.since(trace.id, now - kLately), values);
                    });
                // A signal that is read in turn comes as a value; both may be.
                if (sent.empty() || trace.factor == 0.0 || mending)
                    continue;
                ++m_moment.statements;
                const double slack =
                    std::abs(trace.factor) + 0.5 * std::pow(10.0, -shown->decimals);
                const bool streamed = shown->value >= sent.least * trace.factor - slack
                    && shown->value <= sent.greatest * trace.factor + slack;
                const bool polled = !read.empty()
                    && shown->value >= read.least * trace.factor - slack
                    && shown->value <= read.greatest * trace.factor + slack;
                if (!streamed && !polled)
                    m_moment.finds(QStringLiteral("the legend"), text,
                        "the board sent " + std::to_string(sent.least * trace.factor) + " to "
                            + std::to_string(sent.greatest * trace.factor));
            }
        }
    }

    /// @return what is not so
    std::string theColumnsAre(const widgets::ScopeView &view)
    {
        const auto range = view.visibleRange();
        // The board counts the control periods of all its motors.
        const auto hz = m_moment.world().options().hfHz * m_moment.world().options().motors;
        const int width = m_traces.empty() ? 0 : m_traces.front().plot.width();
        if (width < 100)
            return {};
        const double perColumn = (range.to - range.from) / width; // seconds
        const auto drift = toSeconds(m_moment.world().drift() + kJitter);
        const int off = static_cast<int>(drift / perColumn);
        if (perColumn * hz < 4.0 || off > width / 3)
            return {};
        m_known = m_drawn = 0;
        const TimePoint now = m_moment.world().now();
        const TimePoint linked = m_moment.world().linkChanged();
        // While a thread stood still the board's time and the picture's went apart, and a board that was met anew has
        // an axis of its own: before that they do not fit as a whole.
        const TimePoint whole = std::max(now - m_moment.calm, linked);
        m_steady =
            static_cast<int>((toSeconds(whole.time_since_epoch()) - range.from) / perColumn) + off;
        // Where the samples are, were the newest packet just drawn.
        const bool known = m_moment.world().ofBoard([&](const judge::McpBoard &board) {
            bool any = false;
            for (Trace &trace : m_traces) {
                const auto at = board.sampledAt(trace.id);
                const auto newest = board.newestTick(trace.id), oldest = board.oldestTick(trace.id);
                if (!at || trace.factor == 0.0 || now - *at > kLately)
                    continue;
                const auto &samples = board.samplesOf(trace.id);
                const std::int64_t step =
                    samples.size() < 2 ? 1 : samples.back().tick - samples[samples.size() - 2].tick;
                if (double(3 * step) > perColumn * hz)
                    continue; // told apart
                const double zero = toSeconds(at->time_since_epoch()) - double(*newest) / hz;
                const double first = (range.from - zero) * hz - off * perColumn * hz;
                trace.sent.resize(
                    static_cast<std::size_t>(width) + 2U * static_cast<std::size_t>(off));
                for (std::size_t i = 0; i < trace.sent.size(); ++i) {
                    const auto from = static_cast<std::int64_t>(first + double(i) * perColumn * hz);
                    const auto to =
                        static_cast<std::int64_t>(first + double(i + 1) * perColumn * hz);
                    trace.sent[i] = board.extremes(trace.id, from, to);
                    if (from < *oldest)
                        m_known = std::max(m_known, int(i) + 1);
                }
                m_drawn =
                    static_cast<int>(
                        (toSeconds(at->time_since_epoch() - kUnderWay) - range.from) / perColumn)
                    + off;
                m_linked =
                    static_cast<int>(
                        (toSeconds(linked.time_since_epoch() + kMends) - range.from) / perColumn)
                    + off;
                // Behind a loss it takes a while until packets are told apart again: some may be missing, none made up.
                m_mended.clear();
                for (const auto &[when, tick] : board.lost())
                    m_mended.emplace_back(
                        static_cast<int>((double(tick) / hz + zero - range.from) / perColumn) + off,
                        static_cast<int>(toSeconds(kMends) / perColumn));
                any = true;
            }
            return any;
        });
        if (!known)
            return {};
        const PictureInk ink(view);
        m_labels = view.cursors().visible();
        const bool references = const_cast<widgets::ScopeView &>(view).ghosts().hasReference();
        m_letters = references ? static_cast<int>(kLetters * width) : 0;
        m_painted.clear();
        for (const Trace &trace : m_traces)
            if (!trace.sent.empty())
                for (PictureInk::Column &column : ink.columnsOf(trace))
                    m_painted.push_back({&trace, std::move(column)});
        std::string best;
        std::size_t least = std::numeric_limits<std::size_t>::max();
        for (int shift = 0; shift <= 2 * off && least > 0; ++shift) {
            std::string first;
            const std::size_t wrong = compare(shift, first);
            if (wrong < least) {
                least = wrong;
                best = first;
            }
        }
        m_moment.statements += static_cast<int>(m_painted.size());
        const QString folder = qEnvironmentVariable("ROTORSCOPE_PICTURES");
        if (least > 0 && !folder.isEmpty()) // to look at it
            ink.picture().save(folder + QStringLiteral("/untrue-%1.png").arg(m_moment.statements));
        if (least == 0)
            return {};
        return best + " and " + std::to_string(least - 1) + " other places, in a picture to "
            + std::to_string(range.to) + " s at "
            + std::to_string(toSeconds(now.time_since_epoch())) + " s";
    }
    struct Painted {
        const Trace *trace;
        PictureInk::Column column;
    };

    /// @param shift  columns between the picture and the samples. @return how many places differ
    std::size_t compare(int shift, std::string &first) const
    {
        std::size_t wrong = 0;
        for (const Painted &one : m_painted) {
            const Trace &trace = *one.trace;
            const PictureInk::Column &painted = one.column;
            if (painted.x + shift - kGap < m_known + kLoose || painted.x < m_steady)
                continue; // from before the judge listened, or a thread stood still
            if (painted.x < m_letters)
                continue;
            const int at = painted.x + shift;
            const auto sent = [&](int around) {
                judge::Extremes all;
                for (int x = painted.x - around; x <= painted.x + around; ++x)
                    if (const auto cell = std::size_t(std::max(0, x + shift));
                        cell < trace.sent.size())
                        all.include(trace.sent[cell]);
                return all;
            };
            const judge::Extremes wide = sent(PictureInk::kAround + kLoose), narrow = sent(1);
            const std::string where =
                trace.name.toStdString() + " at column " + std::to_string(painted.x);
            const int height = trace.plot.height();
            const auto row = [&](double digits) { return trace.rowOf(digits * trace.factor); };
            if (wide.empty() && painted.top >= 0 && sent(kGap).empty()) {
                note(first, where + ": drawn, and nothing was sent");
                ++wrong;
            } else if (!wide.empty() && painted.top >= 0
                && (painted.top < std::min(row(wide.greatest), height - 1) - kLoose
                    || painted.bottom > std::max(row(wide.least), 0) + kLoose)) {
                note(first,
                    where + ": drawn in rows " + std::to_string(painted.top) + " to "
                        + std::to_string(painted.bottom) + ", sent in "
                        + std::to_string(row(wide.greatest)) + " to "
                        + std::to_string(row(wide.least)));
                ++wrong;
            }
            const bool mends =
                std::any_of(m_mended.begin(), m_mended.end(), [at](const auto &loss) {
                    return at > loss.first - kGap && at < loss.first + loss.second;
                });
            if (narrow.empty() || at > m_drawn || at < m_linked || mends)
                continue; // it need not be there; what is there has been sent
            const int from = row(narrow.greatest) - kLoose, to = row(narrow.least) + kLoose;
            if (to < kLoose + kEdge || from > height - kLoose - kEdge)
                continue; // out of the picture, or under its edge
            if (m_labels && to > height - kLabels)
                continue; // those of the cursors stand on the lower edge
            if (!painted.inkedWithin(from, std::min(height - 1, to))) {
                note(first, where + ": not drawn, and the board sent it");
                ++wrong;
            }
        }
        return wrong;
    }
    static void note(std::string &first, const std::string &what)
    {
        if (first.empty())
            first = what;
    }

    ScreenMoment &m_moment;
    std::vector<Trace> m_traces;
    std::vector<Painted> m_painted;
    std::vector<std::pair<int, int>> m_mended; ///< columns at which a loss begins, and for how many
    bool m_labels = false; ///< of the cursors are there
    int m_letters = 0; ///< columns in which those of references stand, in the colours of the traces
    int m_linked = 0; ///< columns before the link stood
    int m_steady = 0; ///< the first column that is judged
    int m_known = 0, m_drawn = 0; ///< columns from and to which the judge can tell what is right
};

} // namespace support
