#include "widgets/control/stop_words.h"

#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"

#include <QGridLayout>
#include <QLabel>

namespace widgets {
namespace {

constexpr std::array kOrder{drive::StopWord::Requested, drive::StopWord::Accepted,
    drive::StopWord::DriveIdle, drive::StopWord::Standstill};

QLabel *plainLabel(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

StopWords::StopWords(QWidget *parent)
    : QWidget(parent)
{
    auto *grid = new QGridLayout(this);
    grid->setContentsMargins(0, 0, 0, 0);
    grid->setVerticalSpacing(1);
    for (std::size_t i = 0; i < kWords; ++i) {
        m_lines[i].mark = plainLabel(this);
        m_lines[i].age = plainLabel(this);
        m_lines[i].age->setAlignment(Qt::AlignRight);
        grid->addWidget(m_lines[i].mark, static_cast<int>(i), 0);
        grid->addWidget(m_lines[i].age, static_cast<int>(i), 1);
    }
    grid->setColumnStretch(0, 1);
    clear();
}

void StopWords::clear()
{
    for (std::size_t i = 0; i < kWords; ++i) {
        m_lines[i].since.reset();
        m_lines[i].mark->setText(QStringLiteral("\u25cb ") + stopWordText(kOrder[i]));
        m_lines[i].mark->setEnabled(false);
        m_lines[i].age->clear();
    }
}

void StopWords::take(const drive::StopProgress &progress, Milliseconds now)
{
    if (progress.word == drive::StopWord::Requested)
        clear();
    const auto found = std::find(kOrder.begin(), kOrder.end(), progress.word);
    if (found == kOrder.end())
        return; // NotConfirmed: the alarm says it, the words stay where the evidence is
    const auto i = static_cast<std::size_t>(found - kOrder.begin());
    m_lines[i].since = now;
    m_lines[i].mark->setText(QStringLiteral("\u25cf ") + stopWordText(progress.word));
    m_lines[i].mark->setEnabled(true);
    refresh(now);
}

void StopWords::refresh(Milliseconds now)
{
    for (const Line &line : m_lines) {
        if (!line.since)
            continue;
        const double age = static_cast<double>((now - *line.since).count()) / 1000.0;
        line.age->setText(tr("%1 s ago").arg(numberText(age, age < 10.0 ? 1 : 0)));
    }
}

bool StopWords::ended() const { return m_lines.back().since.has_value(); }

QString StopWords::text() const
{
    QStringList lines;
    for (const Line &line : m_lines)
        if (line.since)
            lines.append(line.mark->text());
    return lines.join(QLatin1Char('\n'));
}

} // namespace widgets
