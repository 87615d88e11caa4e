#include "catalog/register_info.h"

namespace catalog {

bool isInteger(ValueType type) { return type <= ValueType::S32; }

std::size_t widthOf(ValueType type)
{
    switch (type) {
    case ValueType::U8:
    case ValueType::S8:
        return 1;
    case ValueType::U16:
    case ValueType::S16:
        return 2;
    case ValueType::U32:
    case ValueType::S32:
    case ValueType::F32:
        return 4;
    case ValueType::Text:
    case ValueType::Raw:
        break;
    }
    return 0;
}

} // namespace catalog
