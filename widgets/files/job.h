// FileJob: work with a file in a thread of a pool, over values that do not change meanwhile. Once it takes longer than
// a second a dialog shows how far it is, how long it will still take, and Cancel; it blocks nothing. What the work
// found out is used in the GUI thread, by the function that the work returns.
#pragma once

#include <QElapsedTimer>
#include <QPointer>
#include <QSemaphore>
#include <QTimer>

#include <atomic>
#include <functional>
#include <memory>

class QProgressDialog;

namespace widgets {

class FileJob : public QObject {
    Q_OBJECT
public:
    using Proceed = std::function<bool(double)>; ///< told 0..1, any thread; false: cancelled
    using Finish = std::function<void()>;
    using Work = std::function<Finish(const Proceed &)>;
    static constexpr int kQuiet_ms = 1000; ///< shorter ones show no dialog

    /// Starts at once and deletes itself when it is over. Destroyed before, with its window, it cancels and waits,
    /// and nothing of it is used.
    FileJob(const QString &title, Work work, QWidget *window);
    ~FileJob() override;

    void cancel(); ///< the work ends soon, in its own words
    bool underWay() const { return !m_over && !m_cancelled; }

Q_SIGNALS:
    void over(); ///< after the work's function ran

private:
    void tick();
    QString estimate(double fraction) const;

    QString m_title;
    QPointer<QProgressDialog> m_dialog;
    QTimer m_timer;
    QElapsedTimer m_elapsed;
    bool m_over = false;
    std::atomic<bool> m_cancelled = false;
    std::atomic<double> m_fraction = 0.0;
    std::shared_ptr<QSemaphore> m_left; ///< available once the thread has let go of this
};

} // namespace widgets
