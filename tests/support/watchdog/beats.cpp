#include "support/watchdog/beats.h"

#include "support/watchdog/running_code.h"

#include <QMetaEnum>
#include <QTest>

#include <cstdio>
#include <vector>

namespace support {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSlowed = true;
#else
constexpr bool kSlowed = false;
#endif

struct Running {
    int loop; ///< how deep the event loop is that brought it
    double start_s;
    double inside_s = 0.0; ///< of beats in loops inside it
    QByteArray name; ///< the receiver may be gone at the end
};

std::vector<Running> &running()
{
    static std::vector<Running> all;
    return all;
}

Beat::Told &all()
{
    static Beat::Told told;
    return told;
}

QByteArray nameOf(const QObject &receiver)
{
    return receiver.metaObject()->className() + (" " + receiver.objectName().toUtf8());
}

void tell(const Running &beat, double seconds, QEvent::Type type)
{
    Beat::Told &told = all();
    const char *event = QMetaEnum::fromType<QEvent::Type>().valueToKey(type);
    QString text =
        QStringLiteral("a beat of %1 ms: %2 for %3")
            .arg(QString::number(seconds * 1e3, 'f', 0),
                event ? QLatin1String(event) : QString::number(type), QString::fromUtf8(beat.name));
    for (const std::string &function : codeThatRan())
        text += QStringLiteral("\n    ") + QString::fromStdString(function);
    // No warning: a test may wait for those.
    std::fprintf(stderr, "%s\n", qPrintable(text));
    ++told.beats;
    if (seconds >= told.longest_s)
        told.what = text;
    if (seconds > Beat::kFrozen_s && !kSlowed && QTest::currentTestFunction())
        QTest::qFail(qPrintable(text), __FILE__, __LINE__);
}

} // namespace

const Beat::Told &Beat::told() { return all(); }

void Beat::forget() { all() = {}; }

Beat::Beat(const QObject &receiver, const QEvent &event)
{
    const int loop = QThread::currentThread()->loopLevel();
    if (!running().empty() && running().back().loop == loop)
        return; // part of what goes on
    m_counts = true;
    m_type = event.type();
    noteCodeAfter(kLong_s);
    running().push_back({loop, threadSeconds(), 0.0, nameOf(receiver)});
}

Beat::~Beat()
{
    if (!m_counts)
        return;
    const Running beat = std::move(running().back());
    running().pop_back();
    const double whole = threadSeconds() - beat.start_s;
    const double seconds = whole - beat.inside_s;
    if (!running().empty())
        running().back().inside_s += whole;
    if (seconds > kLong_s)
        tell(beat, seconds, m_type);
    all().longest_s = std::max(all().longest_s, seconds);
    if (running().empty())
        noteCodeAfter(0.0);
}

} // namespace support
