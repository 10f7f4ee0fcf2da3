bash "$COMMON/two_farms_plans.sh"
