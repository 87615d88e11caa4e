// MotorDescription: the description of a motor that stands beside the board's own: a file's, and what was measured.
// What is measured comes into it as one step, which can be taken back. It writes nothing, neither to a board nor to a
// file. Inertias are what was typed of motors whose boards do not know it, for every form that needs it.
#pragma once

#include "motor/sheet.h"

#include <QMap>
#include <QObject>
#include <QString>

#include <optional>
#include <utility>
#include <vector>

namespace widgets {

/// By the name that the board gives its motor, fit to be shown, in kg m2.
using Inertias = QMap<QString, double>;

class MotorDescription : public QObject {
    Q_OBJECT
public:
    using Sheet = std::optional<motor::MotorSheet>;
    using QObject::QObject;

    const Sheet &sheet() const { return m_sheet; }
    bool holdsMeasured() const { return !m_before.empty(); }

    /// Of a file, or none: there is nothing to take back any more.
    void open(Sheet sheet)
    {
        m_before.clear();
        set(std::move(sheet));
    }
    void close() { open(std::nullopt); }

    /// The measured figures take the place of those that are there. @param board  what it begins with, if nothing is
    void use(const motor::MotorSheet &measured, const motor::MotorSheet &board)
    {
        m_before.push_back(m_sheet);
        motor::MotorSheet sheet = m_sheet.value_or(board);
        for (const motor::MotorQuantityInfo &info : motor::motorQuantities())
            if (const auto &value = measured.*info.member)
                sheet.*info.member = value;
        set(sheet);
    }
    /// The last use().
    void takeBack()
    {
        if (m_before.empty())
            return;
        Sheet before = std::move(m_before.back());
        m_before.pop_back();
        set(std::move(before));
    }

Q_SIGNALS:
    void changed();

private:
    void set(Sheet sheet)
    {
        m_sheet = std::move(sheet);
        Q_EMIT changed();
    }

    Sheet m_sheet;
    std::vector<Sheet> m_before; ///< each use()
};

} // namespace widgets
