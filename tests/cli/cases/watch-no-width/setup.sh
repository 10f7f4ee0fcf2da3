#!/usr/bin/env bash
printf "time,lon,lat\\n0,9.15,52.69\\n1,9.1501,52.69\\n" > drive.csv
