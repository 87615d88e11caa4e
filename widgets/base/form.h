// Form: one page of a tool for tuning (gains, start-up, ramps, motor), docked below the scope. A form is a view of the
// RegisterModel: it shows what the board holds, leaves what the user wants as pending edits, and never writes by
// itself.
#pragma once

#include "widgets/base/device.h"

#include <QWidget>

#include <vector>

namespace widgets {

class Form : public QWidget {
    Q_OBJECT
public:
    using QWidget::QWidget;

    /// What is to be polled while the form can be seen.
    virtual std::vector<catalog::RegisterId> watchedRegisters() const { return {}; }
    /// A few times a second while the form can be seen: ages, progress. `now` is the workbench's clock.
    virtual void refresh(Milliseconds now) { Q_UNUSED(now) }
    /// What stays in view below the form when its place is too small for all of it; nullptr: nothing. A child of the
    /// form that is in no layout of it.
    virtual QWidget *footer() const { return nullptr; }
    /// Of the window's height, when it is the first tool that is opened.
    virtual double heightShare() const { return 0.48; }
    /// Where typing goes when the form is opened by its key.
    virtual void focusFirst() { setFocus(Qt::ShortcutFocusReason); }

Q_SIGNALS:
    void watchedRegistersChanged();
    void failed(const QString &sentence); ///< a command that this form sent did not end well
};

} // namespace widgets
