// StopWords: how far the last stop has got, in four words for each motor, each with its age and never ahead of its
// evidence: that one motor stands says nothing of another. It has four lines: all words of one motor, or of several
// motors the newest word of each; the others are in the tool tip then.
#pragma once

#include "drive/event.h"
#include "widgets/base/device.h"

#include <QWidget>

#include <array>
#include <map>
#include <optional>

class QLabel;

namespace widgets {

class StopWords : public QWidget {
    Q_OBJECT
public:
    static constexpr std::size_t kWords = 4; ///< requested, accepted, drive idle, standstill

    explicit StopWords(QWidget *parent = nullptr);

    void accept(const drive::StopProgress &progress, Milliseconds now);
    void refresh(Milliseconds now); ///< the ages go on
    void clear();
    bool rested() const; ///< every motor was idle, or more than that
    QString text() const; ///< all words that were reached, for tests and screen readers

protected:
    void changeEvent(QEvent *event) override;

private:
    struct Word {
        QString text;
        std::optional<Milliseconds> since; ///< empty: not reached
    };
    struct Motor {
        std::array<Word, kWords> words;
        bool mayCoast = false; ///< its last word is that nothing can be measured
        QString reached() const;
    };
    struct Line {
        QLabel *mark = nullptr;
        QLabel *age = nullptr;
        std::optional<Milliseconds> since;
    };
    Motor &motor(int number);
    static void clear(Motor &motor);
    void showAll();
    void showWord(std::size_t at, const Word &word, const QString &text);
    void fitHeight();

    std::map<int, Motor> m_motors;
    std::array<Line, kWords> m_lines;
};

} // namespace widgets
