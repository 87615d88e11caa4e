#include "widgets/files/sample_room_dialog.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/setpoint_text.h"
#include "widgets/base/value_text.h"
#include "widgets/files/sample_room.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QStorageInfo>

#include <cmath>
#include <optional>

namespace widgets {

namespace {

constexpr double kMost_GB = 100'000.0;

/// Negative for an empty line: what is usual. Empty if it is no size.
std::optional<double> sizeIn(const QString &text)
{
    if (text.trimmed().isEmpty())
        return -1.0;
    const auto value = readSetpoint(text);
    return value && *value >= 0.0 && *value <= kMost_GB ? std::optional(*value) : std::nullopt;
}

/// Of the disk on which the folder is, or will be.
double freeOn(const QString &folder)
{
    QString existing = folder;
    while (!QFileInfo::exists(existing) && existing != QFileInfo(existing).path())
        existing = QFileInfo(existing).path();
    const qint64 bytes = QStorageInfo(existing).bytesAvailable();
    return bytes < 0 ? -1.0 : static_cast<double>(bytes) / 1e9;
}

} // namespace

SampleRoomDialog::SampleRoomDialog(const SampleRoom &room, QWidget *parent)
    : QDialog(parent)
    , m_room(room)
    , m_size(new QLineEdit(this))
    , m_meaning(wrappedLabel("roomMeaning", this))
    , m_free(freeOn(room.folder()))
{
    setObjectName(QStringLiteral("sampleRoomDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    setWindowTitle(tr("Room for samples"));
    m_size->setObjectName(QStringLiteral("roomSize"));
    m_size->setAlignment(Qt::AlignRight);
    m_size->setPlaceholderText(tr("automatic: %1").arg(numberText(room.usual(), 1)));
    if (room.wanted() >= 0.0)
        m_size->setText(
            numberText(room.wanted(), room.wanted() == std::floor(room.wanted()) ? 0 : 3));
    connect(m_size, &QLineEdit::textChanged, this, &SampleRoomDialog::follow);

    auto *explain = wrappedLabel("roomExplain", this);
    explain->setText(
        tr("When the memory for samples is full, the oldest ones are moved to the disk and stay on "
           "the scope. When the room there is used up too, the oldest are let go. They are gone "
           "when Rotorscope ends: what is to be kept has to be recorded (Ctrl+R) or exported. 0 "
           "keeps samples in memory only; an empty field lets Rotorscope choose."));
    auto *held = wrappedLabel("roomHeld", this);
    held->setText(room.heldText()
        + (m_free < 0.0 ? QString()
                        : QLatin1Char('\n')
                    + tr("%1 GB are free on the disk of %2")
                          .arg(numberText(m_free, 1), deviceText(room.folder()))));
    auto *buttons = new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this);
    m_ok = buttons->button(QDialogButtonBox::Ok);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    auto *form = edged(new QFormLayout(this), kDialogEdges, kGrid);
    form->addRow(explain);
    form->addRow(tr("&Room on disk [GB]"), m_size);
    form->addRow(m_meaning);
    form->addRow(held);
    form->addRow(buttons);
    setMinimumWidth(460);
    follow();
}

void SampleRoomDialog::follow()
{
    const auto size = sizeIn(m_size->text());
    m_ok->setEnabled(size.has_value());
    if (!size) {
        m_meaning->setText(tr("The room is a plain number of 0 or more, or nothing."));
        return;
    }
    const double room = *size < 0.0 ? m_room.usual() : *size;
    QString text = m_room.meaningText(room);
    if (const QString less = m_room.lessText(room); !less.isEmpty())
        text += QLatin1Char('\n') + less;
    else if (m_free >= 0.0 && room > m_free)
        text += QLatin1Char('\n') + tr("That is more than is free: the last 1 GB is left free.");
    m_meaning->setText(text);
}

void SampleRoomDialog::accept()
{
    const auto size = sizeIn(m_size->text());
    if (!size)
        return;
    Q_EMIT chosen(*size);
    QDialog::accept();
}

} // namespace widgets
