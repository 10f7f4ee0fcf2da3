bash "$COMMON/riverside_plan.sh" 6
