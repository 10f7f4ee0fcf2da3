bash "$COMMON/riverside_coverage.sh"
