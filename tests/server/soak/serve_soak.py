#!/usr/bin/env python3
"""Lets a fake tractor drive for a while before `tramline serve`, with readers, and looks at the server's memory.

Usage: serve_soak.py --tramline PROGRAM [--seconds N] [--hertz N] [--readers N]

Fails where the server's memory grows by more than the fixes themselves take, where a reader misses a fix, where
frames come late, or where the drive that is kept is not what the readers saw.
"""

import argparse
import http.client
import json
import math
import pathlib
import re
import socket
import subprocess
import sys
import tempfile
import threading
import time
import urllib.parse
import urllib.request

LON, LAT = 10.5, 52.3
METRES_PER_DEGREE = 111_320.0
WIDTH_M, SPEED_MPS, LANE_M = 6.0, 3.0, 400.0
# A fix is kept twice, as it came and as it was understood, in lists that double when they are full: all that may
# grow once the coverage file has been saved for the first time, which takes the most.
BYTES_PER_FIX = 600
SLACK_KB = 4_000


def place(second):
    """Up and down on lanes that are a little too far apart, with every tenth on the one before."""
    way_m = second * SPEED_MPS
    lane, along = int(way_m // LANE_M), way_m % LANE_M
    x = along if lane % 2 == 0 else LANE_M - along
    y = (WIDTH_M + 0.3) * (lane - lane // 10)
    return LON + x / METRES_PER_DEGREE / math.cos(math.radians(LAT)), LAT + y / METRES_PER_DEGREE


def resident_kb(pid):
    status = pathlib.Path(f"/proc/{pid}/status").read_text()
    return int(re.search(r"VmRSS:\s+(\d+)", status).group(1))


class Tractor(threading.Thread):
    def __init__(self, seconds, hertz):
        super().__init__(daemon=True)
        self.listening = socket.create_server(("127.0.0.1", 0))
        self.port = self.listening.getsockname()[1]
        self.seconds, self.hertz, self.sent = seconds, hertz, []
        self.go = threading.Event()

    def run(self):
        line, _ = self.listening.accept()
        line.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
        line.sendall(b"time,lon,lat,width\n")
        self.go.wait()
        start = time.monotonic()
        for i in range(self.seconds * self.hertz):
            due = start + i / self.hertz
            time.sleep(max(0.0, due - time.monotonic()))
            lon, lat = place(i / self.hertz)
            self.sent.append(time.monotonic())
            line.sendall(f"{1_770_000_000 + i / self.hertz:.3f},{lon:.9f},{lat:.9f},{WIDTH_M}\n".encode())
        self.line = line


def slow_link(address):
    """A connection that holds little of what is not read yet."""
    link = socket.socket(socket.AF_INET6 if ":" in address[0] else socket.AF_INET)
    link.setsockopt(socket.SOL_SOCKET, socket.SO_RCVBUF, 4096)
    link.settimeout(60)
    link.connect(address)
    return link


class Reader(threading.Thread):
    def __init__(self, url, pause_s, tractor):
        super().__init__(daemon=True)
        self.url, self.pause_s, self.tractor = url, pause_s, tractor
        self.frames = self.fixes = self.bytes = 0
        self.late_s, self.end = [], None

    def connected(self):
        place = urllib.parse.urlparse(self.url)
        connection = http.client.HTTPConnection(place.hostname, place.port, timeout=60)
        if self.pause_s > 0:
            connection.sock = slow_link((place.hostname, place.port))
        connection.request("GET", place.path)
        return connection.getresponse()

    def run(self):
        with self.connected() as stream:
            event = ""
            for raw in stream:
                self.bytes += len(raw)
                text = raw.decode()
                if text.startswith("event: "):
                    event = text[7:].strip()
                elif text.startswith("data: ") and event == "end":
                    self.end = json.loads(text[6:])["figures"]
                    return
                elif text.startswith("data: ") and event == "frame":
                    now, fix = time.monotonic(), json.loads(text[6:])["fix"]
                    # The oldest fix of the frame has waited longest.
                    if fix > self.fixes and self.fixes < len(self.tractor.sent):
                        self.late_s.append(now - self.tractor.sent[self.fixes])
                    self.fixes, self.frames = fix, self.frames + 1
                    time.sleep(self.pause_s)


def call(address, method, path, body=None):
    request = urllib.request.Request(address + "api/v1" + path, method=method,
                                     data=None if body is None else json.dumps(body).encode(),
                                     headers={"Content-Type": "application/json"})
    with urllib.request.urlopen(request, timeout=120) as answer:
        return json.loads(answer.read())


def soak(options, folder):
    server = subprocess.Popen([options.tramline, "serve", folder, "--port", "0"], stdout=subprocess.PIPE, text=True)
    try:
        address = re.search(r"http://\S+/", server.stdout.readline()).group(0)
        tractor = Tractor(options.seconds, options.hertz)
        tractor.start()
        feed = call(address, "POST", "/feeds", {"source": f"tcp://127.0.0.1:{tractor.port}"})["id"]
        readers = [Reader(f"{address}api/v1/feeds/{feed}/events", 0.5 if i == 1 else 0.0, tractor)
                   for i in range(options.readers)]
        for reader in readers:
            reader.start()
        tractor.go.set()
        memory_kb = []
        begin = time.monotonic()
        while tractor.is_alive():
            tractor.join(1)
            memory_kb.append((time.monotonic() - begin, resident_kb(server.pid)))
        # What was sent last may still be under way.
        patience_ends = time.monotonic() + 60
        while call(address, "GET", f"/feeds/{feed}")["fixes"] < len(tractor.sent) and time.monotonic() < patience_ends:
            time.sleep(0.05)
        drive = call(address, "DELETE", f"/feeds/{feed}")["drive"]
        for reader in readers:
            reader.join(30)
        kept = call(address, "GET", f"/drives/{drive}")
        return memory_kb, readers, kept
    finally:
        server.terminate()
        server.wait(30)


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--seconds", type=int, default=600)
    parser.add_argument("--hertz", type=int, default=50)
    parser.add_argument("--readers", type=int, default=3)
    options = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        memory_kb, readers, kept = soak(options, folder)

    fixes = options.seconds * options.hertz
    first, middle, last = memory_kb[min(9, len(memory_kb) - 1)], memory_kb[len(memory_kb) // 2], memory_kb[-1]
    print(f"{fixes} fixes at {options.hertz} Hz, {len(readers)} readers (the second one slow)")
    print("memory: " + ", ".join(f"{kb / 1024:.1f} MB after {at:.0f} s" for at, kb in (first, middle, last)))
    faults = []
    growth_kb = last[1] - middle[1]
    allowed_kb = SLACK_KB + BYTES_PER_FIX * fixes / 2 / 1024
    print(f"growth over the second half: {growth_kb / 1024:.1f} MB, {2 * growth_kb * 1024 / fixes:.0f} bytes a fix")
    if growth_kb > allowed_kb:
        faults.append(f"memory grew by {growth_kb} kB in the second half, more than {allowed_kb:.0f}")
    for i, reader in enumerate(readers):
        late = sorted(reader.late_s)
        print(f"reader {i + 1}: {reader.frames} frames, {reader.bytes / 1e6:.1f} MB; oldest fix of a frame behind: median "
              f"{1e3 * late[len(late) // 2]:.0f} ms, 99 % {1e3 * late[len(late) * 99 // 100]:.0f} ms, most {1e3 * late[-1]:.0f} ms")
        if reader.fixes != fixes or reader.end is None:
            faults.append(f"reader {i + 1} saw {reader.fixes} of {fixes} fixes, end: {reader.end is not None}")
        elif abs(reader.end["covered_m2"] - kept["summary"]["covered_m2"]) > 1e-3:
            faults.append(f"reader {i + 1} ends with {reader.end['covered_m2']} m²")
        # The slow one waits for itself, and for what is on its way to it.
        if i == 1 and late and late[len(late) * 9 // 10] > 20:
            faults.append(f"the slow reader is {late[len(late) * 9 // 10]:.1f} s behind")
        if i != 1 and late[len(late) * 9 // 10] > 0.1:
            faults.append(f"reader {i + 1} is {late[len(late) * 9 // 10]:.3f} s behind")
    if kept["fixes"] != fixes:
        faults.append(f"the drive has {kept['fixes']} fixes")
    for fault in faults:
        print("FAULT:", fault)
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
