#!/usr/bin/env bash
touch closeups
