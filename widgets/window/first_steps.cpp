#include "widgets/window/first_steps.h"

#include "widgets/base/look/named.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QResizeEvent>
#include <QVBoxLayout>

#include <algorithm>
#include <climits>

namespace widgets {
namespace {

constexpr int kGap = kGrid;
constexpr int kBetween = kHalfGrid; ///< two buttons
constexpr int kLeastText = 150; ///< pixels: narrower lines are not read
constexpr int kLeastAround = 560; ///< height of what is around: lower, the scope needs all of it

/// Which buttons a card has: none, the first, or both.
int answersOf(FirstSteps::Step step)
{
    return step == FirstSteps::Step::Welcome ? 2 : step == FirstSteps::Step::Save ? 1 : 0;
}

} // namespace

FirstSteps::FirstSteps(Device &device, QWidget *parent)
    : QFrame(parent)
    , m_device(device)
    , m_title(new SteadyLabel(this))
    , m_text(new QLabel(this))
    , m_first(named(new QPushButton(this), "firstStepsFirst"))
    , m_second(named(new QPushButton(this), "firstStepsSecond"))
    , m_close(named(new QPushButton(tr("Hide"), this), "firstStepsHide"))
    , m_answers(new QWidget(this))
{
    setObjectName(QStringLiteral("firstSteps"));
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    m_title->setFont(inBold(m_title->font()));
    m_title->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setWordWrap(true);
    m_text->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    m_close->setToolTip(tr("Help > First steps brings these cards back."));
    m_close->setFlat(true);

    m_between = bare(new QBoxLayout(QBoxLayout::LeftToRight, m_answers), kBetween);
    m_between->addWidget(m_first);
    m_between->addWidget(m_second);
    m_between->addStretch(1);
    auto *head = new QHBoxLayout;
    head->addWidget(m_title, 1);
    head->addWidget(m_close);
    m_rest = new QBoxLayout(QBoxLayout::LeftToRight);
    m_rest->setSpacing(kGap);
    m_rest->addWidget(m_text, 1);
    m_rest->addWidget(m_answers);
    auto *layout = edged(new QVBoxLayout(this), {12, 6, kGap, kGap}, kFineGrid);
    layout->addLayout(head);
    layout->addLayout(m_rest, 1);

    connect(m_first, &QPushButton::clicked, this, [this] {
        if (m_step == Step::Welcome)
            Q_EMIT simulatorWanted();
        else if (m_step == Step::Save)
            Q_EMIT exportWanted();
    });
    connect(m_second, &QPushButton::clicked, this, &FirstSteps::boardWanted);
    connect(m_close, &QPushButton::clicked, this, &FirstSteps::finish);
    connect(&device, &Device::identityChanged, this, &FirstSteps::follow);
    connect(&device, &Device::statusChanged, this, &FirstSteps::follow);
    connect(&device, &Device::wishEnded, this, &FirstSteps::follow);
    connect(&device, &Device::linkStateChanged, this, &FirstSteps::follow);
    setMinimumWidth(kLeastText); // the window may become narrower than the buttons in a line
    if (parent)
        parent->installEventFilter(this);
    hide();
}

bool FirstSteps::eventFilter(QObject *watched, QEvent *event)
{
    if (watched == parentWidget() && event->type() == QEvent::Resize)
        place();
    return QFrame::eventFilter(watched, event);
}

void FirstSteps::restart()
{
    show(Step::Welcome);
    follow();
}

void FirstSteps::finish()
{
    m_step = Step::Done;
    place();
    Q_EMIT finished();
}

QString FirstSteps::textOf(Step step)
{
    switch (step) {
    case Step::Welcome:
        return tr(
            "Try everything on a simulated board, or choose the port of your own board above.");
    case Step::Start:
        return tr("Tick \"Arm\" on the right, then press Start. The Esc key stops every "
                  "motor, wherever you are.");
    case Step::Speed:
        return tr("Type another speed and press Enter. Drag a register from the list onto "
                  "the scope to see it too.");
    case Step::Save:
        return tr("The export writes the visible part, or all of it, as a CSV file with units.");
    case Step::Done:
        break;
    }
    return {};
}

void FirstSteps::show(Step step)
{
    m_step = step;
    switch (step) {
    case Step::Welcome:
        m_title->setText(tr("Welcome to Rotorscope"));
        m_first->setText(tr("Connect to simulated board"));
        m_second->setText(tr("Connect my board"));
        break;
    case Step::Start:
        m_title->setText(tr("Connected: the scope shows live signals"));
        break;
    case Step::Speed:
        m_title->setText(tr("The motor is running"));
        break;
    case Step::Save:
        m_title->setText(tr("Save what you see"));
        m_first->setText(tr("Export CSV"));
        break;
    case Step::Done:
        break;
    }
    m_text->setText(textOf(step));
    m_first->setVisible(answersOf(step) > 0);
    m_second->setVisible(answersOf(step) > 1);
    m_answers->setVisible(answersOf(step) > 0);
    place();
    fitHeight();
}

void FirstSteps::resizeEvent(QResizeEvent *event)
{
    QFrame::resizeEvent(event);
    if (event->size().width() != event->oldSize().width())
        fitHeight();
}

void FirstSteps::changeEvent(QEvent *event)
{
    QFrame::changeEvent(event);
    if (event->type() == QEvent::FontChange)
        fitHeight();
}

/// The buttons beside the text or below it, in a line or one below the other: as the card is lowest that needs most.
void FirstSteps::fitHeight()
{
    const QMargins around = layout()->contentsMargins();
    const int whole = contentsRect().width() - around.left() - around.right();
    if (whole <= 0)
        return;
    int least = INT_MAX;
    for (const bool beside : {true, false})
        for (const bool inLine : {true, false})
            if (const int height = heightWith(beside, inLine, whole); height < least) {
                least = height;
                using Direction = QBoxLayout::Direction;
                m_rest->setDirection(beside ? Direction::LeftToRight : Direction::TopToBottom);
                m_between->setDirection(inLine ? Direction::LeftToRight : Direction::TopToBottom);
            }
    if (least == INT_MAX)
        return; // before it has its place, nothing of it can be read
    setFixedHeight(least + m_close->sizeHint().height() + layout()->spacing() + around.top()
        + around.bottom() + 2 * frameWidth());
}

/// Of text and buttons of the highest card.
int FirstSteps::heightWith(bool beside, bool inLine, int whole) const
{
    const auto wide = [](const QPushButton *button, const QString &text) {
        const QFontMetrics metrics = button->fontMetrics();
        return button->sizeHint().width() + metrics.horizontalAdvance(text)
            - metrics.horizontalAdvance(button->text());
    };
    const int first = wide(m_first, tr("Connect to simulated board"));
    const int second = wide(m_second, tr("Connect my board"));
    const int both = inLine ? first + kBetween + second : std::max(first, second);
    const int line = m_first->sizeHint().height();
    int highest = 0;
    for (const Step step : {Step::Welcome, Step::Start, Step::Speed, Step::Save}) {
        const int count = answersOf(step);
        const int across = count > 1 ? both : count > 0 ? wide(m_first, tr("Export CSV")) : 0;
        const int answers = count == 0 ? 0 : count > 1 && !inLine ? 2 * line + kBetween : line;
        const int room = beside && count > 0 ? whole - across - kGap : whole;
        if (room < kLeastText || across > whole)
            return INT_MAX;
        const int text = m_text->fontMetrics()
                             .boundingRect(QRect(0, 0, room, 1), Qt::TextWordWrap, textOf(step))
                             .height();
        highest = std::max(
            highest, beside ? std::max(text, answers) : text + (count > 0 ? kGap : 0) + answers);
    }
    return highest;
}

void FirstSteps::setCrowded(bool crowded)
{
    m_crowded = crowded;
    place();
}

/// What a card says of the board holds only while the board answers; the banner has the word until then.
void FirstSteps::place()
{
    const bool holds = m_step == Step::Welcome || m_step == Step::Save || m_device.answering();
    const bool low = parentWidget() && parentWidget()->height() < kLeastAround;
    const bool wanted = m_step != Step::Done && !m_crowded && !low;
    QSizePolicy policy = sizePolicy();
    policy.setRetainSizeWhenHidden(wanted);
    setSizePolicy(policy);
    setVisible(wanted && holds);
}

void FirstSteps::follow()
{
    if (m_step == Step::Done)
        return;
    using drive::MotorState;
    const MotorState state = m_device.status(m_device.motor()).state;
    if (m_step == Step::Welcome && m_device.identified())
        show(Step::Start);
    place();
    if (m_step == Step::Start && state == MotorState::Running)
        show(Step::Speed);
    if (m_step == Step::Speed && state != MotorState::Running
        && m_device.statusIsNow(m_device.motor())) // also behind a fault
        show(Step::Save);
}

} // namespace widgets
