// StopWords: how far the last stop has got, in four words, each with its age and never ahead of its evidence.
#pragma once

#include "drive/event.h"
#include "widgets/base/device.h"

#include <QWidget>

#include <array>
#include <optional>

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
    bool ended() const; ///< the last word was reached
    QString text() const; ///< all lines, for tests and screen readers

private:
    struct Line {
        QLabel *mark = nullptr;
        QLabel *age = nullptr;
        std::optional<Milliseconds> since;
    };
    std::array<Line, kWords> m_lines;
};

} // namespace widgets
