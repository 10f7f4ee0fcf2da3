bash "$COMMON/riverside_repair.sh"
