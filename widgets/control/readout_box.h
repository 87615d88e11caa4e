// ReadoutBox: a few measured values of the motor that is shown, as text. Rows that the board does not have are left
// out.
#pragma once

#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <QTimer>
#include <QWidget>

class QLabel;

namespace widgets {

class ReadoutBox : public QWidget {
    Q_OBJECT
public:
    ReadoutBox(Device &device, RegisterModel &registers, QWidget *parent = nullptr);

    /// To be polled as long as it is there.
    std::vector<catalog::RegisterId> watchedRegisters() const;
    /// Between a name and its value, without a place of its own: nothing moves when it comes and goes.
    void putBeside(std::string_view name, QWidget &widget);
    std::optional<double> value(const char *name) const; ///< newest; empty if stale or not there

Q_SIGNALS:
    void watchedRegistersChanged();
    void updated();

private:
    void resolve();
    void update();

    struct Row {
        const char *name = nullptr;
        QLabel *label = nullptr; ///< none: polled and not shown
        QLabel *value = nullptr;
        std::optional<catalog::RegisterId> id;
    };
    Device &m_device;
    RegisterModel &m_registers;
    std::vector<Row> m_rows;
    QTimer m_soon; ///< changes that come together are shown once
};

/// A register's value with its unit, as a number that keeps its length while it changes; a dash where it is not known.
QString steadyText(const RegisterModel &registers, std::optional<catalog::RegisterId> id);

} // namespace widgets
