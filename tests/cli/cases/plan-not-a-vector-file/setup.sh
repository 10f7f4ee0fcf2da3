#!/usr/bin/env bash
echo 'dear diary' >field.geojson
