#include "mcp/response.h"

namespace mcp {

Result<Response, CodecError> decodeResponse(ByteView payload)
{
    if (payload.empty())
        return fail(CodecError::Empty);
    return Response{payload.back(), payload.first(payload.size() - 1)};
}

std::optional<std::uint8_t> statusOf(const Response &response)
{
    if (response.data.size() > 1)
        return std::nullopt;
    return response.data.empty() ? response.status : response.data.front();
}

Result<GetAnswer, CodecError> decodeGetAnswer(
    std::span<const RegisterId> ids, const Response &response)
{
    GetAnswer answer;
    answer.status = response.status;
    answer.values.reserve(ids.size());
    ByteReader reader(response.data);
    for (const RegisterId id : ids) {
        if (reader.left() == 0)
            break;
        auto value = decodeValue(id, reader);
        if (!value)
            return fail(value.error());
        answer.values.push_back(*std::move(value));
    }
    if (reader.left() > 0)
        return fail(CodecError::Leftover);
    const bool all = answer.values.size() == ids.size();
    if (response.ok() && !all)
        return fail(CodecError::TooShort);
    if (!response.ok() && all && !ids.empty()) // an empty list is refused as it is
        return fail(CodecError::Leftover);
    return answer;
}

Result<SetAnswer, CodecError> decodeSetAnswer(std::size_t count, const Response &response)
{
    SetAnswer answer;
    answer.status = response.status;
    if (response.data.empty()) {
        if (response.ok() || count == 1)
            answer.registers.assign(count, response.status);
        return answer;
    }
    const bool closed = count == 1 || response.status == static_cast<std::uint8_t>(Status::Nok);
    if (response.data.size() > count || !closed)
        return fail(CodecError::Leftover);
    answer.registers.assign(response.data.begin(), response.data.end());
    return answer;
}

std::optional<std::uint8_t> versionOf(const Response &response)
{
    if (!response.ok() || response.data.size() != 4)
        return std::nullopt;
    return response.data[0];
}

} // namespace mcp
