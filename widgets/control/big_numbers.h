// BigNumbers: a page of a few values in letters that can be read from across the room, with the state above them. What
// is not live is a dash. It shows; it asks for nothing but to be polled while it can be seen.
#pragma once

#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <QTimer>
#include <QWidget>

namespace widgets {

class BigNumbers : public QWidget {
    Q_OBJECT
public:
    BigNumbers(Device &device, RegisterModel &registers, QWidget *parent = nullptr);

    std::vector<catalog::RegisterId> watchedRegisters() const; ///< none while it is hidden
    QString valueText(const char *name) const; ///< as drawn, with its unit

    QSize minimumSizeHint() const override { return {320, 160}; }

Q_SIGNALS:
    void watchedRegistersChanged();

protected:
    void paintEvent(QPaintEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void hideEvent(QHideEvent *event) override;

private:
    struct Cell {
        const char *name = nullptr;
        QString title;
        std::optional<catalog::RegisterId> id;
    };
    void resolve();
    void describe();
    void paintState(QPainter &painter, const QRect &place) const;
    void paintCell(QPainter &painter, const QRect &place, const Cell &cell) const;

    Device &m_device;
    RegisterModel &m_registers;
    std::vector<Cell> m_cells;
    QTimer m_soon; ///< changes that come together are shown once
};

} // namespace widgets
