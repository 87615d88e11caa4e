// StopWords: how far the last stop has got, in four words for each motor, each with its age and never ahead of its
// evidence: that one motor stands says nothing of another.
#pragma once

#include "drive/event.h"
#include "widgets/base/device.h"

#include <QWidget>

#include <array>
#include <map>
#include <optional>

class QGridLayout;
class QLabel;

namespace widgets {

class StopWords : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kWords = 4; ///< requested, accepted, drive idle, standstill

    explicit StopWords(QWidget *parent = nullptr);

    void take(const drive::StopProgress &progress, Milliseconds now);
    void refresh(Milliseconds now); ///< the ages go on
    void clear();
    bool rested() const; ///< every motor was idle, or more than that
    QString text() const; ///< all words that were reached, for tests and screen readers

private:
    struct Line {
        QLabel *mark = nullptr;
        QLabel *age = nullptr;
        std::optional<Milliseconds> since;
    };
    struct Motor {
        QLabel *name = nullptr; ///< shown where there is more than one
        std::array<Line, kWords> lines;
    };
    Motor &motor(int number);
    static void clear(Motor &motor);

    QGridLayout *m_grid;
    std::map<int, Motor> m_motors;
};

} // namespace widgets
