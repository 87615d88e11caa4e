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
#include <utility>

namespace widgets {
namespace {

constexpr int kGap = kGrid;
constexpr int kBetween = kHalfGrid; ///< two buttons
constexpr int kLeastText = 150; ///< pixels: narrower lines are not read
constexpr int kLeastAround = 560; ///< height of what is around: lower, the scope needs all of it

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

FirstSteps::Card FirstSteps::cardOf(Step step)
{
    switch (step) {
    case Step::Welcome:
        return {tr("Welcome to Rotorscope"),
            tr("Try everything on a simulated board, or choose the port of your own board above."),
            tr("Connect to simulated board"), tr("Connect my board")};
    case Step::Start:
        return {tr("Connected: the scope shows live signals"),
            tr("Tick \"Arm\" on the right, then press Start. The Esc key stops every "
               "motor, wherever you are."),
            {}, {}};
    case Step::Speed:
        return {tr("The motor is running"),
            tr("Type another speed and press Enter. Drag a register from the list onto "
               "the scope to see it too."),
            {}, {}};
    case Step::Save:
        return {tr("Save what you see"),
            tr("The export writes the visible part, or all of it, as a CSV file with units."),
            tr("Export CSV"), {}};
    case Step::Done:
        break;
    }
    return {};
}

void FirstSteps::show(Step step)
{
    m_step = step;
    const Card card = cardOf(step);
    m_title->setText(card.title);
    m_text->setText(card.text);
    const std::pair<QPushButton *, QString> answers[] = {
        {m_first, card.first}, {m_second, card.second}};
    for (const auto &[button, says] : answers) {
        button->setVisible(!says.isEmpty());
        if (!says.isEmpty()) // one without words has another size, by which widths are told
            button->setText(says);
    }
    m_answers->setVisible(!card.first.isEmpty());
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
    const int line = m_first->sizeHint().height();
    int highest = 0;
    for (const Step step : {Step::Welcome, Step::Start, Step::Speed, Step::Save}) {
        const Card card = cardOf(step);
        const bool one = !card.first.isEmpty(), two = !card.second.isEmpty();
        const int first = one ? wide(m_first, card.first) : 0;
        const int second = two ? wide(m_second, card.second) : 0;
        const int across = two && inLine ? first + kBetween + second : std::max(first, second);
        const int answers = !one ? 0 : two && !inLine ? 2 * line + kBetween : line;
        const int room = beside && one ? whole - across - kGap : whole;
        if (room < kLeastText || across > whole)
            return INT_MAX;
        const int text = m_text->fontMetrics()
                             .boundingRect(QRect(0, 0, room, 1), Qt::TextWordWrap, card.text)
                             .height();
        highest =
            std::max(highest, beside ? std::max(text, answers) : text + (one ? kGap : 0) + answers);
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
