// What is painted of a trace in some columns of the scope's picture: which rows have its colour, and which that of any
// trace.
#pragma once

#include "widgets/scope/view.h"

#include <QEventLoop>
#include <QImage>
#include <QTimer>

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace support {

/// A trace as it is laid out on the screen.
struct PictureTrace {
    QString name;
    QRgb color = 0;
    QRect plot;
    double least = 0.0, greatest = 1.0; ///< of its axis

    PictureTrace(const widgets::ScopeView &view, capture::ChannelId channel)
        : name(view.nameOf(channel))
        , color(view.colorOf(channel).rgb())
        , plot(view.plotRect(view.plotOf(channel)))
        , least(view.valueRangeOf(channel).from)
        , greatest(view.valueRangeOf(channel).to)
    {
    }
    int motor(int otherwise) const
    {
        return name.contains(QLatin1Char('@')) ? name.section(QLatin1Char('@'), 1).toInt()
                                               : otherwise;
    }
    std::string registerName() const { return name.section(QLatin1Char('@'), 0, 0).toStdString(); }
    int rowOf(double value) const
    {
        const double row = (greatest - value) / (greatest - least) * plot.height();
        return static_cast<int>(std::clamp(row, -1e4, 1e4));
    }
};

/// What is laid out may not have been painted yet.
inline void letItPaint()
{
    constexpr int kFrame_ms = 80;
    QEventLoop loop;
    QTimer::singleShot(kFrame_ms, &loop, &QEventLoop::quit);
    loop.exec();
}

class PictureInk {
public:
    static constexpr int kColumns = 24; ///< that are looked at
    static constexpr int kAround = 3; ///< columns on each side, which may show what is sought

    explicit PictureInk(const widgets::ScopeView &view)
        : m_picture(const_cast<widgets::ScopeView &>(view).grab().toImage().convertToFormat(
            QImage::Format_RGB32))
        , m_ratio(m_picture.width() / double(std::max(1, view.width())))
    {
        for (const capture::ChannelId channel : view.channels())
            m_colors.push_back(view.colorOf(channel).rgb());
    }

    struct Column {
        int x = 0; ///< from the plot's left edge
        int top = -1, bottom = -1; ///< of the trace's own pixels; none: -1
        std::vector<bool> inked; ///< by row: a pixel of any trace

        bool inkedWithin(int from, int to) const
        {
            for (int row = std::max(0, from); row <= to && row < static_cast<int>(inked.size());
                 ++row)
                if (inked[static_cast<std::size_t>(row)])
                    return true;
            return false;
        }
    };
    std::vector<Column> columnsOf(const PictureTrace &trace) const
    {
        std::vector<Column> columns;
        const int width = trace.plot.width();
        for (int k = 0; k < kColumns; ++k) {
            // The right end has the last values written over it.
            Column column{width / 20 + k * (width * 3 / 4) / kColumns, -1, -1,
                std::vector<bool>(static_cast<std::size_t>(trace.plot.height()))};
            for (int row = 0; row < trace.plot.height(); ++row) {
                for (int dx = -kAround; dx <= kAround; ++dx) {
                    const QRgb pixel = pixelAt(trace.plot.topLeft() + QPoint(column.x + dx, row));
                    const bool own = isOf(pixel, trace.color);
                    if (own || std::any_of(m_colors.begin(), m_colors.end(), [pixel](QRgb color) {
                            return isOf(pixel, color);
                        }))
                        column.inked[static_cast<std::size_t>(row)] = true;
                    if (own && column.top < 0)
                        column.top = row;
                    if (own)
                        column.bottom = row;
                }
            }
            columns.push_back(std::move(column));
        }
        return columns;
    }

    const QImage &picture() const { return m_picture; }

private:
    QRgb pixelAt(const QPoint &at) const
    {
        return m_picture.pixel(QPoint(int(at.x() * m_ratio), int(at.y() * m_ratio)));
    }
    /// Between the cursors a trace is tinted a little.
    static bool isOf(QRgb pixel, QRgb color)
    {
        constexpr int kTint = 14; // of 255
        return std::abs(qRed(pixel) - qRed(color)) <= kTint
            && std::abs(qGreen(pixel) - qGreen(color)) <= kTint
            && std::abs(qBlue(pixel) - qBlue(color)) <= kTint;
    }

    QImage m_picture;
    double m_ratio;
    std::vector<QRgb> m_colors;
};

} // namespace support
