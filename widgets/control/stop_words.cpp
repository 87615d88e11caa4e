#include "widgets/control/stop_words.h"

#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"
#include "widgets/base/value_text.h"

#include <QEvent>
#include <QGridLayout>
#include <QLabel>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kLineGap = 1; ///< pixels between two lines

constexpr std::array kOrder{drive::StopWord::Requested, drive::StopWord::Accepted,
    drive::StopWord::DriveIdle, drive::StopWord::Standstill};

QLabel *plainLabel(QWidget *parent)
{
    auto *label = new QLabel(parent);
    label->setTextFormat(Qt::PlainText);
    return label;
}

} // namespace

QString StopWords::Motor::reached() const
{
    QStringList all;
    for (const Word &word : words)
        if (word.since)
            all.append(QStringLiteral("\u25cf ") + word.text);
    return all.join(QLatin1Char('\n'));
}

StopWords::StopWords(QWidget *parent)
    : QWidget(parent)
{
    setObjectName(QStringLiteral("stopWords"));
    setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto *grid = bare(new QGridLayout(this), -1, kLineGap);
    grid->setColumnStretch(0, 1);
    for (std::size_t i = 0; i < kWords; ++i) {
        Line &line = m_lines[i];
        line.mark = plainLabel(this);
        line.mark->setWordWrap(true); // it may have to say why there is no word
        line.age = plainLabel(this);
        line.age->setAlignment(Qt::AlignRight | Qt::AlignTop);
        grid->addWidget(line.mark, static_cast<int>(i), 0);
        grid->addWidget(line.age, static_cast<int>(i), 1);
    }
    grid->setRowStretch(static_cast<int>(kWords), 1);
    fitHeight();
    motor(1);
    showAll();
}

/// What is below stays where it is, whatever there is to say.
void StopWords::fitHeight()
{
    constexpr int kLines = static_cast<int>(kWords);
    setFixedHeight(kLines * fontMetrics().height() + (kLines - 1) * kLineGap);
}

void StopWords::changeEvent(QEvent *event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fitHeight();
}

StopWords::Motor &StopWords::motor(int number)
{
    const auto [at, isNew] = m_motors.try_emplace(number);
    if (isNew)
        clear(at->second);
    return at->second;
}

void StopWords::clear(Motor &motor)
{
    for (std::size_t i = 0; i < kWords; ++i)
        motor.words[i] = {stopWordText(kOrder[i]), {}};
    motor.mayCoast = false;
}

void StopWords::clear()
{
    m_motors.clear(); // another board may have fewer motors
    motor(1);
    showAll();
}

void StopWords::accept(const drive::StopProgress &progress, Milliseconds now)
{
    // Where nothing measures the speed that is the last word.
    const bool mayCoast = progress.word == drive::StopWord::MayCoast;
    const auto found =
        mayCoast ? kOrder.end() - 1 : std::find(kOrder.begin(), kOrder.end(), progress.word);
    if (found == kOrder.end())
        return; // NotConfirmed: the alarm says it, the words stay where the evidence is
    Motor &motor = this->motor(progress.motor);
    std::optional<Milliseconds> since = now;
    if (progress.word == drive::StopWord::Requested) {
        // A stop that goes on over a connection that was lost is as old as it is.
        if (const auto asked = motor.words.front().since; asked && !motor.words[2].since)
            since = asked;
        clear(motor);
    }
    motor.mayCoast = mayCoast;
    motor.words[static_cast<std::size_t>(found - kOrder.begin())] = {
        stopWordText(progress.word), since};
    showAll();
    refresh(now);
}

void StopWords::showAll()
{
    for (std::size_t i = 0; i < kWords; ++i)
        showWord(i, {}, {});
    QStringList all;
    if (m_motors.size() == 1) {
        const Motor &motor = m_motors.begin()->second;
        for (std::size_t i = 0; i < kWords; ++i)
            // The last word may take two lines; that the board accepted the stop says nothing beside them.
            if (i != 1 || !motor.mayCoast)
                showWord(i, motor.words[i], motor.words[i].text);
    } else {
        std::size_t line = 0;
        for (const auto &[number, motor] : m_motors) {
            const auto newest = std::find_if(motor.words.rbegin(), motor.words.rend(),
                [](const Word &word) { return word.since.has_value(); });
            const Word &word = newest == motor.words.rend() ? motor.words.front() : *newest;
            if (line < kWords)
                showWord(line++, word,
                    tr("Motor %1: %2", "number, word of a stop")
                        .arg(QString::number(number), word.text));
            all.append(tr("Motor %1").arg(QString::number(number)));
            if (const QString reached = motor.reached(); !reached.isEmpty())
                all.append(reached);
        }
    }
    setToolTip(all.join(QLatin1Char('\n')));
}

void StopWords::showWord(std::size_t at, const Word &word, const QString &text)
{
    Line &line = m_lines[at];
    line.since = word.since;
    const QString sign = word.since ? QStringLiteral("\u25cf ") : QStringLiteral("\u25cb ");
    line.mark->setText(text.isEmpty() ? QString() : sign + text);
    line.mark->setEnabled(word.since.has_value());
    line.age->clear();
    for (QLabel *label : {line.mark, line.age})
        label->setVisible(!text.isEmpty());
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

bool StopWords::rested() const
{
    return std::all_of(m_motors.begin(), m_motors.end(), [](const auto &one) {
        const auto &words = one.second.words;
        return words[2].since.has_value() || words[3].since.has_value();
    });
}

QString StopWords::text() const
{
    QStringList all;
    for (const auto &[number, motor] : m_motors) {
        if (m_motors.size() > 1)
            all.append(tr("Motor %1").arg(QString::number(number)));
        if (const QString reached = motor.reached(); !reached.isEmpty())
            all.append(reached);
    }
    return all.join(QLatin1Char('\n'));
}

} // namespace widgets
