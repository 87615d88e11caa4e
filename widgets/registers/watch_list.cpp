#include "widgets/registers/watch_list.h"

#include <unordered_set>

namespace widgets {
namespace {

constexpr int kSoonMs = 30;
constexpr Milliseconds kPeriod{100};

} // namespace

WatchList::WatchList(Device &device, const RegisterModel &model, QObject *parent)
    : QObject(parent)
    , m_device(device)
    , m_model(model)
{
    m_soon.setSingleShot(true);
    m_soon.setInterval(kSoonMs);
    connect(&m_soon, &QTimer::timeout, this, &WatchList::send);
    connect(&device, &Device::linkStateChanged, this, [this] {
        if (m_device.answering())
            changed();
    });
}

void WatchList::changed()
{
    if (!m_soon.isActive())
        m_soon.start();
}

void WatchList::forget()
{
    m_asked.clear();
    m_drawn.clear();
    changed();
}

void WatchList::send()
{
    if (!m_device.answering() || !m_device.identified())
        return;
    std::vector<catalog::RegisterId> sum;
    std::unordered_set<catalog::RegisterId> seen;
    std::vector<catalog::RegisterId> drawn;
    // The model shows one motor: what a board has of that one it has of each.
    const auto shown = [this](catalog::RegisterId id) {
        const auto catalog = m_device.catalog();
        const catalog::RegisterInfo *info = catalog ? catalog->find(id) : nullptr;
        return info ? catalog->withMotor(*info, m_device.motor()) : id;
    };
    for (const Named &source : m_sources) {
        for (const catalog::RegisterId id : source.registers()) {
            if (!m_model.pollable(shown(id)) || !seen.insert(id).second)
                continue;
            sum.push_back(id);
            if (source.drawn)
                drawn.push_back(id);
        }
    }
    if (sum == m_asked && drawn == m_drawn)
        return;
    m_asked = sum;
    m_drawn = drawn;
    m_device.submit(drive::Watch{std::move(sum), kPeriod, std::move(drawn)});
}

} // namespace widgets
