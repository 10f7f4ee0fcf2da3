#!/usr/bin/env bash
touch notes
