#include "widgets/control/stop_words.h"

#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"

#include <QGridLayout>
#include <QLabel>

#include <algorithm>
#include <iterator>

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
    , m_grid(new QGridLayout(this))
{
    setObjectName(QStringLiteral("stopWords"));
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setVerticalSpacing(1);
    m_grid->setColumnStretch(0, 1);
    motor(1);
}

StopWords::Motor &StopWords::motor(int number)
{
    const auto [at, isNew] = m_motors.try_emplace(number);
    Motor &motor = at->second;
    if (!isNew)
        return motor;
    constexpr int kRows = kWords + 1;
    const int top = kRows * static_cast<int>(m_motors.size());
    motor.name = plainLabel(this);
    motor.name->setText(tr("Motor %1").arg(QString::number(number)));
    m_grid->addWidget(motor.name, top, 0, 1, 2);
    for (std::size_t i = 0; i < kWords; ++i) {
        Line &line = motor.lines[i];
        line.mark = plainLabel(this);
        line.age = plainLabel(this);
        line.age->setAlignment(Qt::AlignRight);
        m_grid->addWidget(line.mark, top + 1 + static_cast<int>(i), 0);
        m_grid->addWidget(line.age, top + 1 + static_cast<int>(i), 1);
    }
    motor.lines.back().mark->setWordWrap(true); // it may have to say why there is none
    clear(motor);
    for (auto &[any, one] : m_motors)
        one.name->setVisible(m_motors.size() > 1);
    return motor;
}

void StopWords::clear(Motor &motor)
{
    for (std::size_t i = 0; i < kWords; ++i) {
        Line &line = motor.lines[i];
        line.since.reset();
        line.mark->setText(QStringLiteral("\u25cb ") + stopWordText(kOrder[i]));
        line.mark->setEnabled(false);
        line.age->clear();
    }
}

void StopWords::clear()
{
    // Another board may have fewer motors.
    for (auto at = std::next(m_motors.begin()); at != m_motors.end(); at = m_motors.erase(at)) {
        delete at->second.name;
        for (const Line &line : at->second.lines) {
            delete line.mark;
            delete line.age;
        }
    }
    m_motors.begin()->second.name->hide();
    clear(m_motors.begin()->second);
}

void StopWords::take(const drive::StopProgress &progress, Milliseconds now)
{
    // Where nothing measures the speed that is the last word.
    const auto found = progress.word == drive::StopWord::MayCoast
        ? kOrder.end() - 1
        : std::find(kOrder.begin(), kOrder.end(), progress.word);
    if (found == kOrder.end())
        return; // NotConfirmed: the alarm says it, the words stay where the evidence is
    Motor &motor = this->motor(progress.motor);
    std::optional<Milliseconds> since = now;
    if (progress.word == drive::StopWord::Requested) {
        // A stop that goes on over a connection that was lost is as old as it is.
        if (const auto asked = motor.lines.front().since; asked && !motor.lines[2].since)
            since = asked;
        clear(motor);
    }
    // The last word may take two lines; that the board accepted the stop says nothing beside them.
    for (QLabel *label : {motor.lines[1].mark, motor.lines[1].age})
        label->setVisible(progress.word != drive::StopWord::MayCoast);
    Line &line = motor.lines[static_cast<std::size_t>(found - kOrder.begin())];
    line.since = since;
    line.mark->setText(QStringLiteral("\u25cf ") + stopWordText(progress.word));
    line.mark->setEnabled(true);
    refresh(now);
}

void StopWords::refresh(Milliseconds now)
{
    for (const auto &[number, motor] : m_motors) {
        for (const Line &line : motor.lines) {
            if (!line.since)
                continue;
            const double age = static_cast<double>((now - *line.since).count()) / 1000.0;
            line.age->setText(tr("%1 s ago").arg(numberText(age, age < 10.0 ? 1 : 0)));
        }
    }
}

bool StopWords::rested() const
{
    return std::all_of(m_motors.begin(), m_motors.end(), [](const auto &one) {
        const auto &lines = one.second.lines;
        return lines[2].since.has_value() || lines[3].since.has_value();
    });
}

QString StopWords::text() const
{
    QStringList words;
    for (const auto &[number, motor] : m_motors) {
        if (m_motors.size() > 1)
            words.append(motor.name->text());
        for (const Line &line : motor.lines)
            if (line.since)
                words.append(line.mark->text());
    }
    return words.join(QLatin1Char('\n'));
}

} // namespace widgets
