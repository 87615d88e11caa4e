#include "widgets/control/stop_alarm.h"

#include "widgets/base/messages.h"

#include <QDialogButtonBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

namespace widgets {

StopAlarm::StopAlarm(QWidget *parent)
    : QDialog(parent)
{
    setObjectName(QStringLiteral("stopAlarm"));
    setWindowTitle(tr("Stop motors"));
    setWindowModality(Qt::ApplicationModal);
}

void StopAlarm::make()
{
    m_text = new QLabel(this);
    m_detail = new QLabel(this);
    setStyleSheet(
        QStringLiteral("widgets--StopAlarm { background: #b71c1c; } QLabel { color: white; }"));

    QFont large = font();
    large.setPointSizeF(large.pointSizeF() * 1.8);
    large.setBold(true);
    m_text->setFont(large);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setAlignment(Qt::AlignCenter);
    m_text->setObjectName(QStringLiteral("stopAlarmText"));
    m_detail->setTextFormat(Qt::PlainText);
    m_detail->setAlignment(Qt::AlignCenter);
    m_detail->setWordWrap(true);

    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Close, this);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *layout = new QVBoxLayout(this);
    layout->setContentsMargins(28, 24, 28, 20);
    layout->setSpacing(14);
    layout->addWidget(m_text);
    layout->addWidget(m_detail);
    layout->addWidget(buttons);
}

void StopAlarm::raiseWith(const QString &detail)
{
    if (!m_text)
        make();
    m_text->setText(stopNotConfirmedText());
    m_detail->setText(detail);
    open();
    raise();
}

void StopAlarm::raiseAlarm(int motor)
{
    raiseWith(tr("Motor %1 was told to stop, but neither its state nor its speed shows that it "
                 "did. Rotorscope goes on trying. Closing this message starts nothing again.")
                  .arg(QString::number(motor)));
}

void StopAlarm::raiseNotSent()
{
    raiseWith(tr("There is no connection that could carry the stop, and the motor was not at rest "
                 "when it was last heard. Closing this message starts nothing again."));
}

void StopAlarm::confirmedLate()
{
    if (isVisible())
        m_detail->setText(tr("Meanwhile standstill was measured."));
}

} // namespace widgets
