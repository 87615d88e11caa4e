// Whether the values of registers that a window shows are those that the board holds: in the rows of the tree that are
// on the screen, in the fields of forms, and in the legend where signals are read in turn. A value without a mark is
// one that the board gave lately; an older one is greyed.
#pragma once

#include "support/screen/judged_register.h"
#include "support/screen/screen_moment.h"
#include "support/screen/text_catcher.h"
#include "widgets/scope/drawing/stale_mark.h"
#include "widgets/scope/view.h"

#include <QLineEdit>
#include <QTreeView>

namespace support {

class ValuesJudge {
public:
    /// Polled four times a second, read again after a silence.
    static constexpr Duration kOld = 2500ms;
    /// The same of one that counts for 2 s in the picture.
    static constexpr Duration kDrawn = 3500ms;

    explicit ValuesJudge(ScreenMoment &moment)
        : m_moment(moment)
    {
    }

    void look()
    {
        theTreeIs();
        theFieldsAre();
        if (!m_moment.world().mcp())
            theLegendIs();
    }

private:
    void theTreeIs()
    {
        const auto *tree = m_moment.find<QTreeView>("registerTree");
        if (tree == nullptr || !tree->isVisible())
            return;
        const int step = std::max(1, tree->visualRect(tree->indexAt({2, 2})).height());
        for (int y = step / 2; y < tree->viewport()->height(); y += step) {
            const QModelIndex index = tree->indexAt({2, y});
            if (!index.isValid() || !index.parent().isValid()
                || tree->isFirstColumnSpanned(index.row(), index.parent()))
                continue;
            const QString name = index.data().toString();
            const QColor grey = tree->palette().color(QPalette::Disabled, QPalette::Text);
            for (int column = 1; column < tree->model()->columnCount(); ++column) {
                const QModelIndex cell = index.siblingAtColumn(column);
                const QString head = tree->model()->headerData(column, Qt::Horizontal).toString();
                const bool raw = head == QLatin1String("Raw");
                if (tree->isColumnHidden(column) || (!raw && head != QLatin1String("Value")))
                    continue;
                const auto brush = cell.data(Qt::ForegroundRole).value<QBrush>();
                const bool marked = brush.style() != Qt::NoBrush && brush.color() == grey;
                const bool edited = cell.data(Qt::BackgroundRole).isValid();
                if (!marked && !edited)
                    valueIs("tree", name, cell.data().toString(), raw);
            }
        }
    }

    void theFieldsAre()
    {
        for (const auto *widget : m_moment.window().findChildren<QWidget *>()) {
            const QString name = widget->objectName();
            const bool raw = name.startsWith(QLatin1String("raw_"));
            if ((!raw && !name.startsWith(QLatin1String("field_"))) || !widget->isVisible())
                continue;
            QString text;
            const QWidget *shows = nullptr;
            if (const auto *edit = widget->findChild<QLineEdit *>()) {
                text = edit->text();
                shows = edit;
            } else if (const auto *label = widget->findChild<QLabel *>()) {
                text = label->text();
                shows = label;
            }
            if (shows == nullptr || shows->hasFocus() || !shows->isEnabled())
                continue;
            const bool edited = shows->palette().color(QPalette::Base)
                != m_moment.window().palette().color(QPalette::Base);
            const bool marked = shows->palette().color(QPalette::Active, QPalette::Text)
                == m_moment.window().palette().color(QPalette::Disabled, QPalette::Text);
            if (!edited && !marked)
                valueIs("field", name.section(QLatin1Char('_'), 1), text, raw);
        }
    }

    /// What is drawn is read in turn, or travels with every exchange.
    void theLegendIs()
    {
        const auto *view = m_moment.find<widgets::ScopeView>("scope");
        if (view == nullptr || !view->isVisible() || !m_moment.heard || m_moment.more > Duration{}
            || !m_moment.answers() || !view->staleMark().why().isEmpty())
            return; // or it shows a file
        TextCatcher texts(view->shapesSize());
        const_cast<widgets::ScopeView *>(view)->drawShapes(texts);
        for (const capture::ChannelId channel : view->channels()) {
            const QString name = view->nameOf(channel), begins = name + QStringLiteral("  ");
            for (const QString &text : texts.caught()) {
                if (!text.startsWith(begins))
                    continue;
                const QString value = text.mid(begins.size());
                const QString full =
                    name.contains(QLatin1Char('@')) ? name : name + QStringLiteral("@1");
                const auto known = judgedRegister(m_moment.world(),
                    full.section(QLatin1Char('@'), 0, 0).toStdString(),
                    full.section(QLatin1Char('@'), 1).toInt(), false);
                const auto came = known ? m_moment.world().newestOf(known->id) : std::nullopt;
                const bool isNumber = ScreenMoment::number(value).has_value();
                if (came && m_moment.world().linkChanged() + 3s < m_moment.world().now())
                    m_moment.ages(QStringLiteral("the legend"), text, isNumber, *came);
                valueIs("legend", full, value, false, kDrawn);
            }
        }
    }

    /// @param where  it is shown
    /// @param text  shown without a mark
    void valueIs(
        const char *where, QString name, const QString &text, bool raw, Duration mostOld = kOld)
    {
        const auto shown = ScreenMoment::number(text);
        const int motor = name.contains(QLatin1Char('@'))
            ? name.section(QLatin1Char('@'), 1).toInt()
            : m_moment.chosenMotor();
        name = name.section(QLatin1Char('@'), 0, 0);
        const auto known = judgedRegister(m_moment.world(), name.toStdString(), motor, raw);
        if (!shown || !known)
            return;
        ++m_moment.statements;
        const std::string wrong = wrongOf(*shown, *known, mostOld);
        if (!wrong.empty())
            m_moment.finds(name + QStringLiteral(" in the ") + QLatin1String(where), text, wrong);
    }
    /// @return  what is not so; empty: it is
    std::string wrongOf(
        const ScreenMoment::Number &shown, const JudgedRegister &known, Duration mostOld) const
    {
        const TimePoint now = m_moment.world().now();
        const Duration old = mostOld + m_moment.moreFor(mostOld);
        const auto values = m_moment.world().given(known.id);
        if (values.empty())
            return "the board never gave it";
        if (values.back().at + old < now)
            return "the board gave it " + seconds(now - values.back().at)
                + " ago, and it has no mark";
        std::string gave;
        for (auto value = values.rbegin(); value != values.rend(); ++value) {
            if (shown.is(value->number * known.factor))
                return {};
            const std::string number = std::to_string(value->number * known.factor);
            if (gave.find(number) == std::string::npos)
                gave += number + ", " + seconds(now - value->at) + " ago; ";
            if (value->at + old < now)
                break;
        }
        return "the board gave " + gave;
    }
    static std::string seconds(Duration time)
    {
        return std::to_string(std::chrono::duration_cast<std::chrono::milliseconds>(time).count())
            + " ms";
    }
    ScreenMoment &m_moment;
};

} // namespace support
