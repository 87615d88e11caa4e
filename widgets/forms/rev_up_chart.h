// RevUpChart: the stages of a start as a picture: speed and current over time on two axes. Its points are dragged with
// the mouse or nudged with the keys, and snap to what the register can hold. It draws the model's stages and changes
// them only there: during a drag too the picture shows what the model took.
#pragma once

#include "widgets/forms/rev_up_model.h"

#include <QtCharts/QChartView>

#include <array>

class QLineSeries;
class QValueAxis;

namespace widgets {

struct MeasuredStart;

class RevUpChart : public QChartView {
    Q_OBJECT
public:
    enum class Quantity : std::uint8_t { Speed, Current };
    struct Point {
        int stage = 0;
        Quantity quantity = Quantity::Speed;
        bool operator==(const Point &) const = default;
    };

    explicit RevUpChart(RevUpModel &model, QWidget *parent = nullptr);

    /// Where a used stage's point is, in the viewport.
    QPointF handle(const Point &point) const;
    /// The drawn line's corners, in seconds and the axis' unit; while the picture is visible.
    QList<QPointF> drawn(Quantity quantity) const;
    QList<QPointF> drawnMeasured(Quantity quantity) const;
    std::optional<Point> selected() const { return m_selected; }
    /// The selected point in words, with units; how to move points if none is selected.
    QString hint() const;
    /// Where the words at the speed from which the observer sees are, in the viewport; empty: there is none in view.
    QRectF observerWords() const { return wordsOfObserver().place; }
    QSize sizeHint() const override { return minimumSizeHint(); }
    QSize minimumSizeHint() const override;

    void setMeasured(const MeasuredStart &start);

public Q_SLOTS:
    void selectStage(int stage); ///< keeps the quantity; a stage that is not used selects nothing
    void fit(); ///< shows all

Q_SIGNALS:
    void hintChanged();
    void stageSelected(int stage);
    void addWanted();
    void removeWanted();

protected:
    bool event(QEvent *event) override;
    void showEvent(QShowEvent *event) override;
    void changeEvent(QEvent *event) override;
    void resizeEvent(QResizeEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;
    void wheelEvent(QWheelEvent *event) override;
    void drawForeground(QPainter *painter, const QRectF &rect) override;

private:
    struct Drag {
        Point point;
        QPointF from; ///< where the button went down, viewport
        QPointF offset; ///< from there to the point
        motor::RevUpStage before;
        double begins_s = 0.0; ///< the stage
        bool sideways = false, upright = false; ///< has left the dead zone that way
    };

    void makeSeries();
    void restyle();
    void showStages();
    void select(std::optional<Point> point);
    void announce();
    std::optional<Point> pointAt(const QPointF &position) const;
    void dragTo(const QPointF &position);
    bool nudge(const QKeyEvent &key);
    QPointF valueOf(const Point &point) const;
    QPointF toView(const QPointF &value, Quantity quantity) const;
    QPointF toValue(const QPointF &position, Quantity quantity) const;
    double beginOf(int stage) const; ///< s
    QColor colorOf(Quantity quantity) const;
    struct Words {
        QString text;
        QRectF place;
    };
    QString titleOf(Quantity quantity) const;
    double observerSpeed() const;
    double currentLimit() const;
    bool inView(Quantity quantity, double value) const;
    double reaches(double speed_rpm) const;
    Words wordsOfObserver() const;
    Words wordsOfCurrent() const;
    void drawLimit(QPainter &painter, Quantity quantity, double value, const Words &words) const;
    void drawPoints(QPainter &painter) const;
    void drawMistakes(QPainter &painter) const;

    RevUpModel &m_model;
    QValueAxis *m_time;
    std::array<QValueAxis *, 2> m_axes; ///< by quantity, as the next two
    std::array<QLineSeries *, 2> m_plan, m_measured;
    std::optional<Point> m_selected;
    std::optional<Drag> m_drag;
};

} // namespace widgets
