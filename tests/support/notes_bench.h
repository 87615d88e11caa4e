// A recording with two notes, for tests that add some to it.
#pragma once

#include "session/recording/file.h"

#include <QFile>
#include <QtTest>

namespace support {

constexpr recorded::Nanos kSecond = 1'000'000'000;

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

inline void writeRecording(const QString &path, bool ended)
{
    QString text;
    session::RecordingFile file(session::makeDiskSink(path, text), {0, "test", "board"});
    QVERIFY(file.open());
    file.add(0, capture::StreamLayout{1, 1000.0, 0.0, 1, {{1, "A", "A", 0.1, 0.0}}, {}});
    for (capture::Tick tick = 0; tick < 5000; tick += 1000) {
        file.add(tick * 1'000'000,
            capture::SampleBlock{1, tick, 1000, std::vector<std::int16_t>(1000, 7), {}, 0});
        file.flushAll();
    }
    file.add(kSecond, recorded::Note{kSecond, kSecond, "first"});
    file.add(2 * kSecond, recorded::Note{2 * kSecond, 2 * kSecond, "second"});
    if (ended)
        QVERIFY(file.end());
}

} // namespace support
