-- Dissector for Wireshark and tshark: the recordings of Rotorscope (docs/recording-format.md).
-- Link type USER0: bytes of a serial line that speaks ASPEP, cut anywhere; they are put together per direction.
-- Link type USER1: Rotorscope's own entries.
-- Install: into ~/.local/lib/wireshark/plugins, or start with -X lua_script:rotorscope.lua.

local aspep = Proto("aspep", "ASPEP, Asymmetric Serial Packet Exchange Protocol")
local types = { [0x5] = "BEACON", [0x6] = "PING", [0x9] = "REQUEST or ASYNC", [0xA] = "RESPONSE", [0xF] = "NACK" }
-- Who sends it says which of the two it is.
local function name_of(kind, direction)
    if kind == 0x9 then return direction == 2 and "REQUEST" or "ASYNC" end
    return types[kind]
end
local f = aspep.fields
f.type = ProtoField.uint32("aspep.type", "Type", base.HEX, types, 0x0000000F)
f.length = ProtoField.uint32("aspep.length", "Payload length", base.DEC, nil, 0x0001FFF0)
f.crc = ProtoField.uint32("aspep.crc", "Header CRC-4", base.HEX, nil, 0xF0000000)
f.crc_ok = ProtoField.bool("aspep.crc_ok", "Header CRC-4 right")
f.version = ProtoField.uint32("aspep.beacon.version", "Version", base.DEC, nil, 0x00000070)
f.data_crc = ProtoField.uint32("aspep.beacon.data_crc", "Data CRC", base.DEC, nil, 0x00000080)
f.rx = ProtoField.uint32("aspep.beacon.rx", "Requests, 32 bytes more than", base.DEC, nil, 0x00003F00)
f.tx_sync = ProtoField.uint32("aspep.beacon.tx_sync", "Answers, 32 bytes more than", base.DEC, nil, 0x001FC000)
f.tx_async = ProtoField.uint32("aspep.beacon.tx_async", "Datalog, 64 bytes", base.DEC, nil, 0x0FE00000)
f.configured = ProtoField.uint32("aspep.ping.configured", "Configured", base.DEC, nil, 0x00000030)
f.parity = ProtoField.uint32("aspep.ping.parity", "Packet parity", base.DEC, nil, 0x000000C0)
f.link_id = ProtoField.uint32("aspep.ping.link", "Link", base.DEC, nil, 0x00000F00)
f.number = ProtoField.uint32("aspep.ping.number", "Number", base.DEC, nil, 0x0FFFF000)
f.error = ProtoField.uint32("aspep.nack.error", "Error", base.DEC, nil, 0x0000FF00)
f.payload = ProtoField.bytes("aspep.payload", "Payload")
f.noise = ProtoField.bytes("aspep.noise", "No packet")
f.direction = ProtoField.uint32("aspep.direction", "Direction", base.DEC, { [1] = "from the drive", [2] = "to the drive" })

local crc_table = { [0] = 0x0, 0x7, 0xE, 0x9, 0xB, 0xC, 0x5, 0x2, 0x1, 0x6, 0xF, 0x8, 0xA, 0xD, 0x4, 0x3 }
local function crc4(head)
    local crc = 0
    for shift = 0, 24, 4 do
        crc = crc_table[bit.bxor(crc, bit.band(bit.rshift(head, shift), 0xF))]
    end
    return crc
end

local function is_header(bytes, at)
    if at + 4 > bytes:len() then return false end
    local head = bytes:range(at, 4):le_uint()
    return types[bit.band(head, 0xF)] ~= nil and crc4(bit.band(head, 0x0FFFFFFF)) == bit.rshift(head, 28)
end

-- What the first pass leaves for each frame: the bytes of earlier frames that belong to a packet that ends in it.
local carried = {}   -- by frame
local open = {}      -- by direction: what has not ended yet
local data_crc = {}  -- payloads carry two bytes of CRC; by frame
local beacon_crc = 0

function aspep.init()
    carried, open, data_crc, beacon_crc = {}, {}, {}, 0
end

local direction_field = Field.new("frame.packet_flags_direction")

local NOISE = 0x0

-- One packet of `bytes` at `at`. Returns its type, or NOISE, and where it ends; nothing if its end is not there yet.
local function packet_at(bytes, at, crc)
    if bytes:len() - at < 4 then return nil end
    if not is_header(bytes, at) then return NOISE, at + 1 end
    local head = bytes:range(at, 4):le_uint()
    local kind = bit.band(head, 0xF)
    if kind ~= 0x9 and kind ~= 0xA then return kind, at + 4 end
    local length = bit.rshift(bit.band(head, 0x1FFF0), 4)
    local size = length + (length > 0 and crc or 0)
    if at + 4 + size > bytes:len() then return nil end
    return kind, at + 4 + size
end

local function show_packet(tree, bytes, at, stop, kind, direction)
    local t = tree:add(aspep, bytes:range(at, stop - at))
    local word = bytes:range(at, 4)
    t:set_text("ASPEP " .. name_of(kind, direction))
    t:add_le(f.type, word)
    if kind == 0x5 then
        for _, field in ipairs({ f.version, f.data_crc, f.rx, f.tx_sync, f.tx_async }) do t:add_le(field, word) end
    elseif kind == 0x6 then
        for _, field in ipairs({ f.configured, f.parity, f.link_id, f.number }) do t:add_le(field, word) end
    elseif kind == 0xF then
        t:add_le(f.error, word)
    else
        t:add_le(f.length, word)
    end
    t:add_le(f.crc, word)
    t:add(f.crc_ok, true):set_generated()
    if stop > at + 4 then t:add(f.payload, bytes:range(at + 4, stop - at - 4)) end
end

function aspep.dissector(buffer, pinfo, tree)
    pinfo.cols.protocol = "ASPEP"
    local flags = direction_field()
    local direction = flags and flags.value or 0
    local first = not pinfo.visited
    if first then
        carried[pinfo.number] = open[direction] or ""
        data_crc[pinfo.number] = beacon_crc
    end
    local bytes = buffer
    local before = carried[pinfo.number] or ""
    if #before > 0 then
        bytes = ByteArray.new(before .. buffer:bytes():tohex()):tvb("ASPEP, put together")
    end
    local t = tree:add(aspep, buffer())
    t:add(f.direction, direction):set_generated()
    local names, at, noise = {}, 0, nil
    local crc = data_crc[pinfo.number] or 0
    while at < bytes:len() do
        local kind, stop = packet_at(bytes, at, crc)
        if not kind then break end
        if kind == NOISE then
            noise = noise or at
        else
            if noise then t:add(f.noise, bytes:range(noise, at - noise)) noise = nil end
            show_packet(t, bytes, at, stop, kind, direction)
            if kind == 0x5 then crc = bit.band(bytes:range(at, 1):uint(), 0x80) ~= 0 and 2 or 0 end
            names[#names + 1] = name_of(kind, direction)
        end
        at = stop
    end
    if noise then t:add(f.noise, bytes:range(noise, at - noise)) names[#names + 1] = "noise" end
    if first then
        open[direction] = at < bytes:len() and bytes:range(at):bytes():tohex() or ""
        beacon_crc = crc
    end
    local more = at < bytes:len() and " ..." or ""
    pinfo.cols.info = (direction == 2 and "> " or "< ") .. table.concat(names, ", ") .. more
end

local entries = Proto("rotorscope", "Rotorscope recording")
local kinds = { [0] = "padding", "begin", "layout", "samples", "register", "polled values", "event", "snapshot", "note", "lost", "end", "overview" }
local e = entries.fields
e.kind = ProtoField.uint8("rotorscope.kind", "Kind", base.DEC, kinds)
e.stream = ProtoField.uint32("rotorscope.stream", "Stream")
e.tick = ProtoField.int64("rotorscope.tick", "First tick")
e.lost = ProtoField.int64("rotorscope.lost_ticks", "Lost ticks")
e.count = ProtoField.uint32("rotorscope.count", "Samples a signal")
e.signals = ProtoField.uint16("rotorscope.signals", "Fast signals")
e.text = ProtoField.string("rotorscope.text", "Text")

local function text_at(buffer, at)
    local length = buffer(at, 2):le_uint()
    return buffer(at + 2, length):string(ENC_UTF_8), at + 2 + length
end

function entries.dissector(buffer, pinfo, tree)
    pinfo.cols.protocol = "Rotorscope"
    if buffer:len() < 4 or buffer(0, 2):string() ~= "RS" then return 0 end
    local t = tree:add(entries, buffer())
    local kind = buffer(3, 1):uint()
    t:add(e.kind, buffer(3, 1))
    local info = kinds[kind] or "?"
    if kind == 3 then
        t:add_le(e.stream, buffer(4, 4))
        t:add_le(e.tick, buffer(8, 8))
        t:add_le(e.lost, buffer(16, 8))
        t:add_le(e.count, buffer(24, 4))
        t:add_le(e.signals, buffer(28, 2))
        info = info .. ": " .. buffer(24, 4):le_uint() .. " of " .. buffer(28, 2):le_uint() .. " signals"
    elseif kind == 1 then
        local program = text_at(buffer, 12)
        t:add(e.text, program)
        info = info .. ": " .. program
    elseif kind == 6 then
        local name, at = text_at(buffer, 4)
        local words = { name }
        local count = buffer(at, 2):le_uint()
        at = at + 2
        for _ = 1, count do
            local key, value
            key, at = text_at(buffer, at)
            value, at = text_at(buffer, at)
            words[#words + 1] = key .. "=" .. value
        end
        info = table.concat(words, " ")
        t:add(e.text, info)
    elseif kind == 8 then
        local note = text_at(buffer, 20)
        t:add(e.text, note)
        info = info .. ": " .. note
    end
    pinfo.cols.info = info
end

local encapsulations = DissectorTable.get("wtap_encap")
encapsulations:add(wtap.USER0, aspep)
encapsulations:add(wtap.USER1, entries)
