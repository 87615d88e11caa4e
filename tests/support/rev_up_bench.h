// The rev-up form on a simulated board in virtual time, with everything it works with in the window.
#pragma once

#include "capture/capture.h"
#include "support/edit_bench.h"
#include "support/window_rig.h"
#include "widgets/forms/rev_up_chart.h"
#include "widgets/forms/rev_up_form.h"
#include "widgets/forms/rev_up_start.h"
#include "widgets/forms/rev_up_table.h"
#include "widgets/registers/entry_edit.h"

#include <QLabel>
#include <QPushButton>

namespace facts {

struct RevUpBench {
    using Chart = widgets::RevUpChart;
    using Quantity = Chart::Quantity;

    EditBench bench;
    capture::Capture capture;
    AnsweredPrompt files;
    widgets::RevUpForm form;
    widgets::RevUpModel &model;
    Chart &chart;
    widgets::RevUpTable *table;
    QStringList failures;

    explicit RevUpBench(const simulation::BoardOptions &options = {})
        : bench(options)
        , form({bench.device, bench.model, bench.edits, capture, files, bench.panel.actions().apply,
              bench.panel.actions().revert})
        , model(form.model())
        , chart(form.chart())
        , table(form.findChild<widgets::RevUpTable *>(QStringLiteral("revUpTable")))
    {
        QObject::connect(&form, &widgets::Form::failed, &form,
            [this](const QString &sentence) { failures.append(sentence); });
        QObject::connect(&bench.device, &widgets::Device::streamStarted, &form,
            [this](const capture::StreamLayout &layout) { capture.begin(layout); });
        QObject::connect(&bench.device, &widgets::Device::samplesArrived, &form,
            [this](const capture::SampleBlock &block) { capture.append(block); });
        form.resize(1000, 320);
        readWatched();
    }

    /// What the window would poll for the form, once.
    void readWatched()
    {
        drive::Read read{form.watchedRegisters()};
        const drive::WishId wish = bench.device.submit(read);
        bench.link.runUntilEnded(wish);
        QCoreApplication::processEvents();
    }
    bool show()
    {
        form.show();
        return QTest::qWaitForWindowExposed(&form);
    }
    const motor::RevUp &stages() const { return model.stages(); }
    bool type(int row, int column, const QString &text)
    {
        return model.setData(model.index(row, column), text);
    }
    bool setAll(const motor::RevUp &stages) { return model.setStages(stages); }
    Bytes heldBytes() { return std::get<Bytes>(bench.held("REVUP_DATA")); }
    Bytes wantedBytes() const
    {
        return std::get<Bytes>(*bench.model.wanted(bench.id("REVUP_DATA")));
    }

    // The mouse on the picture.
    void press(const QPointF &at) { mouse(QEvent::MouseButtonPress, at, Qt::LeftButton); }
    void move(const QPointF &at) { mouse(QEvent::MouseMove, at, Qt::NoButton); }
    void release(const QPointF &at) { mouse(QEvent::MouseButtonRelease, at, Qt::LeftButton); }

private:
    void mouse(QEvent::Type type, const QPointF &at, Qt::MouseButton button)
    {
        const bool up = type == QEvent::MouseButtonRelease;
        QMouseEvent event(type, at, chart.viewport()->mapToGlobal(at), button,
            up ? Qt::NoButton : Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(chart.viewport(), &event);
    }
};

} // namespace facts
