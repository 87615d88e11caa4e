#!/usr/bin/env python3
"""A client of MCP over ASPEP that shares no line with Rotorscope: connects, reads, starts the motor, records two signals
and stops, in the sequence and with the pauses of ST's own tool. It knows nothing of simulators.

Written from the facts of the protocol (the layout of headers, CRC-4 generator 0x7, commands, register identifiers); see
docs/protocol-notes.md. Prints what it does, one summary line last, and ends with status 0 if all went well.
"""

import argparse
import collections
import os
import select
import socket
import struct
import sys
import termios
import time
import tty

BEACON, PING, DATA, RESPONSE, ERROR = 5, 6, 9, 10, 15
GET, SET, START, STOP = 2, 1, 3, 4
IDLE, RUN = 0, 6
UNKNOWN_REGISTER = 5
CRC4 = (0, 7, 14, 9, 11, 12, 5, 2, 1, 6, 15, 8, 10, 13, 4, 3)
REPLY_S = 0.5  # a datalog packet may be on its way, and the machine may be busy


def register(element, kind, motor=1):
    return element << 6 | {"u8": 1, "u16": 2, "u32": 3, "text": 4, "raw": 5}[kind] << 3 | motor


STATUS, FAULTS = register(1, "u8"), register(0, "u32")
SPEED_MEAS, SPEED_RAMP, DATALOG = register(1, "u32"), register(6, "raw"), register(20, "raw")
IQ_MEAS, ID_MEAS = 0x08D1, 0x0911
DESCRIPTION = {  # what ST's tool reads first
    "GLOBAL_CONFIG": register(0, "raw", 0), "FW_NAME": register(0, "text", 0), "CTRL_STAGE": register(1, "text", 0),
    "MOTOR_CONFIG": register(1, "raw"), "APPLICATION_CONFIG": register(2, "raw"), "FOCFW_CONFIG": register(3, "raw"),
    "PWR_STAGE": register(2, "text"), "MOTOR_NAME": register(3, "text"), "SCALE_CONFIG": register(4, "raw"),
}


class Trouble(Exception):
    pass


def header(bits):
    """Four bytes of a header whose bits 0 to 27 are given."""
    crc = 0
    for shift in range(0, 28, 4):
        crc = CRC4[crc ^ (bits >> shift & 15)]
    return struct.pack("<I", bits | crc << 28)


def crc_holds(word):
    crc = 0
    for shift in range(0, 32, 4):
        crc = CRC4[crc ^ (word >> shift & 15)]
    return crc == 0


class Line:
    """The serial port: whole packets in, whole packets out, and the pause in front of a payload."""

    def __init__(self, device, pause_s):
        self.is_serial = not device.startswith("tcp:")
        if self.is_serial:
            self.file = os.open(device, os.O_RDWR | os.O_NOCTTY)
            tty.setraw(self.file, termios.TCSANOW)
        else:
            host, port = device[4:].split(":")
            self.socket = socket.create_connection((host, int(port)))
            self.socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.file = self.socket.fileno()
        self.pause_s = pause_s
        self.buffer = bytearray()

    def pause(self, seconds):
        end = time.monotonic() + seconds
        while (left := end - time.monotonic()) > 0:
            select.select([], [], [], left)

    def send(self, head, payload=b""):
        os.write(self.file, head)
        if payload:
            if self.is_serial:
                termios.tcdrain(self.file)
            self.pause(self.pause_s)
            os.write(self.file, payload)

    def fill(self, until):
        left = until - time.monotonic()
        if left <= 0 or not select.select([self.file], [], [], left)[0]:
            return False
        self.buffer += os.read(self.file, 65536)
        return True

    def packet(self, until):
        """(word, payload), or None when the time is over or where a header should be there is none."""
        while len(self.buffer) < 4:
            if not self.fill(until):
                return None
        word = struct.unpack_from("<I", self.buffer)[0]
        if not crc_holds(word):
            return None
        size = word >> 4 & 0x1FFF if word & 15 in (DATA, RESPONSE) else 0
        while len(self.buffer) < 4 + size:
            if not self.fill(until):
                return None
        payload = bytes(self.buffer[4:4 + size])
        del self.buffer[:4 + size]
        return word, payload

    def skip_behind(self, packet, until):
        """Whether it came. One in eighty places among samples looks like a header, none like a known BEACON."""
        while packet not in self.buffer:
            if not self.fill(until):
                return False
        del self.buffer[:self.buffer.index(packet) + len(packet)]
        return True


class Client:
    def __init__(self, line):
        self.line = line
        self.counts = collections.Counter()
        self.records = []  # payloads of datalog packets

    def heard(self, kind, until):
        """The next packet of that kind; datalog packets are kept on the way."""
        while (packet := self.line.packet(until)) is not None:
            word, payload = packet
            if word & 15 == DATA:
                self.records.append(payload)
            elif word & 15 == kind:
                return packet
            elif word & 15 == ERROR:
                self.counts["errors"] += 1
                return None
        return None

    def exchange(self, head, kind):
        self.line.send(head)
        packet = self.heard(kind, time.monotonic() + REPLY_S)
        return packet[0] if packet else None

    def connect(self):
        """Everything at its largest, then what the board can, then a PING."""
        widest = struct.unpack("<I", header(0x0FFFFF85))[0] & 0x0FFFFFFF
        for _ in range(10):
            self.line.buffer.clear()
            offer = self.exchange(header(widest), BEACON)
            if offer is None:
                continue
            if self.exchange(header(offer & 0x0FFFFFFF), BEACON) != offer:
                continue
            reply = self.exchange(header(PING), PING)
            if reply is not None and reply >> 4 & 3 == 3:
                self.agreed = offer
                return {"request": ((offer >> 8 & 63) + 1) * 32, "response": ((offer >> 14 & 127) + 1) * 32,
                        "datalog": (offer >> 21 & 127) * 64}
        raise Trouble("the board does not connect")

    def again(self):
        """After a lost packet: the agreed BEACON until it is echoed, then PING."""
        self.counts["recoveries"] += 1
        beacon = struct.pack("<I", self.agreed)
        for _ in range(10):
            self.line.send(beacon)
            if self.line.skip_behind(beacon, time.monotonic() + REPLY_S):
                reply = self.exchange(header(PING), PING)
                if reply is not None and reply >> 4 & 3 == 3:
                    return
        raise Trouble("the board does not come back")

    def request(self, command, content=b"", motor=0, repeat=True):
        """The response's payload without its status byte, and that byte."""
        payload = struct.pack("<H", command << 3 | motor) + content
        for _ in range(4):
            self.line.send(header(len(payload) << 4 | DATA), payload)
            packet = self.heard(RESPONSE, time.monotonic() + REPLY_S)
            if packet:
                self.counts["requests"] += 1
                return packet[1][:-1], packet[1][-1]
            self.again()
            if not repeat:
                return b"", None
        raise Trouble("four requests without an answer")

    def get(self, *ids):
        values, status = self.request(GET, b"".join(struct.pack("<H", one) for one in ids))
        if status != 0:
            raise Trouble(f"reading {[hex(one) for one in ids]}: status {status}")
        return values

    def set_raw(self, one, content):
        _, status = self.request(SET, struct.pack("<HH", one, len(content)) + content)
        return status

    def wait_for(self, state, seconds):
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            if self.get(STATUS)[0] == state:
                return
        faults = struct.unpack("<I", self.get(FAULTS))[0]
        raise Trouble(f"not in state {state} after {seconds} s; faults {faults:08x}")


def describe(client):
    for name, one in DESCRIPTION.items():
        value, status = client.request(GET, struct.pack("<H", one))
        if status == UNKNOWN_REGISTER:
            print(f"{name}: not in this build")
        elif status != 0:
            raise Trouble(f"reading {name}: status {status}")
        elif one >> 3 & 7 == 4:
            print(f"{name}: {value.rstrip(bytes(1)).decode('latin-1')!r}")
        else:
            print(f"{name}: {len(value) - 2} bytes")
    version = client.get(DESCRIPTION["GLOBAL_CONFIG"])[2:6]
    print(f"SDK version {version[3]}.{version[2]}.{version[1]}")


def datalog(buffer_size, rate, ids, mark):
    return struct.pack("<HBBBB", buffer_size, rate, len(ids), 255, 0) + struct.pack(f"<{len(ids)}H", *ids) + bytes([mark])


def record(client, size, seconds):
    """Two signals at every control period; how many samples came, and how many were lost between packets."""
    if client.set_raw(DATALOG, datalog(size, 0, [IQ_MEAS, ID_MEAS], 1)) != 0:
        raise Trouble("the datalog was refused")
    client.records.clear()
    end = time.monotonic() + seconds
    while time.monotonic() < end:
        client.get(SPEED_MEAS)
    client.set_raw(DATALOG, datalog(size, 0, [], 0))
    samples, lost, torn, expected, total = 0, 0, 0, None, 0
    for payload in client.records:
        if payload[-2:] != b"\x01\x00" or (len(payload) - 6) % 4:
            torn += 1  # the line lost some of it; then the next header was lost, too
            if torn > client.counts["recoveries"]:
                raise Trouble(f"a datalog packet of another form, {len(payload)} bytes")
            continue
        stamp, blocks = struct.unpack_from("<I", payload)[0], (len(payload) - 6) // 4
        if expected is not None:
            lost += stamp - expected & 0xFFFFFFFF
        expected = stamp + blocks & 0xFFFFFFFF
        samples += blocks
        total += sum(struct.unpack_from(f"<{2 * blocks}h", payload, 4)[::2])
    return samples, lost, total / max(samples, 1)


def run(client, options):
    print("connected:", client.connect())
    if client.set_raw(DATALOG, datalog(2048, 0, [], 0)) is None:
        raise Trouble("the datalog cannot be stopped")
    describe(client)
    try:
        start(client)
        return drive(client, options)
    finally:
        client.request(STOP, motor=1)
        client.wait_for(IDLE, 20)


def start(client):
    """Again where nothing came of it: a lost START must not be sent twice, but a motor at rest has not had it."""
    for _ in range(4):
        _, status = client.request(START, motor=1, repeat=False)
        print("START:", status)
        if status is not None or client.get(STATUS)[0] != IDLE:
            return


def drive(client, options):
    client.wait_for(RUN, 10)
    if client.set_raw(SPEED_RAMP, struct.pack("<iH", options.speed, 500)) != 0:
        raise Trouble("the ramp was refused")
    client.line.pause(1.0)
    samples, lost, mean = record(client, 2048, options.seconds)
    speed = struct.unpack("<i", client.get(SPEED_MEAS))[0]
    if abs(speed - options.speed) > 0.05 * options.speed:
        raise Trouble(f"{speed} rpm instead of {options.speed}")
    if samples == 0:
        raise Trouble("no sample came")
    return (f"{client.counts['requests']} requests, {client.counts['recoveries']} recoveries, {samples} samples, "
            f"{lost} lost, mean Iq {mean:.0f} digits at {speed} rpm")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("device", help="a serial port, or tcp:HOST:PORT")
    parser.add_argument("--speed", type=int, default=1800, help="rpm")
    parser.add_argument("--seconds", type=float, default=1.0, help="how long the datalog runs")
    parser.add_argument("--pause", type=float, default=1.5, help="ms between header and payload")
    options = parser.parse_args()
    try:
        print("client:", run(Client(Line(options.device, options.pause / 1000)), options))
    except Trouble as trouble:
        sys.exit(f"client: {trouble}")


if __name__ == "__main__":
    main()
