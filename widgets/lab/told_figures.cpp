#include "widgets/lab/told_figures.h"

#include "lab/evaluation/finding.h"
#include "widgets/base/si_text.h"
#include "widgets/lab/text.h"

#include <QCoreApplication>

namespace widgets {
namespace {

struct ToldFigures {
    Q_DECLARE_TR_FUNCTIONS(ToldFigures)
};

QString told(const lab::Figure &figure)
{
    const auto text = [&figure, place = lab::lastPlaceOf(*figure.value)](double value) {
        return siText(value, QString::fromUtf8(figure.unit), place);
    };
    const lab::Estimate &value = *figure.value;
    if (!value.low || !value.high)
        return ToldFigures::tr("%1: %2.", "a number").arg(labText(figure.name), text(value.value));
    return ToldFigures::tr("%1: %2 (%3 to %4).", "a number and its interval")
        .arg(labText(figure.name), text(value.value), text(*value.low), text(*value.high));
}

QStringList figuresIn(const lab::Finding &finding)
{
    QStringList lines;
    const auto add = [&lines]<class Found>(const Found &found) {
        if constexpr (lab::HasFigures<Found>)
            for (const lab::Figure &figure : figuresOf(found))
                if (figure.value)
                    lines.append(told(figure));
    };
    std::visit(add, finding);
    return lines;
}

} // namespace

ExperimentBar::Evaluate tellsFigures()
{
    return [](const Experiments::Run &run) -> ExperimentBar::Show {
        const auto found = lab::findingIn(run.capture, run.happenings);
        return [found, refused = run.outcome.end == lab::End::Refused]() -> QStringList {
            if (found)
                return figuresIn(*found) + labSentences(lab::notesOf(*found));
            if (refused)
                return {}; // why is said already
            return {ToldFigures::tr("Not conclusive: %1").arg(labSentence(found.error()))};
        };
    };
}

} // namespace widgets
