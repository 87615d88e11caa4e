// The family of icons: each drawing is there and to be seen in both themes, and each name that the window uses has one.
#include "support/places.h"
#include "widgets/base/look/line_icon.h"
#include "widgets/base/look/theme.h"

#include <QApplication>
#include <QDir>
#include <QDirIterator>
#include <QImage>
#include <QRegularExpression>
#include <QTest>

class TestLineIcon : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void eachIsInkedInTheColourOfText();
    void eachNameThatIsUsedHasOne();
};

namespace {

QStringList names()
{
    QStringList all;
    for (const QString &file : QDir(QStringLiteral(":/icons/line")).entryList())
        all.append(file.section(QLatin1Char('.'), 0, 0));
    return all;
}

/// How many pixels are as good as of this colour.
int inked(const QString &name, const QColor &color)
{
    constexpr int kSize = 32;
    const QImage image =
        widgets::lineIcon(name.toUtf8().constData()).pixmap(QSize(kSize, kSize)).toImage();
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += image.pixelColor(x, y) == color ? 1 : 0;
    return count;
}

} // namespace

void TestLineIcon::eachIsInkedInTheColourOfText()
{
    QVERIFY(names().size() > 50);
    for (const QPalette &palette : {widgets::lightPalette(), widgets::darkPalette()}) {
        QApplication::setPalette(palette);
        for (const QString &name : names())
            QVERIFY2(inked(name, palette.color(QPalette::ButtonText)) > 10, qPrintable(name));
    }
}

void TestLineIcon::eachNameThatIsUsedHasOne()
{
    const QStringList known = names();
    static const QRegularExpression use(
        QStringLiteral("(?:[lL]ineIcon\\([^\"\\n;]*|Dock\", )\"([a-z-]+)\""));
    QDirIterator files(support::sourceFile(QStringLiteral("widgets")), {QStringLiteral("*.cpp")},
        QDir::Files, QDirIterator::Subdirectories);
    int uses = 0;
    while (files.hasNext()) {
        QFile file(files.next());
        QVERIFY(file.open(QIODevice::ReadOnly));
        auto each = use.globalMatch(QString::fromUtf8(file.readAll()));
        while (each.hasNext()) {
            const QString name = each.next().captured(1);
            QVERIFY2(
                known.contains(name), qPrintable(name + QLatin1String(" in ") + file.fileName()));
            ++uses;
        }
    }
    QVERIFY(uses > 30);
}

QTEST_MAIN(TestLineIcon)
#include "tst_line_icon.moc"
