// GiveBack: the button that writes back what an experiment has left on a board, beside the sentence that names it. An
// edit like any other: it needs arming, asks where an edit asks, is read back, and can be undone. Its tool tip says why
// it cannot be pressed.
#pragma once

#include "drive/wish.h"

#include <QPushButton>

#include <vector>

namespace widgets {

class Device;
class Experiments;
class RegisterEdits;

class GiveBack : public QPushButton {
    Q_OBJECT
public:
    GiveBack(
        Device &device, RegisterEdits &edits, Experiments &experiments, QWidget *parent = nullptr);

    /// What the registers of the board that is connected held before.
    void offer(const std::vector<drive::RegisterWrite> &back);

Q_SIGNALS:
    void told(const QString &sentence); ///< what became of it

private:
    QString hint() const;
    void follow();

    Device &m_device;
    RegisterEdits &m_edits;
    Experiments &m_experiments;
    const QString m_step; ///< how its step is named in the list of edits
    std::vector<drive::RegisterWrite> m_back;
};

} // namespace widgets
