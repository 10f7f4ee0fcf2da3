bash "$COMMON/riverside_plan.sh" 12
