// The form of the gains on a simulated board, in virtual time: fields are typed into, what is polled is what the form
// watches, and Apply goes through the real drive and its line.
#pragma once

#include "support/edit_bench.h"
#include "widgets/base/fields/number_edit.h"
#include "widgets/forms/gain_lab.h"
#include "widgets/forms/gains_form.h"

#include <QAction>
#include <QLayout>
#include <QPushButton>
#include <QTabWidget>
#include <QTest>

namespace facts {

struct GainBench : EditBench {
    widgets::GainsForm form;
    /// Everything that is streamed.
    std::function<void(const capture::StreamLayout *, const capture::SampleBlock *)> heard;

    explicit GainBench(
        const simulation::BoardOptions &options = {}, const widgets::Inertias &inertias = {})
        : EditBench(options)
        , form(device, model, edits, panel.actions().apply, panel.actions().revert, inertias)
    {
        answerYes = true;
        QObject::connect(&device, &widgets::Device::streamStarted, &form,
            [this](const capture::StreamLayout &layout) {
                if (heard)
                    heard(&layout, nullptr);
            });
        QObject::connect(&device, &widgets::Device::samplesArrived, &form,
            [this](const capture::SampleBlock &block) {
                if (heard)
                    heard(nullptr, &block);
            });
        form.layout()->addWidget(form.footer());
        form.resize(1000, 320);
        form.show();
        arm();
        pages()->setCurrentWidget(lab());
        look();
    }

    QTabWidget *pages() { return form.findChild<QTabWidget *>(QStringLiteral("gainPages")); }
    widgets::GainLab *lab()
    {
        return form.findChild<widgets::GainLab *>(QStringLiteral("gainLab"));
    }
    widgets::NumberEdit *field(const char *name)
    {
        return form.findChild<widgets::NumberEdit *>(QLatin1String(name));
    }
    QPushButton *button(const char *name)
    {
        return form.findChild<QPushButton *>(QLatin1String(name));
    }

    /// Reads what the form watches until it wants nothing new, and lets it look.
    void look()
    {
        for (int round = 0; round < 2; ++round) {
            const auto watched = form.watchedRegisters();
            const drive::WishId wish = 2000000 + ++m_looks;
            link.drive->submit({wish, drive::Read{watched}}, link.now);
            link.runUntilEnded(wish);
            form.refresh(ms());
            QCoreApplication::processEvents();
        }
    }

    void typeInto(const char *name, const QString &text)
    {
        QLineEdit *edit = field(name);
        edit->setFocus();
        edit->selectAll();
        if (text.isEmpty())
            QTest::keyClick(edit, Qt::Key_Delete);
        else
            QTest::keyClicks(edit, text);
    }

    bool previewAndApply()
    {
        QPushButton *preview = button("labPreview");
        if (!preview->isEnabled())
            return false;
        preview->click();
        if (edits.pendingCount() == 0)
            return true; // the board has them
        const bool ended = apply();
        look();
        return ended && edits.pendingCount() == 0 && !model.hasEdits();
    }

private:
    drive::WishId m_looks = 0;
};

} // namespace facts
