#!/usr/bin/env bash
echo time,lon,lat > drive.csv
