// Why a link or a port ended, and what to do about it: once, for the window and the command line. Each adds what
// only its own controls or options can do. English; the window translates its pieces, in the context "Link".
#pragma once

#include "drive/event.h"
#include "session/files/problem_words.h"
#include "session/transports/endpoint.h"

namespace session {

/// Why a link ended or came back, or what is tried; empty for None.
QString linkProblemText(drive::LinkReason reason, ProblemWords wordsOf = englishWords);
/// Why a port could not be opened or is gone; empty for None.
QString portErrorText(
    const PortError &why, const QString &port, ProblemWords wordsOf = englishWords);

} // namespace session
