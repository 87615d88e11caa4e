// A field of a form: what it says of the register's value.
#include "support/window_facts.h"
#include "widgets/registers/field.h"

#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTest>

using namespace std::chrono_literals;

class TestRegisterField : public QObject {
    Q_OBJECT
private Q_SLOTS:
    void anOldValueIsMarkedUntilANewOneComes();
};

void TestRegisterField::anOldValueIsMarkedUntilANewOneComes()
{
    widgets::RegisterModel model;
    model.setCatalog(facts::smallCatalog(), 1);
    widgets::RegisterField field(model, QStringLiteral("SPEED_MEAS"));
    const auto ink = [&field] {
        const auto *shows = field.findChild<QLineEdit *>();
        const QWidget *widget =
            shows ? static_cast<const QWidget *>(shows) : field.findChild<QLabel *>();
        return widget->palette().color(shows ? QPalette::Text : QPalette::WindowText);
    };
    const QColor pale = QApplication::palette().color(QPalette::Disabled, QPalette::Text);
    const auto value = [](int rpm) {
        return std::vector<drive::Reading>{
            facts::reading(facts::kSpeed, catalog::Value(std::int64_t(rpm)))};
    };
    model.accept(value(1500), widgets::Milliseconds(0));
    QVERIFY(ink() != pale);
    model.setBelieved(false);
    QCOMPARE(ink(), pale);
    model.setBelieved(true);
    model.accept(value(1600), widgets::Milliseconds(500));
    QVERIFY(ink() != pale);
    model.refresh(widgets::Milliseconds(60'000)); // it is not read any more
    QCOMPARE(ink(), pale);
}

QTEST_MAIN(TestRegisterField)
#include "tst_register_field.moc"
