// There is no guardian on Windows: a program that dies there leaves its motors as they are.
#include "session/link/guardian.h"

namespace session {

std::shared_ptr<Guardian> startGuardian(const char *&why)
{
    why = "no guardian on this system: if the program dies, motors go on turning";
    return nullptr;
}

} // namespace session
