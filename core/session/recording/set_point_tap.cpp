#include "session/recording/set_point_tap.h"
