// experiment: carries out the plan in a file. Afterwards the motor is as it was.
#include "experiments/run.h"
#include "lab/plan_file.h"

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>

namespace cli {

namespace {

constexpr QLatin1String kKind("experiment");

Outcome<QJsonObject> readPlan(const QString &path)
{
    constexpr qint64 kMost = 65536; // a plan is a few lines
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return failure(kFileError,
            QStringLiteral("%1 cannot be read: %2; check its name.").arg(path, file.errorString()));
    const QByteArray bytes = file.read(kMost + 1);
    QJsonParseError error{};
    const QJsonDocument document = QJsonDocument::fromJson(bytes, &error);
    if (bytes.size() > kMost || error.error != QJsonParseError::NoError)
        return failure(kFileError,
            QStringLiteral("%1 is no plan: at byte %2: %3.")
                .arg(path, QString::number(error.offset),
                    bytes.size() > kMost ? QStringLiteral("too long") : error.errorString()));
    if (!document.isObject() || !document.object().value(kKind).isString())
        return failure(kFileError,
            QStringLiteral("%1 is no plan: it has no \"experiment\", such as \"step\".").arg(path));
    return document.object();
}

Outcome<lab::PlanNumbers> numbersOf(const QString &path, const QJsonObject &plan)
{
    lab::PlanNumbers numbers;
    for (auto at = plan.begin(); at != plan.end(); ++at) {
        if (at.key() == kKind)
            continue;
        if (!at.value().isDouble())
            return failure(
                kFileError, QStringLiteral("%1: its \"%2\" is no number.").arg(path, at.key()));
        numbers.emplace_back(at.key().toStdString(), at.value().toDouble());
    }
    return numbers;
}

Outcome<int> runExperiment(Desk &desk)
{
    const QString &path = desk.arguments.words.first();
    const auto file = readPlan(path);
    if (!file)
        return tl::make_unexpected(file.error());
    const auto numbers = numbersOf(path, *file);
    if (!numbers)
        return tl::make_unexpected(numbers.error());
    ExperimentRun run(desk);
    const QString kind = file->value(kKind).toString();
    const auto subject = run.subject(kind == QLatin1String("step"));
    if (!subject)
        return tl::make_unexpected(subject.error());
    const auto plan = lab::planOf(kind.toStdString(), *numbers, *subject, desk.arguments.limits);
    if (!plan)
        return failure(
            kFileError, QStringLiteral("%1: %2.").arg(path, QString::fromStdString(plan.error())));
    return run.run(*subject, {*plan});
}

constexpr OptionText kExperimentOptions[] = {kRunOption};

} // namespace

const Command kExperiment{.name = "experiment",
    .words = "PLAN.json",
    .help = "Carries out the experiment that a file plans; then all is as before.",
    .least = 1,
    .most = 1,
    .options = kExperimentOptions,
    .read = readRunFile,
    .canMove = true,
    .ownsMotor = true,
    .ofOneMotor = true,
    .run = runExperiment};

} // namespace cli
