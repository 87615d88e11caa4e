// Any bytes at any time into the Controller: it stays within its bounds and never asks to be called in a circle.
#include "aspep/controller.h"
#include "fuzz/script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t *data, std::size_t size)
{
    aspep::Controller controller({});
    controller.connect({});
    int stops = 0;
    int connections = 0;
    fuzz::play({data, size}, controller, [&](TimePoint now) {
        if (!controller.takeOutput().empty())
            controller.handleSent(now);
        for (const auto &event : controller.takeEvents()) {
            if (const auto *response = std::get_if<aspep::Controller::Response>(&event))
                fuzz::require(response->payload.size() <= controller.agreed().txSyncMax());
            if (const auto *async = std::get_if<aspep::Controller::Async>(&event))
                fuzz::require(async->payload.size() <= controller.agreed().txAsyncMax());
            constexpr std::uint8_t kStop[] = {0x21, 0x00};
            if (std::holds_alternative<aspep::Controller::Suspect>(event) && stops++ < 3)
                controller.sendUrgent(kStop, now);
            if (std::holds_alternative<aspep::Controller::Lost>(event) && connections++ < 2)
                controller.connect(now);
        }
        if (controller.canSend()) {
            constexpr std::uint8_t kRequest[] = {0x10, 0x00, 0x49, 0x00};
            controller.sendRequest(kRequest, now);
        }
    });
    return 0;
}
