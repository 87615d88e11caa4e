#include "session/endpoint.h"
