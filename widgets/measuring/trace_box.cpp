#include "widgets/measuring/trace_box.h"

#include "widgets/scope/view.h"

#include <QComboBox>

#include <algorithm>

namespace widgets {

namespace {
constexpr int kRegister = Qt::UserRole + 1;
/// Of the box: the register that was chosen last, shown or not.
constexpr char kSignal[] = "signal";
} // namespace

void fillTraceBox(
    QComboBox &box, const ScopeView &scope, const capture::Capture &capture, int first)
{
    const QSignalBlocker quiet(box);
    const QVariant channel = box.currentData();
    if (channel.isValid())
        box.setProperty(kSignal, box.currentData(kRegister));
    const QVariant signal = box.property(kSignal);
    box.clear();
    for (const capture::ChannelId id : scope.channels()) {
        const auto info = capture.info(id);
        box.addItem(scope.nameOf(id), id);
        box.setItemData(box.count() - 1, info ? info->registerId : 0U, kRegister);
    }
    int index = channel.isValid() ? box.findData(channel) : -1;
    if (index < 0)
        index =
            signal.isValid() ? box.findData(signal, kRegister) : std::min(first, box.count() - 1);
    box.setCurrentIndex(index);
}

} // namespace widgets
