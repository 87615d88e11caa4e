// WatchList: which registers are polled right now: the sum of what the parts of the window show. Asks the device only
// when the sum has changed.
#pragma once

#include "widgets/base/device.h"
#include "widgets/registers/model.h"

#include <QTimer>

#include <functional>
#include <vector>

namespace widgets {

class WatchList : public QObject {
    Q_OBJECT
public:
    using Source = std::function<std::vector<catalog::RegisterId>()>;

    WatchList(Device &device, const RegisterModel &model, QObject *parent = nullptr);

    /// Sources are asked in this order; the earlier ones are the more important.
    void addSource(Source source) { m_sources.push_back({std::move(source), false}); }
    /// What it names is drawn: read more often where a board records nothing by itself.
    void addDrawnSource(Source source) { m_sources.push_back({std::move(source), true}); }
    const std::vector<catalog::RegisterId> &registers() const { return m_asked; }

public Q_SLOTS:
    void changed(); ///< one of the sources has something else to say
    void forget(); ///< the board is another one: ask again

private:
    void send();

    Device &m_device;
    const RegisterModel &m_model;
    struct Named {
        Source registers;
        bool drawn = false;
    };
    std::vector<Named> m_sources;
    std::vector<catalog::RegisterId> m_asked, m_drawn;
    QTimer m_soon;
};

} // namespace widgets
