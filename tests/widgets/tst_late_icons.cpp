// LateIcons: icons that come late are those of the style.
#include "widgets/base/late_icons.h"
#include "widgets/base/theme.h"

#include <QApplication>
#include <QStyleFactory>
#include <QTest>

#include <memory>

class LateIconsTest : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void anIconIsTheStylesOwn_data()
    {
        QTest::addColumn<int>("which");
        QTest::newRow("clears a field") << int(QStyle::SP_LineEditClearButton);
        QTest::newRow("more of a menu bar") << int(QStyle::SP_ToolBarHorizontalExtensionButton);
        QTest::newRow("closes a dock") << int(QStyle::SP_TitleBarCloseButton);
        QTest::newRow("a warning") << int(QStyle::SP_MessageBoxWarning);
    }
    void anIconIsTheStylesOwn()
    {
        QFETCH(int, which);
        const auto icon = static_cast<QStyle::StandardPixmap>(which);
        QApplication::setStyle(new widgets::LateIcons);
        const std::unique_ptr<QStyle> fusion(QStyleFactory::create(QStringLiteral("Fusion")));
        const QIcon theirs = fusion->standardIcon(icon);
        const QIcon late = QApplication::style()->standardIcon(icon);
        QVERIFY(!theirs.isNull());
        QVERIFY(!late.isNull());
        QCOMPARE(late.availableSizes(), theirs.availableSizes());
        for (const int side : {10, 16, 32}) {
            for (const qreal scale : {1.0, 2.0}) {
                const QSize size(side, side);
                QCOMPARE(late.actualSize(size), theirs.actualSize(size));
                const QImage shown = late.pixmap(size, scale, QIcon::Disabled).toImage();
                QVERIFY(!shown.isNull());
                QCOMPARE(shown, theirs.pixmap(size, scale, QIcon::Disabled).toImage());
                QCOMPARE(shown.devicePixelRatio(),
                    theirs.pixmap(size, scale, QIcon::Disabled).devicePixelRatio());
            }
        }
    }

    /// As `-stylesheet` gives the program one: another style then stands before ours.
    void itIsTheStylesOwnUnderAStyleSheetToo()
    {
        QApplication::setStyle(new widgets::LateIcons);
        qApp->setStyleSheet(QStringLiteral("QLabel { padding: 1px; }"));
        const auto icon = QStyle::SP_TitleBarCloseButton;
        const QIcon late = QApplication::style()->standardIcon(icon);
        const std::unique_ptr<QStyle> fusion(QStyleFactory::create(QStringLiteral("Fusion")));
        QCOMPARE(
            late.pixmap(16, 16).toImage(), fusion->standardIcon(icon).pixmap(16, 16).toImage());
        QVERIFY(!late.pixmap(16, 16).isNull());
    }

    void aThemeThatChangesUnderAStyleSheetLeavesTheStyle()
    {
        qApp->setStyleSheet(QStringLiteral("QLabel { padding: 1px; }"));
        widgets::applyTheme(widgets::Theme::Light);
        const QIcon late = QApplication::style()->standardIcon(QStyle::SP_TitleBarCloseButton);
        widgets::applyTheme(widgets::Theme::Dark);
        QVERIFY(!late.pixmap(16, 16).isNull());
    }
    void cleanup() { qApp->setStyleSheet({}); }
};

QTEST_MAIN(LateIconsTest)
#include "tst_late_icons.moc"
