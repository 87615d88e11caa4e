// Where the acts of the user and the words of a product go that a judge has to know of.
#pragma once

#include "support/ms_rules.h"

namespace support {

/// Who is told; times are its own.
class ActSink {
public:
    virtual void act(judge::Act::Kind kind) = 0;
    virtual void said(judge::Word word, int motor) = 0;
    virtual void said(judge::LinkState link) = 0;
    virtual void saidIdentified(int motors) = 0;

protected:
    ~ActSink() = default;
};

} // namespace support
