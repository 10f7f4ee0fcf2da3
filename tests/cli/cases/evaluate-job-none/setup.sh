#!/usr/bin/env bash
python3 "$COMMON/draw_task_set.py" "$INPUT/TASKDATA"
