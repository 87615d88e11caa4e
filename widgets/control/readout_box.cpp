#include "widgets/control/readout_box.h"

#include "drive/set_points/shaft_position.h"
#include "widgets/base/look/spacing.h"
#include "widgets/base/steady_label.h"
#include "widgets/base/value_text.h"

#include <QGridLayout>

#include <cmath>

namespace widgets {

QString steadyText(const RegisterModel &registers, std::optional<catalog::RegisterId> id)
{
    const QString dash = QStringLiteral("\u2013");
    const auto catalog = registers.catalog();
    if (!id || !catalog)
        return dash;
    const auto value = registers.shownValue(*id);
    const catalog::RegisterInfo *info = catalog->find(*id);
    if (!value || info == nullptr)
        return dash;
    if (info->type != catalog::ValueType::F32 && info->fractionBits == 0)
        return registers.text(*id);
    // A number without a step of its own: as many digits as a meter has.
    const double size = std::abs(*value);
    const int decimals = size < 10.0 ? 2 : size < 100.0 ? 1 : 0;
    const QString unit = unitText(catalog->readScale(*id).unit);
    return numberText(*value, decimals) + (unit.isEmpty() ? QString() : QChar(0x202f) + unit);
}

ReadoutBox::ReadoutBox(Device &device, RegisterModel &registers, QWidget *parent)
    : QWidget(parent)
    , m_device(device)
    , m_registers(registers)
{
    auto *grid = bare(new QGridLayout(this));
    grid->setVerticalSpacing(kFineGrid);
    const std::pair<const char *, QString> rows[] = {
        {"SPEED_MEAS", tr("Measured speed")},
        {"SPEED_REF", tr("Speed reference")},
        {"I_Q_MEAS", tr("Current Iq")},
        {"BUS_VOLTAGE", tr("Bus voltage")},
        {"MOTOR_POWER", tr("Power")},
        {"HEATS_TEMP", tr("Power stage")},
    };
    for (const auto &[name, text] : rows) {
        auto *label = new QLabel(text, this);
        auto *value = new SteadyLabel(this);
        value->setObjectName(QLatin1String(name));
        value->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        // All that the names leave, whatever the number is.
        value->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
        const int row = static_cast<int>(m_rows.size());
        grid->addWidget(label, row, 0);
        grid->addWidget(value, row, 1);
        m_rows.push_back({name, label, value, {}});
    }
    // What the questions before a motion are judged by.
    for (const char *name : {"I_Q_REF", "I_D_REF", "CONTROL_MODE"})
        m_rows.push_back({name, nullptr, nullptr, {}});
    grid->setColumnStretch(1, 1);
    connect(&device, &Device::motorChanged, this, &ReadoutBox::resolve);
    connect(&device, &Device::identityChanged, this, &ReadoutBox::resolve);
    m_soon.setSingleShot(true);
    connect(&m_soon, &QTimer::timeout, this, &ReadoutBox::update);
    connect(&registers, &QAbstractItemModel::dataChanged, this, [this] { m_soon.start(0); });
    connect(&registers, &QAbstractItemModel::modelReset, this, &ReadoutBox::resolve);
    update();
}

std::vector<catalog::RegisterId> ReadoutBox::watchedRegisters() const
{
    std::vector<catalog::RegisterId> ids;
    for (const Row &row : m_rows)
        if (row.id)
            ids.push_back(*row.id);
    const bool turns = m_device.capability(drive::Feature::PositionRamp).available;
    if (const auto catalog = m_device.catalog(); catalog && turns)
        for (const auto shaft : drive::shaftRegisters(*catalog, m_device.motor()))
            ids.push_back(shaft);
    return ids;
}

std::optional<double> ReadoutBox::value(const char *name) const
{
    for (const Row &row : m_rows)
        if (row.id && std::string_view(row.name) == name)
            return m_registers.shownValue(*row.id);
    return {};
}

void ReadoutBox::putBeside(std::string_view name, QWidget &widget)
{
    for (const Row &row : m_rows)
        if (row.value && name == row.name) {
            widget.setMaximumHeight(row.value->sizeHint().height());
            static_cast<QGridLayout *>(layout())->addWidget(
                &widget, static_cast<int>(&row - m_rows.data()), 1, Qt::AlignLeft);
            row.value->lower();
        }
}

void ReadoutBox::resolve()
{
    const auto catalog = m_device.catalog();
    for (Row &row : m_rows) {
        row.id.reset();
        const catalog::RegisterInfo *info = catalog ? catalog->find(row.name) : nullptr;
        if (info && info->readable() && !info->stub)
            row.id = catalog->withMotor(*info, m_device.motor());
        const bool there = row.id.has_value() || !catalog;
        for (QLabel *label : {row.label, row.value}) // which keep their places
            if (label) {
                label->setEnabled(there);
                label->setToolTip(there ? QString() : tr("This board does not tell it."));
            }
    }
    update();
    Q_EMIT watchedRegistersChanged();
}

void ReadoutBox::update()
{
    for (const Row &row : m_rows)
        if (row.value)
            row.value->setText(steadyText(m_registers, row.id));
    Q_EMIT updated();
}

} // namespace widgets
