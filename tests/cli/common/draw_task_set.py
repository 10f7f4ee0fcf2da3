#!/usr/bin/env python3
"""Draws an ISOXML task set: three time logs of a cultivator on two fields, into the folder given.

Disks of 10 m and a crumbler of 10 m behind them. Field PFD1 is 100 m by 60 m and worked on two days that
follow one another, three passes each; PFD2, 0.05 degrees further east and 40 m by 30 m, is worked three weeks
later in three passes. The machine counts the area of each pass, and begins the second day with 500 m2 on its
counter; on PFD2 it counts twice what it worked.
"""

import pathlib
import struct
import sys

M_PER_DEG_LAT = 111250.0
M_PER_DEG_LON = 68700.0  # at 52 degrees north, about
LAT = 52.0

HEADER = """<?xml version="1.0" encoding="UTF-8"?>
<TIM A="" D="4"><PTN A="" B="" D=""/><DLV A="008D" B="" C="DET-1"/><DLV A="0074" B="" C="DET-1"/></TIM>
"""

DEVICE = """<DVC A="DVC-1" B="Cultivator" C="1"><DET A="DET-1" B="1" C="1" D="whole" E="0" F="0"/>
<DET A="DET-2" B="2" C="4" D="disks" E="1" F="1"><DOR A="10"/><DOR A="11"/><DOR A="12"/></DET>
<DET A="DET-3" B="3" C="4" D="crumbler" E="2" F="1"><DOR A="10"/><DOR A="11"/><DOR A="13"/></DET>
<DPT A="10" B="0043" C="10000" D="width"/><DPT A="11" B="0087" C="0" D="across"/>
<DPT A="12" B="0086" C="-2000" D="along"/><DPT A="13" B="0086" C="-4000" D="along"/></DVC>
"""


def partfield(name, lon, width, height):
    east, north = lon + width / M_PER_DEG_LON, LAT + height / M_PER_DEG_LAT
    ring = [(lon, LAT), (east, LAT), (east, north), (lon, north), (lon, LAT)]
    points = "".join(f'<PNT A="2" C="{y:.9f}" D="{x:.9f}"/>' for x, y in ring)
    return f'<PFD A="{name}" C="{name}" D="0"><PLN A="1"><LSG A="1">{points}</LSG></PLN></PFD>\n'


def records(day, lon, length, first_pass, passes, counter, factor):
    out = b""
    ms = 8 * 3600 * 1000
    for k in range(first_pass, first_pass + passes):
        xs = [2.0 * i for i in range(int(length / 2) + 1)]
        if k % 2:
            xs.reverse()
        for i, x in enumerate(xs):
            if i:
                counter += factor * 20
            y = 5 + 10 * k
            values = ((0, 1 if i + 1 < len(xs) else 0), (1, int(counter)))
            out += struct.pack("<IHiiB", ms, day, round((LAT + y / M_PER_DEG_LAT) * 1e7),
                               round((lon + x / M_PER_DEG_LON) * 1e7), 4)
            out += struct.pack("<B", len(values)) + b"".join(struct.pack("<Bi", *v) for v in values)
            ms += 1000
        ms += 20000  # to turn
    return out


def main():
    folder = pathlib.Path(sys.argv[1])
    folder.mkdir(parents=True, exist_ok=True)
    tasks = ('<TSK A="TSK1" B="stubble" E="PFD1" G="4"><TLG A="TLG00001" C="1"/><TLG A="TLG00002" C="1"/></TSK>\n'
             '<TSK A="TSK2" B="seedbed" E="PFD2" G="4"><TLG A="TLG00003" C="1"/></TSK>\n')
    (folder / "TASKDATA.XML").write_text(
        '<?xml version="1.0" encoding="UTF-8"?>\n<ISO11783_TaskData VersionMajor="4" VersionMinor="3">\n' +
        partfield("PFD1", 10.0, 100, 60) + partfield("PFD2", 10.05, 40, 30) + DEVICE + tasks +
        "</ISO11783_TaskData>\n")
    for name, content in (("TLG00001", records(15000, 10.0, 100, 0, 3, 0, 1)),
                          ("TLG00002", records(15001, 10.0, 100, 3, 3, 500, 1)),
                          ("TLG00003", records(15021, 10.05, 40, 0, 3, 0, 2))):
        (folder / f"{name}.xml").write_text(HEADER)
        (folder / f"{name}.bin").write_bytes(content)


if __name__ == "__main__":
    main()
