#include "widgets/control/big_numbers.h"

#include "widgets/base/device_text.h"
#include "widgets/base/look/section_head.h"
#include "widgets/base/messages.h"
#include "widgets/control/readout_box.h"
#include "widgets/control/state_strip.h"

#include <QPainter>

#include <algorithm>

namespace widgets {
namespace {

constexpr int kColumns = 2;
constexpr int kNumberGap = 10;

QString dash() { return QStringLiteral("\u2013"); }

/// The largest font in which the text fits, and not larger than the place is high.
QFont fitting(QFont font, const QString &text, const QSize &place)
{
    font.setPixelSize(std::max(8, place.height()));
    const int width = QFontMetrics(font).horizontalAdvance(text);
    if (width > place.width())
        font.setPixelSize(std::max(8, font.pixelSize() * place.width() / width));
    return font;
}

} // namespace

BigNumbers::BigNumbers(Device &device, RegisterModel &registers, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_registers(registers)
    , m_cells{{"SPEED_MEAS", tr("Speed"), {}}, {"I_Q_MEAS", tr("Current Iq"), {}},
          {"BUS_VOLTAGE", tr("Bus voltage"), {}}, {"MOTOR_POWER", tr("Power"), {}},
          {"HEATS_TEMP", tr("Power stage"), {}}}
{
    setObjectName(QStringLiteral("bigNumbers"));
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    connect(&device, &Device::motorChanged, this, &BigNumbers::resolve);
    connect(&device, &Device::identityChanged, this, &BigNumbers::resolve);
    for (const auto changed : {&Device::linkStateChanged, &Device::batchApplied})
        connect(&device, changed, this, &BigNumbers::describe);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &BigNumbers::describe);
    connect(&registers, &QAbstractItemModel::dataChanged, this, [this] { m_soon.start(0); });
    connect(&registers, &QAbstractItemModel::modelReset, this, &BigNumbers::resolve);
    resolve();
}

std::vector<catalog::RegisterId> BigNumbers::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    for (const Cell &cell : m_cells)
        if (isVisible() && cell.id)
            ids.push_back(*cell.id);
    return ids;
}

void BigNumbers::resolve()
{
    const auto catalog = m_device.catalog();
    for (Cell &cell : m_cells) {
        cell.id.reset();
        const catalog::RegisterInfo *info = catalog ? catalog->find(cell.name) : nullptr;
        if (info && info->readable() && !info->stub)
            cell.id = catalog->withMotor(*info, m_device.motor());
    }
    describe();
    Q_EMIT watchedRegistersChanged();
}

QString BigNumbers::valueText(const char *name) const
{
    for (const Cell &cell : m_cells)
        if (std::string_view(cell.name) == name)
            return steadyText(m_registers, cell.id);
    return dash();
}

void BigNumbers::describe()
{
    QStringList parts;
    for (const Cell &cell : m_cells)
        parts.append(cell.title + QStringLiteral(": ") + valueText(cell.name));
    setAccessibleName(tr("Large numbers"));
    setAccessibleDescription(parts.join(QStringLiteral("; ")));
    update();
}

void BigNumbers::showEvent(QShowEvent *event)
{
    QWidget::showEvent(event);
    Q_EMIT watchedRegistersChanged();
}

void BigNumbers::hideEvent(QHideEvent *event)
{
    QWidget::hideEvent(event);
    Q_EMIT watchedRegistersChanged();
}

void BigNumbers::paintState(QPainter &painter, const QRect &place) const
{
    const drive::MotorStatus status = m_device.status(m_device.motor());
    const bool believed = m_device.statusIsNow(m_device.motor());
    QString text = believed ? motorStateText(status.state) : linkStateText(m_device.link());
    if (const QString name = deviceText(status.stateName); believed && !name.isEmpty())
        text = QStringLiteral("%1 \u2013 %2").arg(name, text);
    if (const auto &board = m_device.identified(); board && board->identity.motors > 1)
        text = tr("Motor %1: %2", "number, state").arg(QString::number(m_device.motor()), text);
    for (const std::string &fault : believed ? status.faultsNow : std::vector<std::string>())
        text += QStringLiteral("  \u2716 ") + deviceText(fault);
    painter.setPen(believed ? stateColor(status.state, palette())
                            : palette().color(QPalette::Disabled, QPalette::WindowText));
    painter.setFont(fitting(inBold(font()), text, {place.width(), place.height() * 7 / 10}));
    painter.drawText(place, Qt::AlignLeft | Qt::AlignVCenter, text);
}

void BigNumbers::paintCell(QPainter &painter, const QRect &place, const Cell &cell) const
{
    painter.setPen(palette().color(QPalette::Mid));
    painter.setBrush(palette().color(QPalette::Window));
    painter.drawRoundedRect(QRectF(place).adjusted(0.5, 0.5, -0.5, -0.5), 6, 6);
    const QRect inside = place.adjusted(14, 6, -14, -6);
    QRect title = inside;
    title.setHeight(inside.height() / 5);
    QRect value = inside;
    value.setTop(title.bottom() + 1);
    painter.setPen(palette().color(QPalette::Disabled, QPalette::WindowText));
    painter.setFont(fitting(font(), cell.title, {title.width(), title.height() * 8 / 10}));
    painter.drawText(title, Qt::AlignLeft | Qt::AlignVCenter, cell.title);

    const QString text = valueText(cell.name);
    // The unit stands smaller behind a number that has room to grow: its letters keep their size while it changes.
    const qsizetype end = text.indexOf(QChar(0x202f));
    const QString number = end < 0 ? text : text.left(end);
    const QString unit = end < 0 ? QString() : text.mid(end + 1);
    QRect unitPlace = value;
    unitPlace.setLeft(value.right() - value.width() / 5);
    QRect numberPlace = value;
    numberPlace.setRight(unitPlace.left() - 8);
    const QString room = number.size() < 5 ? QStringLiteral("00000") : number;
    const QFont large = fitting(inBold(font()), room, {numberPlace.width(), numberPlace.height()});
    painter.setPen(palette().color(
        text == dash() ? QPalette::Disabled : QPalette::Active, QPalette::WindowText));
    painter.setFont(large);
    const int base = value.center().y() + QFontMetrics(large).capHeight() / 2;
    const int left = numberPlace.right() - painter.fontMetrics().horizontalAdvance(number);
    painter.drawText(left, base, number);
    painter.setFont(fitting(font(), unit, {unitPlace.width(), value.height() * 2 / 5}));
    painter.drawText(unitPlace.left(), base, unit);
}

void BigNumbers::paintEvent(QPaintEvent *)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QRect all = rect().adjusted(kNumberGap, kNumberGap, -kNumberGap, -kNumberGap);
    QRect state = all;
    state.setHeight(all.height() / 8);
    paintState(painter, state);
    const QRect cells(all.left(), state.bottom() + kNumberGap, all.width(),
        all.bottom() - state.bottom() - kNumberGap + 1);
    // The first over the whole width, the others in pairs.
    const int rows = 1 + (static_cast<int>(m_cells.size()) - 1 + kColumns - 1) / kColumns;
    const int height = (cells.height() - (rows - 1) * kNumberGap) / rows;
    const int width = (cells.width() - (kColumns - 1) * kNumberGap) / kColumns;
    for (int i = 0; i < static_cast<int>(m_cells.size()); ++i) {
        const int row = i == 0 ? 0 : 1 + (i - 1) / kColumns;
        const int column = i == 0 ? 0 : (i - 1) % kColumns;
        const QRect place(cells.left() + column * (width + kNumberGap),
            cells.top() + row * (height + kNumberGap), i == 0 ? cells.width() : width, height);
        paintCell(painter, place, m_cells[static_cast<std::size_t>(i)]);
    }
}

} // namespace widgets
