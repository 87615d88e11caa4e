#include "widgets/control/stop_alarm.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/messages.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>
#include <iterator>
#include <utility>

namespace widgets {
namespace {

constexpr int kLeastWidth = 300; ///< of the text

QString styleOf(bool calm)
{
    return QStringLiteral("widgets--StopAlarm { background: %1; } QLabel { color: white; }")
        .arg(calm ? QStringLiteral("#37474f") : QStringLiteral("#b71c1c"));
}

} // namespace

StopAlarm::StopAlarm(QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("stopAlarm"));
    setWindowTitle(tr("Stop motors"));
    setWindowModality(Qt::ApplicationModal);
}

void StopAlarm::make()
{
    m_text = wrappedLabel("stopAlarmText", this);
    m_detail = wrappedLabel("stopAlarmDetail", this);
    setStyleSheet(styleOf(m_calm));

    m_text->setFont(inBold(font(), 1.8));
    m_text->setAlignment(Qt::AlignCenter);
    m_detail->setAlignment(Qt::AlignHCenter | Qt::AlignTop);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    m_takeBack = buttons->addButton(tr("Take the Stop &back"), QDialogButtonBox::DestructiveRole);
    m_takeBack->setObjectName(QStringLiteral("takeStopBack"));
    m_takeBack->setAutoDefault(false);
    keepPlace(*m_takeBack); // the other button stays where it is
    connect(m_takeBack, &QPushButton::clicked, this, [this] {
        Q_EMIT takenBack();
        reject();
    });
    auto *layout =
        edged(new QVBoxLayout(this), {3 * kGrid, 3 * kGrid, 3 * kGrid, kDialogEdge}, kDialogEdge);
    // Always as large as what it has room for: what a word-wrapped label needs in height is asked for by no other
    // constraint.
    layout->setSizeConstraint(QLayout::SetFixedSize);
    layout->addWidget(m_text);
    layout->addWidget(m_detail);
    layout->addWidget(buttons);
}

void StopAlarm::raiseWith(const QString &text)
{
    if (!m_text)
        make();
    if (!isVisible()) {
        fitHeadline();
        m_detail->setMinimumHeight(0); // room for what was told another time
    }
    showText(text);
    if (!isVisible())
        place();
    open();
    raise();
}

/// In one line where that leaves what has to be seen free, else in as many as it takes; with room for the other one.
void StopAlarm::fitHeadline()
{
    const QFontMetrics metrics = m_text->fontMetrics();
    const QMargins around = layout()->contentsMargins();
    const QStringList both{stopNotConfirmedText(), lateText()};
    int width = 0, height = 0;
    for (const QString &text : both)
        width = std::max(width, metrics.horizontalAdvance(text) + 2);
    if (m_keepFree && m_keepFree->isVisible()) {
        const int left = m_keepFree->mapTo(parentWidget(), QPoint()).x();
        const int right = parentWidget()->width() - left - m_keepFree->width();
        width = std::clamp(std::max(left, right) - around.left() - around.right(), kLeastWidth,
            std::max(kLeastWidth, width));
    }
    for (const QString &text : both)
        height = std::max(
            height, metrics.boundingRect(QRect(0, 0, width, 1), Qt::TextWordWrap, text).height());
    m_text->setFixedSize(width, height);
}

/// With room for whatever the evidence may make of it, and never less than it has.
void StopAlarm::showText(const QString &text)
{
    const bool calm = stand(m_motors);
    if (std::exchange(m_calm, calm) != calm)
        setStyleSheet(styleOf(calm));
    // After the style, with which a box of buttons shows all that it has.
    m_takeBack->setVisible(!m_ports.isEmpty());
    m_text->setText(calm ? lateText() : stopNotConfirmedText());
    m_detail->setText(text);
    const int width = m_text->width();
    m_detail->setFixedWidth(width);
    QStringList all{text};
    for (const auto word : {drive::StopWord::NotConfirmed, drive::StopWord::DriveIdle,
             drive::StopWord::Standstill, drive::StopWord::MayCoast}) {
        Words one = m_motors;
        for (auto &[motor, its] : one)
            its = word;
        all.append(detail(one));
    }
    int height = m_detail->minimumHeight();
    for (const QString &one : all)
        height = std::max(height,
            m_detail->fontMetrics()
                .boundingRect(QRect(0, 0, width, 1), Qt::TextWordWrap, one)
                .height());
    m_detail->setMinimumHeight(height);
}

void StopAlarm::setPlace(const QWidget *over, const QWidget *keepFree)
{
    m_over = over;
    m_keepFree = keepFree;
}

void StopAlarm::place()
{
    if (!m_over || !m_over->isVisible())
        return;
    const auto onScreen = [](const QWidget *widget) {
        return QRect(widget->mapToGlobal(QPoint()), widget->size());
    };
    layout()->activate();
    const QRect over = onScreen(m_over);
    const QRect window = onScreen(parentWidget());
    QRect mine(QPoint(), sizeHint());
    mine.moveCenter(over.center());
    if (m_keepFree && m_keepFree->isVisible() && mine.intersects(onScreen(m_keepFree))) {
        const QRect free = onScreen(m_keepFree);
        if (free.center().x() > over.center().x())
            mine.moveRight(free.left() - 1);
        else
            mine.moveLeft(free.right() + 1);
    }
    mine.moveLeft(std::clamp(
        mine.left(), window.left(), std::max(window.left(), window.right() - mine.width() + 1)));
    move(mine.topLeft());
}

void StopAlarm::begin()
{
    if (isVisible())
        return;
    m_motors.clear();
    m_ofAll = false;
}

void StopAlarm::raiseAlarm(int motor)
{
    begin();
    m_motors[motor] = drive::StopWord::NotConfirmed;
    raiseWith(detail());
}

void StopAlarm::raiseNotSent()
{
    begin();
    m_ofAll = true;
    raiseWith(tr("There is no connection that could carry the stop, and the motor was not at rest "
                 "when it was last heard. Closing this message starts nothing again."));
}

void StopAlarm::showWanted(const QStringList &ports)
{
    const bool more = ports.size() > m_ports.size();
    m_ports = ports;
    if (more) {
        begin();
        m_ofAll = true;
        raiseWith(detail());
    } else if (isVisible()) {
        // A port is open again: what was heard before may be of another board.
        m_count = 0;
        std::erase_if(
            m_motors, [](const auto &one) { return one.second != drive::StopWord::NotConfirmed; });
        showText(detail());
    }
}

void StopAlarm::setMotors(int motors)
{
    m_count = motors;
    if (isVisible() && !m_motors.empty())
        showText(detail());
}

void StopAlarm::accept(const drive::StopProgress &progress)
{
    const bool confirms = progress.word == drive::StopWord::DriveIdle
        || progress.word == drive::StopWord::Standstill
        || progress.word == drive::StopWord::MayCoast;
    if (!isVisible() || !confirms)
        return;
    // It may be the first that is heard of it: of a port that is back.
    drive::StopWord &word = m_motors.try_emplace(progress.motor, progress.word).first->second;
    if (word != drive::StopWord::Standstill) // which stays true when it is stopped once more
        word = progress.word;
    showText(detail());
}

/// All that it is about: by measurement, not because nothing drives them.
bool StopAlarm::stand(const Words &motors) const
{
    const bool all = !m_ofAll || (m_count > 0 && std::ssize(motors) >= m_count);
    return all && m_ports.isEmpty() && !motors.empty()
        && std::all_of(motors.begin(), motors.end(),
            [](const auto &one) { return one.second == drive::StopWord::Standstill; });
}

QString StopAlarm::detail(const Words &motors) const
{
    QStringList parts;
    if (!m_ports.isEmpty())
        parts.append(ofPorts());
    if (!motors.empty())
        parts.append(ofMotors(motors));
    if (parts.isEmpty())
        parts.append(tr("The port is open again, and the stop goes on."));
    return parts.join(QStringLiteral("\n\n"));
}

/// Each motor for itself: that one stands says nothing of another.
QString StopAlarm::ofMotors(const Words &motors) const
{
    QStringList lines;
    bool trying = false;
    for (const auto &[motor, word] : motors) {
        const QString number = QString::number(motor);
        if (word == drive::StopWord::Standstill)
            lines.append(tr("Motor %1: meanwhile standstill was measured.").arg(number));
        else if (word == drive::StopWord::MayCoast)
            lines.append(
                tr("Motor %1: meanwhile its drive is idle. Its speed is not measurable: the "
                   "rotor may coast.")
                    .arg(number));
        else if (word == drive::StopWord::DriveIdle)
            lines.append(tr("Motor %1: meanwhile its drive is idle.").arg(number));
        else
            lines.append(tr("Motor %1 was told to stop, but neither its state nor its speed shows "
                            "that it did.")
                             .arg(number));
        trying = trying || word == drive::StopWord::NotConfirmed;
    }
    if (trying)
        lines.append(tr("Rotorscope goes on trying. Closing this message starts nothing again."));
    else if (stand(motors))
        lines.append(tr("At first nothing confirmed the stop. Closing this message starts nothing "
                        "again."));
    return lines.join(QLatin1Char('\n'));
}

QString StopAlarm::lateText() { return tr("Confirmed late: standstill was measured."); }

QString StopAlarm::ofPorts() const
{
    return tr("%1 is not open any more, and no evidence of the stop had come. The motor may still "
              "be turning. "
              "As soon as a port is open again, what is found there is stopped before anything "
              "else. Closing this message starts nothing again and takes nothing back.",
        "one or more ports")
        .arg(m_ports.join(QStringLiteral(", ")));
}

} // namespace widgets
