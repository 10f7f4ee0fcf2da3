#!/usr/bin/env python3
"""Kills `tramline serve` at random moments while it stores fields, machines, plans, drives and a live feed, starts it
again on the same folder, and looks for all that was answered with success.

Usage: serve_kills.py --tramline PROGRAM [--kills N] [--seed N]

Fails where something that was answered is lost or not what was answered, where something that was deleted is back,
where anything that is listed cannot be read whole (by SQLite, by GDAL and over HTTP), and where a file is left over.
"""

import argparse
import http.client
import json
import pathlib
import random
import re
import signal
import socket
import sqlite3
import subprocess
import sys
import tempfile
import threading
import time

LON, LAT = 9.0, 50.0
DEGREE_M = 111_320.0
MACHINE = {"name": "drill", "width_m": 6, "radius_m": 6}
KINDS = ("fields", "machines", "plans", "drives")
# On a busy machine nothing of some kind may be done before the server is killed. Then there are more kills, up to so
# many times as many, each after more time.
MOST_TIMES = 3


class Killed(Exception):
    """The server went before it had answered."""


class Refused(Exception):
    """The server answered, but not with success."""


def start(program, folder):
    process = subprocess.Popen([program, "serve", str(folder), "--port", "0"], stdout=subprocess.PIPE,
                               stderr=subprocess.PIPE, text=True)
    return Server(process, process.stdout.readline())


class Server:
    def __init__(self, process, said):
        self.process = process
        found = re.search(r"http://127\.0\.0\.1:(\d+)/", said)
        if not found:
            raise SystemExit(f"the server does not start again: {said} {self.process.stderr.read()}")
        self.port = int(found.group(1))

    def call(self, method, path, body=None):
        """The answer; raises Killed where there is none that is whole."""
        connection = http.client.HTTPConnection("127.0.0.1", self.port, timeout=60)
        try:
            data = body if isinstance(body, bytes) or body is None else json.dumps(body).encode()
            connection.request(method, "/api/v1" + path, data)
            answer = connection.getresponse()
            got = answer.read()
        except (OSError, http.client.HTTPException) as fault:
            raise Killed from fault
        finally:
            connection.close()
        if answer.status >= 400:
            raise Refused(f"{method} {path}: {answer.status} {got.decode()}")
        return json.loads(got) if answer.getheader("Content-Type") == "application/json" else got

    def described(self, kind, ident):
        """All that is said of an object but for how long the evaluation took."""
        out = self.call("GET", f"/{kind}/{ident}")
        out.get("summary", {}).pop("seconds", None)
        return out

    def end_of(self, job):
        while job["state"] in ("queued", "running"):
            time.sleep(0.005)
            job = self.call("GET", f"/jobs/{job['id']}")
        if job["state"] != "done":
            raise Refused(str(job))
        return job["result"]

    def end(self, how):
        self.process.send_signal(how)
        self.process.stdout.close()
        errors = self.process.stderr.read()
        self.process.stderr.close()
        self.process.wait(60)
        return errors


class Ledger:
    """What has been answered: for each object all the states it may be in. None: it is not there."""

    def __init__(self):
        self.lock = threading.Lock()
        self.states = {kind: {} for kind in KINDS}
        self.feeds = {}  # fixes that the server has told of

    def set(self, kind, ident, *states):
        with self.lock:
            self.states[kind][ident] = states

    def some(self, kind, chance):
        """Any that is there."""
        with self.lock:
            there = sorted(ident for ident, states in self.states[kind].items() if None not in states)
        return chance.choice(there) if there else None


def square(chance):
    west, south = LON + chance.random() * 0.01, LAT + chance.random() * 0.01
    east, north = west + 0.0012, south + 0.0008
    return {"type": "Polygon",
            "coordinates": [[[west, south], [east, south], [east, north], [west, north], [west, south]]]}


def log_of(chance):
    lines = ["time,lon,lat,width"]
    west, south = LON + chance.random() * 0.01, LAT + chance.random() * 0.01
    for i in range(chance.randrange(40, 200)):
        lines.append(f"{1_770_000_000 + i},{west + 2.0 * (i % 50) / DEGREE_M:.9f},"
                     f"{south + 5.5 * (i // 50) / DEGREE_M:.9f},6")
    return ("\n".join(lines) + "\n").encode()


class Worker(threading.Thread):
    """Does one thing after another until the server is gone."""

    def __init__(self, server, ledger, number, seed):
        super().__init__(daemon=True)
        self.server, self.ledger, self.number = server, ledger, number
        self.chance = random.Random(seed)
        self.done, self.fault = 0, None

    def run(self):
        acts = [[self.new_field, self.rename_field, self.delete("fields")], [self.new_machine, self.delete("machines")],
                [self.new_plan, self.new_plan, self.rename_plan, self.delete("plans")],
                [self.new_drive, self.new_drive, self.evaluate_again, self.delete("drives")]][self.number]
        try:
            while True:
                (acts[0] if self.done == 0 else self.chance.choice(acts))()
                self.done += 1
        except Killed:
            pass
        except Exception as fault:  # pylint: disable=broad-except
            self.fault = f"{type(fault).__name__}: {fault}"

    def name(self):
        return f"name {self.chance.randrange(10**9)}"

    def told(self, kind, ident):
        self.ledger.set(kind, ident, self.server.described(kind, ident))

    def new_field(self):
        made = self.server.call("POST", "/fields", {"name": self.name(), "geometry": square(self.chance)})
        self.told_or_named("fields", made["id"], made)

    def told_or_named(self, kind, ident, made):
        """There from the moment it is answered, whether there is time to ask for it or not."""
        self.ledger.set(kind, ident, {"id": ident, "name": made.get("name")})
        self.told(kind, ident)

    def rename(self, kind):
        ident = self.ledger.some(kind, self.chance)
        if ident is None:
            return
        old = self.server.described(kind, ident)
        new = {**old, "name": self.name()}
        self.ledger.set(kind, ident, old, new)
        self.server.call("PATCH", f"/{kind}/{ident}", {"name": new["name"]})
        self.ledger.set(kind, ident, new)

    def rename_field(self):
        self.rename("fields")

    def rename_plan(self):
        self.rename("plans")

    def new_machine(self):
        machine = {**MACHINE, "name": self.name(), "width_m": self.chance.randrange(1, 40), "min_length_m": 7}
        made = self.server.call("POST", "/machines", machine)
        self.ledger.set("machines", made["id"], made)
        if self.chance.random() < 0.5:
            new = {**made, "name": self.name()}
            self.ledger.set("machines", made["id"], made, new)
            self.server.call("PUT", f"/machines/{made['id']}", {k: v for k, v in new.items() if k != "id"})
            self.ledger.set("machines", made["id"], new)

    def new_plan(self):
        field = self.server.call("POST", "/fields", {"name": self.name(), "geometry": square(self.chance)})
        self.ledger.set("fields", field["id"], {"id": field["id"], "name": field["name"]})
        job = self.server.call("POST", "/jobs", {"kind": "plan", "field": field["id"], "machine": MACHINE,
                                                 "objective": {"minimise": "overlap"}})
        ident = self.server.end_of(job)["plan"]
        self.told_or_named("plans", ident, {"name": field["name"]})

    def new_drive(self):
        sent = self.server.call("POST", "/uploads?name=drive.csv", log_of(self.chance))
        name = self.name()
        job = self.server.call("POST", "/drives", {"upload": sent["id"], "name": name})
        self.told_or_named("drives", self.server.end_of(job)["drive"], {"name": name})

    def evaluate_again(self):
        """On the same ground it gives the same."""
        ident = self.ledger.some("drives", self.chance)
        if ident is not None:
            self.server.end_of(self.server.call("POST", "/jobs", {"kind": "evaluate", "drive": ident}))

    def delete(self, kind):
        def act():
            ident = self.ledger.some(kind, self.chance)
            if ident is None or self.chance.random() < 0.5:
                return
            with self.ledger.lock:
                states = self.ledger.states[kind][ident]
            self.ledger.set(kind, ident, None, *states)
            self.server.call("DELETE", f"/{kind}/{ident}")
            self.ledger.set(kind, ident, None)
        return act


class Tractor(threading.Thread):
    """Sends a fix every 5 ms to whoever calls, and asks the server how many it has."""

    def __init__(self, server, ledger):
        super().__init__(daemon=True)
        self.server, self.ledger, self.fault = server, ledger, None
        self.listening = socket.create_server(("127.0.0.1", 0))

    def send(self):
        line, _ = self.listening.accept()
        with line:
            try:
                line.sendall(b"time,lon,lat,width\n")
                for i in range(10**6):
                    line.sendall(f"{1_770_000_000 + i},{LON + 2.0 * i / DEGREE_M:.9f},{LAT},6\n".encode())
                    time.sleep(0.005)
            except OSError:
                pass  # the server is gone

    def run(self):
        threading.Thread(target=self.send, daemon=True).start()
        try:
            feed = self.server.call("POST", "/feeds",
                                    {"source": f"tcp://127.0.0.1:{self.listening.getsockname()[1]}"})["id"]
            while True:
                self.ledger.feeds[feed] = self.server.call("GET", f"/feeds/{feed}")["fixes"]
                time.sleep(0.01)
        except Killed:
            pass
        except Exception as fault:  # pylint: disable=broad-except
            self.fault = f"{type(fault).__name__}: {fault}"
        finally:
            self.listening.close()


def fits(got, wanted):
    """Where there was no time to ask for all of it, what is known of it."""
    return all(got.get(key) == value for key, value in wanted.items())


class Check:
    def __init__(self, server, folder, ledger, read):
        self.server, self.folder, self.ledger, self.read = server, folder, ledger, read
        self.faults, self.single = [], set()
        self.listed = {kind: {item["id"]: item for item in server.call("GET", f"/{kind}")} for kind in KINDS}

    def answered(self):
        """All that was answered is there, as it was answered; and only that is settled from now on."""
        for kind in KINDS:
            for ident, states in list(self.ledger.states[kind].items()):
                if ident not in self.listed[kind]:
                    if None not in states:
                        self.faults.append(f"{kind}/{ident} is lost")
                    self.ledger.set(kind, ident, None)
                    continue
                got = self.of(kind, ident)
                if not any(state is not None and fits(got, state) for state in states):
                    self.faults.append(f"{kind}/{ident} is back or not as it was answered:\n  {got}\n  {states}")
                self.ledger.set(kind, ident, got)
            # Those that were stored, but killed before they were answered.
            for ident in self.listed[kind]:
                if ident not in self.ledger.states[kind]:
                    self.ledger.set(kind, ident, self.of(kind, ident))

    def of(self, kind, ident):
        return self.listed[kind][ident] if kind == "machines" else self.server.described(kind, ident)

    def whole(self):
        """Every file that is new since it was last looked at."""
        files = [(kind, self.folder / kind / f"{ident}.gpkg") for kind in KINDS if kind != "machines"
                 for ident in self.listed[kind]]
        files.append(("machines", self.folder / "machines.gpkg"))
        for kind, file in files:
            if kind == "machines" and not file.exists() and not self.listed[kind]:
                continue
            state = file.stat()
            if self.read.get(file) == (state.st_ino, state.st_mtime_ns):
                continue
            self.read[file] = (state.st_ino, state.st_mtime_ns)
            with sqlite3.connect(f"file:{file}?mode=ro", uri=True) as database:
                if database.execute("PRAGMA integrity_check").fetchall() != [("ok",)]:
                    self.faults.append(f"{file} is no whole database")
            database.close()
            seen = subprocess.run(["ogrinfo", "-ro", "-al", "-q", str(file)], capture_output=True, text=True,
                                  check=False)
            if seen.returncode != 0 or "ERROR" in seen.stderr or not seen.stdout:
                self.faults.append(f"GDAL cannot read {file}: {seen.stderr}")
            self.over_http(kind, file.stem)

    def over_http(self, kind, ident):
        paths = {"plans": ["layers/tracks", "files/gpkg"], "drives": ["layers/covered", "files/log", "files/gpkg"]}
        for path in paths.get(kind, []):
            try:
                self.server.call("GET", f"/{kind}/{ident}/{path}")
            except Refused as fault:
                self.faults.append(str(fault))

    def nothing_left_over(self):
        wanted = {"machines.gpkg", ".lock"}
        for kind in ("fields", "plans"):
            wanted |= {f"{kind}/{ident}.gpkg" for ident in self.listed[kind]}
        for ident in self.listed["drives"]:
            # Logs of feeds have the extension of feeds.
            wanted |= {f"drives/{ident}{extension}" for extension in (".gpkg", ".json", ".csv", ".log")}
        for entry in self.folder.rglob("*"):
            name = str(entry.relative_to(self.folder))
            if entry.is_file() and name not in wanted and not (self.single and name.startswith("feeds/")):
                self.faults.append(f"{name} is left over")

    def feeds(self):
        """Each has become a drive with every fix the server had told of."""
        end = time.monotonic() + 60
        while any(job["state"] in ("queued", "running") for job in self.server.call("GET", "/jobs")):
            if time.monotonic() > end:
                self.faults.append("feeds are not taken up")
                return
            time.sleep(0.01)
        # A single place is no drive; its log stays where it is.
        self.single = {job["id"] for job in self.server.call("GET", "/jobs")
                       if "at least two are needed" in str(job["error"])}
        self.faults += [f"{job}" for job in self.server.call("GET", "/jobs")
                        if job["state"] != "done" and job["id"] not in self.single]
        self.listed["drives"] = {item["id"]: item for item in self.server.call("GET", "/drives")}
        for feed, fixes in self.ledger.feeds.items():
            drive = self.listed["drives"].get(feed)
            if fixes >= 2 and (drive is None or drive["fixes"] < fixes):
                self.faults.append(f"of the feed {feed} with {fixes} fixes there is {drive}")
        self.ledger.feeds.clear()


def start_two(program, folder):
    """At the same moment on the same folder: one of them gets it, the other one says so."""
    two = [subprocess.Popen([program, "serve", str(folder), "--port", "0"], stdout=subprocess.PIPE,
                            stderr=subprocess.PIPE, text=True) for _ in range(2)]
    said = [(process, process.stdout.readline()) for process in two]
    running = [(process, line) for process, line in said if line]
    for process, line in said:
        if line:
            continue
        errors = process.communicate(timeout=60)[1]
        if process.returncode != 2 or "another tramline server" not in errors:
            raise SystemExit(f"the second server ends with {process.returncode}: {errors}")
    if len(running) != 1:
        raise SystemExit(f"{len(running)} servers run on one folder")
    return Server(*running[0])


def rounds(options, folder):
    ledger, read, seed = Ledger(), {}, random.Random(options.seed)
    counts = dict.fromkeys(KINDS, 0)
    server = start(options.tramline, folder)
    for number in range(MOST_TIMES * options.kills):
        extra = max(0, number + 1 - options.kills)
        if extra > 0 and min(counts.values()) > 0:
            break
        workers = [Worker(server, ledger, i, seed.random()) for i in range(4)]
        # Feeds take a while to be taken up: in every third round.
        if number % 3 == 0:
            workers.append(Tractor(server, ledger))
        for worker in workers:
            worker.start()
        time.sleep(seed.uniform(0.02, 0.4) + 0.5 * extra)
        errors = server.end(signal.SIGKILL)
        for worker in workers:
            worker.join(60)
        faults = [worker.fault for worker in workers if worker.fault]
        if errors:
            faults.append(f"the server says: {errors}")

        server = start_two(options.tramline, folder) if number % 5 == 4 else start(options.tramline, folder)
        check = Check(server, folder, ledger, read)
        check.feeds()
        check.answered()
        check.whole()
        check.nothing_left_over()
        faults += check.faults
        for kind in KINDS:
            counts[kind] = max(counts[kind], len(check.listed[kind]))
        if faults:
            server.end(signal.SIGKILL)
            return f"after kill {number + 1}", faults, counts
    errors = server.end(signal.SIGTERM)
    return "at the end", [f"the server says: {errors}"] if errors else [], counts


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--tramline", required=True)
    parser.add_argument("--kills", type=int, default=20)
    parser.add_argument("--seed", type=int, default=random.SystemRandom().randrange(10**6))
    options = parser.parse_args()
    begin = time.monotonic()
    with tempfile.TemporaryDirectory() as folder:
        when, faults, counts = rounds(options, pathlib.Path(folder))
    print(f"killed and started again for {time.monotonic() - begin:.1f} s, seed {options.seed}; kept at most "
          + ", ".join(f"{count} {kind}" for kind, count in counts.items()))
    for fault in faults:
        print("FAULT", when + ":", fault)
    if not faults and min(counts.values()) == 0:
        print("FAULT: nothing was kept of some kind, so that nothing was tested:", counts)
        faults.append("")
    sys.exit(1 if faults else 0)


if __name__ == "__main__":
    main()
