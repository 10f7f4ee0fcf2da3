#!/usr/bin/env bash
mkdir plan.gpkg
