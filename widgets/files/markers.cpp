#include "widgets/files/markers.h"

#include "capture/csv_export.h"
#include "widgets/scope/events/event_log.h"

namespace widgets {

Markers markersOf(const EventLog &events)
{
    Markers all;
    for (const ScopeEvent &event : events.events())
        if (event.kind == EventKind::Marker)
            all[capture::toNanos(event.seconds)] = event.text;
    return all;
}

QByteArray markerList(const Markers &markers)
{
    QByteArray list("time [s],marker\n");
    capture::ChannelInfo words; // headings are marked the same way
    for (const auto &[at, text] : markers) {
        words.name = text.toStdString();
        list += QByteArray::fromStdString(capture::csvTime(at)) + ','
            + QByteArray::fromStdString(capture::csvHeading(words)) + '\n';
    }
    return list;
}

} // namespace widgets
