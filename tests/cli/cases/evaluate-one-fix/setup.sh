#!/usr/bin/env bash
printf "time,lon,lat\n2026-05-06T08:00:00Z,9.15240,52.69544\n" > drive.csv
