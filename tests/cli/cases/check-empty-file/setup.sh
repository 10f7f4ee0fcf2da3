#!/usr/bin/env bash
: >plan.gpkg
