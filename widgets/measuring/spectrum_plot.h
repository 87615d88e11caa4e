// A spectrum as a picture over frequency or order: one stroke a pixel column, so that no line of it is lost and drawing
// does not grow with the bins. The wheel, dragging and keys move the frequency axis; the amplitudes fit themselves.
#pragma once

#include "scope/spectrum.h"
#include "widgets/measuring/keyed_plot.h"

#include <QString>

class QCPGraph;
class QCPItemStraightLine;
class QCPItemText;
class QCPRange;

namespace widgets {

class SpectrumPlot final : public KeyedPlot {
    Q_OBJECT
public:
    explicit SpectrumPlot(QWidget *parent = nullptr);

    struct Picture {
        scope::Spectrum spectrum; ///< no bins: nothing to show
        std::vector<scope::SpectrumPeak> peaks;
        QString unit; ///< of an amplitude
        scope::OrderAxis orders; ///< valid: the axis counts orders
        bool decibels = false;
    };
    void showSpectrum(Picture picture);
    void showNothing(const QString &why);
    void mark(int peak); ///< one of the peaks, by a line; -1: none
    void fit() override; ///< everything up to half the sample rate
    double from() const; ///< hertz, what the axis shows
    double to() const;
    int points() const; ///< of the trace as it is drawn

protected:
    void zoom(double factor) override;
    void pan(double share) override;

private:
    void dress() override;
    void draw() override;
    void bound(const QCPRange &range);
    double level(std::size_t bin) const;
    double levelOf(double amplitude) const;
    double shownX(double hertz) const;
    double highest() const; ///< hertz
    void drawPeaks();
    void setLimits(double least, double most);

    QCPGraph *m_trace;
    QCPGraph *m_dots;
    QCPItemStraightLine *m_mark;
    QList<QCPItemText *> m_numbers;
    Picture m_picture;
    int m_marked = -1;
    double m_from = 0.0; ///< hertz; `to` 0: everything
    double m_to = 0.0;
    bool m_setting = false;
};

} // namespace widgets
