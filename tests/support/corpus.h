// The files of a fuzz target's corpus through it, in the ordinary build: what a fuzzer once found stays found. A target
// is one function; a finding aborts.
#pragma once

#include "support/places.h"

#include <QDir>
#include <QtTest>

#include <cstdint>

namespace support {

using FuzzTarget = int (*)(const std::uint8_t *, std::size_t);

inline int play(FuzzTarget target, const QByteArray &bytes)
{
    return target(reinterpret_cast<const std::uint8_t *>(bytes.constData()),
        static_cast<std::size_t>(bytes.size()));
}

inline QString corpora() { return support::dataFile(QStringLiteral("corpus")); }

inline QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

/// Rows "target", "path": one a file. @param names  of targets, which are folders
inline void addFilesOf(const QStringList &names)
{
    QTest::addColumn<QString>("target");
    QTest::addColumn<QString>("path");
    for (const QString &name : names) {
        const QDir folder(corpora() + u'/' + name);
        for (const QFileInfo &file : folder.entryInfoList(QDir::Files, QDir::Name))
            QTest::addRow("%s %s", qPrintable(name), qPrintable(file.fileName()))
                << name << file.filePath();
    }
}

inline void playFile(FuzzTarget target, const QString &path)
{
    QVERIFY(target != nullptr);
    const QByteArray bytes = contentOf(path);
    QVERIFY(!bytes.isEmpty());
    QCOMPARE(play(target, bytes), 0);
}

/// Its beginnings, and it with one bit flipped: a fair sample of the long ones.
inline void playSpoilt(FuzzTarget target, const QString &path)
{
    QVERIFY(target != nullptr);
    const QByteArray bytes = contentOf(path);
    const qsizetype step = std::max<qsizetype>(1, bytes.size() / 50);
    for (qsizetype at = 0; at < bytes.size(); at += step) {
        QCOMPARE(play(target, bytes.first(at)), 0);
        QByteArray flipped = bytes;
        flipped[at] = static_cast<char>(flipped[at] ^ 1 << at % 8);
        QCOMPARE(play(target, flipped), 0);
    }
}

} // namespace support
