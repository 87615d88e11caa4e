// Hands the ticks of axis_ticks.h to a QCustomPlot axis. Includes the slow header: only for the scope's own files.
#pragma once

#include <qcustomplot.h>

namespace widgets {

class AxisTicker : public QCPAxisTicker {
public:
    enum class Labels { Values, Times };
    explicit AxisTicker(Labels labels)
        : m_labels(labels)
    {
    }
    /// @param count  ticks, at most
    /// @param pixels  how long the axis is: small ticks closer than a few pixels are left out
    /// @param room  for so many labels, close together, where there would be next to none
    void setMost(int count, int pixels, int room = 0)
    {
        m_most = count;
        m_pixels = pixels;
        m_room = room;
    }
    void setOrigin(double origin) { m_origin = origin; } ///< what the labels call zero

    void generate(const QCPRange &range, const QLocale &locale, QChar format, int precision,
        QVector<double> &ticks, QVector<double> *subTicks, QVector<QString> *labels) override;

private:
    QVector<double> smallTicks(double from, double to, double step) const;

    Labels m_labels;
    int m_most = 10;
    int m_pixels = 0;
    int m_room = 0;
    double m_origin = 0.0;
};

} // namespace widgets
