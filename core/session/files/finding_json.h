// What an experiment found, as JSON in one line: the same bytes from its run, from every later evaluation of its
// recording, and in its run book. The manual rotorscope-cli(1) has the keys.
#pragma once

#include "lab/evaluation/finding.h"

#include <QByteArray>

namespace session {

QByteArray findingJson(const lab::Finding &finding);

/// 95 % to either side of a point's gain.
double halfInterval(const lab::ResponsePoint &point);
/// The word for it, e.g. "viscous+dry".
const char *modelOf(const lab::Mechanics &found);

} // namespace session
