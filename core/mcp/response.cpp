#include "mcp/response.h"

namespace mcp {

Result<Response, CodecError> decodeResponse(ByteView payload)
{
    if (payload.empty())
        return fail(CodecError::Empty);
    return Response{payload.back(), payload.first(payload.size() - 1)};
}

Result<GetAnswer, CodecError> decodeGetAnswer(std::span<const RegisterId> ids, ByteView payload)
{
    const auto response = decodeResponse(payload);
    if (!response)
        return fail(response.error());
    GetAnswer answer;
    answer.status = response->status;
    ByteReader reader(response->data);
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
    if (response->ok() && answer.values.size() < ids.size())
        return fail(CodecError::TooShort);
    return answer;
}

Result<SetAnswer, CodecError> decodeSetAnswer(std::size_t count, ByteView payload)
{
    const auto response = decodeResponse(payload);
    if (!response)
        return fail(response.error());
    SetAnswer answer;
    answer.status = response->status;
    if (response->data.empty()) {
        if (response->ok() || count == 1)
            answer.registers.assign(count, response->status);
        return answer;
    }
    if (response->data.size() > count)
        return fail(CodecError::Leftover);
    answer.registers.assign(response->data.begin(), response->data.end());
    return answer;
}

std::optional<std::uint8_t> versionOf(const Response &response)
{
    if (!response.ok() || response.data.size() != 4)
        return std::nullopt;
    return response.data[0];
}

} // namespace mcp
