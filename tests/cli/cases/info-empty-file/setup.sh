#!/usr/bin/env bash
: >field.geojson
