// Earlier records behind the traces, kept as one picture: of each pixel, which trace of which record is uppermost
// there. One record more is painted over it, one less or a paler one is another colour of the same picture; all are
// painted anew only where another time, size or scale is looked at. Knows no samples.
#pragma once

#include "capture/channel.h"

#include <QImage>

#include <functional>
#include <span>
#include <vector>

namespace widgets {

class TraceInk;

class RecordPicture {
public:
    /// What all records are painted with.
    struct Look {
        QSize size;
        double span = 0.0; ///< seconds
        struct Trace {
            capture::ChannelId channel = 0;
            double lower = 0.0; ///< of its axis
            double upper = 0.0;
            bool operator==(const Trace &) const = default;
        };
        std::vector<Trace> traces;
    };
    struct Record {
        double from = 0.0; ///< seconds on the session's axis, at the left edge
        std::uint64_t samples = 0; ///< of all traces: others may have come, or gone
        /// When those that end within it do, as a sum: a value that is given up holds for less long.
        std::uint64_t ends = 0;
    };
    /// Paints one of the records; the colour of its trace i is `first` + i.
    using Paint = std::function<void(std::size_t record, TraceInk &ink, QRgb first)>;

    /// @param records  oldest first
    void update(const Look &look, std::vector<Record> records, const Paint &paint);
    /// Writes every pixel; the ground where no record is.
    /// @param colors  of each record that update() was given one a trace
    void drawOn(QImage &image, std::span<const QRgb> colors, QRgb ground) const;

private:
    bool suits(const Look &look) const;

    Look m_look;
    std::vector<Record> m_records;
    QRgb m_first = 1; ///< what the oldest record's first trace is painted with
    QImage m_picture;
};

} // namespace widgets
