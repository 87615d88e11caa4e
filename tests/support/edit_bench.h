// A register panel on a simulated board, in virtual time: what is typed goes through the real drive and its line.
#pragma once

#include "support/link_pair.h"
#include "support/window_facts.h"
#include "widgets/registers/edits.h"
#include "widgets/registers/panel.h"

#include <QCoreApplication>
#include <QObject>

namespace facts {

struct EditBench {
    support::Session link;
    widgets::Device device;
    widgets::RegisterModel model;
    widgets::RegisterEdits edits{device, model};
    widgets::RegisterPanel panel{model, edits};
    std::vector<drive::Write> writes; ///< all that were asked for
    QStringList told;
    bool answerYes = false; ///< to every question, without a window
    int questions = 0;

    explicit EditBench(const simulation::BoardOptions &options = {}, bool quiet = true)
        : link(false, options)
    {
        link.judge.excuse("ends once", "the window and the test count their wishes each from 1");
        if (quiet) // the panel's own question is for the tests of that question
            QObject::disconnect(&edits, &widgets::RegisterEdits::asked, &panel, nullptr);
        QObject::connect(
            &device, &widgets::Device::wishMade, &panel, [this](const drive::Wish &wish) {
                if (const auto *write = std::get_if<drive::Write>(&wish.what))
                    writes.push_back(*write);
                link.drive->submit(wish, link.now); // its events come later, as from another thread
            });
        QObject::connect(&device, &widgets::Device::armWished, &panel, [this](bool arm) {
            arm ? link.drive->arm() : link.drive->disarm();
            device.armedChanged(link.drive->armed());
        });
        QObject::connect(&device, &widgets::Device::identityChanged, &panel, [this] {
            if (device.identified())
                model.setMotorLimits(device.identified()->limits);
            model.setCatalog(device.catalog(), device.motor());
        });
        QObject::connect(&device, &widgets::Device::readingsArrived, &panel,
            [this](const std::vector<drive::Reading> &readings) { model.accept(readings, ms()); });
        QObject::connect(&edits, &widgets::RegisterEdits::told, &panel,
            [this](const QString &sentence, bool) { told.append(sentence); });
        QObject::connect(
            &edits, &widgets::RegisterEdits::asked, &panel,
            [this] {
                ++questions;
                if (answerYes)
                    edits.confirm();
            },
            Qt::QueuedConnection);
        device.portChanged(session::PortState::Open, {});
        feed(device,
            {drive::LinkChanged{drive::LinkState::Connected, drive::LinkReason::None},
                *link.identified});
        link.onEvent = [this](const drive::Event &event) { feed(device, {event}); };
        readAll();
    }
    ~EditBench() { link.onEvent = nullptr; }

    widgets::Milliseconds ms() const
    {
        return std::chrono::duration_cast<widgets::Milliseconds>(link.now.time_since_epoch());
    }
    drive::RegisterId id(std::string_view name) const { return link.id(name); }

    void arm() { device.setArmed(true); }

    /// Every register that can be written and read, structures too.
    std::map<drive::RegisterId, catalog::Value> readAll()
    {
        drive::Read read;
        for (const catalog::RegisterInfo &info : device.catalog()->registers())
            if (info.writable() && info.readable() && !info.stub)
                read.registers.push_back(device.catalog()->withMotor(info, 1));
        const drive::WishId wish = 1000000 + ++m_reads;
        link.drive->submit({wish, read}, link.now);
        link.runUntilEnded(wish);
        std::map<drive::RegisterId, catalog::Value> values;
        for (const drive::RegisterId one : read.registers)
            if (const auto at = link.values.find(one);
                at != link.values.end() && at->second.status == drive::ReadStatus::Ok)
                values[one] = at->second.value;
        return values;
    }

    bool type(std::string_view name, const QString &text,
        widgets::RegisterModel::Column column = widgets::RegisterModel::ValueColumn)
    {
        return model.setData(model.indexOf(id(name), column), text);
    }
    /// Until nothing is under way; questions are answered on the way.
    bool settle()
    {
        QCoreApplication::processEvents();
        return link.runUntil(
            [this] {
                QCoreApplication::processEvents();
                return !edits.underWay();
            },
            std::chrono::seconds(5));
    }
    bool apply()
    {
        edits.apply();
        return settle();
    }
    catalog::Value held(std::string_view name)
    {
        drive::WishId wish = 1000000 + ++m_reads;
        link.drive->submit({wish, drive::Read{{id(name)}}}, link.now);
        link.runUntilEnded(wish);
        return link.values[id(name)].value;
    }

private:
    drive::WishId m_reads = 0;
};

} // namespace facts
